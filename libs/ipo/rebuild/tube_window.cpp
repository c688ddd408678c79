// SPDX-License-Identifier: MIT
#include "ipo/rebuild/tube_window.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ipo/rebuild/ties.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// Places of the cost: three of each span, by Gauss.
struct CostPlace {
  std::size_t span;
  double weight;  // mm
  QuinticBasis first, second, third;
};

std::vector<CostPlace> cost_places(const TubeWindow& window, std::vector<ShapePlace>& shape) {
  constexpr double kOffset = 0.7745966692414834;  // sqrt(3 / 5)
  constexpr std::array<double, 3> kPlaces{-kOffset, 0, kOffset},
      kWeights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  std::vector<CostPlace> places;
  const QuinticSpline& spline = window.spline;
  for (std::size_t span = window.first_span; span < spline.spans(); ++span) {
    const double a = spline.begin(span), width = spline.end(span) - a;
    for (std::size_t k = 0; k < 3; ++k) {
      const double t = a + 0.5 * width * (1 + kPlaces[k]);
      places.push_back({span, width * kWeights[k], quintic_basis(spline.knots, span, t, 1),
                        quintic_basis(spline.knots, span, t, 2),
                        quintic_basis(spline.knots, span, t, 3)});
      shape.push_back({t, {}, {}, 0});
    }
  }
  return places;
}

AxisVector combine(const QuinticSpline& spline, std::size_t span, const QuinticBasis& basis) {
  AxisVector sum = AxisVector::Zero();
  for (std::size_t i = 0; i < basis.size(); ++i) sum += basis[i] * spline.control[span + i];
  return sum;
}

AxisVector point_of(const QuinticSpline& spline, double t) {
  const std::size_t span = spline.span_at(t);
  return combine(spline, span, quintic_basis(spline.knots, span, t, 0));
}

/// The axes in which a window moves; at least two.
std::vector<int> moving_axes(const TubeWindow& window, const std::vector<Tie>& ties) {
  std::vector<int> moving, still;
  for (int axis = 0; axis < kAxes; ++axis) {
    const double at = window.spline.control.front()[axis];
    const bool moves = std::any_of(ties.begin(), ties.end(),
                                   [&](const Tie& tie) {
                                     return tie.point[axis] != at || tie.tangent[axis] != 0;
                                   }) ||
                       std::any_of(window.spline.control.begin(), window.spline.control.end(),
                                   [&](const AxisVector& point) { return point[axis] != at; });
    (moves ? moving : still).push_back(axis);
  }
  for (std::size_t i = 0; moving.size() < 2; ++i) moving.push_back(still[i]);
  std::sort(moving.begin(), moving.end());
  return moving;
}

template <int dimensions>
class WindowSolver {
 public:
  using Program = TubeProgram<dimensions>;
  using Vector = typename Program::Vector;
  using Matrix = typename Program::Matrix;

  WindowSolver(TubeWindow& window, const Guide& guide, const ShapeLimits& limits,
               const std::vector<Tie>& ties, std::vector<int> axes)
      : window_(window), guide_(guide), limits_(limits), ties_(ties), axes_(std::move(axes)) {
    AxisVector shares = AxisVector::Zero();
    for (const Tie& tie : ties) shares = shares.cwiseMax(tie.tangent.cwiseAbs());
    even_out_jerk(limits_, shares);
    places_ = cost_places(window, shape_);
    for (ShapePlace& at : shape_) {
      const MoveAttributes& move = guide.vertices()[guide.line_at(at.t)].attributes;
      at.feed = move.rapid ? kUnlimited : move.feed;
    }
  }

  bool solve() {
    bool inside = false;
    for (int round = 0; round < tuning::rebuild::kMostRounds; ++round) {
      if (!solve_once(round == 0 ? tuning::rebuild::kSmoothed : 1)) return false;
      inside = measure();
      if (inside && round + 1 >= tuning::rebuild::kRounds) return true;
    }
    return inside;
  }

 private:
  Vector reduced(const AxisVector& full) const {
    Vector out;
    for (int i = 0; i < dimensions; ++i) out[i] = full[axes_[static_cast<std::size_t>(i)]];
    return out;
  }

  bool solve_once(std::size_t smoothed) {
    QuinticSpline& spline = window_.spline;
    Program program(spline.control.size());
    add_jerk(program, smoothed);
    for (const Tie& tie : ties_) add_tie(program, tie);
    std::vector<Vector> control;
    for (const AxisVector& point : spline.control) control.push_back(reduced(point));
    const auto outcome =
        program.solve(control, window_.fixed_first, spline.control.size() - window_.fixed_last);
    if (!outcome.solved) return false;
    for (std::size_t i = 0; i < control.size(); ++i)
      for (int k = 0; k < dimensions; ++k)
        spline.control[i][axes_[static_cast<std::size_t>(k)]] = control[i][k];
    return true;
  }

