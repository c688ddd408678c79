// SPDX-License-Identifier: MIT
// ,C and ,R: a chamfer or a rounding after the move of their line. FANUC: operator's manual,
// "Optional chamfering and corner R"; Haas: mill operator's manual, "Corner Rounding and
// Chamfering".
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

bool makes_corners(const GCode& code) { return is_line_or_arc(code) && code.number != kG00; }

bool ends_program(const GCode& code) {
  return code.letter == 'M' && (code.number == kM02 || code.number == kM30);
}

/// G28 and the like: codes that take the axes for something else than the second move.
bool takes_axes(const GCode& code) {
  return code.group == Group::non_modal && LetterSet(code.words).has_any(kAxisWords);
}

std::string name_of(const Word& word) {
  return std::string(",") + word.letter + number_text(word.value);
}

/// Nothing if the line moves as it must.
std::string why_no_first_move(const Command& command, const Output& out) {
  const GCode* motion = command.find(Group::motion);
  if (motion == nullptr || !out.has_move()) return "its line does not move";
  return makes_corners(*motion) ? "" : code_name(*motion) + " makes no corners";
}

}  // namespace

void ask_for_corner(const Command& command, const Modal& modal, Output& out) {
  const Word* word = command.corner();
  if (word == nullptr || out.failed() || word->value == 0) return;
  if (modal.unknown.has_any({Part::motion, Part::plane, Part::units})) return;
  double size = word->value * modal.mm_per_unit;
  if (!(size > 0) || !is_near(size))
    return out.report(
        Code::SC2007, word->pos,
        name_of(*word) + " must " + (size > 0 ? "be 1000000 mm at most" : "not be negative"));
  if (const std::string why = why_no_first_move(command, out); !why.empty())
    return out.report(Code::SC2261, word->pos, name_of(*word) + ": " + why);
  if (modal.ended)
    return out.report(Code::SC2263, word->pos, name_of(*word) + ": the program ends");
  const auto scale = modal.transformation.scale(plane_axes(modal.plane));
  if (!scale)
    return out.report(Code::SC2263, word->pos,
                      name_of(*word) + ": the axes of the plane have different scales");
  size *= *scale;
  out.ask_for_corner({{word->letter == 'R', size}, modal.plane, name_of(*word), word->pos});
}

void check_pending_corner(const Command& command, const Modal& modal, Output& out) {
  for (const auto& [code, word] : command.codes()) {
    const std::string name = code_name(*code);
    if (code->group == Group::motion && !makes_corners(*code))
      return out.leave_corner(Code::SC2263, name + " follows, and not G01, G02 or G03");
    if (takes_axes(*code) || code->group == Group::cutter_compensation)
      return out.leave_corner(Code::SC2263, name + " comes before its second move");
    if (code->group == Group::plane && selected_plane(*code) != modal.plane)
      return out.leave_corner(Code::SC2264, name + " changes the plane before its second move");
    if (ends_program(*code) && !command.values().letters().has_any(kAxisWords))
      return out.leave_corner(Code::SC2263, "the program ends");
  }
}

}  // namespace softcnc::ipr
