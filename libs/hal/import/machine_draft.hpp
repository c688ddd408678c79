// SPDX-License-Identifier: MIT
// A machine file in the making: values, each with the setting that it comes from.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/import/import_machine.hpp"
#include "hal/machine/machine_loader.hpp"

namespace softcnc::hal {

class MachineDraft {
 public:
  /// Files that settings name are read where they lie below `folder`, that of the settings, or
  /// below an allowed one.
  MachineDraft(std::string folder, std::vector<std::string> allowed)
      : folder_(std::move(folder)), allowed_(std::move(allowed)) {}

  /// Reads a file that settings name, which must be a regular one: nobody waits for a pipe that a
  /// person has not named. What lies outside the folder of the settings is not quoted. Errors:
  /// SC7037.
  Result<std::string> read_named_file(const std::string& file);

  /// Takes over a value, as a machine file spells it, which `from` gives; a comment says so.
  void set(const std::string& key, std::string value, const GivenAt& from);
  void set(const std::string& key, double value, const GivenAt& from);
  /// Sets a value that no setting gives; the comment says why.
  void choose(const std::string& key, std::string value, std::string why);
  bool has(const std::string& key) const { return known_.contains(key); }

  /// Lists a setting among those that have no key.
  void leave(const GivenAt& from, std::string_view why = {});
  /// Adds a line to that list.
  void leave(std::string line) { left_.push_back(std::move(line)); }
  void fail(Code code, const GivenAt& at, std::string message);
  void warn(Code code, const GivenAt& at, std::string message);
  bool is_good() const noexcept { return errors_.empty(); }

  MachineState& state() noexcept { return state_; }

  /// Returns the machine file, or all errors. `made_from` is its first line.
  tl::expected<ImportedMachine, std::vector<Diagnostic>> finish(const std::string& file,
                                                                const std::string& made_from);

 private:
  struct Value {
    std::string key, value, comment;
    std::optional<GivenAt> from;
  };

  Diagnostic diagnostic(Code code, const GivenAt& at, std::string message) const;
  void add(Value value);
  void add_missing_limits();
  std::string text(const std::string& made_from);

  std::string folder_;
  std::vector<std::string> allowed_;
  std::set<std::string> unquoted_;  // files
  std::vector<Value> values_;
  std::set<std::string> known_;
  std::vector<std::string> left_;
  std::vector<Diagnostic> errors_, notes_;
  std::map<int, GivenAt> places_;  // by line of the text
  MachineState state_;
};

/// Returns where a part of a line is; `line` is the whole of it.
GivenAt place_of(const std::string& file, int number, const std::string& line,
                 std::string_view part);

/// Returns a number if the text is one, with a sign or without; nothing for what is not finite.
std::optional<double> setting_number(std::string_view text);

/// Returns the text without blanks around it.
std::string_view trimmed_setting(std::string_view text);

/// Returns the lines of a text, without their ends.
std::vector<std::string> setting_lines(std::string_view text);

}  // namespace softcnc::hal
