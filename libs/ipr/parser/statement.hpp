// SPDX-License-Identifier: MIT
// What a line says about the order of lines: an O-word of RS274, or IF, WHILE, GOTO of FANUC
// macros.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

struct Statement {
  enum class Kind : std::uint8_t {
    none,
    // O-words; `label` is "100" or the name within o<...>, in lower case and without blanks
    program,  // O1000 alone: the beginning of a program
    sub,
    end_sub,
    call,
    leave_sub,  // return
    if_begin,
    else_if,
    else_begin,
    if_end,
    while_begin,  // or the end of a do loop
    while_end,
    do_begin,
    repeat_begin,
    repeat_end,
    next_round,  // continue
    leave_loop,  // break
    misspelt,    // a label, and no keyword that there is, or a label with unknown characters
    // FANUC; `label` is the number of the loop
    go_to,         // value: the line number N; not taken where has_condition and condition is false
    loop_begin,    // WHILE [..] DO m, or DO m alone
    loop_end,      // END m
    misspelt_end,  // what END m may have been meant by
  };

  Kind kind = Kind::none;
  std::string label;
  std::string label_meant;      // of a misspelt one: `1` in `o1 0epeat`, `ramp` in `o3ramp>`
  bool label_computed = false;  // by #.. or [..]
  double value = 0;        // condition, number of rounds, line number, or what return gives back
  bool has_value = false;  // return and endsub may go without
  bool condition = true;   // of IF [..] GOTO and WHILE [..] DO
  bool uncertain = false;  // value, condition or an argument is unknown after an error
  std::vector<double> arguments;  // of call
  SourcePos pos;                  // from O or the keyword to its end
};

/// Whether one label may have been meant for the other: an unknown character in it stands for one
/// of that, or for none.
bool may_mean(std::string_view strange, std::string_view label) noexcept;
/// Whether a word in lower case stands in a line, before its comments.
bool names(std::string_view line, std::string_view word) noexcept;
/// Whether it is ` sub` or `R200 sub`: the word alone, or behind one other.
bool names_sub_alone(std::string_view line) noexcept;
/// Whether it is misspelt, and may have been meant for this label.
bool may_be_of(const Statement& statement, std::string_view label) noexcept;

}  // namespace softcnc::ipr
