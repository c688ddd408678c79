// SPDX-License-Identifier: MIT
// What programs leave on a machine: where it stands, work offsets, reference points, the tool in
// the spindle, tool lengths, parameters.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "motion/core/axes.hpp"

namespace softcnc {

/// The largest magnitude of positions and offsets that are stored.
inline constexpr double kFarthest = 1e6;  // mm
/// The largest magnitude of the rotation of a work system.
inline constexpr double kMostTurned = 36000;  // degrees

/// Returns false also for what is not a number.
inline bool is_near(double mm) noexcept { return mm >= -kFarthest && mm <= kFarthest; }
inline bool is_near(const AxisVector& place) noexcept {
  return is_near(place[0]) && is_near(place[1]) && is_near(place[2]);
}

/// A work coordinate system: G54 to G59.3.
struct WorkOffset {
  AxisVector origin = AxisVector::Zero();  // mm, in machine coordinates
  double rotation = 0;                     // rad, about Z, counter-clockwise

  friend bool operator==(const WorkOffset&, const WorkOffset&) = default;
};

/// What G10 L1, L10 and L11 store for a tool. Wear is what a FANUC control stores separately, by
/// G10 L11 and L13, and adds.
struct ToolOffset {
  AxisVector length = AxisVector::Zero();  // mm, from the control point to the tip
  double radius = 0;                       // mm
  double length_wear = 0;                  // mm, along Z
  double radius_wear = 0;                  // mm

  friend bool operator==(const ToolOffset&, const ToolOffset&) = default;
};

/// Where the machine stands, as it was kept last.
struct KeptPosition {
  AxisVector place = AxisVector::Zero();  // mm, machine coordinates
  bool in_motion = false;  // it has left that place, and nobody has seen it at rest since

  friend bool operator==(const KeptPosition&, const KeptPosition&) = default;
};

inline constexpr int kWorkSystems = 9;
/// The number of further work systems: G54.1 P1 to P300.
inline constexpr int kFurtherSystems = 300;

/// The initial state is that of a new MachineState.
struct MachineState {
  std::array<WorkOffset, kWorkSystems> work;    // G54, G55, ... G59.3
  std::map<int, WorkOffset> further_work;       // by P of G54.1; what is not there is zero
  int active = 0;                               // index of a work system
  AxisVector shift = AxisVector::Zero();        // mm: of G92 and G52
  bool shift_on = false;                        // off after G92.2
  AxisVector home = AxisVector::Zero();         // mm, machine coordinates: G28
  AxisVector second_home = AxisVector::Zero();  // G30
  std::array<std::optional<AxisVector>, 2> further_homes;  // G30 P3 and P4; unset: no such place
  std::optional<KeptPosition> position;                    // unset: it was never kept
  std::optional<int> loaded_tool;                          // in the spindle
  std::map<int, ToolOffset> tools;                         // by tool number
  std::map<int, double> parameters;                        // numbered ones that outlive a program
  std::map<std::string, double> globals;                   // named ones, without #< and >

  /// Returns where a program begins, mm, machine coordinates: machine zero, if nothing was kept.
  AxisVector place() const noexcept {
    return position ? position->place : AxisVector(AxisVector::Zero());
  }
  /// Returns the work system of an index: those of `work`, then G54.1 P1, P2 and so on.
  WorkOffset work_system(int index) const {
    if (index < kWorkSystems) return work[static_cast<std::size_t>(index)];
    const auto found = further_work.find(index - kWorkSystems + 1);
    return found == further_work.end() ? WorkOffset{} : found->second;
  }
  /// Returns the same to be changed, and adds it if it is not there.
  WorkOffset& work_system_entry(int index) {
    if (index < kWorkSystems) return work[static_cast<std::size_t>(index)];
    return further_work[index - kWorkSystems + 1];
  }

  friend bool operator==(const MachineState&, const MachineState&) = default;
};

}  // namespace softcnc
