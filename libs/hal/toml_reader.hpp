// SPDX-License-Identifier: MIT
// TOML as a flat list of named values, each with its place in the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hal/machine_value.hpp"
#include "motion/result.hpp"

namespace softcnc::hal {

/// A value or a table of a TOML text. Tables come before what they contain.
struct TomlEntry {
  std::string path;  // "axis.x.blu_um"
  bool table = false;
  FileValue value;    // of a table: OtherValue
  SourcePos key_pos;  // in bytes
  SourcePos value_pos;
};

/// Every table and value of `text`. Errors: SC7002 (no TOML), SC7012 (a key given twice).
Result<std::vector<TomlEntry>> read_toml(std::string_view text);

/// One value as TOML spells it; what is no TOML value is taken as a string.
FileValue read_toml_value(const std::string& text);

/// Line `line` (from 1) of a text, without its end.
std::string text_line(std::string_view text, int line);

}  // namespace softcnc::hal
