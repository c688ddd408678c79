// SPDX-License-Identifier: MIT
// Variables that are set from outside, before the first line of a program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace softcnc::ipr {

/// A variable and its value: "_td" is #<_td>, "500" is #500.
struct Definition {
  std::string name;
  double value = 0;
};

/// Reads "NAME=VALUE". NAME is that of a global variable, which begins with '_', or a number, each
/// also as a program writes it: #<_td>, #500. As in programs, case and blanks of a name do not
/// count. VALUE is a finite number. Returns nothing for any other text.
std::optional<Definition> parse_definition(std::string_view text);

/// Returns the variable as a program writes it.
std::string shown_name(const Definition& definition);

}  // namespace softcnc::ipr
