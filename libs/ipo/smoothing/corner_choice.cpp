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

std::vector<Move> curve_of(const RoundedCorner& corner) {
  std::vector<Move> moves;
  const double end = length(corner.curve);
  const bool is_one = corner.before.attributes == corner.after.attributes;
  const double middle = is_one ? end : 0.5 * end;
  append(moves, corner.curve, 0, middle, corner.before.attributes);
  append(moves, corner.curve, middle, end, corner.after.attributes);
  return moves;
}

}  // namespace

CornerChoice::CornerChoice(const Machine& machine, std::unique_ptr<const TrialPlan> trial)
    : limits_(limits_of(machine)),
      feed_(machine.limits.feed > 0 ? machine.limits.feed : kUnlimited),
      trial_(std::move(trial)) {
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
  const std::vector<Move> passed = curve_of(corner);
  const auto keeps_feed = [&](const Move& move) { return trial_->keeps_feed(move); };
  if (std::all_of(passed.begin(), passed.end(), keeps_feed)) return true;
  const auto& [before, after, curve, cut_before, cut_after] = corner;
  const double begin = std::max(before.begin, before.end - cut_before - needed(before, before.end));
  const double end = std::min(after.end, after.begin + cut_after + needed(after, after.begin));
  std::vector<Move> rounded, resting;
  append(rounded, before.path, begin, before.end - cut_before, before.attributes);
  rounded.insert(rounded.end(), passed.begin(), passed.end());
  append(rounded, after.path, after.begin + cut_after, end, after.attributes);
  append(resting, before.path, begin, before.end, before.attributes);
  append(resting, after.path, after.begin, end, after.attributes);
  return trial_->time(rounded) < tuning::corners::kNotWorth * trial_->time(resting);
}

}  // namespace softcnc::ipo
