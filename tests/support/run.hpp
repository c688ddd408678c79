// SPDX-License-Identifier: MIT
// Blocks in, rows out: planner, queue, interpolator and verifier as the product joins them.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "ipo/interpolator.hpp"
#include "ipo/planner.hpp"
#include "ipo/stop.hpp"
#include "motion/verify.hpp"

namespace softcnc::test {

struct Run {
  std::vector<Setpoint> rows;
  Measured measured;
  double time = 0;  // of the profile, s
  std::map<Limit, double> time_by_limit;
  std::vector<Diagnostic> diagnostics;
  ipo::PlannerCounts counts;
};

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
    moves.emplace_back(Move{Line(points[i - 1], points[i]), rapid, feed, Join::follow});
  return number_blocks(std::move(moves));
}

/// `stop_after`: rows after which a stop is asked for; -1: none. `chunk`: blocks pushed before the
/// planner is asked; 0: all of them.
inline Run run(const Machine& machine, const std::vector<Block>& blocks, int stop_after = -1,
               std::size_t chunk = 1, double feed_override = 1) {
  Run result;
  Diagnostics diagnostics;
  ipo::Planner planner(machine, feed_override, diagnostics);
  ipo::BlockQueue queue(10 * machine.control.period);
  ipo::Interpolator interpolator(queue, machine.control);
  Verifier verifier(machine);
  std::size_t next = 0;
  bool exhausted = false;
  const auto push = [&](ipo::TimedBlock timed) {
    timed.profile.for_each_piece(
        [&](Limit limit, double duration) { result.time_by_limit[limit] += duration; });
    queue.push(std::move(timed));
  };
  const auto pump = [&] {
    if (auto timed = planner.pop()) {
      push(std::move(*timed));
      return;
    }
    if (next == blocks.size()) {
      exhausted = exhausted || next == blocks.size();
      planner.finish();
      while (auto timed = planner.pop()) push(std::move(*timed));
      return;
    }
    const std::size_t end = chunk == 0 ? blocks.size() : std::min(blocks.size(), next + chunk);
    while (next < end) planner.push(blocks[next++]);
  };
  bool stopped = false;
  while (true) {
    queue.trim();
    while (!exhausted && queue.t_end() <= interpolator.needs_until()) pump();
    if (stop_after >= 0 && !stopped && static_cast<int>(result.rows.size()) > stop_after) {
      stopped = true;
      while (!exhausted) pump();
      if (!queue.empty()) {
        const ipo::Constraints constraints(machine, feed_override);
        const ipo::State now = interpolator.state();
        for (auto& timed : ipo::plan_stop(constraints, queue.take_rest(), now, interpolator.time()))
          queue.push(std::move(timed));
        interpolator.replanned();
      }
    }
    const auto setpoint = interpolator.step();
    if (!setpoint) break;
    std::vector<Stretch> stretches;
    queue.for_each_recent([&](const ipo::TimedBlock& timed) {
      if (const Move* move = timed.move()) stretches.push_back({&move->path, timed.s_start});
    });
    verifier.row(*setpoint, stretches);
    result.rows.push_back(*setpoint);
  }
  verifier.finish();
  result.measured = verifier.measured();
  result.time = queue.t_end();
  result.counts = planner.counts();
  for (const Diagnostic& d : diagnostics.all()) result.diagnostics.push_back(d);
  return result;
}

/// Third differences round more: how far they may exceed.
inline constexpr double kJerkShare = 5e-3;

/// Empty if every row keeps velocity, acceleration (both to `share`), the chord tolerance and the
/// path; otherwise what is exceeded.
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
  if (run.measured.chord_error > machine.control.chord_tolerance)
    return "chord error " + std::to_string(run.measured.chord_error * 1e3) + " um";
  if (run.measured.path_deviation > 1e-9)
    return "path deviation " + std::to_string(run.measured.path_deviation);
  return {};
}

}  // namespace softcnc::test
