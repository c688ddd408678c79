// SPDX-License-Identifier: MIT
#include "runtime/comparison/compared_figure.hpp"

#include <algorithm>

#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

using Value = std::optional<double>;

bool has_pulses(const Machine& machine) { return is_by_pulses(machine.control.interpolation); }

/// A staircase has no chords, and those of a motion that leaves the path are none of the path.
bool has_chord_error(const Machine& machine) {
  return !has_pulses(machine) && !accelerates_after(machine.control.interpolation);
}

/// Under the clock of the profile a staircase is wherever the plan is.
bool has_own_feed(const Machine& machine) {
  return !has_pulses(machine) || machine.control.pulse_clock == PulseClock::paper;
}

/// From row to row a staircase is off by its BLU.
bool has_own_chords(const Machine& machine) { return !has_pulses(machine); }

/// Differences of a staircase would be those of its BLU.
bool has_derivatives(const Machine& machine) { return !has_pulses(machine); }

Value if_(bool means_something, double value) {
  return means_something ? Value(value) : std::nullopt;
}

/// The largest part of its limit that any axis takes; an axis without a limit takes none.
Value part_of_limit(const AxisVector& largest, double Axis::*limit, const Machine& machine) {
  Value part;
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.present && axis.*limit > 0)
      part = std::max(part.value_or(0), largest[i] / (axis.*limit));
  }
  return part;
}

template <typename Of>
Value contour_um(const Outcome& outcome, Of&& of) {
  if (!outcome.contour || outcome.contour->cutting.instants == 0) return std::nullopt;
  return um_from_mm(of(outcome.contour->cutting));
}

constexpr ComparedFigure kFigures[] = {
    {"time_s", [](const Outcome& outcome, const Machine&) { return Value(outcome.time); }},
    {"chord_error_um_max",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_chord_error(machine), um_from_mm(outcome.measured.chord_error));
     }},
    {"chord_error_um_rms",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_chord_error(machine), um_from_mm(outcome.measured.chord_error_rms));
     }},
    {"path_deviation_um_max",
     [](const Outcome& outcome, const Machine&) {
       return Value(um_from_mm(outcome.measured.path_deviation));
     }},
    {"feed_fluctuation_max",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_own_feed(machine), outcome.measured.feed_fluctuation);
     }},
    {"feed_fluctuation_rms",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_own_feed(machine), outcome.measured.feed_fluctuation_rms);
     }},
    {"feed_fluctuation_p99",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_own_feed(machine), outcome.measured.feed_fluctuation_p99);
     }},
    {"chord_fluctuation_max",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_own_chords(machine), outcome.measured.chord_fluctuation);
     }},
    {"chord_fluctuation_rms",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_own_chords(machine), outcome.measured.chord_fluctuation_rms);
     }},
    {"chord_fluctuation_p99",
     [](const Outcome& outcome, const Machine& machine) {
       return if_(has_own_chords(machine), outcome.measured.chord_fluctuation_p99);
     }},
    {"acceleration_over_limit",
     [](const Outcome& outcome, const Machine& machine) {
       return has_derivatives(machine)
                  ? part_of_limit(outcome.measured.acceleration, &Axis::acceleration, machine)
                  : std::nullopt;
     }},
    {"jerk_over_limit",
     [](const Outcome& outcome, const Machine& machine) {
       return has_derivatives(machine) ? part_of_limit(outcome.measured.jerk, &Axis::jerk, machine)
                                       : std::nullopt;
     }},
    {"contour_error_um_max",
     [](const Outcome& outcome, const Machine&) {
       return contour_um(outcome, [](const ContourFigures& of) { return of.max; });
     }},
    {"contour_error_um_rms",
     [](const Outcome& outcome, const Machine&) {
       return contour_um(outcome, [](const ContourFigures& of) { return of.rms(); });
     }},
};

}  // namespace

std::span<const ComparedFigure> compared_figures() noexcept { return kFigures; }

}  // namespace softcnc::runtime
