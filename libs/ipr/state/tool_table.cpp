// SPDX-License-Identifier: MIT
// Rows that G10 has made go before the tools of the machine file.
#include "ipr/state/tool_table.hpp"

namespace softcnc::ipr {

std::optional<ToolOffset> ToolTable::find(int number) const {
  if (const auto found = state.tools.find(number); found != state.tools.end()) return found->second;
  ToolOffset tool;
  if (const auto found = machine.tools.find(number); found != machine.tools.end()) {
    tool.radius = found->second.radius;
    return tool;
  }
  const bool any_number = is_fanuc_like(dialect) || number == 0;
  if (any_number || (state.tools.empty() && machine.tools.empty())) return tool;
  return std::nullopt;
}

ToolOffset& ToolTable::row(int number) const {
  return state.tools.try_emplace(number, find(number).value_or(ToolOffset{})).first->second;
}

std::optional<double> ToolTable::radius(int number) const {
  const auto kept = state.tools.find(number);
  const bool has_row = kept != state.tools.end();
  const double wear = has_row ? kept->second.radius_wear : 0;
  if (has_row && kept->second.radius != 0) return kept->second.radius + wear;
  if (const auto known = machine.tools.find(number); known != machine.tools.end())
    return known->second.radius + wear;
  return has_row ? std::optional(wear) : std::nullopt;
}

}  // namespace softcnc::ipr
