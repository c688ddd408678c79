// SPDX-License-Identifier: MIT
#include "surface/tool_track.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softcnc::surface {
namespace {

AxisVector between(const AxisVector& a, const AxisVector& b, double part) {
  return a + part * (b - a);
}

double distance(const AxisVector& point, const AxisVector& from, const AxisVector& to) {
  const AxisVector along = to - from;
  const double square = along.squaredNorm();
  const double part = square > 0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0.0;
  return (point - between(from, to, part)).norm();
}

}  // namespace

double ToolTrack::tooth_period(const Cutter& cutter) noexcept {
  return 2 * std::numbers::pi / (cutter.teeth * std::abs(cutter.spin));
}

void ToolTrack::begin(const Cutter& cutter, double at) {
  close_stretch();
  begins_at_ = at;
  cutter_ = cutter;
  begins_ = cutter.spin != 0 && cutter.teeth > 0 && cutter.radius > 0;
}

void ToolTrack::start_stretch(const ToolRow& row) {
  begins_ = false;
  if (row.t > last_.t && begins_at_ > last_.t) {
    const double part = std::min(1.0, (begins_at_ - last_.t) / (row.t - last_.t));
    last_.tip = between(last_.tip, row.tip, part);
    last_.commanded = between(last_.commanded, row.commanded, part);
    last_.t += part * (row.t - last_.t);
  }
  end_places();
  stretches_.push_back({cutter_, last_.t, places_.size()});
  add_place({last_.t, last_.tip});
  pass_begin_ = last_.t;
  pass_from_ = last_.tip;
  pass_tips_.clear();
  pass_number_ = 0;
  pass_cutting_ = true;
  rests_ = false;
  target_ = 0;
}

void ToolTrack::add(const ToolRow& row) {
  if (!any_) last_ = row;
  any_ = true;
  if (begins_) start_stretch(row);
  const bool turns = cutter_.spin != 0 && !stretches_.empty() && row.t > last_.t;
  if (turns) close_passes(row);
  last_ = row;
}

/// Closes every pass that ends up to the row.
void ToolTrack::close_passes(const ToolRow& row) {
  const SpindleStretch& stretch = stretches_.back();
  const double period = tooth_period(stretch.cutter);
  pass_cutting_ = pass_cutting_ && row.cutting;
  target_ = row.target;
  for (;;) {
    const double end = stretch.begin + static_cast<double>(pass_number_ + 1) * period;
    if (end > row.t) break;
    const double part = (end - last_.t) / (row.t - last_.t);
    close_pass(end, between(last_.tip, row.tip, part),
               between(last_.commanded, row.commanded, part));
    pass_cutting_ = row.cutting;
  }
  add_place({row.t, row.tip});
  pass_tips_.push_back(row.tip);
}

/// Of a rest only its begin and its end.
void ToolTrack::add_place(const Place& place) {
  const bool rests = place_ && place.tip == place_->tip;
  if (place_ && !(rests && place_rests_)) places_.push_back(*place_);
  place_rests_ = rests;
  place_ = place;
}

void ToolTrack::end_places() {
  if (place_) places_.push_back(*place_);
  place_.reset();
  place_rests_ = false;
}

/// What rests through a second pass cuts nothing new.
void ToolTrack::close_pass(double end, const AxisVector& to, const AxisVector& commanded) {
  const double bulge = bulge_of(pass_from_, to);
  const bool rests = bulge == 0 && to == pass_from_;
  if (!rests || !rests_)
    passes_.push_back({stretches_.size() - 1, pass_begin_, end, pass_from_, to, commanded, bulge,
                       pass_cutting_, static_cast<float>(target_)});
  rests_ = rests;
  pass_begin_ = end;
  pass_from_ = to;
  pass_tips_.clear();
  ++pass_number_;
}

double ToolTrack::bulge_of(const AxisVector& from, const AxisVector& to) const noexcept {
  double most = 0;
  for (const AxisVector& tip : pass_tips_) most = std::max(most, distance(tip, from, to));
  return most;
}

/// The last pass of a stretch ends where the tool stands then; its edges turn on to the end of it.
void ToolTrack::close_stretch() {
  const bool open = !stretches_.empty() && !begins_ && cutter_.spin != 0;
  if (open && last_.t > pass_begin_) {
    const double period = tooth_period(stretches_.back().cutter);
    close_pass(pass_begin_ + period, last_.tip, last_.commanded);
  }
  cutter_ = {};
}

Status ToolTrack::finish() {
  close_stretch();
  end_places();
  const Status places = places_.finish(), passes = passes_.finish();
  return places ? passes : places;
}

std::size_t ToolTrack::end_of(std::size_t stretch) const noexcept {
  return stretch + 1 < stretches_.size() ? stretches_[stretch + 1].first : places_.values().size();
}

void ToolTrack::sample(const EdgePass& pass, std::span<AxisVector> out) const {
  const auto places = places_.values();
  const auto first = places.begin() + static_cast<std::ptrdiff_t>(stretches_[pass.stretch].first);
  const auto last = places.begin() + static_cast<std::ptrdiff_t>(end_of(pass.stretch));
  auto place =
      std::upper_bound(first, last, pass.begin, [](double t, const Place& p) { return t < p.t; });
  const double step = (pass.end - pass.begin) / static_cast<double>(out.size() - 1);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double t = pass.begin + static_cast<double>(i) * step;
    while (place != last && place->t <= t) ++place;
    if (place == last) {
      out[i] = std::prev(place)->tip;
      continue;
    }
    const Place& before = *(place == first ? place : std::prev(place));
    const double span = place->t - before.t;
    out[i] = span > 0 ? between(before.tip, place->tip, (t - before.t) / span) : before.tip;
  }
}

std::size_t ToolTrack::memory() const noexcept {
  return stretches_.capacity() * sizeof(SpindleStretch) + places_.memory() + passes_.memory();
}

void ToolTrack::release() const noexcept {
  places_.release();
  passes_.release();
}

}  // namespace softcnc::surface
