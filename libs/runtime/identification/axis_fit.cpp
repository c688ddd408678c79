// SPDX-License-Identifier: MIT
#include "runtime/identification/axis_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/model/servo_figures.hpp"
#include "runtime/identification/axis_replay.hpp"

namespace softcnc::runtime {
namespace {

/// kv, torque and friction as multiples of those of the machine file (the first two by their
/// logarithms), and the two sides of the gap, mm.
enum Parameter { kGain, kTorque, kFriction, kAhead, kAfter, kParameters };
using FitParameters = Eigen::Matrix<double, kParameters, 1>;
using Square = Eigen::Matrix<double, kParameters, kParameters>;
using Sensitivity = Eigen::Matrix<double, Eigen::Dynamic, kParameters>;

/// Differences by which derivatives are taken: well above what one count changes.
const FitParameters kDifference{{0.004, 0.05, 0.1, 0.004, 0.004}};
constexpr int kMostSteps = 25;
constexpr double kSettled = 1e-4;     // of the differences: a step below ends the search
constexpr double kBlock = 0.25;       // s
constexpr double kLeastMotion = 0.1;  // mm: an axis that moves less tells nothing
constexpr double kUnknown = 0.5;      // of a figure: with a larger uncertainty it is not known
constexpr double kSingular = 1e-10;   // of the largest: an eigenvalue that is none

class AxisFitter {
 public:
  AxisFitter(const Axis& axis, const AxisRecord& record, double period, double loop_period)
      : axis_(axis),
        nominal_(figures_of(axis)),
        record_(record),
        period_(period),
        loop_period_(loop_period) {}

  AxisFit fit();

 private:
  AxisFigures figures(const FitParameters& p) const noexcept;
  Eigen::VectorXd residual(const FitParameters& p) const;
  Sensitivity sensitivity(const FitParameters& p) const;
  bool improve(FitParameters& p, Eigen::VectorXd& left, double& damping) const;
  Square covariance(const Sensitivity& by, const Eigen::VectorXd& left) const;

