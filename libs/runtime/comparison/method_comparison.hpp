// SPDX-License-Identifier: MIT
// One interpolation method on one program and machine, at several sampling phases.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "runtime/comparison/spread.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

/// Returns all methods, in the order of their names.
constexpr auto all_methods() noexcept {
  std::array<Method, kMethodNames.size()> methods{};
  for (std::size_t i = 0; i < methods.size(); ++i) methods[i] = static_cast<Method>(i);
  return methods;
}

/// Runs a program by one method once for each of `phases` places, evenly spaced within the period:
/// in run k of n the first cutting move begins k/n of a period later than in run 0, which is the
/// run of the program as it is. So its first setpoint on the curve comes k/n of a step nearer to
/// the start of the curve, and with it all that follow. Two things are as they are in any run: a
/// machine that waits in a corner for the next setpoint (docs/feed.md) begins what follows at a
/// setpoint, and times are those of the motion without the delay. The runs go to the simulated
/// mill, or nowhere on a machine whose backend is `none`.
class MethodComparison {
 public:
  /// `program` must outlive it; it is read once for each phase. A method that does not fit the
  /// machine is an error() before the first run. Requires one phase or more.
  MethodComparison(Program& program, const Machine& machine, ChannelOptions options, Method method,
                   int phases);

  /// Does the next run. Returns false, and does nothing, after the last one, and after a run that
  /// did not come to its end. `watcher` may be null.
  bool run_next(Watcher* watcher);

  /// Returns the median and the worst of each of compared_figures() over the runs so far: nothing
  /// for a figure that means nothing, or nothing at all if a run did not come to its end.
  std::vector<std::optional<Spread>> spreads() const;
  /// Returns the first error of a run that did not come to its end; nothing if there is none. Its
  /// exit status says whether the method cannot run the program, or reading it has failed (5).
  const std::optional<Diagnostic>& error() const noexcept { return error_; }
  /// Returns the error as a text of one line, with its code; empty if there is none.
  std::string note() const;

 private:
  void run(Watcher* watcher, double delay, Outcome& outcome);

  Program& program_;
  Machine machine_;
  ChannelOptions options_;
  int phases_, next_ = 0;
  bool stopped_ = false;
  std::vector<std::vector<double>> values_;  // of each figure, run by run
  std::optional<Diagnostic> error_;
};

}  // namespace softcnc::runtime
