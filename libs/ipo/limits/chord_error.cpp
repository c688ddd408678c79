// SPDX-License-Identifier: MIT
// The chord error of paper 000: how long a period's step may be where the path is curved.
#include "ipo/limits/chord_error.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/limits/constraint_list.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class ChordError final : public Constraint {
 public:
  ChordError(double tolerance, double period)
      : tolerance_(tolerance * (1 - tuning::limits::kChordMargin)), period_(period) {}

  Limit limit(const Move&) const noexcept override { return Limit::chord; }
  bool holds_over_steps() const noexcept override { return true; }

  double velocity_limit(const PathPoint& point, const Move&) const noexcept override {
    const double v = chord_step(point.ddq.norm(), tolerance_) / period_;
    return v * v;
  }

 private:
  double tolerance_, period_;
};

}  // namespace

double chord_step(double kappa, double tolerance) noexcept {
  if (kappa <= 0) return kUnlimited;
  if (kappa * tolerance >= 1) return 2 * tolerance;
  return 2 * std::sqrt(tolerance * (2 / kappa - tolerance));
}

std::unique_ptr<Constraint> make_chord_error(const Machine& machine) {
  const Control& control = machine.control;
  // Pulses follow the path between the samples.
  if (is_by_pulses(control.interpolation) || limits_chord(control.interpolation)) return nullptr;
  return std::make_unique<ChordError>(control.chord_tolerance, control.period);
}

}  // namespace softcnc::ipo
