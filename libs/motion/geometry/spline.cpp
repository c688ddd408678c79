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

std::vector<double> chords_of(SplinePoints points) {
  std::vector<double> chords;
  for (std::size_t i = 1; i < points.size(); ++i)
    chords.push_back((points[i] - points[i - 1]).norm());
  return chords;
}

/// A row of the equations for the tangents T: before T[i-1] + at T[i] + after T[i+1] = right.
struct TridiagonalRow {
  double before, at, after;
  AxisVector right;
};

/// That the second derivative is the same on both sides of point i, and none at the ends, in terms
/// of Hermite pieces. Diagonally dominant.
TridiagonalRow row_of(SplinePoints points, const std::vector<double>& chords, std::size_t i) {
  const auto direction = [&](std::size_t k) {
    return AxisVector((points[k + 1] - points[k]) / chords[k]);
  };
  if (i == 0) return {0, 2, 1, 3 * direction(0)};
  if (i + 1 == points.size()) return {1, 2, 0, 3 * direction(i - 1)};
  const double share = chords[i] / (chords[i - 1] + chords[i]);  // of the piece before, crosswise
  const double rest = 1 - share;
  return {share, 2, rest, 3 * (share * direction(i - 1) + rest * direction(i))};
}

/// By elimination from the first point to the last, and back.
std::vector<AxisVector> tangents_of(SplinePoints points, const std::vector<double>& chords) {
  std::vector<AxisVector> tangents;
  std::vector<double> after;
  for (std::size_t i = 0; i < points.size(); ++i) {
    TridiagonalRow row = row_of(points, chords, i);
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
AxisVector inner_control(SplinePoints points, const std::vector<double>& chords,
                         const std::vector<AxisVector>& tangents, std::size_t i) {
  const AxisVector leap = (points[i + 1] - points[i]) / chords[i];
  const AxisVector both = tangents[i] + tangents[i + 1];
  return points[i] + chords[i] / 3 * tangents[i] + chords[i - 1] * (both / 3 - leap);
}

std::vector<AxisVector> control_of(SplinePoints points, const std::vector<double>& chords) {
  const auto tangents = tangents_of(points, chords);
  std::vector<AxisVector> control{points.front(), points.front() + chords[0] / 3 * tangents[0]};
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    control.push_back(inner_control(points, chords, tangents, i));
  control.emplace_back(points.back() - chords.back() / 3 * tangents.back());
  control.push_back(points.back());
  return control;
}

std::vector<double> knots_of(const std::vector<double>& chords) {
  std::vector<double> knots(4, 0.0);
  for (const double chord : chords) knots.push_back(knots.back() + chord);
  knots.insert(knots.end(), 3, knots.back());
  return knots;
}

}  // namespace

Result<NurbsSpec> natural_spline(SplinePoints points) {
  if (Status status = check_points(points); !status) return tl::unexpected(status.error());
  const std::vector<double> chords = chords_of(points);
  NurbsSpec spec;
  spec.control = control_of(points, chords);
  spec.weights.assign(spec.control.size(), 1.0);
  spec.knots = knots_of(chords);
  return spec;
}

}  // namespace softcnc
