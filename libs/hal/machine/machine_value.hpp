// SPDX-License-Identifier: MIT
// Values between the text of a machine file and the Machine.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "hal/machine/machine_keys.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// A value that no key takes, by the name of its type: "a date", "a table".
struct OtherTomlValue {
  std::string_view type;
};
using NumberRows = std::vector<std::vector<double>>;
using FileValue = std::variant<double, std::int64_t, std::string, std::vector<double>, NumberRows,
                               OtherTomlValue>;

/// The number of errors after which nothing more is reported of a machine or state file: each of
/// them keeps its line, and a hostile file may have millions.
inline constexpr std::size_t kMostErrors = 1000;

/// Checks `value` against type and range of the key and stores it in internal units.
/// Errors: SC7004, SC7005, SC7006, SC7009, SC7052; their place is left to the caller.
Status assign(const KeyRef& ref, const FileValue& value, Machine& machine);

/// Returns what the key takes, in words: "greater than 0 and at most 1000".
std::string allowed_text(const MachineKey& key);

/// The value as a machine file spells it; assign() of what that reads as stores the same bits. The
/// machine stays as it is.
std::string value_text(const KeyRef& ref, Machine& machine);

}  // namespace softcnc::hal
