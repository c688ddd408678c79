// SPDX-License-Identifier: MIT
#include "ipr/lines/operands.hpp"

#include "ipr/codes/axis_letters.hpp"
#include "ipr/codes/code_numbers.hpp"

namespace softcnc::ipr {
namespace {

Unknown named_axes(const Command& command) noexcept {
  Unknown named;
  for (int i = 0; i < kAxes; ++i)
    if (command.values().has(axis_letter(i)) || command.unread().has(axis_letter(i)))
      named.add(position_part(i));
  return named;
}

/// Whether it may be a further line of a curve that an earlier one has begun.
bool may_go_on(const GCode& code, const Command& command) noexcept {
  const LetterSet given = command.values().letters();
  return (code.number == kG062 && !given.has('P')) || (code.number == kG052 && !given.has('L')) ||
         code.number == kG061;
}

/// A G05 that goes on from the one before, if there is one.
bool follows_tangent(const GCode& code, const Command& command) noexcept {
  return code.number == kG05 && !command.values().letters().has_any("IJK");
}

bool goes_to_machine_point(const Command& command) noexcept {
  const GCode* code = command.find(Group::non_modal);
  return code != nullptr && code->number == kG53;
}

Unknown of_feed(const Modal& modal) noexcept {
  Unknown parts{Part::feed, Part::feed_mode, Part::units};
  if (modal.feed_mode == FeedMode::per_turn || modal.surface) parts |= {Part::speed, Part::spindle};
  return parts;
}

Unknown operands_of_motion(const GCode& code, const Command& command, const Modal& modal) noexcept {
  Unknown parts = kPosition | Unknown{Part::units, Part::distance, Part::cutter, Part::polar};
  if (code.number == kG053 || may_go_on(code, command)) parts.add(Part::motion);
  if (follows_tangent(code, command)) parts |= {Part::motion, Part::tangent};
  if (!goes_to_machine_point(command)) parts |= kOffsets;
  if (code.number != kG00) parts |= of_feed(modal);
  const bool in_plane = code.number == kG02 || code.number == kG03 || is_canned_cycle(code) ||
                        code.number == kG05 || code.number == kG051 || is_curve_of_lines(code);
  if (in_plane) parts |= {Part::plane, Part::centres};
  if (modal.polar || command.has_polar_words()) parts.add(Part::plane);
  if (is_canned_cycle(code)) parts.add(Part::spindle);
  if (code.number == kG74 || code.number == kG84) parts.add(Part::speed);
  const bool by_mode = command.has(Group::motion) && command.find_word(Group::motion).letter != 'G';
  if (is_canned_cycle(code) && by_mode) parts.add(Part::cycle_words);
  return parts;
}

/// G10 L10, L11 and L20 go by the position.
Unknown operands_of_table(const Command& command) noexcept {
  Unknown parts{Part::units, Part::distance};
  const double table = command.values().value_or('L', 0);
  const bool by_position = table == 10 || table == 11 || table == 20;
  if (!by_position || !command.values().letters().has_any(kAxisWords)) return parts;
  return parts | kPosition | kOffsets;
}

/// Into which tables G10 writes.
Unknown tables(const Command& command) noexcept {
  const double table = command.unread().has('L') ? 0 : command.values().value_or('L', 0);
  if (table == 2 || table == 20) return {Part::shift};
  const bool of_tools = table == 1 || (table >= 10 && table <= 13);
  return of_tools ? Unknown{Part::tool_data} : Unknown{Part::shift, Part::tool_data};
}

Unknown operands_of_offset(const GCode& code, const Command& command, const Modal& modal) noexcept {
  if (is_hole_pattern(code))
    return operands_of_motion(code, command, modal) | of_feed(modal) |
           Unknown{Part::motion, Part::plane, Part::spindle, Part::speed, Part::cycle_words};
  switch (code.number) {
    case kG12:
    case kG13:
      return kPosition | kCoordinates | of_feed(modal) | Unknown{Part::tool_data};
    case kG10:
      return operands_of_table(command);
    case kG28:
    case kG30:
      return kPosition | kCoordinates;
    case kG31:
      return kPosition | kCoordinates | of_feed(modal);
    case kG52:
      return {Part::units, Part::shift};
    case kG53:
      return {Part::motion, Part::distance};
    case kG92:
      return kPosition | kOffsets | Unknown{Part::units};
    default:
      return code.number == kG28 + 1 || code.number == kG30 + 1 ? kPosition : Unknown{};
  }
}

/// G41.1 and G42.1 give the diameter themselves.
Unknown operands_of_compensation(const GCode& code) noexcept {
  if (code.number == kG40) return {};
  if (code.number == kG411 || code.number == kG421) return {Part::plane, Part::units};
  return {Part::plane, Part::tool, Part::tool_data, Part::units};
}

/// Whether the line names all the axes of the plane, or with G51 all axes.
bool names_centre(const GCode& code, const Command& command, const Modal& modal) noexcept {
  const LetterSet given = command.values().letters();
  const PlaneAxes plane = plane_axes(modal.plane);
  const LetterSet needed = code.number == kG68 ? plane_letters(plane) : kAxisWords;
  return needed.without(given).empty();
}

/// Of G68, G51 and G51.1; what cancels them reads nothing.
Unknown operands_of_transformation(const GCode& code, const Command& command,
                                   const Modal& modal) noexcept {
  if (code.act == nullptr || code.words.empty() || code.number == kG501) return {};
  Unknown parts{Part::units};
  if (code.number == kG68) parts |= {Part::plane, Part::distance};
  if (code.number == kG68 && modal.incremental) parts.add(Part::rotation);
  const Part own = code.number == kG68 ? Part::rotation : Part::scaling;
  if (code.number != kG511 && !names_centre(code, command, modal))
    parts |= kPosition | kOffsets.without({own});
  return parts;
}

/// G43.1 gives the length itself.
Unknown operands_of_length(const GCode& code, const Command& command) noexcept {
  Unknown parts{Part::units};
  if (code.number == kG43) parts |= {Part::tool, Part::tool_data};
  if (code.number == kG432 && command.values().has('H')) parts.add(Part::tool_data);
  return parts;
}

}  // namespace

Unknown operands(const GCode& code, const Command& command, const Modal& modal) noexcept {
  if (is_refused(code)) return {};
  switch (code.group) {
    case Group::motion:
      return operands_of_motion(code, command, modal);
    case Group::non_modal:
      return operands_of_offset(code, command, modal);
    case Group::feed:
      return {Part::units, Part::feed_mode};
    case Group::cutter_compensation:
      return operands_of_compensation(code);
    case Group::tool_length:
      return operands_of_length(code, command);
    case Group::scaling:
    case Group::rotation:
      return operands_of_transformation(code, command, modal);
    case Group::tool:
    case Group::length_number:
      return {Part::tool_data};
    case Group::surface:
      return {Part::tool, Part::units};
    case Group::path_control:
      return {Part::units};
    case Group::spindle:
      return {Part::speed};
    case Group::saving:
      return code.number == kM72 ? Unknown{Part::saved_modes} : Unknown{};
    case Group::tool_change:
      if (code.words.empty()) return {Part::tool};
      return command.values().has('Q') ? Unknown{Part::tool_data} : Unknown{};
    default:
      return {};
  }
}

Unknown results(const GCode& code, const Command& command) noexcept {
  switch (code.group) {
    case Group::motion: {
      if (is_refused(code)) return kPosition | Unknown{Part::motion};
      Unknown parts = named_axes(command);
      if (is_curve_of_lines(code)) parts.add(Part::motion);
      if (is_canned_cycle(code)) parts.add(Part::cycle_words);
      if (code.number == kG05) parts.add(Part::tangent);
      return parts;
    }
    case Group::non_modal:
      if (code.number == kG28 || code.number == kG30 || code.number == kG31) return kPosition;
      if (is_hole_pattern(code) || code.number == kG47 || code.number == kG150) return kPosition;
      if (code.number == kG12 || code.number == kG13) return named_axes(command);
      if (code.number == kG53) return named_axes(command);
      if (code.number == kG10) return tables(command);
      if (code.number == kG52) return {Part::shift};
      if (code.number >= kG92 && code.number <= kG923) return {Part::shift};
      return code.number == kG65 ? kEverything : Unknown{};
    case Group::saving:
      return code.number == kM72 ? Unknown{Part::feed, Part::speed} : settled(code);
    default:
      return settled(code);
  }
}

Unknown settled(const GCode& code) noexcept {
  switch (code.group) {
    case Group::motion:
      if (is_canned_cycle(code)) return {Part::motion, Part::tangent, Part::cycle_words};
      return {Part::motion, Part::tangent};
    case Group::cycle:
      return {Part::motion};
    case Group::plane:
      return {Part::plane};
    case Group::units:
      return {Part::units};
    case Group::distance:
      return {Part::distance};
    case Group::arc_distance:
      return {Part::centres};
    case Group::feed_mode:
      return {Part::feed_mode};
    case Group::feed:
      return {Part::feed};
    case Group::speed:
    case Group::spindle_mode:
      return {Part::speed};
    case Group::spindle:
      return {Part::spindle};
    case Group::tool:
      return {Part::tool};
    case Group::tool_change:  // M61 takes words, M06 stops the spindle
      return code.words.empty() ? Unknown{Part::tool, Part::spindle} : Unknown{Part::tool};
    case Group::cutter_compensation:
    case Group::radius_number:
      return {Part::cutter};
    case Group::tool_length:
    case Group::length_number:
      return {Part::tool_length};
    case Group::work_offset:
      return {Part::work_system};
    case Group::saving:
      return code.number == kM72 ? Unknown{} : Unknown{Part::saved_modes};
    case Group::polar:
      return {Part::polar};
    case Group::rotation:
      return {Part::rotation};
    case Group::scaling:
      return {code.number == kG501 || code.number == kG511 ? Part::mirror : Part::scaling};
    default:
      return {};
  }
}

Unknown set_by(LetterSet letters) noexcept {
  Unknown parts;
  for (int i = 0; i < kAxes; ++i)
    if (letters.has(axis_letter(i))) parts.add(position_part(i));
  if (letters.has('F')) parts.add(Part::feed);
  if (letters.has('S')) parts.add(Part::speed);
  if (letters.has('T')) parts.add(Part::tool);
  if (letters.has('G'))
    parts |=
        {Part::motion, Part::plane, Part::distance, Part::centres, Part::feed_mode, Part::cutter};
  if (letters.has('M')) parts |= {Part::spindle, Part::saved_modes, Part::end};
  return parts;
}

}  // namespace softcnc::ipr
