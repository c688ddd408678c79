// SPDX-License-Identifier: MIT
#include "motion/roughness/roughness.hpp"

#include <algorithm>
#include <numbers>

#include "motion/roughness/roughness_table.hpp"

namespace softcnc {
namespace {

constexpr double square(double x) noexcept { return x * x; }

/// Returns how far the feed advances while an edge passes, at twice the critical inclination: there
/// it fits a simulation best.
constexpr double phase(const Surface& surface) noexcept {
  return surface.pick_feed / (2 * std::numbers::pi);
}

/// Returns the square of the pick-feed that leaves the same cusps on a flat surface.
double cusp_square(const Surface& surface) noexcept {
  return square(surface.pick_on_slope()) * surface.cusp_part();
}

PassPhase pass_phase_of(const Surface& surface) noexcept {
  return surface.slope_across > 0 ? PassPhase::at_any_phase : PassPhase::in_phase;
}

/// A of (4): of the cusp and the mark of the cutter, square mm.
double squares(const Surface& surface, double feed_per_tooth) noexcept {
  return cusp_square(surface) + square(std::max(feed_per_tooth - phase(surface), 0.0));
}

/// Returns the height, mm, above the middle of a chord of the ball; `half_squared` is the square of
/// half the chord.
double sagitta(double radius, double half_squared) noexcept {
  return half_squared / (radius + std::sqrt(std::max(square(radius) - half_squared, 0.0)));
}

/// Returns the square of half the chord for a height. The target never exceeds the ball.
double half_chord_squared(const Surface& surface) noexcept {
  const double height = std::min(surface.rmax, surface.tool_radius);
  return height * (2 * surface.tool_radius - height);
}

/// A flat surface on which edges leave no less than on a curved one. Where the surface is curved by
/// a factor k (1 + r/R along, equation 1 across) a ball lies on it as on a flat one on which all
/// lengths in that direction are sqrt(k) times as long; but edges turn on the ball, where they are
/// k times as long. What that may add is kept free by powers of k that simulated edges never
/// exceed.
struct Flattened {
  double pick_feed;   // mm
  double feed_scale;  // of the feed per tooth
  double tip;         // of the distance from the tip to where the ball touches, pick-feeds

  Flattened(const Surface& surface, double sine, double hollow) noexcept {
    const double across = surface.cusp_part();
    const double along = hollow > 0 ? 1 + surface.tool_radius * hollow : 1;
    pick_feed = surface.pick_on_slope() * std::sqrt(across);
    feed_scale = along == 1 ? 1 : std::pow(along, kAlong);
    if (across != 1) feed_scale *= std::pow(across, across > 1 ? kHollow : kHill);
    tip = surface.tool_radius * sine / (pick_feed * std::sqrt(along));
  }

