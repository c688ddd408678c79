// SPDX-License-Identifier: MIT
#include "report/line_sentence.hpp"

namespace softcnc::app {

std::string_view line_sentence(Limit limit) noexcept {
  switch (limit) {
    case Limit::feed:
      return "Its moves run at the programmed feed.";
    case Limit::rapid:
      return "It is a rapid.";
    case Limit::chord:
      return "The curve is so tight that at the programmed feed its chords would exceed "
             "control.chord_tolerance_um.";
    case Limit::contour:
      return "Its drives lag: any faster, the table would leave the path by more than "
             "control.contour_tolerance_um.";
    case Limit::corner:
      return "The path turns at a corner, where the machine must slow down or stop; a wider "
             "tolerance (G64 P) rounds it more.";
    case Limit::roughness:
      return "A faster feed would leave more than the requested Rmax.";
    case Limit::axis_velocity:
      return "An axis is at its velocity limit.";
    case Limit::acceleration:
      return "An axis is at its acceleration limit, in a curve or where the speed changes.";
    case Limit::drive:
      return "A motor is at the current or the voltage of its drive where the speed changes.";
    case Limit::jerk:
      return "An axis is at its jerk limit, in a curve or where the acceleration changes.";
    case Limit::pulse_rate:
      return "The drive takes no more pulses per second.";
    case Limit::tangential:
      return "The acceleration along the path is at its limit.";
    case Limit::normal:
      return "The acceleration across the path is at its limit in a curve.";
    case Limit::custom:
      return "A constraint beyond those of the machine limits the speed.";
    case Limit::override_:
      return "The feed override is below 100 %.";
    case Limit::hold:
      return "The feed is held.";
    case Limit::stop:
      return "The machine rests.";
  }
  return {};
}

}  // namespace softcnc::app
