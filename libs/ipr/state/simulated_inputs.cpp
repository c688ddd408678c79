// SPDX-License-Identifier: MIT
#include "ipr/state/simulated_inputs.hpp"

#include <cstddef>

namespace softcnc::ipr {

InputChange SimulatedInputs::look_at(const std::string& name, const InputPort& port, int line) {
  double& value = values_.try_emplace(name, port.value).first->second;
  InputChange change{value, value, 0};
  int& taken = taken_[{name, line}];
  int skipped = 0;
  for (std::size_t i = 0; i < port.lines.size(); ++i) {
    if (port.lines[i] != line || skipped++ < taken) continue;
    ++taken;
    change.value = value = port.values[i];
    if (!port.after.empty()) change.after = port.after[i];
    break;
  }
  return change;
}

}  // namespace softcnc::ipr
