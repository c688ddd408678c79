// SPDX-License-Identifier: MIT
#include "motion/verification/contour_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softcnc {

void Contour::begin(std::size_t samples, double s) {
  turns_.add(newest_, s);
  newest_.clear();
  batches_.push_back({samples, s, {}});
}

void Contour::add(const Portion& portion, double s_start, const PathOrigin& origin) {
  const std::size_t before = newest_.size();
  append_pieces(portion, s_start, origin, newest_);
  auto& pieces = batches_.back().pieces;
  pieces.insert(pieces.end(), newest_.begin() + static_cast<std::ptrdiff_t>(before), newest_.end());
}

ContourReport Contour::report() const {
  ContourReport report = report_;
  SharpestTurn turns = turns_;
  turns.add(newest_, sample_s_);
  report.curve_lag = turns.curve_lag(ContourReport::kGoal);
  report.corner_lag = turns.corner_lag(ContourReport::kGoal);
  return report;
}

void Contour::next_batch() {
  if (batches_.empty()) return;
  pieces_.cut(batches_.front().s_start);
  pieces_.append(batches_.front().pieces);
  samples_left_ = batches_.front().samples;
  batches_.pop_front();
}

double Contour::sample(const Setpoint& setpoint, std::span<const AxisVector> actual) noexcept {
  if (samples_left_ == 0) next_batch();
  if (samples_left_ > 0) --samples_left_;
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
