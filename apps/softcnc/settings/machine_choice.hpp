// SPDX-License-Identifier: MIT
// Which machine a part program runs on: the one that --machine names, the one beside the program,
// or the built-in one.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "hal/machine/machine_file.hpp"
#include "messages/messages.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// The machine file beside a part program, by hal::machine_beside(). Empty where that is the
/// program itself or the file that --state names, and for standard input.
std::string machine_beside(const std::string& part, const Options& options);

/// Returns where the machine of a part program comes from.
hal::MachineSource machine_source(const std::string& part, const Options& options);

/// Its machine, read and ready to run.
struct MachineChoice {
  Machine machine;
  std::string file_beside;  // empty: the machine is not that of a file beside the program
};

/// Loads the machine of a part program. Shows warnings, and all errors except the last one. Errors:
/// the SC70xx codes; SC6015 where a run would overwrite a file that the user has not named.
Result<MachineChoice> choose_machine(const std::string& part, const Options& options,
                                     Messages& messages);

/// The machines of several programs: each file is read, and its errors reported, once.
class MachineCache {
 public:
  MachineCache(const Options& options, Messages& messages)
      : options_(options), messages_(messages) {}

  /// Returns the machine of a part program; null where its file is wrong, which has been shown.
  const Machine* of(const std::string& part) { return of(machine_source(part, options_)); }
  /// Returns the machine of a source; null as above.
  const Machine* of(const hal::MachineSource& source);
  /// The exit status of the files that are wrong; 0: none is.
  int status() const noexcept { return status_; }

 private:
  std::optional<Machine> load(const hal::MachineSource& source);

  const Options& options_;
  Messages& messages_;
  std::map<std::string, std::optional<Machine>> machines_;  // by file
  std::set<std::string> reported_;                          // what is wrong with settings
  int status_ = 0;
};

}  // namespace softcnc::app
