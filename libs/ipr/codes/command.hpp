// SPDX-License-Identifier: MIT
// The words of a line, sorted into codes and values.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "ipr/codes/gcode_table.hpp"
#include "ipr/expressions/dialect.hpp"
#include "ipr/interpreter/output.hpp"
#include "ipr/parser/parser.hpp"
#include "ipr/text/letter_set.hpp"

namespace softcnc::ipr {

/// The words that are not codes, by letter.
class Values {
 public:
  Letters letters() const noexcept { return letters_; }
  bool has(char letter) const noexcept { return letters_.has(letter); }
  /// Expects has(letter).
  const Word& word(char letter) const noexcept { return *words_[index(letter)]; }
  double operator[](char letter) const noexcept { return word(letter).value; }
  double value_or(char letter, double otherwise) const noexcept {
    return has(letter) ? word(letter).value : otherwise;
  }

 private:
  friend class Command;
  static std::size_t index(char letter) noexcept { return static_cast<std::size_t>(letter - 'A'); }

  Letters letters_;
  std::array<const Word*, 26> words_{};
};

class Command {
 public:
  struct CodeWord {
    const GCode* code;
    const Word* word;
  };

  /// Sorts the words; reports codes that are unknown or exclude each other, and words given twice.
  void read(const Line& line, Dialect dialect, Output& out);

  /// Adds the motion in force, if words of the line are meant for it.
  void add_modal_motion(const GCode& motion, const Word& word) { add(motion, word); }
  /// A word that no code takes has been told: it may have been meant for any that is missing.
  void doubt_missing() noexcept;
  /// It may be another motion that the line asks for.
  void doubt_motion() noexcept;
  /// Adds the codes that D and H are where no code of the line takes them.
  void add_lone_letters(Dialect dialect);

  const Values& values() const noexcept { return values_; }
  /// In the order in which they act.
  std::span<const CodeWord> codes() const noexcept { return {codes_.data(), count_}; }
  bool has(Group group) const noexcept { return groups_.has(group); }
  /// The code of a group; nullptr if the line has none.
  const GCode* find(Group group) const noexcept;
  /// Its word. Expects has(group).
  const Word& find_word(Group group) const noexcept;
  /// The G00 to G03 that stands before a cycle; nullptr if none does.
  const GCode* below_cycle() const noexcept { return below_cycle_; }
  /// Values that no code of the line takes.
  Letters unused(Dialect dialect) const noexcept;
  /// The words behind G65.
  std::span<const Word> arguments() const noexcept { return arguments_; }
  /// As of Line.
  std::string_view called() const noexcept { return called_; }
  /// What the line's own errors have made uncertain.
  Letters uncertain() const noexcept { return uncertain_; }
  /// What a word that no code of the line takes may have been meant for, once that is told.
  Letters missing() const noexcept { return missing_; }
  /// What of both holds for the lines behind as well.
  Letters lastingly_uncertain() const noexcept;
  /// Of which groups they leave open what is in force.
  Groups doubted() const noexcept { return doubted_; }
  /// Whether a word is given twice, and told: one of the two may be any other.
  bool doubled() const noexcept { return doubled_; }
  /// Groups of which the line has several codes, or not the one that is meant, and that is told.
  Groups contradicted() const noexcept { return contradicted_; }
  /// Whether it has a code that is unknown, and told: it may be another word of the line.
  bool has_unknown_code() const noexcept { return unknown_code_; }
  /// Whether one of them was a probing move.
  bool lost_touch() const noexcept { return lost_touch_; }
  /// Whether it has an unknown M code that may be M02 or M30 with one digit that is wrong, too many
  /// or missing, or is a number alone that may be such.
  bool may_be_end() const noexcept { return may_be_end_; }

 private:
  void read_code(const Word& word, Dialect dialect, Output& out);
  void read_value(const Word& word, Output& out);
  void look_at(std::span<const Word> words, Dialect dialect, Output& out);
  void read_arguments(std::span<const Word> words, Output& out);
  void check_program_number(const Line& line, Output& out);
  void add(const GCode& code, const Word& word);
  bool put_above(const GCode& cycle, const Word& word);
  Letters words_meant() const noexcept;
  void doubt(Groups groups) noexcept;
  void doubt_lost_codes(const Line& line) noexcept;

  Values values_;
  std::array<CodeWord, kGroups> codes_{};  // no group twice
  std::size_t count_ = 0;
  Groups groups_;
  bool calls_macro_ = false;
  const GCode* below_cycle_ = nullptr;
  std::span<const Word> arguments_;
  std::string_view called_;
  Letters uncertain_, missing_;
  Groups doubted_;
  Groups contradicted_;
  bool doubled_ = false, unknown_code_ = false;
  bool lost_touch_ = false;
  bool may_be_end_ = false;
  bool lost_all_ = false;          // of the line: nobody knows what its words are
  bool stands_for_value_ = false;  // a code so large that another letter may be meant
};

}  // namespace softcnc::ipr
