// SPDX-License-Identifier: MIT
#include "ipo/path/profile.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softcnc::ipo {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

}  // namespace

void Profile::add_piece(double s0, double s1, double v0, double v1, Limit limit) {
  const double duration = 2 * (s1 - s0) / (v0 + v1);
  pieces_.push_back({duration_, duration, {s0, v0, (v1 - v0) / duration}, s1, limit});
  duration_ += duration;
}

void Profile::add_ramp(const Ramp& ramp) {
  pieces_.push_back({duration_, ramp.duration, quintic(ramp), ramp.s1, ramp.limit});
  duration_ += ramp.duration;
}

void Profile::add_rest(double duration) {
  const double s = pieces_.empty() ? 0.0 : pieces_.back().s1;
  pieces_.push_back({duration_, duration, {s}, s, Limit::stop});
  duration_ += duration;
}

void Profile::rest_at(double s) { pieces_.push_back({duration_, 0, {s}, s, Limit::stop}); }

void Profile::add_hold(Limit limit) {
  const double s = pieces_.empty() ? 0.0 : pieces_.back().s1;
  pieces_.push_back({duration_, kEndless, {s}, s, limit});
  duration_ = kEndless;
}

void Profile::end_hold() noexcept {
  if (duration_ < kEndless) return;
  duration_ = pieces_.back().t0;
  pieces_.pop_back();
}

Profile Profile::from(double t) const {
  Profile rest;
  for (const Piece& piece : pieces_) {
    const double passed = std::max(t - piece.t0, 0.0);
    if (passed >= piece.duration && &piece != &pieces_.back()) continue;
    const double left = std::max(piece.duration - passed, 0.0);
    Quintic curve = piece.curve.from(passed);
    curve.s0 = std::min(curve.s0, piece.s1);
    rest.pieces_.push_back({rest.duration_, left, curve, piece.s1, piece.limit});
    rest.duration_ += left;
  }
  return rest;
}

Profile Profile::first(std::size_t count) const {
  Profile part;
  for (std::size_t i = 0; i < count; ++i) part.add(pieces_[i]);
  return part;
}

Profile Profile::after(std::size_t count) const {
  Profile rest;
  for (std::size_t i = count; i < pieces_.size(); ++i) rest.add(pieces_[i]);
  return rest;
}

void Profile::append(const Profile& more) {
  for (const Piece& piece : more.pieces_) add(piece);
}

void Profile::add(Piece piece) {
  piece.t0 = duration_;
  duration_ += piece.duration;
  pieces_.push_back(piece);
}

double Profile::end_speed() const noexcept {
  if (pieces_.empty()) return 0;
  const Piece& last = pieces_.back();
  const double v = last.curve.v(last.duration);
  return v > tuning::path::kStandstill ? v : 0;
}

State Profile::at(double t, std::size_t& hint) const noexcept {
  if (pieces_.empty()) return {};
  while (hint + 1 < pieces_.size() && t >= pieces_[hint + 1].t0) ++hint;
  const Piece& piece = pieces_[hint];
  const double tau = std::clamp(t - piece.t0, 0.0, piece.duration);
  const bool ends = tau >= piece.duration || t >= duration_;  // exactly there
  const double s = ends ? piece.s1 : piece.curve.s(tau);
  const double v = std::max(piece.curve.v(tau), 0.0);
  return {std::clamp(s, piece.curve.s0, piece.s1), v, piece.curve.a(tau),
          v > tuning::path::kStandstill || piece.duration == kEndless ? piece.limit : Limit::stop};
}

Profile::Span Profile::span(const Piece& piece, double until) noexcept {
  const double tau = std::min(piece.duration, until - piece.t0);
  const bool whole = tau >= piece.duration;
  return {piece.t0,       piece.t0 + tau,     piece.curve.s0, whole ? piece.s1 : piece.curve.s(tau),
          piece.curve.v0, piece.curve.v(tau), piece.limit};
}

/// s grows with t.
double Profile::time_to(const Piece& piece, double s) noexcept {
  double early = 0, late = piece.duration;
  for (int i = 0; i < tuning::path::kHalvings; ++i) {
    const double middle = 0.5 * (early + late);
    (piece.curve.s(middle) < s ? early : late) = middle;
  }
  return late;
}

double Profile::time_at(double s) const noexcept {
  const auto after = std::partition_point(pieces_.begin(), pieces_.end(),
                                          [s](const Piece& piece) { return piece.s1 < s; });
  if (after == pieces_.end()) return duration_;
  const Quintic& curve = after->curve;
  if (curve.c3 != 0 || curve.c4 != 0 || curve.c5 != 0) return after->t0 + time_to(*after, s);
  const double ds = std::max(s - curve.s0, 0.0);
  // The root of ds = v0 tau + a tau^2 / 2 in the form that does not cancel.
  const double root = std::sqrt(std::max(curve.v0 * curve.v0 + 2 * curve.a0 * ds, 0.0));
  const double sum = curve.v0 + root;
  return after->t0 + (sum > 0 ? std::min(2 * ds / sum, after->duration) : 0.0);
}

}  // namespace softcnc::ipo