  void add_jerk(Program& program, std::size_t smoothed) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      shape_[i].dq = combine(window_.spline, places_[i].span, places_[i].first);
      shape_[i].ddq = combine(window_.spline, places_[i].span, places_[i].second);
    }
    const std::vector<double> speeds = estimate_speeds(shape_, limits_, smoothed);
    const Vector inverse = reduced(limits_.jerk).cwiseInverse();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double v = std::max(speeds[i], tuning::rebuild::kLeastSpeed);
      const double weight = places_[i].weight * std::pow(v, 6);
      const Matrix metric = (weight * inverse.cwiseProduct(inverse)).asDiagonal();
      program.add_cost(static_cast<int>(places_[i].span), places_[i].third, metric, Vector::Zero());
    }
  }

  void add_tie(Program& program, const Tie& tie) {
    const QuinticSpline& spline = window_.spline;
    const QuinticBasis basis = quintic_basis(spline.knots, tie.span, tie.t, 0);
    const Vector goal = reduced(tie.point), tangent = reduced(tie.tangent).normalized();
    const double mu = tuning::rebuild::kMiddle * tie.weight / (tie.tolerance * tie.tolerance);
    program.add_cost(static_cast<int>(tie.span), basis,
                     mu * (Matrix::Identity() - tangent * tangent.transpose()), goal);
    // What settled control points shape was inside with the last solution.
    const bool held = window_.before && tie.span < window_.fixed_first;
    const Vector now = held ? reduced(point_of(*window_.before, tie.t)) : goal;
    typename Program::Bounds bounds;
    bounds.first = static_cast<int>(tie.span);
    bounds.basis = basis;
    const auto bound = [&](const Vector& direction, double most) {
      const auto k = static_cast<std::size_t>(bounds.count++);
      const double middle = direction.dot(goal), at = direction.dot(now);
      bounds.direction[k] = direction;
      bounds.low[k] = middle - most;
      bounds.high[k] = middle + most;
      if (!held) return;
      bounds.low[k] = std::min(bounds.low[k], at - tuning::rebuild::kSlack * tie.tolerance);
      bounds.high[k] = std::max(bounds.high[k], at + tuning::rebuild::kSlack * tie.tolerance);
    };
    const double tight = tie.tolerance * tuning::rebuild::kMargin * window_.tightened[tie.span];
    for (const Vector& normal : normals(tangent)) {
      bound(normal, tight);
      keep_in_travel(bounds, tie);
    }
    bound(tangent, tie.slip);
    program.add_bounds(bounds);
  }

  /// Narrows the last bound where the path is nearer to an end of travel than its tolerance.
  void keep_in_travel(typename Program::Bounds& bounds, const Tie& tie) const {
    const auto k = static_cast<std::size_t>(bounds.count - 1);
    const Vector& normal = bounds.direction[k];
    const double middle = normal.dot(reduced(tie.point));
    const double margin = tuning::rebuild::kTravelMargin * tie.tolerance;
    for (int i = 0; i < dimensions; ++i) {
      const int axis = axes_[static_cast<std::size_t>(i)];
      const double part = normal[i];
      if (std::abs(part) < tuning::rebuild::kAcross) continue;
      double low = (limits_.least[axis] - tie.point[axis] + margin) / part;
      double high = (limits_.most[axis] - tie.point[axis] - margin) / part;
      if (part < 0) std::swap(low, high);
      const double least = bounds.low[k], most = bounds.high[k];
      bounds.low[k] = std::min(std::max(least, middle + low), most - margin);
      bounds.high[k] = std::max(std::min(most, middle + high), bounds.low[k] + margin);
    }
  }

  /// Directions across the path: one in a plane, three in space.
  static std::vector<Vector> normals(const Vector& tangent) {
    if constexpr (dimensions == 2) {
      return {Vector(-tangent[1], tangent[0])};
    } else {
      Eigen::Index least = 0;
      tangent.cwiseAbs().minCoeff(&least);
      const Vector a = tangent.cross(Vector::Unit(least)).normalized();
      const Vector b = tangent.cross(a);
      constexpr double kHalfRoot3 = 0.8660254037844386;
      return {a, -0.5 * a + kHalfRoot3 * b, -0.5 * a - kHalfRoot3 * b};
    }
  }

  /// Whether all of the window is inside; tightens what is not.
  bool measure() {
    const QuinticSpline& spline = window_.spline;
    const double t0 = spline.begin(window_.first_span - std::min(window_.first_span, kBefore));
    TubeCheck check(guide_, spline, t0);
    const std::vector<double> shares = check.shares();
    window_.furthest = check.furthest();
    window_.feet = check.feet();
    for (std::size_t i = 0; i < shares.size(); ++i) {
      double near = shares[i];
      if (i > 0) near = std::max(near, shares[i - 1]);
      if (i + 1 < shares.size()) near = std::max(near, shares[i + 1]);
      double& tightened = window_.tightened[i];
      tightened = std::min(1.0, tightened * std::clamp(tuning::rebuild::kGoal / near, 0.5, 1.2));
    }
    return *std::max_element(shares.begin(), shares.end()) <= 1;
  }

  static constexpr std::size_t kBefore = 3;

  TubeWindow& window_;
  const Guide& guide_;
  ShapeLimits limits_;
  const std::vector<Tie>& ties_;
  std::vector<int> axes_;
  std::vector<ShapePlace> shape_;
  std::vector<CostPlace> places_;
};

}  // namespace

bool solve(TubeWindow& window, const Guide& guide, const ShapeLimits& limits) {
  const std::vector<Tie> ties = ties_of(window, guide);
  auto axes = moving_axes(window, ties);
  if (axes.size() == 2) return WindowSolver<2>(window, guide, limits, ties, axes).solve();
  return WindowSolver<3>(window, guide, limits, ties, axes).solve();
}

}  // namespace softcnc::ipo
