// SPDX-License-Identifier: MIT
//
// The curve is a Bezier curve of degree 5. At an end with position p, tangent t and curvature
// vector k, a cut d away from the joint along the path, its first control points are p, p + 0.4 d t
// and p + 0.8 d t + 5/4 (0.4 d)^2 k, which makes its curvature there k. Along a straight line these
// points are evenly spaced, so that the curve begins as if nothing were ahead.
//
// Between two lines at an angle its middle is 3/16 d |t1 - t0| from the joint. In general each of
// its points is compared with a point of the paths: the one at the same part of the cut, moved
// along the tangent to be nearer. The distance between the two is an upper bound of the distance of
// the curve from the paths and of the paths from the curve, since the points cover all of the cut,
// except for what lies around the joint: that is no further from the middle than the joint is. The
// bound is sampled, what it may rise to between samples is added from its second differences, and d
// is found with it.
#include "ipo/smoothing/blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ipo/tuning.hpp"
#include "motion/geometry/deviation.hpp"

namespace softcnc::ipo {
namespace {

struct Cut {
  double before, after;
};

std::array<AxisVector, 3> end_points(const PathPoint& end, double d, double direction) {
  const double reach = tuning::blend::kFirstControl * d;
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

  /// Returns an upper bound of the deviation, mm.
  double deviation(const Cut& cut) const {
    const auto points = control(cut);
    const double corner = (bezier(points, 0.5) - position(joint_.before, length_)).norm();
    return std::max({corner, highest({&joint_.before, length_ - cut.before, length_}, points, 0),
                     highest({&joint_.after, 0, cut.after}, points, 0.5)});
  }

  /// Whether the paths turn little within the cut, and have no more knots there than the samples
  /// can see.
  bool is_tame(const Cut& cut) const {
    return is_tame(Portion{&joint_.before, length_ - cut.before, length_}) &&
           is_tame(Portion{&joint_.after, 0, cut.after});
  }

 private:
  static bool is_tame(const Portion& portion) {
    if (std::holds_alternative<Line>(*portion.path)) return true;
    if (const Nurbs* nurbs = std::get_if<Nurbs>(portion.path);
        nurbs && knots_within(*nurbs, portion.s0, portion.s1) > tuning::blend::kMostKnots)
      return false;
    const double step = (portion.s1 - portion.s0) / tuning::blend::kTurnSamples;
    const PathPoint first = at(*portion.path, portion.s0);
    if (first.ddq.norm() * step > tuning::blend::kMostTurn) return false;
    for (int i = 1; i <= tuning::blend::kTurnSamples; ++i)
      if ((at(*portion.path, portion.s0 + i * step, Side::before).dq - first.dq).norm() >
          tuning::blend::kMostTurn)
        return false;
    return true;
  }

  static std::ptrdiff_t knots_within(const Nurbs& nurbs, double s0, double s1) {
    const auto& knots = nurbs.spec().knots;
    const auto first = std::upper_bound(knots.begin(), knots.end(), nurbs.parameter(s0));
    return std::lower_bound(first, knots.end(), nurbs.parameter(s1)) - first;
  }

  static AxisVector bezier(std::array<AxisVector, 6> points, double t) {
    for (std::size_t left = 5; left > 0; --left)
      for (std::size_t i = 0; i < left; ++i) points[i] += t * (points[i + 1] - points[i]);
    return points[0];
  }

  /// Returns the bound for the half of the curve that begins at t0, from its points in the portion.
  static double highest(const Portion& portion, const std::array<AxisVector, 6>& points,
                        double t0) {
    std::array<AxisVector, tuning::blend::kSamples + 1> off;
    for (std::size_t i = 0; i <= tuning::blend::kSamples; ++i) {
      const double part = static_cast<double>(i) / tuning::blend::kSamples;
      off[i] = from_place(portion, bezier(points, t0 + 0.5 * part), part);
    }
    std::array<double, tuning::blend::kSamples + 1> second{};
    for (std::size_t i = 1; i < tuning::blend::kSamples; ++i)
      second[i] = (off[i - 1] - 2 * off[i] + off[i + 1]).norm();
    second.front() = second[1];
    second.back() = second[tuning::blend::kSamples - 1];
    double largest = 0;
    for (std::size_t i = 0; i < tuning::blend::kSamples; ++i)
      largest = std::max(largest, std::max(off[i].norm(), off[i + 1].norm()) +
                                      tuning::blend::kRise * std::max(second[i], second[i + 1]));
    return largest;
  }

  static AxisVector from_place(const Portion& portion, const AxisVector& q, double part) {
    const double s = portion.s0 + part * (portion.s1 - portion.s0);
    const PathPoint here = at(*portion.path, s);
    const double nearer = s + here.dq.dot(q - here.q);
    return q - position(*portion.path, std::clamp(nearer, portion.s0, portion.s1));
  }

  const Joint& joint_;
  double length_;
};

/// Cuts both paths by the same length.
Cut even(double d) { return {d, d}; }

/// Finds the longest cut whose deviation is within the tolerance, by regula falsi on its logarithm:
/// the deviation grows like d at a corner, and like d squared where only the curvature jumps.
struct LongestCut {
  double cut, deviation;
};
std::optional<LongestCut> longest_cut(const Fit& fit, double most, double tolerance) {
  double d = most;
  while (!fit.is_tame(even(d)) && d > tuning::blend::kShortest) d *= 0.5;
  LongestCut good{0, 0};
  double bad = d;
  for (int i = 0; i < tuning::blend::kRounds && d > tuning::blend::kShortest; ++i) {
    const double off = fit.deviation(even(d));
    if (off <= tolerance) {
      good = {d, off};
      if (d >= bad || off > 0.95 * tolerance) break;
      d = std::min(0.5 * (d + bad), d * std::sqrt(0.98 * tolerance / off));
    } else {
      bad = d;
      const double ratio = 0.99 * tolerance / off;
      d = good.cut > 0 ? 0.5 * (good.cut + bad) : d * std::max(ratio, 0.02);
    }
  }
  if (good.cut <= tuning::blend::kShortest) return std::nullopt;
  return good;
}

NurbsSpec bezier_spec(const std::array<AxisVector, 6>& control, double width) {
  NurbsSpec spec{5, {control.begin(), control.end()}, std::vector<double>(6, 1.0), {}};
  spec.knots.assign(6, 0.0);
  spec.knots.insert(spec.knots.end(), 6, width);
  return spec;
}

}  // namespace

JointJump joint_jump(const Path& before, const Path& after) noexcept {
  const PathPoint a = at(before, length(before), Side::before);
  const PathPoint b = at(after, 0, Side::after);
  return {(b.dq - a.dq).norm(), (b.ddq - a.ddq).norm()};
}

std::optional<Blend> make_blend(const Joint& joint) {
  const double most = std::min(joint.most_before, joint.most_after);
  const PathPoint a = at(joint.before, length(joint.before), Side::before);
  const PathPoint b = at(joint.after, 0, Side::after);
  if (a.dq.dot(b.dq) < tuning::blend::kTurnsBack || !(joint.tolerance > 0)) return std::nullopt;
  const Fit fit(joint);
  const auto found = longest_cut(fit, most, joint.tolerance);
  if (!found) return std::nullopt;
  const double d = found->cut;
  auto curve = Nurbs::make(bezier_spec(fit.control(even(d)), 2 * d));
  if (!curve) return std::nullopt;
  return Blend{std::move(*curve), d, d, found->deviation};
}

}  // namespace softcnc::ipo
