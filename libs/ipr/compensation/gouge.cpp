// SPDX-License-Identifier: MIT
#include "ipr/compensation/gouge.hpp"

#include <algorithm>
#include <cmath>

#include "ipr/compensation/corner.hpp"
#include "ipr/state/nearness.hpp"
#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kGrazing = 5e-3;  // mm: programs are rounded to less

const Path& path_of(const OffsetMove& move) { return std::get<Move>(move.block.what).path; }

Gouge too_large(Code code, double tool_radius, const std::string& for_what) {
  return {code, "the tool, radius " + number_text(tool_radius) + " mm, does not fit " + for_what};
}

bool same_height(const Path& before, const Path& next, const PlaneAxes& axes) {
  const double height = start(before)[axes.across];
  const auto is_level = [&](const AxisVector& point) {
    return std::abs(point[axes.across] - height) < kSamePoint;
  };
  return is_level(end(before)) && is_level(start(next)) && is_level(end(next));
}

/// What lies between two curves after a point in which they cross at a small angle, is at most
/// sin^2 / 2c wide, c being the difference of their curvatures.
bool grazes(const PlaneCurve& before, const PlaneCurve& next, const PlaneVector& at) {
  const PlaneVector a = before.direction_at(at), b = next.direction_at(at);
  const double sine = cross(a, b);
  const double difference =
      (before.curvature() * left_of(a) - next.curvature() * left_of(b)).norm();
  return sine * sine < 2 * difference * kGrazing;
}

/// Whether they do, and not just touch, in a point that counts.
template <typename Counts>
bool cross_at(const PlaneCurve& before, const PlaneCurve& next, Counts counts) {
  const Meetings all = meetings(before, next);
  return std::any_of(all.of.begin(), all.of.begin() + static_cast<std::ptrdiff_t>(all.count),
                     [&](const Meeting& at) { return counts(at) && !grazes(before, next, at.at); });
}

bool parallels_cross(const OffsetMove& before, const OffsetMove& next) {
  return cross_at(before.parallel, next.parallel, [&](const Meeting& at) {
    return before.keeps(before.parallel.length() - at.cut_before) && next.keeps(at.cut_after);
  });
}

bool cuts_past_outside_corner(const OffsetMove& before, const OffsetMove& next,
                              const CutterSide& mode) {
  if (corner_between(before.contour, next.contour, mode.side, mode.radius) != Corner::outside)
    return false;
  const bool into_before = cross_at(before.contour, next.parallel, [&](const Meeting& at) {
    return at.cut_before > kAtEnd && next.keeps(at.cut_after);
  });
  return into_before || cross_at(before.parallel, next.contour, [&](const Meeting& at) {
           return before.keeps(before.parallel.length() - at.cut_before) && at.cut_after > kAtEnd;
         });
}

}  // namespace

Gouge gouge_on_arc(const PlaneCurve& contour, double tool_radius) {
  return too_large(Code::SC2145, tool_radius,
                   "into an arc of radius " + number_text(contour.start_radius()) + " mm");
}

Gouge gouge_in_corner(double tool_radius) {
  return too_large(Code::SC2146, tool_radius, "into the inside corner before this move");
}

std::optional<Gouge> gouge_between_corners(const OffsetMove& move, const Meeting& end,
                                           double tool_radius) {
  if (move.cut + end.cut_before <= move.parallel.length() + kLeastRemainder) return std::nullopt;
  return too_large(Code::SC2147, tool_radius, "between the inside corners of this move");
}

std::optional<Gouge> gouge_of_neighbours(const OffsetMove& before, const OffsetMove& next,
                                         const CutterSide& mode) {
  if (before.entry || !same_height(path_of(before), path_of(next), plane_axes(mode.plane)))
    return std::nullopt;
  if (!parallels_cross(before, next) && !cuts_past_outside_corner(before, next, mode))
    return std::nullopt;
  return too_large(Code::SC2150, mode.radius, "between this move and the one before");
}

}  // namespace softcnc::ipr
