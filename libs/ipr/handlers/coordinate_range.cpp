// SPDX-License-Identifier: MIT
// How far things may lie: what is larger than any machine would overflow when it is computed with.
#include <cmath>
#include <string>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

/// Of nearly straight arcs the centre is far away.
constexpr double kLongestLength = 1e9;  // mm

std::string beyond(double limit) { return " beyond " + number_text(limit) + " mm"; }

std::string gives_far_offset(const std::string& who) {
  return who + " gives an offset" + beyond(kFarthest);
}

/// Reports once for all axes that no word of the line names.
template <typename Describe>
void report_far(const Task& task, const AxisVector& place, Describe describe) {
  bool reported = false;
  for (int i = 0; i < kAxes; ++i) {
    const char letter = axis_letter(i);
    const bool named = task.values.has(letter);
    if (is_near(place[i]) || (reported && !named)) continue;
    report_word(task, letter, Code::SC3008,
                describe(named ? std::string(1, letter) : code_name(task.code)));
    reported = true;
  }
}

AxisVector refuse_place(const Task& task, AxisVector place) {
  LetterSet far;
  for (int i = 0; i < kAxes; ++i)
    if (!is_near(place[i])) far.add(axis_letter(i));
  report_far(task, place, leads_far);
  for (int i = 0; i < kAxes; ++i)
    if (far.has(axis_letter(i))) place[i] = task.modal.position[i];
  return place;
}

}  // namespace

std::string leads_far(const std::string& who) {
  return who + " leads to a place" + beyond(kFarthest);
}

AxisVector near_place(const Task& task, const AxisVector& place) {
  return is_near(place) ? place : refuse_place(task, place);
}

bool keep_offset(Task& task, AxisVector& offset, const AxisVector& wanted) {
  if (is_near(wanted)) {
    offset = wanted;
    return true;
  }
  report_far(task, wanted, gives_far_offset);
  return false;
}

bool keep_offset(Task& task, char letter, double& offset, double wanted) {
  if (is_near(wanted)) {
    offset = wanted;
    return true;
  }
  report_word(task, letter, Code::SC3008, gives_far_offset(std::string(1, letter)));
  return false;
}

bool has_near_lengths(Task& task, std::string_view letters) {
  bool near = true;
  for (const char letter : letters) {
    if (!task.values.has(letter)) continue;
    if (std::abs(task.values[letter] * task.modal.mm_per_unit) <= kLongestLength) continue;
    report_word(task, letter, Code::SC3008,
                std::string(1, letter) + " is" + beyond(kLongestLength));
    near = false;
  }
  return near;
}

}  // namespace softcnc::ipr
