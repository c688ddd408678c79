// SPDX-License-Identifier: MIT
// From the setpoints of the path to those that the drives get.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/signals/axis_compensation.hpp"
#include "hal/signals/axis_following.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// Compensates backlash and pitch errors of the axes that have any, and then the lag of the drives,
/// as control.follow says. On a machine with neither the commands are the setpoints themselves.
class Commands {
 public:
  explicit Commands(const Machine& machine);

  /// Returns whether the commands of any axis differ from its path.
  bool differ() const noexcept { return !axes_.empty(); }

  /// Returns the setpoint to send for that of the path; the first one says where the machine
  /// stands. Its fine points are those of the path or, if it has none, of fine_period(). It is
  /// valid until the next call. Realtime.
  const Setpoint& operator()(const Setpoint& path) noexcept;

  /// Returns the same for the place of a rest, which is no setpoint of the path: the instants of
  /// the next one that lie before it stay there.
  const Setpoint& rest(const Setpoint& at) noexcept;

  /// Returns the next setpoint on the way to the state in which programs begin, the path at rest;
  /// null where the commands have got there.
  const Setpoint* next_to_release() noexcept;

  /// Returns command minus path of an axis at the last setpoint, mm. Realtime.
  double added(int axis) const noexcept { return added_[axis]; }
  /// Returns the command of an axis at the last setpoint, mm. Realtime.
  double position(int axis) const noexcept { return sent_.position[axis]; }

  /// Returns the largest speed of the commands so far, mm/s by axis; 0 where they are the path.
  const AxisVector& velocity_max() const noexcept { return velocity_max_; }

  /// Adds the name of the column of an axis's commands, such as "x_cmd_mm", where they differ.
  void add_column(int axis, std::vector<std::string>& columns) const;

 private:
  struct Chain {
    int axis;
    AxisCompensation compensation;
    AxisFollowing following;
  };

  const Setpoint& send(const Setpoint& path) noexcept;
  const Setpoint& after_rest(const Setpoint& path) noexcept;
  void begin() noexcept;
  void move() noexcept;

  std::vector<Chain> axes_;
  std::size_t parts_;  // fine points of a period
  double period_;      // s
  bool started_ = false;
  Setpoint sent_;
  std::vector<FinePoint> fine_;
  FinePoint path_;                   // of the last setpoint
  std::optional<FinePoint> rested_;  // behind it
  Setpoint after_rest_;
  std::vector<FinePoint> fine_after_rest_;
  AxisVector added_ = AxisVector::Zero();         // mm
  AxisVector velocity_max_ = AxisVector::Zero();  // mm/s
};

}  // namespace softcnc::hal
