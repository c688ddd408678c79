// SPDX-License-Identifier: MIT
#include "motion/geometry/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softcnc {
namespace {

constexpr int kNearestSteps = 6;
constexpr double kLastNearestStep = 1e-9;  // of the portion

constexpr int kPieces = 32;  // of a portion, which are halved where they may be nearest
constexpr double kNearer = 1e-3;
constexpr double kDistanceResolution = 1e-6;  // mm

double distance(const Path& path, double s, const AxisVector& point) noexcept {
  return (position(path, s) - point).norm();
}

/// The nearest place so far, and its distance.
struct Nearest {
  double s = 0;
  double distance = std::numeric_limits<double>::infinity();
};

/// A point of a piece is no further from its middle than half its length.
void search(const Path& path, double s0, double s1, const AxisVector& point,
            Nearest& best) noexcept {
  const double middle = (s0 + s1) / 2, half = (s1 - s0) / 2;
  const double off = distance(path, middle, point);
  if (off < best.distance) best = {middle, off};
  if (off - half >= best.distance * (1 - kNearer) - kDistanceResolution) return;
  search(path, s0, middle, point, best);
  search(path, middle, s1, point, best);
}

}  // namespace

double distance_to_segment(const AxisVector& p, const AxisVector& a, const AxisVector& b) noexcept {
  const AxisVector chord = b - a;
  const double square = chord.squaredNorm();
  const double part = square > 0 ? std::clamp((p - a).dot(chord) / square, 0.0, 1.0) : 0.0;
  return (p - a - part * chord).norm();
}

double nearest(const Portion& portion, const AxisVector& point, double guess) noexcept {
  if (const Line* line = std::get_if<Line>(portion.path)) {
    const double s = (line->to() - line->from()).dot(point - line->from()) / line->length();
    return std::clamp(s, portion.s0, portion.s1);
  }
  double s = std::clamp(guess, portion.s0, portion.s1);
  for (int i = 0; i < kNearestSteps; ++i) {
    const PathPoint here = at(*portion.path, s);
    const AxisVector off = here.q - point;
    const double slope = here.dq.dot(off);
    const double curving = 1 + here.ddq.dot(off);
    const double next = std::clamp(s - slope / std::max(curving, 0.5), portion.s0, portion.s1);
    const double step = std::abs(next - s);
    s = next;
    if (step <= kLastNearestStep * (portion.s1 - portion.s0)) break;
  }
  return s;
}

double nearest(const Portion& portion, const AxisVector& point) noexcept {
  const auto& [path, s0, s1] = portion;
  Nearest best{s0, distance(*path, s0, point)};
  if (const double off = distance(*path, s1, point); off < best.distance) best = {s1, off};
  for (int i = 0; i < kPieces; ++i)
    search(*path, s0 + (s1 - s0) * i / kPieces, s0 + (s1 - s0) * (i + 1) / kPieces, point, best);
  const double polished = nearest(portion, point, best.s);
  return distance(*path, polished, point) < best.distance ? polished : best.s;
}

}  // namespace softcnc
