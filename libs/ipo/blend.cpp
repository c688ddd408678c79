// SPDX-License-Identifier: MIT
//
// The curve is a Bezier curve of degree 5. At an end with position p, tangent t and curvature
// vector k, a cut d away from the joint along the path, its first control points are p, p + 0.4 d t
// and p + 0.8 d t + 5/4 (0.4 d)^2 k: by that its curvature there is k. Along a straight line these
// points are evenly spaced, so that the curve begins as if nothing were ahead.
//
// Between two lines at an angle its middle is 3/16 d |t1 - t0| from the joint. In general the
// deviation, both of the curve from the paths and of the paths from the curve, is measured, and d
// found by it.
#include "ipo/blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/deviation.hpp"

namespace softcnc::ipo {
namespace {

constexpr double kReach = 0.4;      // of d: first control point
constexpr double kShortest = 1e-5;  // mm
constexpr double kMostTurn = 0.6;   // rad: of a path within d
constexpr double kMargin = 0.985;   // of the tolerance: the deviation is sampled
constexpr int kSamples = 16;
constexpr int kRounds = 12;

struct Cut {
  double before, after;
};

std::array<AxisVector, 3> end_points(const PathPoint& end, double d, double direction) {
  const double reach = kReach * d;
  const AxisVector along = direction * reach * end.dq;
  return {end.q, end.q + along, end.q + 2 * along + 1.25 * reach * reach * end.ddq};
}

class Fit {
 public:
  explicit Fit(const Joint& joint) : joint_(joint), length_(length(joint.before)) {}

  std::array<AxisVector, 6> control(const Cut& cut) const {
    const auto a = end_points(at(joint_.before, length_ - cut.before, Side::before), cut.before, 1);
    const auto b = end_points(at(joint_.after, cut.after, Side::after), cut.after, -1);
    return {a[0], a[1], a[2], b[2], b[1], b[0]};
  }

  double deviation(const Cut& cut) const {
    const auto points = control(cut);
    std::array<AxisVector, kSamples + 1> curve;
    double largest = 0;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      AxisVector& q = curve[static_cast<std::size_t>(i)];
      q = bezier(points, t);
      largest = std::max(largest, from_paths(q, cut, t));
    }
    for (const double part : {0.0, 0.2, 0.5}) {
      const AxisVector before = position(joint_.before, length_ - part * cut.before);
      const AxisVector after = position(joint_.after, part * cut.after);
      largest = std::max({largest, from_polyline(before, curve), from_polyline(after, curve)});
    }
    return largest;
  }

  /// The paths turn little within the cut, so that what is nearest is found.
  bool is_tame(const Cut& cut) const {
    const auto turned = [](const Path& path, double a, double b) {
      const double middle = 0.5 * (a + b);
      const AxisVector t = at(path, a).dq, u = at(path, middle).dq, v = at(path, b).dq;
      return std::max((u - t).norm(), (v - t).norm()) > kMostTurn;
    };
    return !turned(joint_.before, length_, length_ - cut.before) &&
           !turned(joint_.after, 0, cut.after);
  }

 private:
  static AxisVector bezier(std::array<AxisVector, 6> points, double t) {
    for (std::size_t left = 5; left > 0; --left)
      for (std::size_t i = 0; i < left; ++i) points[i] += t * (points[i + 1] - points[i]);
    return points[0];
  }

  double from_paths(const AxisVector& q, const Cut& cut, double t) const {
    const Portion before{&joint_.before, length_ - cut.before, length_};
    const Portion after{&joint_.after, 0, cut.after};
    const double guess_before = nearest(before, q, before.s0 + std::min(2 * t, 1.0) * cut.before);
    const double guess_after = nearest(after, q, std::max(2 * t - 1, 0.0) * cut.after);
    return std::min((position(joint_.before, guess_before) - q).norm(),
                    (position(joint_.after, guess_after) - q).norm());
  }

  static double from_polyline(const AxisVector& q,
                              const std::array<AxisVector, kSamples + 1>& points) {
    double least = (points.front() - q).squaredNorm();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const AxisVector side = points[i] - points[i - 1];
      const double square = side.squaredNorm();
      const double part = square > 0 ? (q - points[i - 1]).dot(side) / square : 0;
      least =
          std::min(least, (points[i - 1] + std::clamp(part, 0.0, 1.0) * side - q).squaredNorm());
    }
    return std::sqrt(least);
  }

  const Joint& joint_;
  double length_;
};

/// Both cuts as long as each other.
Cut even(double d) { return {d, d}; }

/// The longest cut whose deviation is within the tolerance, by regula falsi on its logarithm: the
/// deviation grows like d at a corner, and like d squared where only the curvature jumps.
std::optional<double> longest_cut(const Fit& fit, double most, double tolerance) {
  double d = most;
  while (!fit.is_tame(even(d)) && d > kShortest) d *= 0.5;
  double good = 0;
  double bad = d;
  for (int i = 0; i < kRounds && d > kShortest; ++i) {
    const double off = fit.deviation(even(d));
    if (off <= tolerance) {
      good = d;
      if (d >= bad || off > 0.95 * tolerance) break;
      d = std::min(0.5 * (d + bad), d * std::sqrt(0.98 * tolerance / off));
    } else {
      bad = d;
      const double ratio = 0.99 * tolerance / off;
      d = good > 0 ? 0.5 * (good + bad) : d * std::max(ratio, 0.02);
    }
  }
  if (good <= kShortest) return std::nullopt;
  return good;
}

NurbsSpec bezier_spec(const std::array<AxisVector, 6>& control, double width) {
  NurbsSpec spec{5, {control.begin(), control.end()}, std::vector<double>(6, 1.0), {}};
  spec.knots.assign(6, 0.0);
  spec.knots.insert(spec.knots.end(), 6, width);
  return spec;
}

}  // namespace

Jump jump(const Path& before, const Path& after) noexcept {
  const PathPoint a = at(before, length(before), Side::before);
  const PathPoint b = at(after, 0, Side::after);
  return {(b.dq - a.dq).norm(), (b.ddq - a.ddq).norm()};
}

std::optional<Blend> make_blend(const Joint& joint) {
  const double most = std::min(joint.most_before, joint.most_after);
  const PathPoint a = at(joint.before, length(joint.before), Side::before);
  const PathPoint b = at(joint.after, 0, Side::after);
  if (a.dq.dot(b.dq) < kTurnsBack || !(joint.tolerance > 0)) return std::nullopt;
  const Fit fit(joint);
  const auto d = longest_cut(fit, most, kMargin * joint.tolerance);
  if (!d) return std::nullopt;
  auto curve = Nurbs::make(bezier_spec(fit.control(even(*d)), 2 * *d));
  if (!curve) return std::nullopt;
  return Blend{std::move(*curve), *d, *d, fit.deviation(even(*d))};
}

}  // namespace softcnc::ipo
