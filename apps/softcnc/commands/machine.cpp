// SPDX-License-Identifier: MIT
// `softcnc machine`: the effective machine, each value with where it came from.
#include <fmt/format.h>

#include <algorithm>

#include "commands/commands.hpp"
#include "hal/machine/machine_file.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"

namespace softcnc::app {

int machine(const Options& options) {
  const auto values = hal::effective_values(options.machine_file, options.settings);
  if (!values) return failed(values.error());
  const auto widest = [&](std::string hal::EffectiveValue::*column) {
    std::size_t width = 0;
    for (const auto& value : *values) width = std::max(width, (value.*column).size());
    return width;
  };
  using Value = hal::EffectiveValue;
  const std::size_t key = widest(&Value::key), text = widest(&Value::value),
                    unit = widest(&Value::unit), origin = widest(&Value::origin);
  StandardOutput out;
  for (const auto& value : *values) {
    std::string line = fmt::format("{:<{}} = {:<{}}  {:<{}}  {:<{}}", value.key, key, value.value,
                                   text, value.unit, unit, value.origin, origin);
    if (options.verbose) line += "  " + value.meaning;
    line.erase(line.find_last_not_of(' ') + 1);
    out.write(line + '\n');
  }
  return out.finish();
}

}  // namespace softcnc::app
