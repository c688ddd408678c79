// SPDX-License-Identifier: MIT
#include "runtime/check/travel_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hal/machine/state_names.hpp"
#include "ipo/path/travel.hpp"
#include "ipr/text/number.hpp"

namespace softcnc::runtime {
namespace {

using ipr::number_text;

constexpr double kSameOrigin = 1e-6;  // mm

const Axis& axis_of(const Machine& machine, int i) {
  return machine.axes[static_cast<std::size_t>(i)];
}

/// Returns by how much a span lies beyond an end of the travel, mm; 0 or less: within.
double excess(const TravelSpan& span, const Axis& axis, int i, bool above) {
  return above ? span.max[i] - axis.max : axis.min - span.min[i];
}

/// The origins of a work system, along one axis, with which its moves lie within the travel, mm.
struct FittingOrigins {
  double least, most;

  bool empty() const noexcept { return least > most + kSameOrigin; }
  bool contain(double origin) const noexcept {
    return origin >= least - kSameOrigin && origin <= most + kSameOrigin;
  }
  /// Returns the middle, in whole millimetres where that fits.
  double middle() const noexcept {
    const double middle = 0.5 * (least + most), whole = std::round(middle);
    return contain(whole) ? whole : middle;
  }
};

FittingOrigins fitting_origins(const TravelSpan& span, const AxisVector& origin,
                               const Machine& machine, int i) {
  if (span.empty(i) || !axis_of(machine, i).present) return {origin[i], origin[i]};
  const Axis& axis = axis_of(machine, i);
  return {origin[i] + axis.min - span.min[i], origin[i] + axis.max - span.max[i]};
}

/// Returns the state with the work systems where the moves that were read would fit; nothing where
/// the program sets an origin itself, or its moves are longer than the travel.
std::optional<MachineState> moved(const TravelReading& reading, const Machine& machine) {
  MachineState state = reading.before;
  for (const auto& [system, span] : reading.survey.by_system()) {
    if (system == kNoSystem) continue;
    if (reading.before.work_system(system) != reading.after.work_system(system))
      return std::nullopt;
    AxisVector& origin = state.work_system_entry(system).origin;
    for (int i = 0; i < kAxes; ++i) {
      const FittingOrigins origins = fitting_origins(span, origin, machine, i);
      if (origins.empty()) return std::nullopt;
      if (!origins.contain(origin[i])) origin[i] = std::round(origins.middle() * 1000) / 1000;
    }
  }
  return state;
}

/// Moves the work systems until the program fits: where an axis has not moved, the first reading
/// does not know that it was to be there.
std::optional<TravelReading> fit(TravelReading reading, const Machine& machine,
                                 const ReadFrom& read) {
  constexpr int kMostReadings = 3;
  for (int n = 0; n < kMostReadings && (n == 0 || reading.only_travel); ++n) {
    const auto state = moved(reading, machine);
    if (!state || *state == reading.before) return std::nullopt;
    reading = read(*state);
    if (reading.good) return reading;
  }
  return std::nullopt;
}

/// The options that put the work systems where they fit.
std::string options_for(const MachineState& fitting, const MachineState& before) {
  std::string options;
  for (int system = 0; system < kWorkSystems + kFurtherSystems; ++system) {
    const AxisVector origin = fitting.work_system(system).origin;
    if (origin == before.work_system(system).origin) continue;
    std::string name = hal::system_name(system);
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    options += fmt::format("{}--work {}={},{},{}", options.empty() ? "" : " ", name,
                           number_text(origin[0]), number_text(origin[1]), number_text(origin[2]));
  }
  return options;
}

/// Returns the work system whose moves go furthest beyond an end of travel; kNoSystem where none
/// does.
int worst_system(const TravelSurvey& survey, const Machine& machine, int i, bool above) {
  int worst = kNoSystem;
  double most = 0;
  for (const auto& [system, span] : survey.by_system()) {
    const double by = excess(span, axis_of(machine, i), i, above);
    if (system == kNoSystem || span.empty(i) || by <= most) continue;
    most = by;
    worst = system;
  }
  return worst;
}

std::string span_text(const TravelSpan& span, const AxisVector& origin, int i) {
  const char letter = kAxisLetters[static_cast<std::size_t>(i)];
  const std::string from = number_text(span.min[i] - origin[i]),
                    to = number_text(span.max[i] - origin[i]);
  return from == to ? fmt::format("is at {} {}", letter, from)
                    : fmt::format("spans {} {} to {}", letter, from, to);
}

/// Advice on the moves of a work system along an axis, with the reading that fits if there is one.
std::string advice_on(const TravelReading& reading, const std::optional<TravelReading>& fits,
                      const Machine& machine, int system, int i) {
  const TravelReading& known = fits ? *fits : reading;
  const auto span = known.survey.by_system().find(system);
  if (span == known.survey.by_system().end() || span->second.empty(i)) return {};
  const AxisVector origin = known.before.work_system(system).origin;
  const std::string name = hal::system_name(system);
  const std::string program =
      fmt::format("in {} the program {} mm", name, span_text(span->second, origin, i));
  const FittingOrigins origins = fitting_origins(span->second, origin, machine, i);
  const Axis& axis = axis_of(machine, i);
  if (origins.empty())
    return fmt::format("{}, which is {} mm: more than the travel of {} mm, wherever {} lies",
                       program, number_text(span->second.max[i] - span->second.min[i]),
                       number_text(axis.max - axis.min), name);
  if (!fits) return {};
  const std::string least = number_text(origins.least), most = number_text(origins.most);
  return fmt::format("{}; it fits with the origin of {} at {} {}{} mm (now {}), for example {}",
                     program, name, kAxisLetters[static_cast<std::size_t>(i)], least,
                     least == most ? "" : " to " + most,
                     number_text(reading.before.work_system(system).origin[i]),
                     options_for(fits->before, reading.before));
}

}  // namespace

Diagnostics::Sink TravelSummary::sink() {
  return [this](const Diagnostic& diagnostic) {
    if (!holds_ || diagnostic.code != Code::SC4001) return further_.pass_on(diagnostic);
    for (int i = 0; i < 2 * kAxes; ++i) {
      if ((diagnostic.subject & ipo::travel_end(i % kAxes, i >= kAxes)) == 0) continue;
      auto& held = held_[static_cast<std::size_t>(i)];
      if (!held) held = Held{diagnostic, 0};
      ++held->lines;
    }
  };
}

void TravelSummary::report(const MachineState& state, const Machine& machine,
                           const ReadFrom& read) {
  if (std::ranges::none_of(held_, [](const auto& held) { return held.has_value(); })) return;
  const TravelReading reading = read(state);
  const TravelSpan all = reading.survey.all();
  const auto fits = fit(reading, machine, read);
  std::vector<Diagnostic> errors;
  for (int end = 0; end < 2 * kAxes; ++end) {
    auto& held = held_[static_cast<std::size_t>(end)];
    if (!held) continue;
    const int i = end % kAxes;
    const bool above = end >= kAxes;
    const double by = excess(all, axis_of(machine, i), i, above);
    Diagnostic error = std::move(held->first);
    error.subject = ipo::travel_end(i, above);
    if (by > 0)  // otherwise the reading was broken off before
      error.message = ipo::beyond_travel(machine, i, above ? by : -by);
    if (held->lines > 1)
      error.message += fmt::format("; {} lines leave it there, this one first", held->lines);
    if (const int system = worst_system(reading.survey, machine, i, above); system != kNoSystem)
      error.advice = advice_on(reading, fits, machine, system, i);
    errors.push_back(std::move(error));
  }
  std::ranges::stable_sort(errors, {}, [](const Diagnostic& one) { return one.pos.line; });
  for (Diagnostic& error : errors) further_.pass_on(std::move(error));
}

}  // namespace softcnc::runtime
