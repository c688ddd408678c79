// SPDX-License-Identifier: MIT
// The inputs of a machine, as a program finds them in simulation.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "motion/model/machine_code.hpp"

namespace softcnc::ipr {

/// How an input changes while an M66 looks at it.
struct InputChange {
  double before = 0;  // the value when the M66 begins
  double value = 0;   // the value after the change
  double after = 0;   // s after the beginning
};

/// Where the inputs are in the tables of their values (InputPort).
class SimulatedInputs {
 public:
  /// Takes the next entry for `line` from the table of an input. Without an entry the input keeps
  /// its value.
  InputChange look_at(const std::string& name, const InputPort& port, int line);

 private:
  std::map<std::string, double> values_;              // once they have been looked at
  std::map<std::pair<std::string, int>, int> taken_;  // entries, by input and line
};

}  // namespace softcnc::ipr
