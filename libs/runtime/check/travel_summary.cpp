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

namespace softcnc::runtime {
namespace {

constexpr double kSameOrigin = 1e-6;  // mm

const Axis& axis_of(const Machine& machine, int i) {
  return machine.axes[static_cast<std::size_t>(i)];
}

/// Returns by how much a span lies beyond an end of the travel, mm; 0 or less: within.
double excess(const TravelSpan& span, const Axis& axis, int i, bool above) {
  return above ? span.max[i] - axis.max : axis.min - span.min[i];
}

/// A length to a micrometre.
std::string mm_text(double mm) {
  std::string text = fmt::format("{:.3f}", mm);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
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

/// What the advice on one work system is made of.
struct SystemTravel {
  int index;
  const TravelSpan& span;
  const AxisVector& origin;
  const Machine& machine;

  FittingOrigins origins(int i) const {
    if (span.empty(i)) return {origin[i], origin[i]};
    const Axis& axis = axis_of(machine, i);
    return {origin[i] + axis.min - span.min[i], origin[i] + axis.max - span.max[i]};
  }
};

/// Returns the option that puts the origin where all axes fit; empty if there is no such place.
std::string fitting_option(const SystemTravel& system) {
  std::string numbers;
  for (int i = 0; i < kAxes; ++i) {
    const FittingOrigins origins = system.origins(i);
    double chosen = system.origin[i];
    if (axis_of(system.machine, i).present && !origins.contain(chosen)) {
      if (origins.empty()) return {};
      chosen = origins.middle();
    }
    numbers += (numbers.empty() ? "" : ",") + mm_text(chosen);
  }
  std::string name = hal::system_name(system.index);
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return fmt::format("--work {}={}", name, numbers);
}

std::string advice_on(const SystemTravel& system, int i) {
  const Axis& axis = axis_of(system.machine, i);
  const char letter = kAxisLetters[static_cast<std::size_t>(i)];
  const std::string name = hal::system_name(system.index);
  const double low = system.span.min[i], high = system.span.max[i];
  const std::string from = mm_text(low - system.origin[i]), to = mm_text(high - system.origin[i]);
  const std::string span = from == to ? fmt::format("is at {} {}", letter, from)
                                      : fmt::format("spans {} {} to {}", letter, from, to);
  const std::string reach = fmt::format("in {} the program {} mm", name, span);
  const FittingOrigins origins = system.origins(i);
  if (origins.empty())
    return fmt::format("{}, which is {} mm: more than the travel of {} mm, wherever {} lies", reach,
                       mm_text(high - low), mm_text(axis.max - axis.min), name);
  const std::string place =
      origins.most - origins.least > kSameOrigin
          ? fmt::format("{} to {}", mm_text(origins.least), mm_text(origins.most))
          : mm_text(origins.least);
  const std::string option = fitting_option(system);
  return fmt::format("{}; it fits with the origin of {} at {} {} mm (now {}){}{}", reach, name,
                     letter, place, mm_text(system.origin[i]),
                     option.empty() ? "" : ", for example ", option);
}

/// Advice on the work system that goes furthest beyond an end of travel; none where the program
/// sets the origin itself, or the moves are in machine coordinates.
std::string advice(const TravelSurvey& survey, const Machine& machine, const StatesAround& states,
                   int i, bool above) {
  const std::pair<const int, TravelSpan>* worst = nullptr;
  const auto by = [&](const TravelSpan& span) {
    return excess(span, axis_of(machine, i), i, above);
  };
  for (const auto& system : survey.by_system())
    if (by(system.second) > 0 && (worst == nullptr || by(system.second) > by(worst->second)))
      worst = &system;
  if (worst == nullptr || worst->first == kNoSystem) return {};
  const WorkOffset work = states.before.work_system(worst->first);
  if (work != states.after.work_system(worst->first)) return {};
  return advice_on({worst->first, worst->second, work.origin, machine}, i);
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

void TravelSummary::report(const TravelSurvey& survey, const Machine& machine,
                           const StatesAround& states) {
  const TravelSpan all = survey.all();
  std::vector<Diagnostic> errors;
  for (int end = 0; end < 2 * kAxes; ++end) {
    auto& held = held_[static_cast<std::size_t>(end)];
    if (!held) continue;
    const int i = end % kAxes;
    const bool above = end >= kAxes;
    const double by = excess(all, axis_of(machine, i), i, above);
    Diagnostic error = std::move(held->first);
    error.subject = ipo::travel_end(i, above);
    error.message = ipo::beyond_travel(machine, i, above ? by : -by);
    if (held->lines > 1)
      error.message += fmt::format("; {} lines leave it there, this one first", held->lines);
    error.advice = advice(survey, machine, states, i, above);
    errors.push_back(std::move(error));
  }
  std::ranges::stable_sort(errors, {}, [](const Diagnostic& one) { return one.pos.line; });
  for (Diagnostic& error : errors) further_.pass_on(std::move(error));
}

}  // namespace softcnc::runtime
