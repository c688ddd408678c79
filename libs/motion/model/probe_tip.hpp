// SPDX-License-Identifier: MIT
// What a machine probes with, and what its probe touches in simulation.
#pragma once

#include <optional>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc {

/// Returns the end of the tool in the spindle, or of the probe, which is there where the machine
/// file has no such tool.
inline ProbeTip probe_tip(const Machine& machine, std::optional<int> loaded_tool) {
  const auto tool = machine.tools.find(loaded_tool.value_or(0));
  return tool == machine.tools.end() ? ProbeTip{machine.probe.radius, 0}
                                     : ProbeTip{tool->second.radius, tool->second.length};
}

inline std::vector<ContactBody> contact_bodies(const Machine& machine) {
  std::vector<ContactBody> bodies;
  for (const auto& [name, body] : machine.contacts) bodies.push_back(body);
  return bodies;
}

}  // namespace softcnc
