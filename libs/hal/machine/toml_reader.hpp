// SPDX-License-Identifier: MIT
// TOML as a flat list of named values, each with its place in the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/machine/machine_value.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// A value or a table of a TOML text. Tables come before what they contain.
struct TomlEntry {
  std::string path;  // "axis.x.blu_um"
  bool table = false;
  FileValue value;    // of a table: OtherTomlValue
  SourcePos key_pos;  // in bytes
  SourcePos value_pos;
};

/// Returns every table and value of `text`. Errors: SC7002 (no TOML), SC7012 (a key given twice),
/// SC7022 (nested deeper than kMaxTomlDepth).
Result<std::vector<TomlEntry>> read_toml(std::string_view text);

/// Returns one value as TOML spells it; what is not a TOML value is taken as a string.
FileValue read_toml_value(const std::string& text);

/// The lines of a text, found once, so that reading many of them does not search from its
/// beginning each time.
class TextLines {
 public:
  explicit TextLines(std::string_view text);

  /// Returns line `number` (from 1), without its end; an empty view if there is none. The view is
  /// valid as long as the text lives.
  std::string_view operator[](int number) const noexcept;

 private:
  std::string_view text_;
  std::vector<std::uint32_t> begins_;  // of each line
};

}  // namespace softcnc::hal
