// SPDX-License-Identifier: MIT
// Blocks in, samples out: planner, queue, interpolator and verifier as the product joins them.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "ipo/planner/planner.hpp"
#include "ipo/planner/stop.hpp"
#include "ipo/queue/interpolator.hpp"
#include "motion/roughness/roughness.hpp"
#include "motion/verification/programmed_path.hpp"
#include "motion/verification/verify.hpp"

namespace softcnc::test {

struct Run {
  std::vector<Setpoint> rows;
  Measured measured;
  double time = 0;  // of the profile, s
  std::map<Limit, double> time_by_limit;
  std::vector<Diagnostic> diagnostics;
  ipo::PlannerCounts counts;
  ProgrammedPath::Deviation deviation;  // from the programmed path, against what G64 allows
  double roughness_used = 0;  // largest part of the speed that a roughness allows at a sample
};

/// What a sample uses of the speed that the roughness of its path allows where it is.
inline double roughness_used(const Machine& machine, const Setpoint& row,
                             const PathStretch& stretch) {
  if (stretch.surface == nullptr || !(stretch.surface->tooth_rate() > 0)) return 0;
  const double s = std::clamp(row.s - stretch.s_start, 0.0, length(*stretch.path));
  double most = 0;  // where derivatives jump, the sample is on either side
  for (const Side side : {Side::before, Side::after})
    most = std::max(most, largest_feed_per_tooth(machine.surfacing.model, *stretch.surface,
                                                 at(*stretch.path, s, side)));
  return row.v / (most * stretch.surface->tooth_rate());
}

inline std::vector<Block> number_blocks(std::vector<std::variant<Move, Dwell, Action>> whats) {
  std::vector<Block> blocks;
  int number = 0;
  for (auto& what : whats) {
    ++number;
    blocks.push_back({std::move(what), {number, 1, 1}, number});
  }
  return blocks;
}

/// A polyline at one feed (mm/s).
inline std::vector<Block> polyline(const std::vector<AxisVector>& points, double feed,
                                   bool rapid = false) {
  std::vector<std::variant<Move, Dwell, Action>> moves;
  for (std::size_t i = 1; i < points.size(); ++i)
    moves.emplace_back(Move{Line(points[i - 1], points[i]), rapid, feed, PathMode::follow});
  return number_blocks(std::move(moves));
}

/// A move along a whole path, from rest to rest, at one feed (mm/s).
inline std::vector<Block> one_move(Path path, double feed) {
  return number_blocks({Move{std::move(path), false, feed, PathMode::follow}});
}

/// What is requested of the feed, by the number of samples after which it is.
using Controls = std::map<int, ipo::FeedControl>;

/// A chunk of one block, after which the next takes so long that all is planned that can be.
inline constexpr std::size_t kSlowly = static_cast<std::size_t>(-1);

/// `chunk`: blocks pushed before the planner is asked; 0: all of them. `visit` sees each sample
/// while its pulses stand.
inline Run run(const Machine& machine, const std::vector<Block>& blocks, const Controls& controls,
               std::size_t chunk = 1, double feed_override = 1,
               const std::function<void(const Setpoint&)>& visit = {}) {
  Run result;
  Diagnostics diagnostics;
  ipo::Planner planner(machine, feed_override, diagnostics);
  ipo::BlockQueue queue(10 * machine.control.period + ipo::setpoint_lag(machine),
                        ipo::setpoint_lag(machine));
  ipo::Interpolator interpolator(queue, machine);
  Verifier verifier(machine);
  ProgrammedPath programmed;
  std::size_t next = 0;
  bool finished = false, stopped = false;
  const auto pump = [&] {
    if (auto part = chunk == kSlowly ? planner.pop_part_now() : planner.pop_part()) {
      const auto count = [&](const auto& timed) {
        timed.profile.for_each_piece(
            [&](Limit limit, double duration) { result.time_by_limit[limit] += duration; });
      };
      std::visit(count, *part);
      queue.push(std::move(*part));
      return true;
    }
    if (stopped || finished) return false;
    const std::size_t size = chunk == 0 ? blocks.size() : chunk == kSlowly ? 1 : chunk;
    const std::size_t end = std::min(blocks.size(), next + size);
    for (; next < end; ++next) {
      programmed.add(blocks[next]);
      planner.push(blocks[next]);
    }
    finished = next == blocks.size();
    if (finished) planner.finish();
    return true;
  };
  const auto fill = [&] {
    while (queue.t_end() <= interpolator.needs_until() && pump()) {
    }
  };
  const auto ask = [&](const ipo::FeedControl& control) {
    stopped = control.stop;
    const double now = interpolator.state_time();
    const ipo::State state = interpolator.state();
    queue.begin_again(planner.replan(queue.take_rest(), state, now, control), now);
    fill();
    interpolator.replanned();
  };
  while (true) {
    queue.trim();
    fill();
    const auto control = controls.find(static_cast<int>(result.rows.size()));
    if (control != controls.end() && !queue.empty()) ask(control->second);
    const auto setpoint = interpolator.step();
    if (!setpoint) break;
    if (visit) visit(*setpoint);
    std::vector<PathStretch> stretches;
    queue.for_each_recent([&](const ipo::TimedBlock& timed) {
      if (const Move* move = timed.move())
        stretches.push_back(
            {&move->path, timed.s_start, move->surface ? &*move->surface : nullptr, move->rapid});
    });
    verifier.sample(*setpoint, stretches);
    programmed.sample(*setpoint);
    if (!stretches.empty())
      result.roughness_used =
          std::max(result.roughness_used, roughness_used(machine, *setpoint, stretches.back()));
    result.rows.push_back(*setpoint);
    result.rows.back().pulses = {};
    result.rows.back().fine = {};
  }
  verifier.finish();
  if (!stopped) programmed.finish();
  result.measured = verifier.measured();
  result.deviation = programmed.worst();
  result.time = queue.t_end();
  result.counts = planner.counts();
  for (const Diagnostic& d : diagnostics.all()) result.diagnostics.push_back(d);
  return result;
}

/// `stop_after`: the sample after which a stop is requested; -1: none.
inline Run run(const Machine& machine, const std::vector<Block>& blocks, int stop_after = -1,
               std::size_t chunk = 1, double feed_override = 1) {
  Controls controls;
  if (stop_after >= 0) controls[stop_after + 1].stop = true;
  return run(machine, blocks, controls, chunk, feed_override);
}

/// Third differences round more: how far they may exceed.
inline constexpr double kJerkShare = 5e-3;

/// Empty if every sample keeps velocity, acceleration (both to `share`), the chord tolerance and
/// the path; otherwise what is exceeded.
inline std::string exceeded(const Machine& machine, const Run& run, double share = 1e-3) {
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (run.measured.velocity[i] > axis.velocity * (1 + share))
      return "velocity " + std::to_string(run.measured.velocity[i]);
    if (run.measured.acceleration[i] > axis.acceleration * (1 + share))
      return "acceleration " + std::to_string(run.measured.acceleration[i]);
    if (axis.jerk > 0 && run.measured.jerk[i] > axis.jerk * (1 + kJerkShare))
      return "jerk " + std::to_string(run.measured.jerk[i]);
  }
  const auto& [feed, tangential, normal] = machine.limits;
  if (tangential > 0 && run.measured.tangential > tangential * (1 + share))
    return "tangential acceleration " + std::to_string(run.measured.tangential);
  if (normal > 0 && run.measured.normal > normal * (1 + share))
    return "normal acceleration " + std::to_string(run.measured.normal);
  if (run.measured.chord_error > machine.control.chord_tolerance)
    return "chord error " + std::to_string(run.measured.chord_error * 1e3) + " um";
  if (run.measured.path_deviation > 1e-9)
    return "path deviation " + std::to_string(run.measured.path_deviation);
  if (run.deviation.off > run.deviation.allowed + machine.control.chord_tolerance + 1e-7)
    return "deviation " + std::to_string(run.deviation.off) + " mm, where " +
           std::to_string(run.deviation.allowed) + " are allowed";
  return {};
}

}  // namespace softcnc::test
