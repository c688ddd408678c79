// SPDX-License-Identifier: MIT
// The machine file: TOML in, Machine out, or the place where it is wrong; and back to text.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/result.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// A machine, or all errors of its file, line by line, and then of the settings.
using MachineOrErrors = tl::expected<Machine, std::vector<Diagnostic>>;

/// Loads the machine of a TOML file with `settings` ("KEY=VALUE": a TOML value, else a string) on
/// top. An empty name means the built-in machine. A file that names any [axis.*] has exactly those
/// axes; a key that is absent keeps its default, except the limit along the path, which then is
/// none. The plant that it names is read from its folder, the one of a setting from the present
/// folder. Errors: the SC70xx codes, with line and column; those of settings in a file called
/// "--set". None is reported that follows from another; of a file that is not TOML only the first.
MachineOrErrors load_machine(const std::string& file, std::span<const std::string> settings);

/// The same for a text that is already in memory; `name` stands for the file in diagnostics. The
/// text contains its plant (SC7003).
MachineOrErrors parse_machine(const std::string& text, const std::string& name,
                              std::span<const std::string> settings);

/// The source of the machine of a program.
struct MachineSource {
  std::string file;       // empty: the built-in machine
  bool confined = false;  // found beside the program: nothing in it reaches outside softcnc
};

/// The machine of a program, and what was done to it.
struct FoundMachine {
  Machine machine;
  std::vector<Diagnostic> ignored;  // SC7021: keys of the file that are ignored
  bool default_file = false;        // the backend writes a file under a name that nobody has given
};

/// Loads a machine as load_machine() does, but a confined machine must be in a regular file
/// (SC7003). It keeps its backend, but files of backends and ports count only where settings name
/// them.
tl::expected<FoundMachine, std::vector<Diagnostic>> find_machine(
    const MachineSource& source, std::span<const std::string> settings);

/// One value of the machine as it will be used.
struct EffectiveValue {
  std::string key;      // "axis.x.blu_um"
  std::string value;    // as a machine file spells it: 2.5, "sim"
  std::string unit;     // "um"; empty where there is none
  std::string origin;   // "default", "mill.toml:3", "--set"
  std::string meaning;  // in a few words
};

/// Returns every value of the machine that load_machine() returns, in the order of the table.
/// Folders of subprograms are whole paths.
tl::expected<std::vector<EffectiveValue>, std::vector<Diagnostic>> effective_values(
    const std::string& file, std::span<const std::string> settings);

/// A value in which two machines differ, as a machine file spells it; empty where one has no such
/// key.
struct DifferingValue {
  std::string key, a, b;
};

/// Returns the values in which two machines differ, in the order of the table of keys; names of
/// files and devices are left out.
std::vector<DifferingValue> differing_values(const Machine& a, const Machine& b);

/// A complete TOML file. It loads back to the identical machine, bit for bit, for every machine
/// that load_machine() returns.
std::string machine_toml(const Machine& machine);

/// Returns the same file for a person: with a head, and with the meaning of each key above it if
/// `explained`. Folders of subprograms are whole paths in it, so that it may lie anywhere. What is
/// printed of the machine that it loads back to is the same text.
std::string readable_machine_toml(const Machine& machine, bool explained);

/// Returns the machine with whole paths of the folders of subprograms.
Machine with_whole_paths(Machine machine);

/// The table of keys in Markdown, as it stands in docs/machine.md.
std::string key_table();

}  // namespace softcnc::hal
