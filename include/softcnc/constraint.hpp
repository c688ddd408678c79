// SPDX-License-Identifier: MIT
// A reason to be slow that the machine file does not know.
#pragma once

#include <softcnc/export.hpp>
#include <softcnc/setpoint.hpp>

namespace softcnc::api {

/// A point of the path: position, and its derivatives by arc length.
struct PathPoint {
  AxisVector position;   // mm
  AxisVector tangent;    // without unit, of length 1
  AxisVector curvature;  // 1/mm: the second derivative
  double feed = 0;       // mm/s, as programmed; 0 in rapids
  bool rapid = false;
};

/// A velocity limit: an upper bound of the speed at each point of the path. It is evaluated while
/// planning, at the nodes of the planner's grid, so a limit that varies along a straight line is
/// seen at the line's ends alone. In traces and reports it is `custom`.
class SOFTCNC_API Constraint {
 public:
  Constraint() = default;
  Constraint(const Constraint&) = delete;
  Constraint& operator=(const Constraint&) = delete;
  virtual ~Constraint();

  /// Returns the largest speed at this point, mm/s; infinity where there is no limit. Less than
  /// 0.001 mm/s, and NaN, count as 0.001 mm/s. The same point must give the same speed each time.
  virtual double largest_speed(const PathPoint& point) const noexcept = 0;
};

}  // namespace softcnc::api
