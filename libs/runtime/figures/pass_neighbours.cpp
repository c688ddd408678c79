// SPDX-License-Identifier: MIT
#include "runtime/figures/pass_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/figures/elapsed.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kAlike = 0.87;            // cosine: 30 degrees
constexpr double kRests = 1e-6;            // mm
constexpr double kSpacing = 0.25;          // pick-feeds, between places
constexpr double kLink = 3;                // pick-feeds: what is shorter is no pass
constexpr double kNear = 0.3, kFar = 1.5;  // pick-feeds, to a pass beside
constexpr double kSteepest = 1.0472;       // rad: what lies higher is in the air, or cut before
constexpr double kEven = 1.25;             // from place to place, of speeds
constexpr double kLevelStep = 0.2;         // of a step from above: what is less is a plunge
constexpr std::size_t kPasses = 6;         // remembered
constexpr std::size_t kPlaces = 20'000;    // remembered of each
constexpr int kTries = 32;                 // misses from one search of a whole pass to the next

AxisVector from_above(AxisVector v) {
  v[2] = 0;
  return v;
}

double lag_of(double teeth) noexcept { return std::abs(teeth - std::round(teeth)); }

/// Above an earlier pass, from which no surface leads here.
bool is_in_air(double aside, double rise, double pick_feed) noexcept {
  return rise > std::tan(kSteepest) * std::max(aside, kNear * pick_feed);
}

}  // namespace

std::optional<NeighbourPass> PassNeighbours::add(const Setpoint& row, const Path& path,
                                                 double begin, const Surface& surface) {
  const double time = static_cast<double>(row.period) * period_;
  if (begins_pass(row, path, begin, time)) begin_pass(block_begun_, surface.pick_feed);
  const Place place{row.position, (time - begun_) * surface.tooth_rate(), row.v};
  if (present_.places.empty()) keep({at(path, begin).q, 0, 0});
  const AxisVector advance = row.position - kept_;
  const double length = advance.norm();
  if (length < kSpacing * surface.pick_feed || length < kRests) return std::nullopt;
  if (turns(advance / length)) {
    begin_pass(block_begun_, surface.pick_feed);
    keep(place);
    return std::nullopt;
  }
  advance_before_ = std::exchange(advance_, advance / length);
  present_.length += from_above(advance).norm();
  keep(place);
  if (present_.length < reported_ + surface.pick_feed || from_above(advance_).norm() < kLevelStep)
    return std::nullopt;
  reported_ = present_.length;
  return neighbour(place, surface.pick_feed);
}

void PassNeighbours::keep(const Place& place) {
  kept_ = place.at;
  if (present_.places.size() < kPlaces) present_.places.push_back(place);
}

/// Rows that do not follow each other are parted by a rapid, or by a rest in one place.
bool PassNeighbours::begins_pass(const Setpoint& row, const Path& path, double begin, double time) {
  const AxisVector before = std::exchange(last_, row.position), step = row.position - before;
  const AxisVector heading = heading_;
  if (step.norm() > kRests) heading_ = step.normalized();
  const bool follows = std::exchange(last_period_, row.period) + 1 == row.period;
  if (std::exchange(block_, row.block) == row.block && follows) return false;
  const PathPoint from = at(path, begin);
  block_begun_ = time - elapsed((row.position - from.q).norm(), row);
  return (!follows && (from.q - before).norm() > kRests) || heading.dot(from.dq) < kPassTurn;
}

/// Where corners are rounded it takes two steps.
bool PassNeighbours::turns(const AxisVector& advance) const noexcept {
  return (!advance_.isZero() && advance.dot(advance_) < kPassTurn) ||
         (!advance_before_.isZero() && advance.dot(advance_before_) < kPassTurn);
}

void PassNeighbours::begin_pass(double time, double pick_feed) {
  if (present_.length > kLink * pick_feed) {
    earlier_.push_front(std::move(present_));
    if (earlier_.size() > kPasses) earlier_.pop_back();
    for (Pass& pass : earlier_) pass.misses = 0;
  }
  present_ = {};
  reported_ = 0;
  begun_ = time;
  advance_.setZero();
  advance_before_.setZero();
}

/// The nearest pass; none in the air.
std::optional<NeighbourPass> PassNeighbours::neighbour(const Place& place, double pick_feed) {
  std::optional<NeighbourPass> nearest;
  for (Pass& pass : earlier_) {
    const auto found = offset(pass, place, pick_feed);
    if (!found) continue;
    if (is_in_air(found->aside, found->rise, pick_feed)) return std::nullopt;
    const double slope = std::atan2(std::abs(found->rise), found->aside);
    if (found->aside < kNear * pick_feed || std::abs(found->heading) < kAlike || slope > kSteepest)
      continue;
    if (nearest && nearest->distance <= found->aside) continue;
    const bool opposite = found->heading < 0;
    nearest = NeighbourPass{found->aside, opposite, opposite ? 0 : found->lag, slope};
  }
  return nearest;
}

/// From the line of a pass, if it leads past here.
std::optional<PassNeighbours::Offset> PassNeighbours::offset(Pass& pass, const Place& place,
                                                             double pick_feed) const {
  const std::size_t i = nearest(pass, place.at, kFar * pick_feed);
  const std::size_t from = i + 1 < pass.places.size() ? i : i - 1;
  const Place &a = pass.places[from], &b = pass.places[from + 1];
  const AxisVector chord = from_above(b.at - a.at), away = from_above(place.at - a.at);
  const double along = chord.norm();
  if (along < kRests) return std::nullopt;
  const double part = away.dot(chord) / (along * along);
  const double aside = (away - part * chord).norm();
  if (aside > kFar * pick_feed || part < -1 || part > 2) return std::nullopt;
  return Offset{aside, place.at[2] - (a.at[2] + part * (b.at[2] - a.at[2])),
                chord.dot(advance_) / along / from_above(advance_).norm(),
                std::max(a.v, b.v) > kEven * std::min(a.v, b.v)
                    ? 0
                    : lag_of(place.teeth - teeth_at(a, b, part))};
}

/// Between places, and a little beyond, at a constant acceleration.
double PassNeighbours::teeth_at(const Place& a, const Place& b, double part) noexcept {
  const double v = std::sqrt(std::max(0.0, a.v * a.v + part * (b.v * b.v - a.v * a.v)));
  return a.teeth + (b.teeth - a.teeth) * part * (a.v + b.v) / (a.v + v);
}

/// Downhill from where it was asked for last; everywhere, now and then, if that leads nowhere near.
std::size_t PassNeighbours::nearest(Pass& pass, const AxisVector& at, double near) {
  const auto distance = [&](std::size_t i) { return from_above(pass.places[i].at - at).norm(); };
  const std::size_t last = pass.places.size() - 1;
  std::size_t& i = pass.cursor;
  while (i < last && distance(i + 1) <= distance(i)) ++i;
  while (i > 0 && distance(i - 1) < distance(i)) --i;
  if (distance(i) <= near) {
    pass.misses = 0;
  } else if (pass.misses++ % kTries == 0) {
    for (std::size_t other = 0; other <= last; ++other)
      if (distance(other) < distance(i)) i = other;
  }
  return i;
}

}  // namespace softcnc::runtime
