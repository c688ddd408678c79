// SPDX-License-Identifier: MIT
// From programmed coordinates to the machine's, and back.
#pragma once

#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

/// The conversion machine = tool + origin + R (program + shift), in mm, with R the rotation of the
/// work system about Z.
class Coordinates {
 public:
  Coordinates() = default;
  Coordinates(const WorkOffset& work, const AxisVector& shift, const AxisVector& tool) noexcept;

  AxisVector to_machine(const AxisVector& program) const noexcept;
  AxisVector to_program(const AxisVector& machine) const noexcept;
  /// Returns a programmed distance in machine axes: only the rotation counts.
  AxisVector direction(const AxisVector& program) const noexcept;

  bool rotated() const noexcept { return sine_ != 0 || cosine_ != 1; }
  /// Returns what is added to a coordinate where nothing is rotated, mm.
  const AxisVector& sum() const noexcept { return sum_; }

  friend bool operator==(const Coordinates&, const Coordinates&) = default;

 private:
  AxisVector moved_ = AxisVector::Zero();  // tool + origin
  AxisVector shift_ = AxisVector::Zero();
  AxisVector sum_ = AxisVector::Zero();
  double cosine_ = 1, sine_ = 0;
};

}  // namespace softcnc::ipr
