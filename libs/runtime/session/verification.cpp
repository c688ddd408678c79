// SPDX-License-Identifier: MIT
#include "runtime/session/verification.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

/// What differences of rows may exceed a limit by.
constexpr double kAxisTolerance = 1e-3;
constexpr double kJerkTolerance = 5e-3;
/// What a roughness may exceed its target by: as little as the limit of a plan may be exceeded.
constexpr double kRoughnessTolerance = 1e-3;
/// What rounding may add to a chord error.
constexpr double kChordTolerance = 1e-6;
/// What rounding may put a row beside the path, where the method promises to stay on it; mm.
constexpr double kPathTolerance = 1e-5;
/// BLU: how far a staircase may be from the planned place at the instant of a row.
constexpr double kStray = 1.5;

/// Three digits, but never an exponent.
std::string percent_text(double percent) {
  return percent < 100 ? fmt::format("{:.3g}", percent) : fmt::format("{:.0f}", percent);
}

class ExcessReporter {
 public:
  ExcessReporter(const Machine& machine, Diagnostics& diagnostics)
      : promised_(machine.control.interpolation == Method::arc_length),
        method_(name(machine.control.interpolation)),
        diagnostics_(diagnostics) {}

  /// `grid`: what rounding to BLU alone may add to the value.
  void operator()(std::string_view what, double value, double limit, double tolerance,
                  std::string_view unit, double grid = 0) {
    if (!(value > limit * (1 + tolerance) + grid)) return;
    const std::string text =
        fmt::format("{} reaches {:.6g} {}, {} % above its limit of {:.6g} {}", what, value, unit,
                    percent_text(100 * (value / limit - 1)), limit, unit);
    diagnostics_.report(promised_ ? Code::SC4002 : Code::SC4003, {},
                        promised_ ? text : fmt::format("{}: {}", method_, text));
  }

 private:
  bool promised_;
  std::string_view method_;
  Diagnostics& diagnostics_;
};

/// Of rounded corners; between the rows a chord may add its own.
void report_deviation(const ProgrammedPath::Deviation& worst, double chord_tolerance,
                      Diagnostics& diagnostics) {
  if (worst.off <= worst.allowed + chord_tolerance + kPathTolerance) return;
  diagnostics.report(Code::SC4002, {},
                     fmt::format("the motion leaves the programmed path by {:.6g} um, where G64 "
                                 "allows {:.6g} um",
                                 um_from_mm(worst.off), um_from_mm(worst.allowed)));
}

}  // namespace

void Verification::add(std::span<const Setpoint> rows, const ipo::BlockQueue& queue) {
  stretches_.clear();
  block_numbers_.clear();
  blocks_.clear();
  queue.for_each_recent([this](const ipo::TimedBlock& timed) {
    show(timed);
    if (!timed.move()) return;
    const Move& move = *timed.move();
    stretches_.push_back(
        {&move.path, timed.s_start, move.surface ? &*move.surface : nullptr, move.rapid});
    blocks_.push_back(&timed);
    block_numbers_.push_back({timed.block.number, timed.last_number()});
  });
  std::size_t first = 0, end = 0;
  for (const Setpoint& row : rows) {
    while (first < stretches_.size() && block_numbers_[first].last < block_before_) ++first;
    while (end < stretches_.size() && block_numbers_[end].first <= row.block) ++end;
    const std::span touched = std::span(stretches_).subspan(first, end - first);
    verifier_.sample(row, touched);
    programmed_.sample(row);
    if (observer_) observer_->observe({row, touched, verifier_.period(), programmed_.last()});
    if (verifier_.period().rmax > 0 && row.block <= block_numbers_[end - 1].last) {
      const auto here = &stretch_at(touched, row.s) - stretches_.data();
      surface_.add(*blocks_[static_cast<std::size_t>(here)], row, verifier_.period().rmax);
    }
    block_before_ = row.block;
  }
}

/// To the observer, unless it knows it.
void Verification::show(const ipo::TimedBlock& timed) {
  if (observer_ == nullptr || timed.last_number() <= observed_) return;
  observed_ = timed.last_number();
  observer_->block(timed);
}

void Verification::pass_over(const Setpoint& row) noexcept {
  verifier_.pass_over(row);
  programmed_.sample(row);
  block_before_ = row.block;
}

void Verification::finish() noexcept {
  verifier_.finish();
  programmed_.finish();
}

void report_excess(const Measured& measured, const ProgrammedPath::Deviation& worst,
                   const Machine& machine, Diagnostics& diagnostics) {
  ExcessReporter check(machine, diagnostics);
  const bool by_pulses = is_by_pulses(machine.control.interpolation);
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    const char letter = kAxisLetters[static_cast<std::size_t>(i)];
    const double per_period = 2 / machine.control.period;  // of a difference, by pulses
    const double v_grid = by_pulses ? kStray * axis.blu * per_period : 0;
    const double a_grid = v_grid * per_period;
    check(fmt::format("the velocity of {}", letter), measured.velocity[i], axis.velocity,
          kAxisTolerance, "mm/s", v_grid);
    check(fmt::format("the acceleration of {}", letter), measured.acceleration[i],
          axis.acceleration, kAxisTolerance, "mm/s2", a_grid);
    if (axis.jerk > 0)
      check(fmt::format("the jerk of {}", letter), measured.jerk[i], axis.jerk, kJerkTolerance,
            "mm/s3", a_grid * per_period);
  }
  if (machine.limits.tangential > 0)
    check("the tangential acceleration", measured.tangential, machine.limits.tangential,
          kAxisTolerance, "mm/s2");
  if (machine.limits.normal > 0)
    check("the normal acceleration", measured.normal, machine.limits.normal, kAxisTolerance,
          "mm/s2");
  const bool leaves = accelerates_after(machine.control.interpolation);  // the path, on purpose
  if (!by_pulses)  // pulses follow the path between the rows
    check(leaves ? "the distance of the curve from the motion" : "the chord error",
          um_from_mm(measured.chord_error), um_from_mm(machine.control.chord_tolerance),
          kChordTolerance, "um");
  if (machine.control.interpolation == Method::arc_length) {
    check("the distance from the path", um_from_mm(measured.path_deviation),
          um_from_mm(kPathTolerance), 0, "um");
    report_deviation(worst, machine.control.chord_tolerance, diagnostics);
  }
  if (measured.rmax_target > 0)
    check("Rmax", um_from_mm(measured.rmax), um_from_mm(measured.rmax_target), kRoughnessTolerance,
          "um");
}

void report_command_excess(const AxisVector& largest, const Machine& machine,
                           Diagnostics& diagnostics) {
  ExcessReporter check(machine, diagnostics);
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.present)
      check(fmt::format("the velocity of the commands of {}",
                        kAxisLetters[static_cast<std::size_t>(i)]),
            largest[i], axis.velocity, kAxisTolerance, "mm/s");
  }
}

}  // namespace softcnc::runtime
