// SPDX-License-Identifier: MIT
#include "motion/verification/programmed_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/geometry/deviation.hpp"

namespace softcnc {
namespace {

/// The nearest point lies within this many times its distance along the path.
constexpr double kRange = 4;
constexpr double kRounding = 1e-9;  // mm

bool may_be_rounded(const Move& move) {
  return move.path_mode == PathMode::follow &&
         (move.corner_tolerance > 0 || move.chord_tolerance > 0);
}

}  // namespace

void ProgrammedPath::add(const Block& block) {
  const Move* move = std::get_if<Move>(&block.what);
  if (!move) {
    follows_ = false;
    return;
  }
  const double begin = std::exchange(s_, s_ + length(move->path));
  const double allowed = std::max(move->corner_tolerance, move->chord_tolerance);
  const bool rounded = may_be_rounded(*move);
  if (rounded || follows_)
    stretches_.push_back({block.number, move->path, begin, s_, allowed, allowed_, follows_});
  follows_ = rounded;
  allowed_ = allowed;
}

void ProgrammedPath::sample(const Setpoint& setpoint) noexcept {
  const AxisVector before = std::exchange(sample_, setpoint.position);
  const bool is_first = !std::exchange(has_sample_, true);
  last_ = 0;
  if (stretches_.empty() || is_first) return;
  find(setpoint.block);
  if (setpoint.block < stretches_[here_].number) return;
  if (setpoint.block == stretches_[here_].number)
    measure_sample(setpoint.position);
  else
    guess_ = length(stretches_[here_].path);  // after it
  near_joints(before, setpoint.position);
  forget();
}

/// After a stop there are stretches ahead, to whose beginning nothing has come.
void ProgrammedPath::finish() noexcept {
  for (std::size_t i = 0; i < stretches_.size() && i <= here_; ++i) count_joint(stretches_[i]);
  stretches_.clear();
}

/// Finds the last stretch that begins with this block or before it.
void ProgrammedPath::find(int number) noexcept {
  const std::size_t before = here_;
  while (here_ + 1 < stretches_.size() && stretches_[here_ + 1].number <= number) ++here_;
  if (here_ != before) guess_ = 0;
}

/// Newton's method may converge elsewhere, so what it finds counts only where it raises neither
/// record.
void ProgrammedPath::measure_sample(const AxisVector& point) noexcept {
  const Deviation found = deviation(point, Search::near_guess);
  const Deviation counted = is_record(found) ? deviation(point, Search::whole) : found;
  count(counted);
  last_ = counted.off;
}

/// The search continues in both directions while the path could still come back so near.
ProgrammedPath::Deviation ProgrammedPath::deviation(const AxisVector& point,
                                                    Search search) noexcept {
  const PathStretch& here = stretches_[here_];
  guess_ = nearest_on(here, point, guess_, search);
  double allowed = here.allowed;
  double least = (position(here.path, guess_) - point).norm();
  const auto try_stretch = [&](const PathStretch& stretch, double guess) {
    const double s = nearest_on(stretch, point, guess, search);
    least = std::min(least, (position(stretch.path, s) - point).norm());
    allowed = std::max(allowed, stretch.allowed);
  };
  const double at = here.s_start + guess_;
  for (std::size_t i = here_; i > 0 && stretches_[i].follows; --i) {
    const PathStretch& before = stretches_[i - 1];
    if (at - before.s_end > kRange * least + kRounding) break;
    try_stretch(before, length(before.path));
  }
  for (std::size_t i = here_ + 1; i < stretches_.size() && stretches_[i].follows; ++i) {
    const PathStretch& after = stretches_[i];
    if (after.s_start - at > kRange * least + kRounding) break;
    try_stretch(after, 0);
  }
  return {least, allowed};
}

double ProgrammedPath::nearest_on(const PathStretch& stretch, const AxisVector& point, double guess,
                                  Search search) noexcept {
  const Portion all{&stretch.path, 0, length(stretch.path)};
  return search == Search::whole ? nearest(all, point) : nearest(all, point, guess);
}

/// Joints around the last sample come near to the chord from the sample before to it.
void ProgrammedPath::near_joints(const AxisVector& from, const AxisVector& to) noexcept {
  const double distance = (to - from).norm();
  const double at = stretches_[here_].s_start + guess_;
  const auto range = [&](const PathStretch& stretch) {
    return distance + kRange * std::min(stretch.joint_off, stretch.allowed_before) + kRounding;
  };
  const auto look = [&](PathStretch& stretch) {
    if (stretch.follows)
      stretch.joint_off =
          std::min(stretch.joint_off, distance_to_segment(start(stretch.path), from, to));
  };
  for (std::size_t i = here_ + 1; i-- > 0;) {
    look(stretches_[i]);
    if (at - stretches_[i].s_start > distance + kRange * stretches_[i].allowed_before) break;
  }
  for (std::size_t i = here_ + 1; i < stretches_.size(); ++i) {
    if (stretches_[i].s_start - at > range(stretches_[i])) break;
    look(stretches_[i]);
  }
}

/// Drops what no sample comes near any more.
void ProgrammedPath::forget() noexcept {
  const auto is_passed = [&](const PathStretch& stretch) {
    const PathStretch& here = stretches_[here_];
    return here.s_start - stretch.s_end >
           kRange * std::max(stretch.allowed_before, stretch.allowed);
  };
  while (here_ > 0 && is_passed(stretches_.front())) {
    count_joint(stretches_.front());
    stretches_.pop_front();
    --here_;
  }
}

void ProgrammedPath::count_joint(const PathStretch& stretch) noexcept {
  if (std::isfinite(stretch.joint_off)) count({stretch.joint_off, stretch.allowed_before});
}

bool ProgrammedPath::is_record(const Deviation& found) const noexcept {
  return found.off > std::max(largest_, kRounding) ||
         found.off - found.allowed > worst_.off - worst_.allowed + kRounding;
}

void ProgrammedPath::count(const Deviation& deviation) noexcept {
  largest_ = std::max(largest_, deviation.off);
  if (deviation.off - deviation.allowed > worst_.off - worst_.allowed) worst_ = deviation;
}

}  // namespace softcnc
