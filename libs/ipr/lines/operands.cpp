// SPDX-License-Identifier: MIT
#include "ipr/lines/operands.hpp"

#include "ipr/codes/axis_letters.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kG00 = 0, kG02 = 20, kG03 = 30, kG05 = 50, kG051 = 51, kG053 = 53;
constexpr int kG10 = 100, kG28 = 280, kG30 = 300, kG43 = 430, kG52 = 520, kG53 = 530, kG65 = 650;
constexpr int kG92 = 920, kG923 = 923;

/// Curves whose points or knots stand one on a line: G05.2 to G06.2.
constexpr bool is_of_several_lines(const GCode& code) noexcept {
  return code.number > kG051 && code.number <= 62;
}

Unknown named_axes(const Command& command) noexcept {
  Unknown named;
  for (int i = 0; i < kAxes; ++i)
    if (command.values().has(axis_letter(i)) || command.unread().has(axis_letter(i)))
      named.add(position_part(i));
  return named;
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
  Unknown parts = kPosition;
  parts |= {Part::units, Part::cutter};
  if (code.number == kG053) parts.add(Part::motion);
  parts.add(Part::distance);
  if (!goes_to_machine_point(command)) parts |= kOffsets;
  if (code.number != kG00) parts |= of_feed(modal);
  const bool in_plane = code.number == kG02 || code.number == kG03 || is_canned_cycle(code) ||
                        code.number == kG05 || code.number == kG051 || is_of_several_lines(code);
  if (in_plane) parts |= {Part::plane, Part::centres};
  if (is_canned_cycle(code)) parts.add(Part::spindle);
  return parts;
}

Unknown operands_of_offset(const GCode& code) noexcept {
  switch (code.number) {
    case kG10: {
      Unknown parts = kPosition;
      parts |= kCoordinates;
      return parts;
    }
    case kG28:
    case kG30: {
      Unknown parts = kPosition;
      parts |= kCoordinates;
      return parts;
    }
    case kG52:
      return {Part::units, Part::shift};
    case kG53:
      return {Part::motion, Part::distance};
    case kG92: {
      Unknown parts = kPosition;
      parts |= {Part::units};
      parts |= kOffsets;
      return parts;
    }
    default:
      return code.number == kG28 + 1 || code.number == kG30 + 1 ? kPosition : Unknown{};
  }
}

}  // namespace

Unknown operands(const GCode& code, const Command& command, const Modal& modal) noexcept {
  switch (code.group) {
    case Group::motion:
      return operands_of_motion(code, command, modal);
    case Group::non_modal:
      return operands_of_offset(code);
    case Group::feed:
      return {Part::units, Part::feed_mode};
    case Group::cutter_compensation:
      return code.words.empty() ? Unknown{} : Unknown{Part::plane, Part::tool, Part::units};
    case Group::tool_length:
      return code.number == kG43 ? Unknown{Part::tool, Part::units} : Unknown{Part::units};
    case Group::surface:
      return {Part::tool, Part::units};
    case Group::path_control:
      return {Part::units};
    case Group::spindle:
      return {Part::speed};
    case Group::saving:
      return {Part::saved_modes};
    case Group::tool_change:
      return code.words.empty() ? Unknown{Part::tool} : Unknown{};
    default:
      return {};
  }
}

Unknown results(const GCode& code, const Command& command) noexcept {
  switch (code.group) {
    case Group::motion: {
      if (!is_of_several_lines(code))
        return is_canned_cycle(code) ? kPosition : named_axes(command);
      Unknown parts = kPosition;
      parts.add(Part::motion);
      return parts;
    }
    case Group::non_modal:
      if (code.number == kG28 || code.number == kG30) return kPosition;
      if (code.number == kG53) return named_axes(command);
      if (code.number == kG10 || code.number == kG52) return {Part::shift};
      if (code.number >= kG92 && code.number <= kG923) return {Part::shift};
      return code.number == kG65 ? kEverything : Unknown{};
    default: {
      return settled(code);
    }
  }
}

Unknown settled(const GCode& code) noexcept {
  switch (code.group) {
    case Group::motion:
      return is_of_several_lines(code) ? Unknown{} : Unknown{Part::motion};
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
    case Group::tool_change:
      return {Part::tool};
    case Group::cutter_compensation:
    case Group::radius_number:
      return {Part::cutter};
    case Group::tool_length:
    case Group::length_number:
      return {Part::tool_length};
    case Group::work_offset:
      return {Part::work_system};
    case Group::saving:
      return {Part::saved_modes};
    default:
      return {};
  }
}

Unknown set_by(Letters letters) noexcept {
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
