// SPDX-License-Identifier: MIT
// The roughness that a ball end mill leaves, and the feed that keeps it: the extended model of
// paper 004 with its equations by number, and one that edges turning on the ball never exceed.
// Lengths are in mm. `sine` is that of the inclination, the component of the unit tangent along the
// tool axis; upward and downward milling leave the same.
#pragma once

#include <cmath>
#include <limits>

#include "motion/core/axes.hpp"
#include "motion/geometry/curve.hpp"
#include "motion/roughness/roughness_request.hpp"

namespace softcnc {

/// The tool axis is Z, whatever the plane of arcs is.
inline double inclination_sine(const AxisVector& tangent) noexcept { return std::abs(tangent[2]); }

/// Returns the upward curvature of the surface along a path, 1/mm, as through a valley; 0 where it
/// is not hollow. `tangent` and `second` are the unit tangent and the second derivative of the
/// path. Where the surface slopes across the feed by up to `slope`, rad, curvature to the side
/// counts as far as it may lie in the surface.
double hollow_curvature(const AxisVector& tangent, const AxisVector& second,
                        double slope = 0) noexcept;

/// Equation (1): both radii of curvature count, that of the surface across the feed and that along
/// it; infinite: flat, negative: hollow.
double rmax_of_curved(const Surface& surface, double feed_per_tooth,
                      double along = std::numeric_limits<double>::infinity()) noexcept;

/// Equation (2), beside the tip, with the phase that (4) and (5) have, too; there it never falls
/// with the feed. Cusps are those of (1), where the surface is curved across the feed; in (4) and
/// (5), too.
double rmax_beside_tip(const Surface& surface, double feed_per_tooth) noexcept;
/// Equation (3), of what the tip leaves uncut; 0 where it leaves nothing, the radius where it
/// leaves all.
double rmax_at_tip(const Surface& surface, double feed_per_tooth, double sine) noexcept;
/// Equation (4), rad: where (2) and (3) meet; 0 where (3) is the lower one everywhere.
double critical_inclination(const Surface& surface, double feed_per_tooth) noexcept;
/// Equation (5), for the target of the surface.
double feed_beside_tip(const Surface& surface) noexcept;
/// Equation (6), for the target of the surface.
double feed_at_tip(const Surface& surface, double sine) noexcept;

/// mm: teeth with a smaller feed rub; no target requires less.
inline constexpr double kLeastFeedPerTooth = 0.002;

/// Returns Rmax at a feed per tooth; it never falls with the feed. In a valley of curvature
/// `hollow`, 1/mm, the surface is longer than the path of the tip, and the feed leaves more
/// (equation 1). The formulas (2) to (6) of the paper do not include that; only the guaranteed
/// model does.
double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth, double sine,
            double hollow = 0) noexcept;
/// Returns the largest feed per tooth at which Rmax is at most the target, but at least
/// kLeastFeedPerTooth.
double largest_feed_per_tooth(RoughnessModel model, const Surface& surface, double sine,
                              double hollow = 0) noexcept;

/// Both at a point of a path.
double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth,
            const PathPoint& point) noexcept;
double largest_feed_per_tooth(RoughnessModel model, const Surface& surface,
                              const PathPoint& point) noexcept;

/// Returns the smallest of them over all inclinations.
double least_feed_per_tooth(RoughnessModel model, const Surface& surface) noexcept;

}  // namespace softcnc
