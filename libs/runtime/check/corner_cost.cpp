// SPDX-License-Identifier: MIT
#include "runtime/check/corner_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "motion/core/units.hpp"
#include "runtime/check/planned_times.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kMuch = 0.1;                   // of the time
constexpr double kTolerances[] = {0.01, 0.05};  // mm, tried in this order

/// As under G64 P: what has a tolerance already keeps it.
void round_corners(Block& block, double tolerance) {
  Move* move = std::get_if<Move>(&block.what);
  if (move == nullptr || move->corner_tolerance > 0) return;
  move->path_mode = PathMode::follow;
  move->corner_tolerance = tolerance;
  move->chord_tolerance = std::max(move->chord_tolerance, tolerance);
}

/// What a person reads of 0.0123, 4.56 and 691.2 s.
std::string seconds_text(double seconds) {
  constexpr double kManySeconds = 100;
  return seconds < kManySeconds ? fmt::format("{:.3g} s", seconds)
                                : fmt::format("{:.1f} s", seconds);
}

bool asks_for_exact_path(const CornerRests& rests) {
  return rests.exact_seconds > 0.5 * rests.roundable_seconds;
}

/// The codes and keys that round corners.
std::string remedy(double tolerance, bool exact) {
  const std::string g64 = fmt::format("G64 P{:.6g} (mm)", tolerance);
  if (exact) return g64;
  return g64 + fmt::format(" or control.corner_tolerance_um = {:.6g}", um_from_mm(tolerance));
}

class CornerJudge {
 public:
  CornerJudge(const ChannelOptions& options, const Outcome& outcome, Diagnostics& diagnostics)
      : options_(options), outcome_(outcome), diagnostics_(diagnostics) {}

  /// Whether rounding may win back a tenth of the time.
  bool is_worth_a_plan(const Machine& machine) const {
    const Method method = machine.control.interpolation;
    return !options_.single_block && !is_by_pulses(method) && !ignores_plan(method) &&
           is_much(rests().roundable_seconds);
  }

  std::optional<CornerCost> plan_again(Program& program, const Machine& machine,
                                       Watcher* watcher) const {
    for (const double tolerance : kTolerances) {
      const auto rounded =
          plan_times(program, machine, options_, watcher,
                     [tolerance](Block& block) { round_corners(block, tolerance); });
      if (!rounded) return std::nullopt;
      const double won = outcome_.time - rounded->time;
      const auto fewer = rests().count - rounded->rests;
      if (is_much(won) && fewer > 0) return CornerCost{fewer, won, tolerance};
    }
    return std::nullopt;
  }

  void report(const CornerCost& cost, std::string_view about) const {
    const bool exact = asks_for_exact_path(rests());
    diagnostics_.report(
        exact ? Code::SC4031 : Code::SC4030, {},
        fmt::format("{} rests at corners{} cost {}{}, {:.0f} % of the time; {} would save {}",
                    cost.rests, exact ? ", which must stay sharp," : "", about,
                    seconds_text(cost.seconds), 100 * cost.seconds / outcome_.time,
                    remedy(cost.tolerance, exact), about.empty() ? "that" : "most of that"));
  }

  const CornerRests& rests() const { return outcome_.time_sheet.corners; }

 private:
  bool is_much(double seconds) const { return seconds > kMuch * outcome_.time; }

  const ChannelOptions& options_;
  const Outcome& outcome_;
  Diagnostics& diagnostics_;
};

}  // namespace

void report_corner_cost(Program& program, const Machine& machine, const ChannelOptions& options,
                        Outcome& outcome, Watcher* watcher, Diagnostics& diagnostics) {
  const CornerJudge judge(options, outcome, diagnostics);
  if (!judge.is_worth_a_plan(machine)) return;
  if (program.streamed() || !options.events.empty())
    return judge.report({judge.rests().count, judge.rests().roundable_seconds, kTolerances[0]},
                        "about ");
  outcome.time_sheet.corner_cost = judge.plan_again(program, machine, watcher);
  if (outcome.time_sheet.corner_cost) judge.report(*outcome.time_sheet.corner_cost, "");
}

}  // namespace softcnc::runtime
