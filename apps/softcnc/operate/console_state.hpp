// SPDX-License-Identifier: MIT
// What the operator's console shows beside the machine: pages, what is typed, the program.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "operate/jog_keys.hpp"
#include "operate/line_editor.hpp"
#include "operate/loaded_program.hpp"

namespace softcnc::app {

enum class Page : std::uint8_t { main, keys, work, tools, found };

/// What is typed on the last row, and what for.
struct Prompt {
  enum class For : std::uint8_t { line, program, touch_off, probe, position, work, tool, tip };

  For what;
  std::string label;
};

/// The steps and feeds of jog keys.
inline constexpr std::array<double, 6> kJogSteps{0.001, 0.01, 0.1, 1, 10, 100};  // mm
inline constexpr std::array<double, 5> kJogFeeds{50, 200, 1000, 3000, 10000};    // mm/min

struct ConsoleState {
  Page page = Page::main;
  std::size_t selection = 0;  // row of a page
  std::optional<Prompt> prompt;
  std::size_t jog_step = 3, jog_feed = 2;  // indices
  std::optional<LoadedProgram> program;
  bool runs = false;  // the program, or it is held
  int line = 0;       // where it is
};

}  // namespace softcnc::app
