// SPDX-License-Identifier: MIT
// The methods of interpolation: their names, and what the rest of the program must know of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "motion/pulses/pulse.hpp"

namespace softcnc {

/// How the next point is found within a period. From `chords` to `two_step` methods ignore the
/// planned speeds; the last five use reference pulses. docs/methods.md has the source of each.
enum class Method : std::uint8_t {
  arc_length,
  taylor1,
  taylor2,
  curvature3p,
  rk4,
  yeh_hsu_1999,
  yeh_hsu_2002,
  chords,
  acc_dec_linear,
  acc_dec_bell,
  two_step,
  sam,
  m_sam,
  dsm,
  m_dsm,
  dda
};
inline constexpr auto kMethodNames = std::to_array<std::string_view>({
    "arc-length",
    "taylor1",
    "taylor2",
    "curvature3p",
    "rk4",
    "yeh-hsu-1999",
    "yeh-hsu-2002",
    "chords",
    "acc-dec-linear",
    "acc-dec-bell",
    "two-step",
    "sam",
    "m-sam",
    "dsm",
    "m-dsm",
    "dda",
});
static_assert(kMethodNames.size() == static_cast<std::size_t>(Method::dda) + 1);

constexpr std::string_view name(Method method) noexcept {
  return kMethodNames[static_cast<std::size_t>(method)];
}
constexpr bool is_by_pulses(Method method) noexcept { return method >= Method::sam; }

/// Whether each setpoint lies where the plan is at its instant; otherwise a method of the
/// literature advances along the curve by its own rule.
constexpr bool follows_time(Method method) noexcept {
  return method == Method::arc_length || is_by_pulses(method);
}

/// Whether a method runs every move at its programmed feed from end to end, whatever the axes can
/// follow.
constexpr bool ignores_plan(Method method) noexcept {
  return method >= Method::chords && method <= Method::two_step;
}

/// Whether a method accelerates the axes after interpolation, by averages of their increments.
constexpr bool accelerates_after(Method method) noexcept {
  return method >= Method::acc_dec_linear && method <= Method::two_step;
}

/// Whether a method limits the chord error itself, period by period, so that the plan does not.
constexpr bool limits_chord(Method method) noexcept {
  return method == Method::curvature3p || method == Method::yeh_hsu_2002;
}

/// Returns the pulse method of a method by pulses.
constexpr PulseMethod pulse_method(Method method) noexcept {
  return static_cast<PulseMethod>(static_cast<int>(method) - static_cast<int>(Method::sam));
}

}  // namespace softcnc
