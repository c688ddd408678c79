// SPDX-License-Identifier: MIT
// A table of names; numbers by their ranges.
#include "ipr/modal_variables.hpp"

#include "ipr/gcode_table.hpp"
#include "motion/units.hpp"

namespace softcnc::ipr {
namespace {

// RS274: ranges of one number per axis (X Y Z, then six axes that softcnc lacks).
constexpr int kHome = 5161, kSecondHome = 5181, kShiftOn = 5210, kShift = 5211, kActive = 5220;
constexpr int kWork = 5221, kWorkStep = 20;
constexpr int kToolOffset = 5401;
constexpr int kPosition = 5420, kPositionEnd = 5429;
// FANUC: the end of the last block, and the same in machine coordinates; where the tool is.
constexpr int kBlockEnd = 5001, kMachine = 5021, kCurrent = 5041;
// FANUC: what outlives a program; switches of the control that change nothing here; codes in force.
constexpr int kKept = 500, kKeptEnd = 1000, kNoSingleBlock = 3003, kNoHold = 3004;
constexpr int kCodes = 4000;

/// Index of an axis if `number` is that of the range that begins at `first`; otherwise -1.
constexpr int axis_in(int number, int first) noexcept {
  return number >= first && number < first + kAxes ? number - first : -1;
}

double program_position(const Modal& modal, int axis) {
  if (modal.uncertain.has(kAxisLetters[static_cast<std::size_t>(axis)])) return kUncertain;
  return modal.coordinates.to_program(modal.position)[axis] / modal.mm_per_unit;
}

double machine_position(const Modal& modal, int axis) {
  if (modal.uncertain.has(kAxisLetters[static_cast<std::size_t>(axis)])) return kUncertain;
  return modal.position[axis] / modal.mm_per_unit;
}

double motion_mode(const Modal& modal) {
  constexpr double kNone = 800;
  if (modal.uncertain.has('G')) return kUncertain;
  return modal.motion != nullptr ? modal.motion->number : kNone;
}

double coordinate_system(const Modal& modal) {
  constexpr int kFirst = 540, kLastWhole = 5;  // G54 to G59, then G59.1 to G59.3
  const int active = modal.state.active;
  return active <= kLastWhole ? kFirst + 10 * active
                              : kFirst + 10 * kLastWhole + active - kLastWhole;
}

double plane(const Modal& modal) {
  constexpr double kXy = 170, kZx = 180, kYz = 190;
  return modal.plane == Plane::xy ? kXy : modal.plane == Plane::zx ? kZx : kYz;
}

double feed(const Modal& modal) {
  return modal.uncertain.has('F') ? kUncertain : mm_min_from_mm_s(modal.feed) / modal.mm_per_unit;
}

double spindle_speed(const Modal& modal) {
  return modal.uncertain.has('S') ? kUncertain : modal.spindle_speed.value_or(0);
}

double selected_tool(const Modal& modal) {
  return modal.uncertain.has('T') ? kUncertain : modal.tool.value_or(0);
}

template <int axis>
double at(const Modal& modal) {
  return program_position(modal, axis);
}

template <int axis>
double machine_at(const Modal& modal) {
  return machine_position(modal, axis);
}

struct Named {
  std::string_view name;
  double (*read)(const Modal&);
};

double zero(const Modal&) { return 0; }
double one(const Modal&) { return 1; }

/// Those of LinuxCNC 2.9. What nothing can change yet is constant.
constexpr Named kNames[] = {
    {"_a", zero},
    {"_abs_a", zero},
    {"_abs_b", zero},
    {"_abs_c", zero},
    {"_abs_u", zero},
    {"_abs_v", zero},
    {"_abs_w", zero},
    {"_abs_x", machine_at<0>},
    {"_abs_y", machine_at<1>},
    {"_abs_z", machine_at<2>},
    {"_absolute", [](const Modal& m) { return m.incremental ? 0.0 : 1.0; }},
    {"_adaptive_feed", zero},
    {"_b", zero},
    {"_c", zero},
    {"_coord_system", coordinate_system},
    {"_feed", feed},
    {"_feed_hold", one},
    {"_feed_override", one},
    {"_imperial", [](const Modal& m) { return m.mm_per_unit == 1 ? 0.0 : 1.0; }},
    {"_incremental", [](const Modal& m) { return m.incremental ? 1.0 : 0.0; }},
    {"_lathe_diameter_mode", zero},
    {"_lathe_radius_mode", one},
    {"_metric", [](const Modal& m) { return m.mm_per_unit == 1 ? 1.0 : 0.0; }},
    {"_metric_machine", one},
    {"_motion_mode", motion_mode},
    {"_plane", plane},
    {"_remap_level", zero},
    {"_rpm", spindle_speed},
    {"_selected_tool", selected_tool},
    {"_speed_override", one},
    {"_spindle_cw", [](const Modal& m) { return m.spindle_direction > 0 ? 1.0 : 0.0; }},
    {"_spindle_on", [](const Modal& m) { return m.spindle_direction != 0 ? 1.0 : 0.0; }},
    {"_task", zero},
    {"_tool_offset", [](const Modal& m) { return m.tool_offset.isZero(0) ? 0.0 : 1.0; }},
    {"_u", zero},
    {"_v", zero},
    {"_vmajor", [](const Modal&) { return 2.9; }},
    {"_vminor", zero},
    {"_w", zero},
    {"_x", at<0>},
    {"_y", at<1>},
    {"_z", at<2>},
};

/// #4001 to #4120 of FANUC: by the number of the group of codes, or that of the letter.
struct Coded {
  int number;
  double (*read)(const Modal&);
};

constexpr double kTenths = 10;  // G54.1 is 541 to LinuxCNC and 54.1 to FANUC

constexpr Coded kFanucCodes[] = {
    {1, [](const Modal& m) { return motion_mode(m) / kTenths; }},
    {2, [](const Modal& m) { return plane(m) / kTenths; }},
    {3, [](const Modal& m) { return m.incremental ? 91.0 : 90.0; }},
    {6, [](const Modal& m) { return m.mm_per_unit == 1 ? 21.0 : 20.0; }},
    {14, [](const Modal& m) { return coordinate_system(m) / kTenths; }},
    {109, feed},
    {119, spindle_speed},
    {120, selected_tool},
};

}  // namespace

std::optional<double> ModalVariables::read(std::string_view name) const {
  for (const Named& row : kNames)
    if (row.name == name) return row.read(modal_);
  return std::nullopt;
}

/// The offset of this number, in mm.
double* ModalVariables::offset(int number) const noexcept {
  MachineState& state = modal_.state;
  if (const int axis = axis_in(number, kHome); axis >= 0) return &state.home[axis];
  if (const int axis = axis_in(number, kSecondHome); axis >= 0) return &state.second_home[axis];
  if (const int axis = axis_in(number, kShift); axis >= 0) return &state.shift[axis];
  if (number < kWork || number >= kWork + kWorkSystems * kWorkStep) return nullptr;
  WorkOffset& work = state.work[static_cast<std::size_t>((number - kWork) / kWorkStep)];
  const int axis = axis_in((number - kWork) % kWorkStep, 0);
  return axis >= 0 ? &work.origin[axis] : nullptr;
}

std::optional<double> ModalVariables::read(int number) const {
  if (uncertain_.count(number) > 0) return kUncertain;
  if (const double* value = offset(number)) return *value;
  if (dialect_ == Dialect::fanuc) return read_fanuc(number);
  if (number == kShiftOn) return modal_.state.shift_on ? 1 : 0;
  if (number == kActive) return modal_.state.active + 1;
  if (const int axis = axis_in(number, kPosition); axis >= 0) return program_position(modal_, axis);
  if (const int axis = axis_in(number, kToolOffset); axis >= 0) return modal_.tool_offset[axis];
  if (number >= kPosition && number < kPositionEnd) return 0;  // of axes that softcnc lacks
  return std::nullopt;
}

std::optional<double> ModalVariables::read_fanuc(int number) const {
  for (const int first : {kBlockEnd, kCurrent})
    if (const int axis = axis_in(number, first); axis >= 0) return program_position(modal_, axis);
  if (const int axis = axis_in(number, kMachine); axis >= 0) return machine_position(modal_, axis);
  if (number >= kKept && number < kKeptEnd) {
    const auto kept = modal_.state.parameters.find(number);
    return kept != modal_.state.parameters.end() ? kept->second : kVacant;
  }
  if (number == kNoSingleBlock || number == kNoHold) return 0;
  for (const Coded& row : kFanucCodes)
    if (kCodes + row.number == number) return row.read(modal_);
  return std::nullopt;
}

bool ModalVariables::is_read_only(int number) const {
  if (offset(number) != nullptr) return false;
  return dialect_ != Dialect::fanuc ||
         !((number >= kKept && number < kKeptEnd) || number == kNoSingleBlock || number == kNoHold);
}

/// A vacant offset is 0. One that is not known leaves the position of its axis unknown.
bool ModalVariables::write(int number, double value) {
  uncertain_.erase(number);
  if (is_uncertain(value)) {
    uncertain_.insert(number);
    if (offset(number) != nullptr) modal_.uncertain |= kAxisWords;
    return true;
  }
  double* const target = offset(number);
  if (target == nullptr) return dialect_ == Dialect::fanuc && write_fanuc(number, value);
  *target = is_vacant(value) ? 0 : value;
  if (dialect_ == Dialect::fanuc) modal_.update_coordinates();
  return true;
}

bool ModalVariables::write_fanuc(int number, double value) {
  if (number >= kKeptEnd) return true;  // a switch
  if (is_vacant(value))
    modal_.state.parameters.erase(number);
  else
    modal_.state.parameters[number] = value;
  return true;
}

}  // namespace softcnc::ipr
