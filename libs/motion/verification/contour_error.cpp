// SPDX-License-Identifier: MIT
#include "motion/verification/contour_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softcnc {

void Contour::begin(double s) {
  turns_.add(newest_, s);
  newest_.clear();
  pieces_.cut(s);
}

void Contour::add(const Portion& portion, double s_start, const PathOrigin& origin) {
  const std::size_t before = newest_.size();
  append_pieces(portion, s_start, origin, newest_);
  pieces_.append(std::span(newest_).subspan(before));
}

ContourReport Contour::report() const {
  ContourReport report = report_;
  SharpestTurn turns = turns_;
  turns.add(newest_, sample_s_);
  report.curve_lag = turns.curve_lag(ContourReport::kGoal);
  report.corner_lag = turns.corner_lag(ContourReport::kGoal);
  return report;
}

double Contour::sample(const Setpoint& setpoint, std::span<const AxisVector> actual) noexcept {
  const double s_before = std::exchange(sample_s_, setpoint.s);
  if (actual.empty()) return 0;
  if (pieces_.empty()) return (actual.back() - setpoint.position).norm();
  const auto count = static_cast<double>(actual.size());
  double error = 0, part = 0;
  for (const AxisVector& point : actual) {
    part += 1 / count;
    const double t = (static_cast<double>(setpoint.period - 1) + part) * period_;
    error = measure(point, {t, s_before + part * (setpoint.s - s_before), setpoint.v});
  }
  return error;
}

double Contour::measure(const AxisVector& point, const Instant& now) noexcept {
  const PathPieces::Nearest nearest = pieces_.nearest(point, foot_, now.s + kAhead);
  if (nearest.s <= now.s) foot_ = nearest.s;
  ContourFigures& figures = nearest.origin.rapid ? report_.rapids : report_.cutting;
  if (nearest.distance > figures.max) {
    const double turn = pieces_.turn(nearest.s, now.s);
    figures.max = nearest.distance;
    figures.time = now.t;
    figures.line = nearest.origin.line;
    figures.speed = now.v;
    figures.radius = turn > 0 ? (now.s - nearest.s) / turn : 0;
  }
  figures.fastest = std::max(figures.fastest, now.v);
  figures.sum_of_squares += nearest.distance * nearest.distance;
  ++figures.instants;
  return nearest.distance;
}

}  // namespace softcnc
