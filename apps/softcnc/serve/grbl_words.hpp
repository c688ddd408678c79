// SPDX-License-Identifier: MIT
// What a line says to the protocol, before it is read as a part program.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace softcnc::app {

/// A letter, in upper case, and its number.
struct GrblWord {
  char letter;
  double number;
};

/// Words, and whether nothing else stands between them, as expressions do.
struct GrblWords {
  std::vector<GrblWord> words;
  bool is_all = true;
};
/// Reads a text in upper case, without blanks and comments.
GrblWords read_words(std::string_view text);
/// Returns the words of a line, without comments; expressions are left out.
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
