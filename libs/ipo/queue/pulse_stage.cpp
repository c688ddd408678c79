// SPDX-License-Identifier: MIT
#include "ipo/queue/pulse_stage.hpp"

#include <fmt/format.h>

#include "motion/core/units.hpp"
#include "motion/geometry/extent.hpp"

namespace softcnc::ipo {
namespace {

/// Returns the clocks for each BLU along an axis: for a constant feed SAM drops one of every three
/// there.
double clocks_per_blu(const Control& control) noexcept {
  const bool drops =
      control.interpolation == Method::sam && control.constant_feed == ConstantFeed::on;
  return drops ? 1.5 : 1.0;
}

std::string blu_text(int axis, double blu) {
  return fmt::format("{:g} um of {}", um_from_mm(blu),
                     kAxisLetters[static_cast<std::size_t>(axis)]);
}

}  // namespace

PulseStage::PulseStage(const Machine& machine) : machine_(machine) {
  for (int i = 0; i < kAxes; ++i) blu_[i] = machine.axes[static_cast<std::size_t>(i)].blu;
}

std::optional<Diagnostic> PulseStage::prepare(Block& block) const {
  Move* move = std::get_if<Move>(&block.what);
  if (!move || !works() || !has_equal_clocks(machine_.control)) return std::nullopt;
  if (auto unlike = check_blu(move->path)) return unlike;
  const Control& control = machine_.control;
  const auto clocks = static_cast<double>(count_clocks(move->path, blu_, control));
  const Extent box = bounds(move->path);
  int axis = 0;
  (box.max - box.min).maxCoeff(&axis);
  if (clocks > 0)
    move->feed *= length(move->path) * clocks_per_blu(control) / (clocks * blu_[axis]);
  if (control.pulse_clock != PulseClock::paper) return std::nullopt;
  move->path_mode = PathMode::stop;
  move->corner_tolerance = 0;
  move->chord_tolerance = 0;
  return std::nullopt;
}

std::optional<Diagnostic> PulseStage::check_blu(const Path& path) const {
  const Extent box = bounds(path);
  int first = -1;
  for (int i = 0; i < kAxes; ++i) {
    if (box.max[i] == box.min[i]) continue;
    if (first < 0) first = i;
    if (blu_[i] != blu_[first])
      return Diagnostic{Code::SC7080,
                        {},
                        fmt::format("one reference clock cannot serve a BLU of {} and one of {}",
                                    blu_text(first, blu_[first]), blu_text(i, blu_[i])),
                        {},
                        {}};
  }
  return std::nullopt;
}

void PulseStage::attach(TimedBlock& timed) {
  const Move* move = timed.move();
  if (!move || !works()) return;
  if (!timed.pulses) {
    const GridPoint from = at_.value_or(counts_of(start(move->path), blu_));
    timed.pulses = std::make_unique<PulseWalk>(move->path, blu_, machine_.control, from);
  }
  at_ = timed.pulses->to();
}

}  // namespace softcnc::ipo
