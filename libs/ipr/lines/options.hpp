// SPDX-License-Identifier: MIT
// How a program is to be read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "ipr/expressions/definition.hpp"
#include "ipr/expressions/dialect.hpp"
#include "ipr/text/called_texts.hpp"
#include "motion/core/axes.hpp"

namespace softcnc::ipr {

/// The language of a program: G-code, or the commands of paper 003; automatic: by its text.
enum class Format : std::uint8_t { automatic, gcode, commands };
inline constexpr std::array<std::string_view, 3> kFormatNames{"auto", "gcode", "commands"};
constexpr std::string_view name(Format format) noexcept {
  return kFormatNames[static_cast<std::size_t>(format)];
}

struct Memory;

/// Where the contacts of probing moves come from: the machine file; the same, though the machine
/// will read them; the machine, which is waited for.
enum class Contacts : std::uint8_t { stated, expected, read };

/// The choices of a user about the reading of a program.
struct InterpreterOptions {
  bool block_skip = false;     // leave out lines that begin with '/'
  bool optional_stop = false;  // M01 stops
  Dialect dialect = Dialect::linuxcnc;
  bool guess_dialect = false;  // choose the dialect by the text; `dialect` where that shows none
  Format format = Format::automatic;
  bool compare_dialects = false;  // warn where a line means something else in the other one
  bool unreachable_too = false;   // read lines that are never run as well, for their errors
  std::string folder = {};        // of the program, with files that it calls; empty: it has none
  std::vector<std::string> subprogram_folders = {};  // next, before those of the machine
  std::vector<Definition> definitions = {};          // of variables, before the first line
  CalledTexts* called = nullptr;  // where their texts are kept; must outlive the interpreter
  std::stop_token stop = {};      // to read no further: waiting() then
  Contacts contacts = Contacts::stated;
  bool remembers = false;  // Interpreter::memory() is asked for
  /// What earlier lines have left, in place of the initial modes; it counts while the interpreter
  /// is made, and begins at its own place.
  const Memory* memory = nullptr;
};

}  // namespace softcnc::ipr
