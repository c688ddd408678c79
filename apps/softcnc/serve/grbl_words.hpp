// SPDX-License-Identifier: MIT
// What a line says to the protocol, before it is read as a part program.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace softcnc::app {

/// The words of a line, without comments: letters and numbers. Expressions are left out.
struct GrblWord {
  char letter;  // upper case
  double number;
};
std::vector<GrblWord> grbl_words(std::string_view line);

/// Returns whether a line has nothing to run: blanks, comments, '%'.
bool is_blank(std::string_view line);
/// Returns whether the answer to a line waits until all motion before it has ended, as grbl's does.
bool waits_for_motion(const std::vector<GrblWord>& words);
/// Returns whether it sets or chooses a work offset or a tool length.
bool sets_offset(const std::vector<GrblWord>& words);
/// Returns whether it probes; and whether it ends a program.
bool probes(const std::vector<GrblWord>& words);
bool ends_program(const std::vector<GrblWord>& words);

}  // namespace softcnc::app
