// SPDX-License-Identifier: MIT
#include "ipo/rebuild/speed_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {

ShapeLimits shape_limits(const Machine& machine) {
  ShapeLimits shape;
  const PlannerLimits limits = limits_of(machine);
  shape.acceleration = limits.acceleration;
  shape.jerk = limits.jerk;
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    shape.velocity[i] = axis.velocity;
    shape.least[i] = axis.min;
    shape.most[i] = axis.max;
  }
  if (machine.limits.feed > 0) shape.feed = machine.limits.feed;
  shape.period = limits.period;
  if (limits.chord_tolerance > 0) shape.chord_tolerance = limits.chord_tolerance;
  return shape;
}

bool are_alike(const ShapeLimits& limits, const AxisVector& shares) noexcept {
  double least = kUnlimited, most = 0;
  for (int i = 0; i < kAxes; ++i) {
    if (shares[i] < tuning::rebuild::kAcross) continue;
    least = std::min(least, limits.jerk[i]);
    most = std::max(most, limits.jerk[i]);
  }
  return most < kUnlimited && most <= tuning::rebuild::kUnlikeAxes * least;
}

void even_out_jerk(ShapeLimits& limits, const AxisVector& shares) noexcept {
  double least = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (shares[i] > 0) least = std::min(least, limits.jerk[i] / shares[i]);
  limits.jerk = limits.jerk.cwiseMin(tuning::rebuild::kJerkRatio * least);
}

namespace {

std::vector<AxisVector> mean_curvatures(const std::vector<ShapePlace>& places,
                                        std::size_t smoothed) {
  std::vector<AxisVector> bends;
  for (const ShapePlace& at : places) {
    const double square = at.dq.squaredNorm();
    bends.emplace_back((at.ddq - at.dq.dot(at.ddq) / square * at.dq) / square);
  }
  if (smoothed < 2) return bends;
  std::vector<AxisVector> means;
  const std::size_t side = smoothed / 2;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const std::size_t first = i - std::min(i, side), end = std::min(i + side + 1, bends.size());
    AxisVector sum = AxisVector::Zero();
    for (std::size_t k = first; k < end; ++k) sum += bends[k];
    means.emplace_back(sum / static_cast<double>(end - first));
  }
  return means;
}

}  // namespace

std::vector<double> estimate_speeds(const std::vector<ShapePlace>& places,
                                    const ShapeLimits& limits, std::size_t smoothed) {
  const std::vector<AxisVector> bends = mean_curvatures(places, smoothed);
  std::vector<double> squares, slopes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const AxisVector tangent = places[i].dq.normalized();
    const double bend = bends[i].norm();
    double v = std::min({places[i].feed, limits.feed, along(limits.velocity, tangent)});
    if (bend > 0) {
      const double accelerated = bends[i].cwiseQuotient(limits.acceleration).norm();
      const double jerked = bend * bend * tangent.cwiseQuotient(limits.jerk).norm();
      v = std::min({v, std::sqrt(1 / accelerated),
                    std::cbrt(tuning::rebuild::kJerkOfCircle / jerked),
                    std::sqrt(8 * limits.chord_tolerance / bend) / limits.period});
    }
    squares.push_back(v * v);
    slopes.push_back(2 * tuning::rebuild::kRamp * along(limits.acceleration, tangent));
  }
  for (std::size_t i = 1; i < places.size(); ++i)
    squares[i] = std::min(squares[i], squares[i - 1] + slopes[i] * (places[i].t - places[i - 1].t));
  for (std::size_t i = places.size() - 1; i > 0; --i)
    squares[i - 1] =
        std::min(squares[i - 1], squares[i] + slopes[i] * (places[i].t - places[i - 1].t));
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

}  // namespace softcnc::ipo
