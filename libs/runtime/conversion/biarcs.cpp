// SPDX-License-Identifier: MIT
#include "runtime/conversion/biarcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "motion/geometry/deviation.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kStraight = 1e-9;  // of a direction
constexpr double kLargest = 1e5;    // mm: a larger radius is a line
constexpr double kShortest = 1e-5;  // mm: a shorter biarc is a line
constexpr int kSamples = 24;

AxisVector left_of(const AxisVector& direction) { return {-direction[1], direction[0], 0}; }

/// Returns the arc from a to b that leaves a in a direction; a line where it hardly bends.
Path arc_from(const AxisVector& a, const AxisVector& direction, const AxisVector& b) {
  const AxisVector normal = left_of(direction), chord = b - a;
  const double across = normal.dot(chord);
  const double radius = chord.squaredNorm() / (2 * across);
  if (std::abs(across) < kStraight * chord.norm() || std::abs(radius) > kLargest) return Line(a, b);
  const auto arc = Arc::make({a, b, a + radius * normal, Plane::xy, across > 0});
  if (!arc) return Line(a, b);
  return *arc;
}

/// Returns where the two arcs of a biarc with equal tangent lengths meet (the family of biarcs of
/// K. M. Bolton, 1975); nothing where there are none.
std::optional<AxisVector> middle_of(const AxisVector& a, const AxisVector& from,
                                    const AxisVector& b, const AxisVector& to) {
  const AxisVector chord = b - a;
  const double along = chord.dot(from + to), turn = 2 * (1 - from.dot(to));
  double d = 0;
  if (turn > kStraight)
    d = (-along + std::sqrt(along * along + turn * chord.squaredNorm())) / turn;
  else if (chord.dot(to) > 0)
    d = chord.squaredNorm() / (4 * chord.dot(to));
  if (!(d > 0)) return std::nullopt;
  return AxisVector(0.5 * (a + b + d * (from - to)));
}

double distance_to(const Path& path, const AxisVector& point) {
  if (const auto* arc = std::get_if<Arc>(&path))
    return std::abs((point - arc->center()).norm() - arc->radius());
  return distance_to_segment(point, start(path), end(path));
}

using Biarc = std::array<Path, 2>;

std::optional<Biarc> biarc(const Path& path, double s0, double s1) {
  const PathPoint a = at(path, s0), b = at(path, s1, Side::before);
  const auto middle = middle_of(a.q, a.dq, b.q, b.dq);
  if (!middle || (*middle - a.q).norm() < kShortest || (b.q - *middle).norm() < kShortest)
    return std::nullopt;
  const Path first = arc_from(a.q, a.dq, *middle);
  const Path back = arc_from(b.q, -b.dq, *middle);
  const auto* arc = std::get_if<Arc>(&back);
  if (!arc) return Biarc{first, Line(*middle, b.q)};
  const auto second = Arc::make({*middle, b.q, arc->center(), Plane::xy, !arc->ccw()});
  if (!second) return std::nullopt;
  return Biarc{first, *second};
}

bool is_near(const Biarc& biarc, const Path& path, double s0, double s1, double tolerance) {
  if (length(biarc[0]) + length(biarc[1]) > 2 * (s1 - s0)) return false;
  for (int i = 1; i < kSamples; ++i) {
    const AxisVector point = position(path, s0 + (s1 - s0) * i / kSamples);
    if (std::min(distance_to(biarc[0], point), distance_to(biarc[1], point)) > tolerance)
      return false;
  }
  return true;
}

}  // namespace

void as_biarcs(const Path& path, double tolerance, const std::function<void(const Path&)>& take) {
  const double end = length(path);
  double step = end;
  for (double s = 0; s < end;) {
    step = std::min(2 * step, end - s);
    std::optional<Biarc> found;
    while (step > kShortest) {
      found = biarc(path, s, s + step);
      if (found && is_near(*found, path, s, s + step, tolerance)) break;
      found.reset();
      step *= 0.8;
    }
    if (end - s - step < kShortest) step = end - s;
    if (found) {
      take((*found)[0]);
      take((*found)[1]);
    } else {
      take(Line(position(path, s), position(path, s + step)));
    }
    s += step;
  }
}

}  // namespace softcnc::runtime
