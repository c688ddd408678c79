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

inline constexpr double kReturnNumber = 99;  // of M99, as a word has it

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
    // FANUC; `label` is the number of the loop
    go_to,       // value: the line number N; not taken where has_condition and condition is false
    loop_begin,  // WHILE [..] DO m, or DO m alone
    loop_end,    // END m
  };

  Kind kind = Kind::none;
  std::string label;
  bool label_computed = false;  // by #.. or [..]
  double value = 0;        // condition, number of rounds, line number, or what return gives back
  bool has_value = false;  // return and endsub may go without
  bool condition = true;   // of IF [..] GOTO and WHILE [..] DO
  bool unknown = false;    // value, condition or an argument is unknown after an error
  std::vector<double> arguments;  // of call
  SourcePos pos;                  // from O or the keyword to its end
};

using StatementKind = Statement::Kind;

}  // namespace softcnc::ipr
