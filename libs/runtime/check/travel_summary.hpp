// SPDX-License-Identifier: MIT
// Moves beyond the travel: one error for each end of an axis, with the work offset that would fit.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"
#include "runtime/check/travel_survey.hpp"

namespace softcnc::runtime {

/// A program that has been read from a state of the machine.
struct TravelReading {
  MachineState before = {}, after = {};
  TravelSurvey survey = {};
  bool good = false;         // nothing is wrong with it
  bool only_travel = false;  // nothing but its travel is
};

/// Reads the program again from a state.
using ReadFrom = std::function<TravelReading(const MachineState&)>;

/// Holds back SC4001, which a program that lies beside the travel has on every line.
class TravelSummary {
 public:
  /// Everything else goes on to `further`, which must outlive this; SC4001 too unless `holds`.
  TravelSummary(Diagnostics& further, bool holds) : further_(further), holds_(holds) {}

  Diagnostics::Sink sink();

  /// Reports what was held back: at the first line of each end of travel, how far the program goes
  /// beyond it and on how many lines. Where the work systems can lie so that all of the program
  /// fits, which reading it from there has to show, the advice names the origins that do; where the
  /// program is longer than the travel, it says so.
  /// `state` is that before the program.
  void report(const MachineState& state, const Machine& machine, const ReadFrom& read);

 private:
  struct Held {
    Diagnostic first;
    std::int64_t lines = 0;
  };

  Diagnostics& further_;
  bool holds_;
  std::array<std::optional<Held>, std::size_t{2 * kAxes}> held_;  // by end of travel
};

}  // namespace softcnc::runtime
