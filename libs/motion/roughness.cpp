// SPDX-License-Identifier: MIT
#include "motion/roughness.hpp"

#include <algorithm>
#include <numbers>

#include "motion/roughness_table.hpp"

namespace softcnc {
namespace {

constexpr double square(double x) noexcept { return x * x; }

/// How far the feed goes on while an edge passes, at twice the critical inclination: there it fits
/// a simulation best.
constexpr double phase(const Surface& surface) noexcept {
  return surface.pick_feed / (2 * std::numbers::pi);
}

/// A of (4): of the cusp and the mark of the cutter, square mm.
double squares(const Surface& surface, double feed_per_tooth) noexcept {
  return square(surface.pick_feed) + square(std::max(feed_per_tooth - phase(surface), 0.0));
}

/// The height over the foot of a chord of the ball, mm, half of which is `half` mm long.
double sagitta(double radius, double half_squared) noexcept {
  return half_squared / (radius + std::sqrt(std::max(square(radius) - half_squared, 0.0)));
}

/// The other way round: the square of half the chord. The target is none of more than the ball.
double half_chord_squared(const Surface& surface) noexcept {
  const double height = std::min(surface.rmax, surface.tool_radius);
  return height * (2 * surface.tool_radius - height);
}

/// Passes alone leave the sagitta of half the pick-feed.
double height_over_cusp(const Surface& surface) noexcept {
  return 4 * half_chord_squared(surface) / square(surface.pick_feed);
}

double edge_rmax(const Surface& surface, double feed_per_tooth, double sine) noexcept {
  const double pick_feed = surface.pick_feed;
  const double height = edge_height(surface.teeth, feed_per_tooth / pick_feed,
                                    surface.tool_radius * sine / pick_feed);
  return sagitta(surface.tool_radius,
                 std::min(height * square(pick_feed) / 4, square(surface.tool_radius)));
}

}  // namespace

double rmax_of_curved(const Surface& surface, double feed_per_tooth, double along,
                      double across) noexcept {
  const double r = surface.tool_radius;
  return square(feed_per_tooth) / (8 * r) * (1 - r / (along + r)) +
         square(surface.pick_feed) / (8 * r) * (1 - r / (across + r));
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
  const double left = 8 * surface.tool_radius * surface.rmax - square(surface.pick_feed);
  return phase(surface) + std::sqrt(std::max(left, 0.0));
}

double feed_at_tip(const Surface& surface, double sine) noexcept {
  return std::sqrt(square(surface.tool_radius * sine) + half_chord_squared(surface));
}

double hollow_bend(const AxisVector& tangent, const AxisVector& bend) noexcept {
  const AxisVector up = AxisVector(0, 0, 1) - tangent[2] * tangent;
  const double level = up.norm();
  return level > 0 ? std::max(0.0, bend.dot(up) / level) : 0;
}

double rmax(RoughnessModel model, const Surface& surface, double feed_per_tooth, double sine,
            double hollow) noexcept {
  if (model == RoughnessModel::guaranteed)
    return edge_rmax(surface, feed_per_tooth * std::sqrt(1 + surface.tool_radius * hollow), sine);
  return std::max(rmax_beside_tip(surface, feed_per_tooth),
                  rmax_at_tip(surface, feed_per_tooth, sine));
}

double largest_feed_per_tooth(RoughnessModel model, const Surface& surface, double sine,
                              double hollow) noexcept {
  const double feed = model == RoughnessModel::paper
                          ? std::min(feed_beside_tip(surface), feed_at_tip(surface, sine))
                          : surface.pick_feed *
                                edge_feed(surface.teeth, height_over_cusp(surface),
                                          surface.tool_radius * sine / surface.pick_feed) /
                                std::sqrt(1 + surface.tool_radius * hollow);
  return std::max(feed, kLeastFeedPerTooth);
}

double least_feed_per_tooth(RoughnessModel model, const Surface& surface) noexcept {
  double least = largest_feed_per_tooth(model, surface, 0);
  if (model == RoughnessModel::paper) return least;
  for (int node = 1; node < kSimulatedTips; ++node) {
    const double sine = simulated_tip(node) * surface.pick_feed / surface.tool_radius;
    least = std::min(least, largest_feed_per_tooth(model, surface, sine));
  }
  return least;
}

}  // namespace softcnc
