// SPDX-License-Identifier: MIT
#include "runtime/circle/circle_figures.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

using Eigen::Vector2d;

constexpr double kQuarter = kTurn / 4;
constexpr double kWindow = kTurn / 12;   // rad on each side of a reversal: its step is fitted there
constexpr double kPassing = kTurn / 60;  // rad on each side: no part of the fit, but of the spike

/// A point, and the angle for which it stands, rad.
struct Weighted {
  Vector2d point;
  double weight;
};

/// The 360 degrees in the middle of a pass; all of it, if it is less.
std::vector<Weighted> middle_of(const CirclePass& pass) {
  const auto& points = pass.actual;
  std::vector<double> turned(points.size(), 0);  // rad, in the direction of motion
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector2d from = points[i - 1] - pass.centre, to = points[i] - pass.centre;
    const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    turned[i] = turned[i - 1] + (pass.clockwise ? -angle : angle);
  }
  const double whole = turned.empty() ? 0 : turned.back();
  const double first = std::max(0.0, (whole - kTurn) / 2), last = first + std::min(whole, kTurn);
  std::vector<Weighted> middle;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double weight =
        std::clamp(turned[i], first, last) - std::clamp(turned[i - 1], first, last);
    if (weight > 0) middle.push_back({points[i], weight});
  }
  return middle;
}

struct Circle {
  Vector2d centre;
  double radius;
};

/// The circle with the least squares of radial distances, by the steps of Gauss and Newton.
Circle least_squares(std::span<const Weighted> points, Circle circle) {
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& [point, weight] : points) {
      const Vector2d out = point - circle.centre;
      const double distance = out.norm();
      if (distance == 0) continue;
      const Eigen::Vector3d line(out.x() / distance, out.y() / distance, 1);
      normal += weight * line * line.transpose();
      right += weight * line * (distance - circle.radius);
    }
    const Eigen::Vector3d change = normal.ldlt().solve(right);
    if (!change.allFinite()) return circle;
    circle.centre += change.head<2>();
    circle.radius += change[2];
  }
  return circle;
}

/// Half a turn at the ends of which is 0.
double within_half_turn(double angle) { return std::remainder(angle, kTurn); }

/// By least squares a + b x + c x^2 + d x^3, and from x = 0 on a step h cos x: the lost motion of
/// one axis, as it is along the radius. x is the angle from the reversal in the direction of
/// motion.
Reversal reversal_at(double place, bool clockwise, std::span<const RadialDeviation> profile) {
  const auto from_place = [&](const RadialDeviation& point) {
    const double angle = within_half_turn(point.angle - place);
    return clockwise ? -angle : angle;
  };
  constexpr int kTerms = 5;
  using Terms = Eigen::Matrix<double, kTerms, 1>;
  using Square = Eigen::Matrix<double, kTerms, kTerms>;
  Square normal = Square::Zero();
  Terms right = Terms::Zero();
  for (const RadialDeviation& point : profile) {
    const double x = from_place(point);
    if (std::abs(x) > kWindow || std::abs(x) < kPassing) continue;
    const Terms line{{1, x, x * x, x * x * x, x > 0 ? std::cos(x) : 0}};
    normal += line * line.transpose();
    right += line * point.deviation;
  }
  const Eigen::FullPivLU<Square> solver(normal);
  if (!solver.isInvertible()) return {};
  const Terms fit = solver.solve(right);
  Reversal reversal{fit[4], 0};
  for (const RadialDeviation& point : profile) {
    const double x = from_place(point);
    if (std::abs(x) > kPassing) continue;
    const double before = fit[0] + x * (fit[1] + x * (fit[2] + x * fit[3]));
    const double after = before + fit[4] * std::cos(x);
    const double out = point.deviation - std::max(before, after);
    const double in = point.deviation - std::min(before, after);
    const double off = out > 0 ? out : in < 0 ? in : 0;
    if (std::abs(off) > std::abs(reversal.spike)) reversal.spike = off;
  }
  return reversal;
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

Range radii_about(const Vector2d& centre, std::span<const Weighted> points) {
  Range range;
  for (const Weighted& weighted : points) {
    const double distance = (weighted.point - centre).norm();
    range.least = std::min(range.least, distance);
    range.most = std::max(range.most, distance);
  }
  return range;
}

/// Adds the second harmonic of the deviations about the least squares centre.
void add_harmonic(CircleFigures& figures, std::span<const Weighted> points) {
  double whole = 0, cosine = 0, sine = 0;
  for (const auto& [point, weight] : points) {
    const Vector2d out = point - figures.centre;
    const double angle = std::atan2(out.y(), out.x()), deviation = out.norm() - figures.radius;
    whole += weight;
    cosine += 2 * weight * deviation * std::cos(2 * angle);
    sine += 2 * weight * deviation * std::sin(2 * angle);
  }
  if (whole == 0) return;
  figures.ellipse = 2 * cosine / whole;
  figures.diagonal = sine / whole;
}

}  // namespace

CircleFigures circle_figures(const CirclePass& pass, const std::optional<Vector2d>& centre) {
  const auto points = middle_of(pass);
  CircleFigures figures;
  const Circle fit = least_squares(points, {pass.centre, pass.radius});
  figures.centre = fit.centre;
  figures.radius = fit.radius;
  const Vector2d about = centre.value_or(fit.centre);
  for (const auto& [point, weight] : points) {
    const Vector2d out = point - about;
    figures.profile.push_back({std::atan2(out.y(), out.x()), out.norm() - pass.radius});
  }
  const Range used = radii_about(about, points), own = radii_about(fit.centre, points);
  figures.outermost = used.most - pass.radius;
  figures.innermost = used.least - pass.radius;
  figures.circular = own.most - own.least;
  add_harmonic(figures, points);
  for (std::size_t i = 0; i < figures.reversals.size(); ++i)
    figures.reversals[i] =
        reversal_at(static_cast<double>(i) * kQuarter, pass.clockwise, figures.profile);
  return figures;
}

BothDirections both_directions(const CirclePass& anticlockwise, const CirclePass& clockwise) {
  const CircleFigures left = circle_figures(anticlockwise, {}),
                      right = circle_figures(clockwise, {});
  auto points = middle_of(anticlockwise);
  const auto others = middle_of(clockwise);
  points.insert(points.end(), others.begin(), others.end());
  const double nominal = anticlockwise.radius;
  const Circle common = least_squares(points, {anticlockwise.centre, nominal});
  const Range range = radii_about(common.centre, points);
  const double speed = (anticlockwise.speed + clockwise.speed) / 2;
  BothDirections both;
  both.circular = range.most - range.least;
  both.mean = common.radius - nominal;
  both.squareness = (left.diagonal + right.diagonal) / nominal;
  both.lag = speed > 0 ? (left.diagonal - right.diagonal) / speed : 0;
  return both;
}

bool same_circle(const CirclePass& a, const CirclePass& b) {
  constexpr double kSame = 10 * CircleFinder::kOnCircle;
  return (a.centre - b.centre).norm() <= kSame && std::abs(a.radius - b.radius) <= kSame;
}

}  // namespace softcnc::runtime
