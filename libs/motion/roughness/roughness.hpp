// SPDX-License-Identifier: MIT
// The roughness that a ball end mill leaves, and the feed that keeps it: the extended model of
// paper 004 with its equations by number, and one that edges turning on the ball never exceed.
// Lengths in mm; `sine` is that of the inclination, the part of the unit tangent along the tool
// axis; upward and downward milling leave the same.
#pragma once

#include <cmath>
#include <limits>

#include "motion/core/axes.hpp"
#include "motion/geometry/curve.hpp"
#include "motion/roughness/roughness_request.hpp"

namespace softcnc {

/// The tool axis is that of Z, whatever the plane of arcs is.
inline double inclination_sine(const AxisVector& tangent) noexcept { return std::abs(tangent[2]); }

/// 1/mm: how much the surface bends upwards along a way, as through a valley; 0 where it does not.
/// By the unit tangent and second derivative of the way. Where the surface slopes across the feed
/// by up to `slope`, rad, bends to the side count as far as they may lie in it.
double hollow_curvature(const AxisVector& tangent, const AxisVector& bend,
                        double slope = 0) noexcept;

/// (1): both radii of curvature count, that across the feed as the surface has it, and that along
/// it; infinite: flat, and negative: hollow.
double rmax_of_curved(const Surface& surface, double feed_per_tooth,
                      double along = std::numeric_limits<double>::infinity()) noexcept;

/// (2), beside the tip, with the phase that (4) and (5) have too; there it never falls with the
/// feed. Cusps are those of (1), where the surface bends across the feed; in (4) and (5) too.
double rmax_beside_tip(const Surface& surface, double feed_per_tooth) noexcept;
/// (3), of what the tip leaves uncut; 0 where it leaves nothing, the radius where it leaves all.
double rmax_at_tip(const Surface& surface, double feed_per_tooth, double sine) noexcept;
/// (4), rad: where (2) and (3) meet; 0 where (3) is the lower one everywhere.
double critical_inclination(const Surface& surface, double feed_per_tooth) noexcept;
/// (5), for the target of the surface.
double feed_beside_tip(const Surface& surface) noexcept;
/// (6), likewise.
double feed_at_tip(const Surface& surface, double sine) noexcept;

/// mm: teeth that are fed less rub; no target asks for less.
inline constexpr double kLeastFeedPerTooth = 0.002;

/// Rmax at a feed per tooth; it never falls with the feed. In a valley that bends by `hollow`,
/// 1/mm, the surface is longer than the way of the tip, and the feed leaves more (equation 1). The
/// formulas (2) to (6) of the paper do not know of it, and only the guaranteed model does.
double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth, double sine,
            double hollow = 0) noexcept;
/// The largest feed per tooth at which Rmax is no higher than the target, but kLeastFeedPerTooth.
double largest_feed_per_tooth(RoughnessModel model, const Surface& surface, double sine,
                              double hollow = 0) noexcept;

/// Both where a way is at a point of its path.
double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth,
            const PathPoint& point) noexcept;
double largest_feed_per_tooth(RoughnessModel model, const Surface& surface,
                              const PathPoint& point) noexcept;

/// The smallest of them over all inclinations.
double least_feed_per_tooth(RoughnessModel model, const Surface& surface) noexcept;

}  // namespace softcnc
