// SPDX-License-Identifier: MIT
// The surface a program asks for (paper 004): what a feed that keeps its roughness depends on.
#pragma once

namespace softcnc {

struct Surface {
  double tool_radius = 0;  // mm, of the ball
  double pick_feed = 0;    // mm, between neighbouring passes
  double rmax = 0;         // mm: the largest height of the roughness
  int teeth = 0;

  bool operator==(const Surface&) const = default;
};

/// What neighbouring passes leave between them however slow the feed, mm: Rmax must be above it
/// (paper 004, equation 5: 8 r Rmax > f_p^2).
constexpr double least_rmax(double tool_radius, double pick_feed) noexcept {
  return pick_feed * pick_feed / (8 * tool_radius);
}

}  // namespace softcnc
