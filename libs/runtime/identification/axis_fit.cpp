// SPDX-License-Identifier: MIT
#include "runtime/identification/axis_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "motion/model/servo_figures.hpp"
#include "runtime/identification/axis_replay.hpp"

namespace softcnc::runtime {
namespace {

/// kv, torque and friction as multiples of those of the machine file (the first two by their
/// logarithms), the two sides of the gap, mm, and how late the record is, s.
enum Parameter { kGain, kTorque, kFriction, kAhead, kAfter, kDelay, kParameters };
using FitParameters = Eigen::Matrix<double, kParameters, 1>;
using Square = Eigen::Matrix<double, kParameters, kParameters>;
using Sensitivity = Eigen::Matrix<double, Eigen::Dynamic, kParameters>;

/// Differences by which derivatives are taken: well above what one count changes.
const FitParameters kDifference{{0.004, 0.05, 0.1, 0.004, 0.004, 0.0002}};
/// The longest step of the search, in each parameter.
const FitParameters kLongest{{0.3, 0.5, 1, 0.1, 0.1, 0.01}};
/// Where searches begin: small and large friction, with a gap on either side, and a late record.
const std::array<FitParameters, 5> kStarts{
    {FitParameters{{0, 0, 1, 0, 0, 0}}, FitParameters{{0, 0, 1, 0.03, 0.03, 0.002}},
     FitParameters{{0, -0.2, 0.5, 0.03, 0, 0}}, FitParameters{{0, 0.2, 1.5, 0, 0.03, 0.001}},
     FitParameters{{0, 0, 1.5, 0, 0, 0.003}}}};
constexpr int kFirstSteps = 3;  // of each search; the best one goes on
constexpr int kMostSteps = 25;
/// Periods of position loops that drives have, s, and what a residual must have less for one of
/// them than for that of the machine file: this part of the mean square of a position.
constexpr std::array kLoopPeriods{2e-3, 1e-3, 0.5e-3, 0.25e-3};
constexpr double kTells = 25;
constexpr double kSettled = 1e-3;     // of the differences: a step below ends the search
constexpr double kBlock = 0.25;       // s
constexpr double kLead = 0.1;         // s of rest before the motion that are looked at,
constexpr double kTail = 1;           // and s after it
constexpr double kLeastMotion = 0.1;  // mm: an axis that moves less tells nothing
constexpr double kUnknown = 0.5;      // of a figure: with a larger uncertainty it is not known
constexpr double kSingular = 1e-10;   // of the largest: an eigenvalue that is none

/// A search for the least residual: where it is, and what is left there.
struct Search {
  FitParameters at;
  Eigen::VectorXd left;
  double damping = 1e-3;
  bool settled = false;
};

bool leaves_less(const Search& a, const Search& b) noexcept {
  return a.left.squaredNorm() < b.left.squaredNorm();
}

class AxisFitter {
 public:
  AxisFitter(const Axis& axis, const AxisRecord& record, double period, double loop_period);

  AxisFit fit();

 private:
  AxisFigures figures(const FitParameters& p) const noexcept;
  MotorMotion motor(const FitParameters& p) const;
  Eigen::VectorXd residual(const MotorMotion& motor, const FitParameters& p) const;
  Eigen::VectorXd residual(const FitParameters& p) const { return residual(motor(p), p); }
  Sensitivity sensitivity(const FitParameters& p) const;
  void improve(Search& search) const;
  void go_on(Search& search, int steps) const;
  Search best() const;
  void try_loop_periods(Search& found);
  Square covariance(const Sensitivity& by, const Eigen::VectorXd& left) const;
  void state_uncertainty(const Square& spread, AxisFit& fit) const;

