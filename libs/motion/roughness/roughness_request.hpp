// SPDX-License-Identifier: MIT
// The surface that a program requests (paper 004): what a feed that keeps its roughness depends on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace softcnc {

struct Surface {
  double tool_radius = 0;  // mm, of the ball
  double pick_feed = 0;    // mm, between neighbouring passes
  double rmax = 0;         // mm: the largest height of the roughness
  int teeth = 0;
  double spindle = 0;               // 1/s, revolutions of the spindle as the move begins
  double transverse_curvature = 0;  // 1/mm, of the surface square to the feed: above 0 on a hill,
                                    // below 0 in a hollow, above -1 / tool_radius
  double slope_across = 0;  // rad, the largest slope of the surface square to the feed as seen from
                            // above; 0: it is level there, and passes are in phase

  /// Returns the speed, mm/s, at a feed per tooth of 1 mm.
  double tooth_rate() const noexcept { return teeth * spindle; }

  /// Returns what passes leave between them, as a part of that on a flat surface: 1 - r/(rho_p + r)
  /// of paper 004, equation 1.
  double cusp_part() const noexcept { return 1 / (1 + tool_radius * transverse_curvature); }

  /// Returns the distance, mm, from pass to pass along the surface, where it slopes most; the
  /// pick-feed is that from above.
  double pick_on_slope() const noexcept { return pick_feed / std::cos(slope_across); }

  bool operator==(const Surface&) const = default;
};

/// The roughness model that limits the feed: that of paper 004, or one that the edges never exceed.
enum class RoughnessModel : std::uint8_t { guaranteed, paper };
inline constexpr std::array<std::string_view, 2> kRoughnessModels{"guaranteed", "paper"};
constexpr std::string_view name(RoughnessModel model) noexcept {
  return kRoughnessModels[static_cast<std::size_t>(model)];
}

/// The phase of the edges in neighbouring passes: the same at the same position along the feed, or
/// determined by time.
enum class SpindlePhase : std::uint8_t { aligned, time };
inline constexpr std::array<std::string_view, 2> kSpindlePhases{"aligned", "time"};
constexpr std::string_view name(SpindlePhase phase) noexcept {
  return kSpindlePhases[static_cast<std::size_t>(phase)];
}

/// How a machine models the surfaces that it cuts.
struct Surfacing {
  RoughnessModel model = RoughnessModel::guaranteed;
  SpindlePhase phase = SpindlePhase::aligned;
};

/// Returns what neighbouring passes leave between them however slow the feed, mm: Rmax must be
/// above it. It is what lies above the chord of a ball; f_p^2 / 8r of paper 004 is a little less.
inline double least_rmax(const Surface& surface) noexcept {
  const double r = surface.tool_radius, pick = surface.pick_on_slope();
  const double half_squared = pick * pick * surface.cusp_part() / 4;
  return half_squared / (r + std::sqrt(std::max(r * r - half_squared, 0.0)));
}

}  // namespace softcnc
