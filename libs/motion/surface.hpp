// SPDX-License-Identifier: MIT
// The surface a program asks for (paper 004): what a feed that keeps its roughness depends on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace softcnc {

struct Surface {
  double tool_radius = 0;  // mm, of the ball
  double pick_feed = 0;    // mm, between neighbouring passes
  double rmax = 0;         // mm: the largest height of the roughness
  int teeth = 0;
  double spindle = 0;      // 1/s, revolutions of the spindle as the move begins
  double bend_across = 0;  // 1/mm, of the surface square to the feed: above 0 on a hill, below 0 in
                           // a hollow, above -1 / tool_radius

  /// mm/s at a feed per tooth of 1 mm.
  double tooth_rate() const noexcept { return teeth * spindle; }

  /// What passes leave between them, as part of that on a flat surface: 1 - r/(rho_p + r) of paper
  /// 004, equation 1.
  double cusp_part() const noexcept { return 1 / (1 + tool_radius * bend_across); }

  bool operator==(const Surface&) const = default;
};

/// Which roughness a feed is judged by: that of paper 004, or one that its edges never exceed.
enum class RoughnessModel : std::uint8_t { guaranteed, paper };
inline constexpr std::array<std::string_view, 2> kRoughnessModels{"guaranteed", "paper"};
constexpr std::string_view name(RoughnessModel model) noexcept {
  return kRoughnessModels[static_cast<std::size_t>(model)];
}

/// How the edges of neighbouring passes stand to each other: at equal places alike, or by time.
enum class SpindlePhase : std::uint8_t { aligned, time };
inline constexpr std::array<std::string_view, 2> kSpindlePhases{"aligned", "time"};
constexpr std::string_view name(SpindlePhase phase) noexcept {
  return kSpindlePhases[static_cast<std::size_t>(phase)];
}

/// How a machine sees the surfaces that it cuts.
struct Surfacing {
  RoughnessModel model = RoughnessModel::guaranteed;
  SpindlePhase phase = SpindlePhase::aligned;
};

/// What neighbouring passes leave between them on a flat surface however slow the feed, mm: Rmax
/// must be above it (paper 004, equation 5: 8 r Rmax > f_p^2).
constexpr double least_rmax(double tool_radius, double pick_feed) noexcept {
  return pick_feed * pick_feed / (8 * tool_radius);
}

/// The same on the surface as it bends across the feed.
inline double least_rmax(const Surface& surface) noexcept {
  return least_rmax(surface.tool_radius, surface.pick_feed) * surface.cusp_part();
}

}  // namespace softcnc
