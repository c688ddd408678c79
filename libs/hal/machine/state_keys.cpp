// SPDX-License-Identifier: MIT
#include "hal/machine/state_keys.hpp"

#include "hal/machine/state_file.hpp"
#include "motion/core/utf8.hpp"

namespace softcnc::hal {

std::string global_name(std::string_view key) {
  std::string name;
  for (const char c : key)
    if (c != ' ' && c != '\t') name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const bool is_name = name.size() > 1 && name.front() == '_' && is_utf8(name) &&
                       name.find_first_of("<>#()\r\n") == std::string::npos;
  return is_name ? name : std::string();
}

std::string unknown_state_key(const std::string& path) {
  const bool parameter = path.starts_with("parameter.");
  return "unknown key '" + path + "'" +
         (parameter ? ": a parameter is a number from " + std::to_string(kFirstParameter) + " to " +
                          std::to_string(kLastParameter) +
                          ", or the name of a global variable, which begins with '_'"
                    : "");
}

}  // namespace softcnc::hal
