// SPDX-License-Identifier: MIT
// Values between the text of a machine file and the Machine.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
using FileValue = std::variant<double, std::int64_t, std::string, std::vector<double>,
                               std::vector<std::string>, NumberRows, OtherTomlValue>;

/// Returns a number, whole or not; nothing if the value is none.
std::optional<double> as_number(const FileValue& value);

/// Returns words in quotes, with commas between; an empty one cannot be given, and is left out.
std::string quoted_words(std::span<const std::string_view> words);

/// Returns an error whose place is left to the caller.
Status value_failure(Code code, std::string message);

/// The number of errors after which nothing more is reported of a machine or state file: each of
/// them keeps its line, and a hostile file may have millions.
inline constexpr std::size_t kMostErrors = 1000;

/// Checks `value` against type and range of the key and stores it in internal units.
/// Errors: SC7004, SC7005, SC7006, SC7009, SC7030, SC7052; their place is left to the caller.
Status assign(const KeyRef& ref, const FileValue& value, Machine& machine);

/// Returns what the key takes, in words: "greater than 0 and at most 1000".
std::string allowed_text(const MachineKey& key);

/// The value as a machine file spells it; assign() of what that reads as stores the same bits. The
/// machine stays as it is.
std::string value_text(const KeyRef& ref, Machine& machine);

}  // namespace softcnc::hal
