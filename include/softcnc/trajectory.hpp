// SPDX-License-Identifier: MIT
// A planned program: where the machine is at any instant.
#pragma once

#include <functional>
#include <memory>

#include <softcnc/export.hpp>
#include <softcnc/program.hpp>
#include <softcnc/setpoint.hpp>

namespace softcnc::api {

/// The motion at an instant, from the plan itself: between setpoints as well as at them.
struct Motion {
  double s = 0, v = 0, a = 0;                    // mm, mm/s, mm/s^2 along the path
  AxisVector position = AxisVector::Zero();      // mm
  AxisVector velocity = AxisVector::Zero();      // mm/s
  AxisVector acceleration = AxisVector::Zero();  // mm/s^2
  int line = 0, block = 0;
  std::string_view limit;
};

/// Holds the whole plan in memory: some 100 bytes for each ramp of a block, and the curves.
class SOFTCNC_API Trajectory {
 public:
  Trajectory(Trajectory&& other) noexcept;
  Trajectory& operator=(Trajectory&& other) noexcept;
  ~Trajectory();

  double duration() const noexcept;  // s
  double length() const noexcept;    // mm of path

  /// Returns the motion at `t`, s, clamped to 0 and duration().
  Motion at(double t) const noexcept;

  /// Calls visit(setpoint) for each period, as `softcnc run` commands them, until it returns false.
  /// The program is planned once more for that; whatever its length, memory stays bounded.
  /// What visit() throws is passed on.
  void for_each_setpoint(const std::function<bool(const Setpoint&)>& visit) const;

  struct Data;

 private:
  friend SOFTCNC_API Expected<Trajectory> plan(const Program&, const Machine&, const RunOptions&);
  explicit Trajectory(std::unique_ptr<Data> data) noexcept;
  std::unique_ptr<Data> data_;
};

/// Plans a program. `program` must outlive the trajectory. Errors: those of check() that are
/// errors.
SOFTCNC_API Expected<Trajectory> plan(const Program& program, const Machine& machine,
                                      const RunOptions& options = {});

}  // namespace softcnc::api
