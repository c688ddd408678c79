// SPDX-License-Identifier: MIT
// What the screen of an operator shows.
#pragma once

#include <string>
#include <vector>

#include "operate/attended_machine.hpp"
#include "operate/console_state.hpp"
#include "operate/journal.hpp"
#include "operate/requests.hpp"
#include "operate/screen.hpp"

namespace softcnc::app {

/// All that is shown.
struct ConsoleView {
  const ConsoleState& state;
  const AttendedMachine& machine;
  const Requests& requests;
  const Journal& journal;
  const LineEditor& editor;  // of the prompt
};

/// Draws the present page, on a screen of any size: the most important rows first.
void draw_console(Screen& screen, const ConsoleView& view);

// Rows of the other pages, each between `first` and `end`.
void draw_keys(Screen& screen, int first, int end);
void draw_work(Screen& screen, int first, int end, const ConsoleView& view);
void draw_tools(Screen& screen, int first, int end, const ConsoleView& view);
void draw_found(Screen& screen, int first, int end, const ConsoleView& view);

/// Returns what the operator can do now that is not obvious; empty: nothing.
std::string advice(const ConsoleView& view);
/// Returns what is known of the loaded program; empty where none is loaded.
std::string program_summary(const ConsoleView& view);
/// Returns the lines about feed, spindle, program and jog keys.
std::vector<std::string> status_rows(const ConsoleView& view);

/// Returns the last row of a page that can be selected.
std::size_t last_row(const ConsoleState& state, const AttendedMachine& machine);
/// Returns the unit of lines that are typed: "mm" or "inch".
std::string unit_text(const AttendedMachine& machine);
/// "G54"
std::string work_system_name(std::size_t index);
/// Returns the numbers of the tools that machine and state know, in their order.
std::vector<int> known_tools(const Machine& machine, const MachineState& state);
/// "T3 ball nose 6 mm"
std::string tool_text(const Machine& machine, int number);

}  // namespace softcnc::app
