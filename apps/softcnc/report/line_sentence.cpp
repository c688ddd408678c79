// SPDX-License-Identifier: MIT
#include "report/line_sentence.hpp"

#include <fmt/format.h>

#include "messages/duration_text.hpp"

namespace softcnc::app {
namespace {

/// Completes "Loses ... because".
std::string_view reason(Limit limit) noexcept {
  switch (limit) {
    case Limit::feed:
      return "its moves are too short to reach the feed";
    case Limit::rapid:
      return "it is a rapid";
    case Limit::chord:
      return "the curve is so tight that chords at the programmed feed would exceed the chord "
             "tolerance";
    case Limit::corner:
      return "the path turns at a corner, where the machine must slow down or stop; G64 P rounds "
             "corners";
    case Limit::roughness:
      return "a faster feed would leave more than the requested Rmax";
    case Limit::axis_velocity:
      return "an axis is at its velocity limit";
    case Limit::acceleration:
      return "an axis is at its acceleration limit, in a curve or on a ramp of the speed";
    case Limit::jerk:
      return "an axis is at its jerk limit, in a curve or on a ramp of the speed";
    case Limit::pulse_rate:
      return "the drive takes no more pulses per second";
    case Limit::tangential:
      return "the tangential acceleration is at its limit";
    case Limit::normal:
      return "the normal acceleration is at its limit in a curve";
    case Limit::custom:
      return "a further constraint limits the speed";
    case Limit::override_:
      return "the feed override is below 100 %";
    case Limit::hold:
      return "of a feed hold";
    case Limit::stop:
      return "the machine rests";
  }
  return {};
}

}  // namespace

std::string line_sentence(const runtime::LineTime& line) {
  const double at_feed = line.seconds - line.lost;
  return fmt::format("Takes {} instead of {} at its feed, because {}.", duration_text(line.seconds),
                     duration_text(std::max(at_feed, 0.0)), reason(line.limit));
}

}  // namespace softcnc::app
