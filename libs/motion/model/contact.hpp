// SPDX-License-Identifier: MIT
// Probing moves: what is to be found, and what a probe touches in simulation.
#pragma once

#include <optional>
#include <span>

#include "motion/core/axes.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/geometry/path.hpp"

namespace softcnc {

/// A body with faces along the axes: a workpiece, a plane as a body beyond the travel, a tool
/// setter. Its corners are in mm, machine coordinates.
struct ContactBody {
  AxisVector min = AxisVector::Zero(), max = AxisVector::Zero();
};

/// The end of a tool, or the tip of a probe, as a ball.
struct ProbeTip {
  double radius = 0;  // mm
  double length = 0;  // mm: from the control point down to the lowest point of the ball

  /// Returns the centre of the ball where the control point is at `place`, mm.
  AxisVector center(const AxisVector& place) const noexcept {
    return place + AxisVector(0, 0, radius - length);
  }
};

/// Returns whether the tip touches one of the bodies where the control point is at `place`, mm,
/// machine coordinates.
bool touches(std::span<const ContactBody> bodies, const ProbeTip& tip,
             const AxisVector& place) noexcept;

enum class ProbeAim : std::uint8_t {
  contact,  // G38.2, G38.3, G31: up to where the tip begins to touch
  release,  // G38.4, G38.5: up to where it touches nothing any more
};

/// A probing move that waits for what the machine finds: a straight line from where that rests.
struct ProbeRequest {
  AxisVector to = AxisVector::Zero();  // mm, machine coordinates
  double feed = 0;                     // mm/s
  ProbeAim aim = ProbeAim::contact;
  ProbeTip tip{};    // in the spindle
  SourcePos source;  // of the line
};

enum class ProbeFound : std::uint8_t {
  found,
  nothing,  // up to the end of the move
  already,  // where the move begins: nothing has moved
};

struct ProbeAnswer {
  ProbeFound found = ProbeFound::nothing;
  AxisVector place = AxisVector::Zero();  // mm, machine coordinates: of the contact or release
  AxisVector rest = AxisVector::Zero();   // mm: where the machine rests now
  std::optional<Diagnostic> refusal{};    // why it has not moved at all
};

/// Returns how far along a line, mm, the control point is where that happens; nothing if it does
/// not on the line, or is so already at its beginning.
std::optional<double> contact_along(const Line& line, std::span<const ContactBody> bodies,
                                    const ProbeTip& tip, ProbeAim aim) noexcept;

}  // namespace softcnc
