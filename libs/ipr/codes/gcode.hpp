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

/// Codes of one group exclude each other on a line. The groups of RS274, but that G80 may stand
/// beside a motion code, as in FANUC's first lines; and one for each word that is a code of its
/// own.
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
};

/// In the order of G, M, and the other letters; within a letter by number.
std::span<const GCode> gcode_table() noexcept;

/// What acts on a line, in this order: by GCode::order.
std::span<const std::string_view> order_names() noexcept;
std::string_view group_name(Group group) noexcept;

/// The row of a word; nullptr if softcnc does not know the code.
const GCode* find_gcode(char letter, double value) noexcept;

/// Whether a word of this letter is a code, rather than a value for one.
inline constexpr Letters kCodeLetters{"GMFSTNO"};
constexpr bool is_code_letter(char letter) noexcept { return kCodeLetters.has(letter); }

/// In the fanuc dialect these are codes too, where no other code of the line takes them.
inline constexpr Letters kLoneLetters{"DH"};

/// G00 to G03.
constexpr bool is_line_or_arc(const GCode& code) noexcept {
  return code.letter == 'G' && code.number <= 30;
}

/// G73, G74, G76, G81 to G89, refused ones among them.
constexpr bool is_canned_cycle(const GCode& code) noexcept {
  return code.group == Group::motion && code.number >= 730 && code.number <= 890;
}

/// G05.2, G05.3, G06.1 and G06.2: curves whose points or knots stand one on a line.
constexpr bool is_curve_of_lines(const GCode& code) noexcept {
  return code.group == Group::motion && code.number >= 52 && code.number <= 62;
}

/// Known, and not supported: it reports why.
constexpr bool is_refused(const GCode& code) noexcept { return code.says.starts_with("Refused"); }

/// Not known to LinuxCNC.
constexpr bool is_of_fanuc(const GCode& code) noexcept { return code.says.starts_with("fanuc:"); }

/// G65, G66 and G66.1: what stands after them on the line are arguments, no codes.
constexpr bool calls_macro(const GCode& code) noexcept {
  return code.letter == 'G' && (code.number == 650 || code.number == 660 || code.number == 661);
}

/// "G02", "G06.2", "M30", "F".
std::string code_name(const GCode& code);
std::string code_name(char letter, double value);

}  // namespace softcnc::ipr
