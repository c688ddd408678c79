// SPDX-License-Identifier: MIT
#include "motion/geometry/spline.hpp"

#include <fmt/format.h>

#include <vector>

namespace softcnc {
namespace {

using SplinePoints = std::span<const AxisVector>;

Status check_points(SplinePoints points) {
  if (points.size() < 2)
    return tl::unexpected(
        Diagnostic{Code::SC2350,
                   {},
                   fmt::format("a spline through {} point{}; it needs at least two", points.size(),
                               points.empty() ? "s" : ""),
                   {},
                   {}});
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i] - points[i - 1]).norm() < kSplineSamePoint)
      return tl::unexpected(
          Diagnostic{Code::SC2351,
                     {},
                     fmt::format("point {} of the spline is the same as point {}", i + 1, i),
                     {},
                     {}});
  return {};
}

/// Returns how far the parameter goes on from each point to the next.
std::vector<double> steps_of(SplinePoints points, SplineParameter parameter) {
  std::vector<double> steps;
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    steps.push_back((points[i] - points[i - 1]).norm());
    length += steps.back();
  }
  if (parameter == SplineParameter::uniform)
    steps.assign(steps.size(), length / static_cast<double>(steps.size()));
  return steps;
}

/// A row of the equations for the tangents T: before T[i-1] + at T[i] + after T[i+1] = right.
struct TridiagonalRow {
  double before, at, after;
  AxisVector right;
};

/// That the second derivative is the same on both sides of point i, and none at natural ends, in
/// terms of Hermite pieces. Diagonally dominant.
TridiagonalRow row_of(SplinePoints points, const std::vector<double>& steps, const SplineEnds& ends,
                      std::size_t i) {
  const auto direction = [&](std::size_t k) {
    return AxisVector((points[k + 1] - points[k]) / steps[k]);
  };
  const auto given = [](const AxisVector& end, const AxisVector& of_chord) {
    return TridiagonalRow{0, 1, 0, of_chord.norm() * end.normalized()};
  };
  if (i == 0)
    return ends.first ? given(*ends.first, direction(0))
                      : TridiagonalRow{0, 2, 1, 3 * direction(0)};
  if (i + 1 == points.size())
    return ends.last ? given(*ends.last, direction(i - 1))
                     : TridiagonalRow{1, 2, 0, 3 * direction(i - 1)};
  const double share = steps[i] / (steps[i - 1] + steps[i]);  // of the piece before, crosswise
  const double rest = 1 - share;
  return {share, 2, rest, 3 * (share * direction(i - 1) + rest * direction(i))};
}

/// By elimination from the first point to the last, and back.
std::vector<AxisVector> tangents_of(SplinePoints points, const std::vector<double>& steps,
                                    const SplineEnds& ends) {
  std::vector<AxisVector> tangents;
  std::vector<double> after;
  for (std::size_t i = 0; i < points.size(); ++i) {
    TridiagonalRow row = row_of(points, steps, ends, i);
    if (i > 0) {
      row.at -= row.before * after.back();
      row.right -= row.before * tangents.back();
    }
    after.push_back(row.after / row.at);
    tangents.emplace_back(row.right / row.at);
  }
  for (std::size_t i = points.size() - 1; i > 0; --i) tangents[i - 1] -= after[i - 1] * tangents[i];
  return tangents;
}

/// Returns the de Boor point of the knots around point i: the blossom of the piece after it.
AxisVector inner_control(SplinePoints points, const std::vector<double>& steps,
                         const std::vector<AxisVector>& tangents, std::size_t i) {
  const AxisVector leap = (points[i + 1] - points[i]) / steps[i];
  const AxisVector both = tangents[i] + tangents[i + 1];
  return points[i] + steps[i] / 3 * tangents[i] + steps[i - 1] * (both / 3 - leap);
}

std::vector<AxisVector> control_of(SplinePoints points, const std::vector<double>& steps,
                                   const SplineEnds& ends) {
  const auto tangents = tangents_of(points, steps, ends);
  std::vector<AxisVector> control{points.front(), points.front() + steps[0] / 3 * tangents[0]};
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    control.push_back(inner_control(points, steps, tangents, i));
  control.emplace_back(points.back() - steps.back() / 3 * tangents.back());
  control.push_back(points.back());
  return control;
}

std::vector<double> knots_of(const std::vector<double>& steps) {
  std::vector<double> knots(4, 0.0);
  for (const double step : steps) knots.push_back(knots.back() + step);
  knots.insert(knots.end(), 3, knots.back());
  return knots;
}

}  // namespace

Result<NurbsSpec> cubic_spline(SplinePoints points, SplineParameter parameter,
                               const SplineEnds& ends) {
  if (Status status = check_points(points); !status) return tl::unexpected(status.error());
  const std::vector<double> steps = steps_of(points, parameter);
  NurbsSpec spec;
  spec.control = control_of(points, steps, ends);
  spec.weights.assign(spec.control.size(), 1.0);
  spec.knots = knots_of(steps);
  return spec;
}

}  // namespace softcnc
