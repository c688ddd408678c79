// SPDX-License-Identifier: MIT
// The end of a move in polar coordinates: by G16, or by LinuxCNC's @ and ^.
#pragma once

#include <optional>

#include "motion/core/axes.hpp"
#include "motion/geometry/arc.hpp"

namespace softcnc::ipr {

/// A radius (mm) and an angle (degrees, counter-clockwise from the first axis of the plane) as a
/// line gives them; what it leaves out is that of the position, seen from the zero point.
struct PolarPoint {
  enum class Form : unsigned char {
    g16,    // G91: an angle adds to that of the position, a radius counts from the position
    words,  // G91: radius and angle both add to those of the position
  };
  Form form = Form::g16;
  PlaneAxes axes{};
  std::optional<double> radius, angle;
  bool incremental = false;  // G91

  /// Returns the point that it names with the tool at `position`; both in programmed coordinates,
  /// mm. Sources: G16 by FANUC's operator's manual of the series 16/18 C, 9.2, and Mitsubishi's of
  /// the M700V, 6.12; the words by LinuxCNC's manual, "Polar Coordinates".
  AxisVector from(const AxisVector& position) const noexcept;

  /// Returns whether the words have a meaning at `position`: seen from the zero point itself
  /// nothing has a direction, to which an angle could be added or which a radius alone could have.
  bool has_direction(const AxisVector& position) const noexcept;
};

}  // namespace softcnc::ipr
