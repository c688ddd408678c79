// SPDX-License-Identifier: MIT
// What a program would gain on a machine whose axes could do more.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "job/job.hpp"
#include "job/terminal.hpp"

namespace softcnc::app {

/// The time with one limit of one axis raised.
struct RaisedLimit {
  std::string axis;   // "x"
  std::string limit;  // "velocity", "acceleration", "jerk"
  double time = 0;    // s
};

struct WhatIf {
  static constexpr double kFactor = 1.5;

  double time = 0;                   // s, with the limits as they are
  std::vector<RaisedLimit> changes;  // the one that wins most first
};

/// Plans the program again for each limit of each axis, raised by half. Nothing where the program
/// has errors or the run is stopped.
std::optional<WhatIf> what_if(Job& job, Terminal& terminal);

nlohmann::ordered_json what_if_json(const WhatIf& what_if);

/// Lines for a terminal, without a newline at the end.
std::string what_if_text(const WhatIf& what_if);

}  // namespace softcnc::app
