// SPDX-License-Identifier: MIT
#include "ipo/profile.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

void Profile::add_piece(double s0, double s1, double v0, double v1, Limit limit) {
  const double duration = 2 * (s1 - s0) / (v0 + v1);
  const double a = (v1 - v0) / duration;
  pieces_.push_back({duration_, duration, s0, s1, v0, a, limit});
  duration_ += duration;
}

void Profile::add_rest(double duration) {
  const double s = pieces_.empty() ? 0.0 : pieces_.back().s1;
  pieces_.push_back({duration_, duration, s, s, 0, 0, Limit::stop});
  duration_ += duration;
}

void Profile::rest_at(double s) { pieces_.push_back({duration_, 0, s, s, 0, 0, Limit::stop}); }

Profile Profile::from(double t) const {
  Profile rest;
  for (const Piece& piece : pieces_) {
    const double passed = std::max(t - piece.t0, 0.0);
    if (passed >= piece.duration && &piece != &pieces_.back()) continue;
    const double s = std::min(piece.s0 + passed * (piece.v0 + 0.5 * piece.a * passed), piece.s1);
    const double left = std::max(piece.duration - passed, 0.0);
    rest.pieces_.push_back(
        {rest.duration_, left, s, piece.s1, piece.v0 + piece.a * passed, piece.a, piece.limit});
    rest.duration_ += left;
  }
  return rest;
}

double Profile::end_speed() const noexcept {
  if (pieces_.empty()) return 0;
  const Piece& last = pieces_.back();
  return std::max(last.v0 + last.a * last.duration, 0.0);
}

State Profile::at(double t, std::size_t& hint) const noexcept {
  if (pieces_.empty()) return {};
  while (hint + 1 < pieces_.size() && t >= pieces_[hint + 1].t0) ++hint;
  const Piece& piece = pieces_[hint];
  const double tau = std::clamp(t - piece.t0, 0.0, piece.duration);
  const bool ends = tau >= piece.duration || t >= duration_;  // exactly there
  const double s = ends ? piece.s1 : piece.s0 + tau * (piece.v0 + 0.5 * piece.a * tau);
  const double v = std::max(piece.v0 + piece.a * tau, 0.0);
  return {std::clamp(s, piece.s0, piece.s1), v, piece.a, v > 0 ? piece.limit : Limit::stop};
}

double Profile::time_at(double s) const noexcept {
  const auto after = std::partition_point(pieces_.begin(), pieces_.end(),
                                          [s](const Piece& piece) { return piece.s1 < s; });
  if (after == pieces_.end()) return duration_;
  const double ds = std::max(s - after->s0, 0.0);
  // Root of ds = v0 tau + a tau^2 / 2 that does not cancel.
  const double root = std::sqrt(std::max(after->v0 * after->v0 + 2 * after->a * ds, 0.0));
  const double sum = after->v0 + root;
  return after->t0 + (sum > 0 ? std::min(2 * ds / sum, after->duration) : 0.0);
}

}  // namespace softcnc::ipo
