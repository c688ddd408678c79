// SPDX-License-Identifier: MIT
// The words of a line, sorted into codes and values.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "ipr/codes/axis_letters.hpp"
#include "ipr/codes/gcode.hpp"
#include "ipr/expressions/dialect.hpp"
#include "ipr/lines/output.hpp"
#include "ipr/parser/parser.hpp"
#include "ipr/state/unknown.hpp"
#include "ipr/text/letter_set.hpp"

namespace softcnc::ipr {

/// The words of a line that are not codes, by letter.
class Values {
 public:
  LetterSet letters() const noexcept { return letters_; }
  bool has(char letter) const noexcept { return letters_.has(letter); }
  /// Returns the word with this letter. Requires has(letter).
  const Word& word(char letter) const noexcept { return *words_[index(letter)]; }
  double operator[](char letter) const noexcept { return word(letter).value; }
  double value_or(char letter, double otherwise) const noexcept {
    return has(letter) ? word(letter).value : otherwise;
  }

 private:
  friend class Command;
  static std::size_t index(char letter) noexcept { return static_cast<std::size_t>(letter - '@'); }

  LetterSet letters_;
  std::array<const Word*, 32> words_{};
};

class Command {
 public:
  struct CodeWord {
    const GCode* code;
    const Word* word;
  };

  /// Sets the rows of the machine's M codes, which must outlive the command.
  void set_machine_codes(std::span<const GCode> codes) noexcept { machine_codes_ = codes; }

  /// Sorts the words of a line. Reports codes that are unknown or exclude each other, and words
  /// given twice.
  void read(const ProgramLine& line, Dialect dialect, Output& out);

  /// Adds the motion in force, for words of the line that are meant for it.
  void add_modal_motion(const GCode& motion, const Word& word) { add(motion, word); }
  /// Adds D and H as codes of their own where no code of the line takes them.
  void add_lone_letters(Dialect dialect);

  const Values& values() const noexcept { return values_; }
  /// Returns the codes in the order in which they act.
  std::span<const CodeWord> codes() const noexcept { return {codes_.data(), count_}; }
  bool has(Group group) const noexcept { return groups_.has(group); }
  /// Returns the code of a group, or nullptr if the line has none.
  const GCode* find(Group group) const noexcept;
  /// Returns the word of the code of a group. Requires has(group).
  const Word& find_word(Group group) const noexcept;
  /// Returns the code of G00 to G03 that stands before a cycle on the line, or nullptr if none
  /// does.
  const GCode* below_cycle() const noexcept { return below_cycle_; }
  /// Returns the letters of the values that no code of the line takes.
  LetterSet unused(Dialect dialect) const noexcept;
  /// Returns the words after G65.
  std::span<const Word> arguments() const noexcept { return arguments_; }
  /// Returns ProgramLine::called.
  std::string_view called() const noexcept { return called_; }
  /// Returns ProgramLine::corner.
  const Word* corner() const noexcept { return corner_; }
  /// Returns the letters of the words whose value is unknown: they could not be read, or are given
  /// twice.
  LetterSet unread() const noexcept { return unread_; }
  /// Returns the parts of the state that the errors of the line's words have left open.
  Unknown unknown() const noexcept { return unknown_; }
  /// Returns whether one of the codes was a probing move.
  bool probes() const noexcept { return probes_; }

  /// Returns whether the line has @ or ^, and the word; nullptr if it has only the other.
  bool has_polar_words() const noexcept { return polar_; }
  const Word* polar_word(char letter) const noexcept { return polar_words_[letter == '@' ? 0 : 1]; }
  /// Puts words with the letters of the plane in the place of @ and ^; their values are set later.
  void replace_polar_words(const PlaneAxes& axes);
  /// Makes the ends unknown to which @ and ^ would lead.
  void lose_polar_words();
  /// Gives the word of an axis another value; adds it, with the place of `like`, if there is none.
  void set_axis(int axis, double value, const Word& like);

 private:
  void read_code(const Word& word, Dialect dialect, Output& out);
  void report_unknown(const Word& word, std::string_view dialect, Output& out);
  void read_value(const Word& word, Output& out);
  void read_arguments(std::span<const Word> words, Output& out);
  void check_program_number(const ProgramLine& line, Output& out);
  void take_polar_words();
  void add(const GCode& code, const Word& word);
  bool put_above(const GCode& cycle, const Word& word);

  std::span<const GCode> machine_codes_;
  std::span<const Word> words_;  // of the line
  Values values_;
  std::array<CodeWord, kGroups> codes_{};  // no group twice
  std::size_t count_ = 0;
  Groups groups_;
  bool calls_macro_ = false;
  const GCode* below_cycle_ = nullptr;
  std::span<const Word> arguments_;
  std::string_view called_;
  const Word* corner_ = nullptr;
  LetterSet unread_;
  Unknown unknown_;
  bool probes_ = false;
  bool polar_ = false;
  std::array<const Word*, 2> polar_words_{};  // @, ^
  std::array<Word, 3> axis_words_{};          // by axis: those of set_axis()
};

}  // namespace softcnc::ipr