  static constexpr double kAlong = 2.0 / 3;                     // 1/2 by equation 1
  static constexpr double kHollow = 1.0 / 3, kHill = -1.0 / 6;  // across, where it is 0
};

double edge_rmax(const Surface& surface, double feed_per_tooth, const Flattened& flat) noexcept {
  const double height = edge_height(pass_phase_of(surface), surface.teeth,
                                    feed_per_tooth * flat.feed_scale / flat.pick_feed, flat.tip);
  return sagitta(surface.tool_radius,
                 std::min(height * square(flat.pick_feed) / 4, square(surface.tool_radius)));
}

/// Passes alone leave the sagitta of half the pick-feed.
double largest_edge_feed(const Surface& surface, const Flattened& flat) noexcept {
  const double height = 4 * half_chord_squared(surface) / square(flat.pick_feed);
  return flat.pick_feed * edge_feed(pass_phase_of(surface), surface.teeth, height, flat.tip) /
         flat.feed_scale;
}

/// Returns the upward curvature of a path at a point, 1/mm, where the model uses it.
double hollow_at(RoughnessModel model, const Surface& surface, const PathPoint& point) noexcept {
  return model == RoughnessModel::guaranteed
             ? hollow_curvature(point.dq, point.ddq, surface.slope_across)
             : 0;
}

}  // namespace

double rmax_of_curved(const Surface& surface, double feed_per_tooth, double along) noexcept {
  const double r = surface.tool_radius;
  return (square(feed_per_tooth) * (1 - r / (along + r)) + cusp_square(surface)) / (8 * r);
}

double rmax_beside_tip(const Surface& surface, double feed_per_tooth) noexcept {
  return squares(surface, feed_per_tooth) / (8 * surface.tool_radius);
}

double rmax_at_tip(const Surface& surface, double feed_per_tooth, double sine) noexcept {
  const double r = surface.tool_radius;
  const double remains = square(feed_per_tooth) - square(r * sine);
  return sagitta(r, std::clamp(remains, 0.0, square(r)));
}

double critical_inclination(const Surface& surface, double feed_per_tooth) noexcept {
  const double r = surface.tool_radius, a = squares(surface, feed_per_tooth);
  const double tip = square(a / (8 * r)) - a / 4 + square(feed_per_tooth);
  return tip > 0 ? std::asin(std::min(std::sqrt(tip) / r, 1.0)) : 0;
}

double feed_beside_tip(const Surface& surface) noexcept {
  const double left = 8 * surface.tool_radius * surface.rmax - cusp_square(surface);
  return phase(surface) + std::sqrt(std::max(left, 0.0));
}

double feed_at_tip(const Surface& surface, double sine) noexcept {
  return std::sqrt(square(surface.tool_radius * sine) + half_chord_squared(surface));
}

double hollow_curvature(const AxisVector& tangent, const AxisVector& second,
                        double slope) noexcept {
  const AxisVector up = AxisVector(0, 0, 1) - tangent[2] * tangent;
  const double level = up.norm();
  if (!(level > 0)) return 0;
  const double upwards = second.dot(up) / level;
  const double aside = std::sqrt(std::max(0.0, second.squaredNorm() - square(upwards)));
  const double turned =
      std::min(slope, std::atan2(aside, upwards));  // where most of it lies in the surface
  return std::max(0.0, upwards * std::cos(turned) + aside * std::sin(turned));
}

double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth, double sine,
            double hollow) noexcept {
  if (model == RoughnessModel::guaranteed)
    return edge_rmax(surface, feed_per_tooth, Flattened(surface, sine, hollow));
  return std::max(rmax_beside_tip(surface, feed_per_tooth),
                  rmax_at_tip(surface, feed_per_tooth, sine));
}

double largest_feed_per_tooth(RoughnessModel model, const Surface& surface, double sine,
                              double hollow) noexcept {
  const double feed = model == RoughnessModel::paper
                          ? std::min(feed_beside_tip(surface), feed_at_tip(surface, sine))
                          : largest_edge_feed(surface, Flattened(surface, sine, hollow));
  return std::max(feed, kLeastFeedPerTooth);
}

double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth,
            const PathPoint& point) noexcept {
  return rmax(model, surface, feed_per_tooth, inclination_sine(point.dq),
              hollow_at(model, surface, point));
}

double largest_feed_per_tooth(RoughnessModel model, const Surface& surface,
                              const PathPoint& point) noexcept {
  return largest_feed_per_tooth(model, surface, inclination_sine(point.dq),
                                hollow_at(model, surface, point));
}

double least_feed_per_tooth(RoughnessModel model, const Surface& surface) noexcept {
  double least = largest_feed_per_tooth(model, surface, 0);
  if (model == RoughnessModel::paper) return least;
  for (int node = 1; node < kSimulatedTips; ++node) {
    const double sine = simulated_tip(node) * std::sqrt(cusp_square(surface)) / surface.tool_radius;
    least = std::min(least, largest_feed_per_tooth(model, surface, sine));
  }
  return least;
}

}  // namespace softcnc
