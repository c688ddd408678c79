// SPDX-License-Identifier: MIT
// Which staircase suits which path.
#include "motion/pulses/staircase.hpp"

#include <cmath>

#include "motion/pulses/counts.hpp"

namespace softcnc {

GridPoint counts_of(const AxisVector& point, const AxisVector& blu) noexcept {
  GridPoint counts{};
  for (int i = 0; i < kAxes; ++i) counts[static_cast<std::size_t>(i)] = Counts(blu[i])(point[i]);
  return counts;
}

Staircase::Staircase(const Path& path, const AxisVector& blu, PulseMethod method)
    : blu_(blu),
      from_(counts_of(start(path), blu)),
      to_(counts_of(end(path), blu)),
      pulses_(std::visit([&](const auto& curve) { return pulses_of(curve, method); }, path)) {}

std::size_t Staircase::fill(std::span<Step> out) noexcept {
  return std::visit([out](auto& pulses) { return pulses.fill(out); }, pulses_);
}

std::optional<double> Staircase::arc_length() const noexcept {
  const auto* curve = std::get_if<CurvePulses>(&pulses_);
  return curve ? std::optional(curve->arc_length()) : std::nullopt;
}

GridPoint Staircase::displacement() const noexcept {
  GridPoint displacement{};
  for (std::size_t i = 0; i < displacement.size(); ++i) displacement[i] = to_[i] - from_[i];
  return displacement;
}

Staircase::Pulses Staircase::pulses_of(const Line&, PulseMethod method) const {
  return LinePulses(displacement(), method);
}

Staircase::Pulses Staircase::pulses_of(const Nurbs& nurbs, PulseMethod method) const {
  return CurvePulses(SplineTrace(nurbs, grid()), displacement(), method);
}

Staircase::Pulses Staircase::pulses_of(const Arc& arc, PulseMethod method) const {
  if (!is_circle(arc)) return CurvePulses(ArcTrace(arc, grid()), displacement(), method);
  const PlaneAxes axes = plane_axes(arc.plane());
  const auto parts = [](double in_blu) {
    return std::llround(in_blu * static_cast<double>(PulseArc::kPart));
  };
  const auto plane_place = [&](const GridPoint& grid) {
    return std::array{grid[static_cast<std::size_t>(axes.first)],
                      grid[static_cast<std::size_t>(axes.second)]};
  };
  const double blu = blu_[axes.first];
  PulseArc pulses;
  pulses.axes = {axes.first, axes.second};
  pulses.from = plane_place(from_);
  pulses.to = plane_place(to_);
  pulses.center = {parts(arc.center()[axes.first] / blu), parts(arc.center()[axes.second] / blu)};
  pulses.radius = parts(arc.radius() / blu);
  pulses.sweep = arc.sweep();
  return ArcPulses(pulses, method);
}

/// Whether x^2 + y^2 = R^2 describes the arc in both axes' BLU: no helix, no spiral, no ellipse.
bool Staircase::is_circle(const Arc& arc) const noexcept {
  const PlaneAxes axes = plane_axes(arc.plane());
  const auto across = static_cast<std::size_t>(axes.across);
  const double blu = blu_[axes.first];
  const AxisVector arm = arc.to() - arc.center();
  const double growth = std::hypot(arm[axes.first], arm[axes.second]) - arc.radius();
  const double furthest = static_cast<double>(PulseArc::kFurthest) * blu;
  return blu == blu_[axes.second] && from_[across] == to_[across] &&
         std::abs(growth) <= 0.5 * blu && arc.radius() + arc.center().norm() < furthest;
}

}  // namespace softcnc
