// SPDX-License-Identifier: MIT
#include "ipo/smoothing/corner_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/path/rest_to_rest.hpp"
#include "ipo/tuning.hpp"
#include "motion/geometry/section.hpp"

namespace softcnc::ipo {
namespace {

/// Appends a part of a path, unless it is too short to be one.
void append(std::vector<Move>& moves, const Path& path, double begin, double end,
            const MoveAttributes& attributes) {
  if (end - begin > tuning::corners::kShortestPart)
    moves.push_back(make_move(section(path, begin, end), attributes));
}

void append_curve(std::vector<Move>& moves, const RoundedCorner& corner) {
  const double end = length(corner.curve);
  const bool is_one = corner.before.attributes == corner.after.attributes;
  const double middle = is_one ? end : 0.5 * end;
  append(moves, corner.curve, 0, middle, corner.before.attributes);
  append(moves, corner.curve, middle, end, corner.after.attributes);
}

}  // namespace

CornerChoice::CornerChoice(const Machine& machine, PlannedTime planned_time)
    : limits_(limits_of(machine)),
      feed_(machine.limits.feed > 0 ? machine.limits.feed : kUnlimited),
      planned_time_(std::move(planned_time)) {
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    velocity_[i] = axis.present ? axis.velocity : kUnlimited;
  }
}

/// Returns the distance, mm, in which the machine reaches the feed of a side at place s of it from
/// rest, and brakes to rest again.
double CornerChoice::needed(const CornerSide& side, double s) const {
  const AxisVector tangent = at(side.path, s).dq;
  const double v =
      std::min(side.attributes.rapid ? kUnlimited : std::min(side.attributes.feed, feed_),
               along(velocity_, tangent));
  const double a = std::min(along(limits_.acceleration, tangent), limits_.tangential);
  const double j = along(limits_.jerk, tangent);
  if (!(v < kUnlimited && a < kUnlimited)) return kUnlimited;
  return j < kUnlimited ? 2 * distance_to_cruise({v, a, j}) : v * v / a;
}

bool CornerChoice::is_sooner(const RoundedCorner& corner) const {
  const auto& [before, after, curve, cut_before, cut_after] = corner;
  const double begin = std::max(before.begin, before.end - cut_before - needed(before, before.end));
  const double end = std::min(after.end, after.begin + cut_after + needed(after, after.begin));
  std::vector<Move> rounded, resting;
  append(rounded, before.path, begin, before.end - cut_before, before.attributes);
  append_curve(rounded, corner);
  append(rounded, after.path, after.begin + cut_after, end, after.attributes);
  append(resting, before.path, begin, before.end, before.attributes);
  append(resting, after.path, after.begin, end, after.attributes);
  return planned_time_(rounded) < tuning::corners::kNotWorth * planned_time_(resting);
}

}  // namespace softcnc::ipo