  const Axis& axis_;
  AxisFigures nominal_;
  const AxisRecord& record_;
  double period_, loop_period_;
};

AxisFigures AxisFitter::figures(const FitParameters& p) const noexcept {
  return {nominal_.kv * std::exp(p[kGain]), nominal_.torque_over_inertia * std::exp(p[kTorque]),
          nominal_.friction_over_inertia * p[kFriction], p[kAhead] + p[kAfter]};
}

Eigen::VectorXd AxisFitter::residual(const FitParameters& p) const {
  const std::vector<double> model =
      replay_axis(with_figures(axis_, figures(p)), {p[kAhead], p[kAfter]}, period_, loop_period_,
                  record_.commanded, record_.actual[0]);
  const auto size = static_cast<Eigen::Index>(model.size());
  return Eigen::Map<const Eigen::VectorXd>(model.data(), size) -
         Eigen::Map<const Eigen::VectorXd>(record_.actual.data(), size);
}

/// One-sided at zero for what cannot be negative.
Sensitivity AxisFitter::sensitivity(const FitParameters& p) const {
  Sensitivity by(static_cast<Eigen::Index>(record_.actual.size()), kParameters);
  for (int i = 0; i < kParameters; ++i) {
    FitParameters above = p, below = p;
    above[i] += kDifference[i];
    below[i] -= kDifference[i];
    if (i >= kFriction) below[i] = std::max(below[i], 0.0);
    by.col(i) = (residual(above) - residual(below)) / (above[i] - below[i]);
  }
  return by;
}

/// Takes one step that leaves less; false where there is none, or it is too short to matter.
bool AxisFitter::improve(FitParameters& p, Eigen::VectorXd& left, double& damping) const {
  const Sensitivity by = sensitivity(p);
  const Square square = by.transpose() * by;
  const FitParameters slope = by.transpose() * left;
  FitParameters scale = square.diagonal();
  scale = scale.cwiseMax(1e-12 * scale.maxCoeff());
  for (int tries = 0; tries < 8; ++tries, damping *= 8) {
    const Square damped = square + Square((damping * scale).asDiagonal());
    FitParameters next = p - damped.ldlt().solve(slope);
    for (const int i : {kFriction, kAhead, kAfter}) next[i] = std::max(next[i], 0.0);
    next[kGain] = std::clamp(next[kGain], p[kGain] - 0.3, p[kGain] + 0.3);
    next[kTorque] = std::clamp(next[kTorque], p[kTorque] - 0.5, p[kTorque] + 0.5);
    Eigen::VectorXd after = residual(next);
    if (!(after.squaredNorm() < left.squaredNorm())) continue;
    const bool matters = ((next - p).cwiseQuotient(kDifference)).cwiseAbs().maxCoeff() > kSettled;
    p = next;
    left = std::move(after);
    damping = std::max(damping / 16, 1e-9);
    return matters;
  }
  return false;
}

/// Of the parameters: H^-1 B H^-1 with H the squared sensitivities and B the sum over blocks of the
/// squared gradients of the residuals, and of an offset of each block by the rounding of a count.
/// Infinite where the motion does not determine a parameter.
Square AxisFitter::covariance(const Sensitivity& by, const Eigen::VectorXd& left) const {
  const auto block = std::max<Eigen::Index>(1, std::lround(kBlock / period_));
  const double resolution = axis_.blu / std::sqrt(12.0);
  Square spread = Square::Zero();
  for (Eigen::Index first = 0; first < left.size(); first += block) {
    const Eigen::Index count = std::min(block, left.size() - first);
    const auto rows = by.middleRows(first, count);
    const FitParameters slope = rows.transpose() * left.segment(first, count);
    const FitParameters shift = resolution * rows.colwise().sum().transpose();
    spread += slope * slope.transpose() + shift * shift.transpose();
  }
  const FitParameters scale = kDifference;  // of comparable effect
  const Square square = scale.asDiagonal() * Square(by.transpose() * by) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Square> solver(square);
  const double largest = solver.eigenvalues().maxCoeff();
  FitParameters inverse;
  for (int i = 0; i < kParameters; ++i)
    inverse[i] = solver.eigenvalues()[i] > kSingular * largest ? 1 / solver.eigenvalues()[i] : 0;
  const Square bread =
      scale.asDiagonal() *
      Square(solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose()) *
      scale.asDiagonal();
  Square result = bread * spread * bread;
  for (int i = 0; i < kParameters; ++i)
    if (!(by.col(i).squaredNorm() > 0)) result(i, i) = std::numeric_limits<double>::infinity();
  return result;
}

AxisFit AxisFitter::fit() {
  AxisFit fit{.figures = nominal_, .uncertainty = {}, .moved = true};
  FitParameters p{{0, 0, 1, 0, 0}};
  Eigen::VectorXd left = residual(p);
  const auto rms = [&left] {
    return std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
  };
  fit.before = rms();
  double damping = 1e-3;
  for (int step = 0; step < kMostSteps && improve(p, left, damping); ++step) {
  }
  fit.residual = rms();
  fit.figures = figures(p);
  const Square spread = covariance(sensitivity(p), left);
  const auto twice = [](double variance) { return 2 * std::sqrt(variance); };
  fit.uncertainty.kv = fit.figures.kv * twice(spread(kGain, kGain));
  fit.uncertainty.torque_over_inertia =
      fit.figures.torque_over_inertia * twice(spread(kTorque, kTorque));
  fit.uncertainty.friction_over_inertia =
      nominal_.friction_over_inertia * twice(spread(kFriction, kFriction));
  fit.uncertainty.backlash =
      twice(spread(kAhead, kAhead) + spread(kAfter, kAfter) + 2 * spread(kAhead, kAfter));
  for (double AxisFigures::*figure :
       {&AxisFigures::kv, &AxisFigures::torque_over_inertia, &AxisFigures::friction_over_inertia})
    if (!(fit.uncertainty.*figure < kUnknown * fit.figures.*figure))
      fit.uncertainty.*figure = std::numeric_limits<double>::infinity();
  fit.lag = velocity_lag(with_figures(axis_, fit.figures));
  fit.lag_uncertainty =
      fit.lag * fit.uncertainty.torque_over_inertia / fit.figures.torque_over_inertia;
  return fit;
}

bool moves(const std::vector<double>& positions) noexcept {
  if (positions.empty()) return false;
  const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
  return *high - *low >= kLeastMotion;
}

}  // namespace

AxisFit fit_axis(const Axis& axis, const AxisRecord& record, double period, double loop_period) {
  if (!moves(record.commanded)) return {.figures = figures_of(axis), .uncertainty = {}};
  return AxisFitter(axis, record, period, loop_period).fit();
}

}  // namespace softcnc::runtime