  const Axis& axis_;
  AxisFigures nominal_;
  double period_, loop_period_;
  std::span<const double> commanded_, actual_;
  double start_ = 0;  // mm: the table before the motion
};

AxisFitter::AxisFitter(const Axis& axis, const AxisRecord& record, double period,
                       double loop_period)
    : axis_(axis), nominal_(figures_of(axis)), period_(period), loop_period_(loop_period) {
  const std::vector<double>& sent = record.commanded;
  const auto differs = [](double a, double b) { return a != b; };
  const auto first = std::adjacent_find(sent.begin(), sent.end(), differs) - sent.begin();
  const auto last = sent.rend() - std::adjacent_find(sent.rbegin(), sent.rend(), differs);
  const auto size = static_cast<std::ptrdiff_t>(sent.size());
  const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, first - std::lround(kLead / period));
  const std::ptrdiff_t to = std::min(size, last + std::lround(kTail / period));
  const auto part = [from, to](const std::vector<double>& all) {
    return std::span(all).subspan(static_cast<std::size_t>(from),
                                  static_cast<std::size_t>(to - from));
  };
  commanded_ = part(sent);
  actual_ = part(record.actual);
  const auto rest = static_cast<std::ptrdiff_t>(first - from + 1);
  start_ =
      std::accumulate(actual_.begin(), actual_.begin() + rest, 0.0) / static_cast<double>(rest);
}

AxisFigures AxisFitter::figures(const FitParameters& p) const noexcept {
  return {nominal_.kv * std::exp(p[kGain]), nominal_.torque_over_inertia * std::exp(p[kTorque]),
          nominal_.friction_over_inertia * p[kFriction], std::max(p[kAhead] + p[kAfter], 0.0)};
}

MotorMotion AxisFitter::motor(const FitParameters& p) const {
  return replay_motor(with_figures(axis_, figures(p)), period_, loop_period_, commanded_);
}

Eigen::VectorXd AxisFitter::residual(const MotorMotion& motor, const FitParameters& p) const {
  const std::vector<double> model =
      replay_table(motor, {p[kAhead], p[kAfter]}, start_, p[kDelay] / period_);
  const auto size = static_cast<Eigen::Index>(model.size());
  return Eigen::Map<const Eigen::VectorXd>(model.data(), size) -
         Eigen::Map<const Eigen::VectorXd>(actual_.data(), size);
}

/// Puts what cannot be negative to zero: friction, and the sum of both sides of the gap.
void keep_possible(FitParameters& p) noexcept {
  p[kFriction] = std::max(p[kFriction], 0.0);
  const double lacks = std::max(-(p[kAhead] + p[kAfter]), 0.0);
  p[kAhead] += lacks / 2;
  p[kAfter] += lacks / 2;
}

/// One-sided at zero for what cannot be negative.
Sensitivity AxisFitter::sensitivity(const FitParameters& p) const {
  Sensitivity by(static_cast<Eigen::Index>(actual_.size()), kParameters);
  const MotorMotion here = motor(p);
  for (int i = 0; i < kParameters; ++i) {
    FitParameters above = p, below = p;
    above[i] += kDifference[i];
    below[i] -= kDifference[i];
    if (i == kFriction) below[i] = std::max(below[i], 0.0);
    if (i == kAhead || i == kAfter) below[i] = std::max(below[i], -p[kAhead + kAfter - i]);
    const bool same_motor = i >= kAhead;
    const Eigen::VectorXd more = same_motor ? residual(here, above) : residual(above);
    by.col(i) =
        (more - (same_motor ? residual(here, below) : residual(below))) / (above[i] - below[i]);
  }
  return by;
}

/// Takes one step that leaves less. The search has settled where there is none, or it is too short
/// to matter.
void AxisFitter::improve(Search& search) const {
  const Sensitivity by = sensitivity(search.at);
  const Square square = by.transpose() * by;
  const FitParameters slope = by.transpose() * search.left;
  FitParameters scale = square.diagonal();
  scale = scale.cwiseMax(1e-12 * scale.maxCoeff());
  for (int tries = 0; tries < 8; ++tries, search.damping *= 8) {
    const Square damped = square + Square((search.damping * scale).asDiagonal());
    const FitParameters step = damped.ldlt().solve(slope);
    FitParameters next = search.at - step.cwiseMax(-kLongest).cwiseMin(kLongest);
    keep_possible(next);
    Eigen::VectorXd after = residual(next);
    if (!(after.squaredNorm() < search.left.squaredNorm())) continue;
    search.settled =
        ((next - search.at).cwiseQuotient(kDifference)).cwiseAbs().maxCoeff() <= kSettled;
    search.at = next;
    search.left = std::move(after);
    search.damping = std::max(search.damping / 16, 1e-9);
    return;
  }
  search.settled = true;
}

void AxisFitter::go_on(Search& search, int steps) const {
  for (int step = 0; step < steps && !search.settled; ++step) improve(search);
}

/// The residual of a count and of friction is no smooth function, and one search can end in a
/// valley of its own.
Search AxisFitter::best() const {
  std::vector<Search> searches;
  for (const FitParameters& start : kStarts)
    go_on(searches.emplace_back(Search{start, residual(start)}), kFirstSteps);
  Search& best = *std::min_element(searches.begin(), searches.end(), leaves_less);
  go_on(best, kMostSteps);
  return std::move(best);
}

/// A counter that is read less often than the machine file says looks like a larger gain and a late
/// record, but not quite: the residual tells. Each search begins where the axis is as late as with
/// what was found before, and the last one is again with the machine file's period.
void AxisFitter::try_loop_periods(Search& found) {
  const double described = loop_period_;
  double chosen = described;
  const double in_favour = 1 + kTells / static_cast<double>(actual_.size());
  const auto search_with = [&](double period, double handicap) {
    const double later = 0.5 * (period - chosen);  // on average
    FitParameters start = found.at;
    start[kGain] -= std::log1p(later * figures(start).kv);
    start[kDelay] -= later;
    loop_period_ = period;
    Search search{start, residual(start)};
    go_on(search, kMostSteps);
    if (handicap * search.left.squaredNorm() > found.left.squaredNorm()) return;
    found = std::move(search);
    chosen = period;
  };
  for (const double other : kLoopPeriods) {
    const double parts = period_ / other;
    const bool divides = parts > 0.999 && std::abs(parts - std::round(parts)) < 1e-3;
    if (divides && std::abs(other - described) > 1e-3 * other) search_with(other, in_favour);
  }
  if (chosen != described) search_with(described, 1 / in_favour);
  loop_period_ = chosen;
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

void AxisFitter::state_uncertainty(const Square& spread, AxisFit& fit) const {
  const auto twice = [](double variance) { return 2 * std::sqrt(variance); };
  AxisFigures& within = fit.uncertainty;
  within.kv = fit.figures.kv * twice(spread(kGain, kGain));
  within.torque_over_inertia = fit.figures.torque_over_inertia * twice(spread(kTorque, kTorque));
  within.friction_over_inertia =
      nominal_.friction_over_inertia * twice(spread(kFriction, kFriction));
  within.backlash =
      twice(spread(kAhead, kAhead) + spread(kAfter, kAfter) + 2 * spread(kAhead, kAfter));
  fit.delay_uncertainty = twice(spread(kDelay, kDelay));
  for (double AxisFigures::*figure :
       {&AxisFigures::kv, &AxisFigures::torque_over_inertia, &AxisFigures::friction_over_inertia})
    if (!(within.*figure < kUnknown * fit.figures.*figure))
      within.*figure = std::numeric_limits<double>::infinity();
  fit.lag_uncertainty = fit.lag * within.torque_over_inertia / fit.figures.torque_over_inertia;
}

AxisFit AxisFitter::fit() {
  const auto rms = [](const Eigen::VectorXd& left) {
    return std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
  };
  const double before = rms(residual(kStarts[0]));
  Search found = best();
  try_loop_periods(found);
  AxisFit fit{.figures = figures(found.at), .uncertainty = {}, .before = before, .moved = true};
  fit.loop_period = loop_period_;
  fit.residual = rms(found.left);
  fit.delay = found.at[kDelay];
  fit.lag = velocity_lag(with_figures(axis_, fit.figures));
  state_uncertainty(covariance(sensitivity(found.at), found.left), fit);
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
