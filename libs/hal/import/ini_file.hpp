// SPDX-License-Identifier: MIT
// LinuxCNC's configuration files (.ini) as sections of variables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hal/import/machine_draft.hpp"

namespace softcnc::hal {

/// A variable; `at` is the place of its value.
struct IniVariable {
  std::string section, name, value;
  GivenAt at;
  bool used = false;
};

/// The variables of a configuration, as LinuxCNC's manual describes the file ("INI Configuration"):
/// comments are lines that begin with '#' or ';', a line that ends in '\\' goes on in the next, and
/// of a variable that is given twice the first counts.
class IniFile {
 public:
  /// Reads a text, with the files that its lines "#INCLUDE NAME" name, which are looked for in the
  /// folder of `file`. Reports to `draft`: SC7034; SC7037 where such a file cannot be read.
  IniFile(std::string_view text, const std::string& file, MachineDraft& draft);

  /// Returns the variable, which counts as used; nullptr if there is none. Reports further ones of
  /// its name (SC7036).
  const IniVariable* find(std::string_view section, std::string_view name);
  /// Returns its value as a number; nothing if there is none, or if it is wrong, which is reported
  /// (SC7035). A comment after the number is passed over.
  struct Number {
    double value = 0;
    GivenAt at;
  };
  std::optional<Number> number(std::string_view section, std::string_view name);
  bool has_section(std::string_view section) const;

  const std::vector<IniVariable>& variables() const noexcept { return variables_; }

 private:
  void read(std::string_view text, const std::string& file, bool included);
  void include(std::string_view name, const GivenAt& at, const std::string& from);
  void take(const std::string& line, int number, const std::string& file);

  MachineDraft& draft_;
  std::string section_;
  std::vector<IniVariable> variables_;
};

/// Returns a file name as one of another file's folder has it; a whole path stays.
std::string beside_file(const std::string& file, const std::string& name);

}  // namespace softcnc::hal
