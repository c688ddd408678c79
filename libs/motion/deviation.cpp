// SPDX-License-Identifier: MIT
#include "motion/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softcnc {
namespace {

constexpr int kNewtonSteps = 6;
constexpr double kLastStep = 1e-9;  // of the portion

double squared_distance(const Path& path, double s, const AxisVector& point) noexcept {
  return (position(path, s) - point).squaredNorm();
}

/// Where the path is nearest among evenly spaced places.
double nearest_sample(const Portion& portion, const AxisVector& point, int samples) noexcept {
  double best = portion.s0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double s = portion.s0 + (portion.s1 - portion.s0) * i / samples;
    const double squared = squared_distance(*portion.path, s, point);
    if (squared >= least) continue;
    least = squared;
    best = s;
  }
  return best;
}

}  // namespace

double distance_to_segment(const AxisVector& p, const AxisVector& a, const AxisVector& b) noexcept {
  const AxisVector way = b - a;
  const double square = way.squaredNorm();
  const double part = square > 0 ? std::clamp((p - a).dot(way) / square, 0.0, 1.0) : 0.0;
  return (p - a - part * way).norm();
}

double nearest(const Portion& portion, const AxisVector& point, double guess) noexcept {
  if (const Line* line = std::get_if<Line>(portion.path)) {
    const double s = (line->to() - line->from()).dot(point - line->from()) / line->length();
    return std::clamp(s, portion.s0, portion.s1);
  }
  double s = std::clamp(guess, portion.s0, portion.s1);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const PathPoint here = at(*portion.path, s);
    const AxisVector off = here.q - point;
    const double slope = here.dq.dot(off);
    const double bend = 1 + here.ddq.dot(off);
    const double next = std::clamp(s - slope / std::max(bend, 0.5), portion.s0, portion.s1);
    const double step = std::abs(next - s);
    s = next;
    if (step <= kLastStep * (portion.s1 - portion.s0)) break;
  }
  return s;
}

double distance(std::span<const Portion> portions, const AxisVector& point, int samples) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const Portion& portion : portions) {
    const double sampled = nearest_sample(portion, point, samples);
    const double s = nearest(portion, point, sampled);
    least = std::min({least, squared_distance(*portion.path, s, point),
                      squared_distance(*portion.path, sampled, point)});
  }
  return std::sqrt(least);
}

}  // namespace softcnc
