// SPDX-License-Identifier: MIT
// The table of codes: everything a line can ask for is a row here and a handler.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "ipr/text/letter_set.hpp"
#include "ipr/text/small_set.hpp"

namespace softcnc::ipr {

struct Task;

/// The group of a code: codes of one group exclude each other on a line. The groups are those of
/// RS274, except that G80 may stand beside a motion code, as in FANUC's first lines; and one for
/// each word that is a code of its own.
enum class Group : std::uint8_t {
  non_modal,
  motion,
  cycle,
  retract,
  spindle_mode,
  plane,
  distance,
  feed_mode,
  units,
  cutter_compensation,
  tool_length,
  work_offset,
  path_control,
  surface,
  stopping,
  tool_change,
  spindle,
  coolant,
  override_,
  saving,
  signal,
  arc_distance,
  feed,
  speed,
  tool,
  line_number,
  program_number,
  radius_number,
  length_number,
  polar,
  scaling,
  rotation,
};
inline constexpr int kGroups = 32;

class Groups : public SmallSet<Groups, Group> {
 public:
  using SmallSet::SmallSet;
};

inline constexpr int kAnyNumber = -1;

struct GCode {
  char letter;
  int number;  // G and M: ten times the number, G06.2 is 62; others: kAnyNumber
  Group group;
  int order;                          // codes of a line act in ascending order
  std::string_view words;             // letters it takes
  void (*act)(Task&);                 // nullptr: nothing is to be done
  std::string_view says;              // one sentence for the user
  std::string_view fanuc_words = {};  // letters that it takes in the fanuc dialect beside
  std::string_view haas_words = {};   // and in the haas dialect beside those
};

/// Returns the table of codes: G, M, then the other letters, each letter by number.
std::span<const GCode> gcode_table() noexcept;

/// Returns names for the steps in which a line acts, by GCode::order.
std::span<const std::string_view> order_names() noexcept;
std::string_view group_name(Group group) noexcept;

/// Returns the row of a word, or nullptr if softcnc does not know the code.
const GCode* find_gcode(char letter, double value) noexcept;

/// Returns the row of an M code in the rows of the machine's own (machine_codes()), or nullptr.
const GCode* find_machine_code(std::span<const GCode> codes, double value) noexcept;

/// The letters of words that are codes; is_code_letter() returns whether a word of this letter is a
/// code, rather than a value for one.
inline constexpr LetterSet kCodeLetters{"GMFSTNO"};
constexpr bool is_code_letter(char letter) noexcept { return kCodeLetters.has(letter); }

/// The letters that are codes in the fanuc dialect too, where no other code of the line takes them.
inline constexpr LetterSet kLoneLetters{"DH"};

/// Returns whether the code is one of G00 to G03.
constexpr bool is_line_or_arc(const GCode& code) noexcept {
  return code.letter == 'G' && code.number <= 30;
}

/// Returns whether the code is one of G73, G74, G76 and G81 to G89, the refused ones included.
constexpr bool is_canned_cycle(const GCode& code) noexcept {
  return code.group == Group::motion && code.number >= 730 && code.number <= 890;
}

/// Returns whether the code is one of G05.2, G05.3, G06.1 and G06.2: curves whose points or knots
/// stand one on a line.
constexpr bool is_curve_of_lines(const GCode& code) noexcept {
  return code.group == Group::motion && code.number >= 52 && code.number <= 62;
}

/// Returns whether the code is G70, G71 or G72: the cycle in force at the places of a pattern.
constexpr bool is_hole_pattern(const GCode& code) noexcept {
  return code.letter == 'G' && code.number >= 700 && code.number <= 720;
}

/// Returns whether the code is G31 or one of G38.2 to G38.5: a move up to the contact of a probe.
constexpr bool is_probing_move(const GCode& code) noexcept {
  return code.letter == 'G' && (code.number == 310 || (code.number >= 382 && code.number <= 385));
}

/// Returns whether the code is known but not supported. Its handler reports why.
constexpr bool is_refused(const GCode& code) noexcept {
  return code.says.starts_with("Refused") || code.says.starts_with("haas: refused");
}

/// Returns whether the code is one that LinuxCNC does not know.
constexpr bool is_of_fanuc(const GCode& code) noexcept { return code.says.starts_with("fanuc:"); }

/// Returns whether the code is one that only Haas' controls know.
constexpr bool is_of_haas(const GCode& code) noexcept { return code.says.starts_with("haas:"); }

/// Returns whether the code is G65, G66 or G66.1: the words after it on the line are arguments, not
/// codes.
constexpr bool calls_macro(const GCode& code) noexcept {
  return code.letter == 'G' && (code.number == 650 || code.number == 660 || code.number == 661);
}

/// Returns the name of a code as messages have it: "G02", "G06.2", "M30", "F".
std::string code_name(const GCode& code);
std::string code_name(char letter, double value);

}  // namespace softcnc::ipr
