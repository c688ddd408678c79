// SPDX-License-Identifier: MIT
// The height that edges turning on a ball leave on the surface, from simulated edges: the
// transition from what passes leave to what the tip leaves, for which paper 004 has no formula.
//
// In parts of the pick-feed f_p it depends on the feed per tooth a = f_t / f_p, on the distance
// b = r sin|alpha| / f_p of the tool axis from where the ball touches, and on the number of teeth.
// Heights are parts of what passes leave without feed, f_p^2 / 8r on a shallow ball. Between its
// nodes the table is linear in b and a^2, and nowhere lower than what was simulated.
//
// Where the surface slopes across the feed, too, the axis is beside the pass, and passes begin at
// different positions. Then the table holds the highest value that passes leave at any phase, in
// either direction, and with the axis anywhere beside them.
#pragma once

#include <array>
#include <cstdint>

namespace softcnc {

/// The phase between passes: all alike on a surface that is level across the feed, or at any phase,
/// in either direction, and however the surface slopes across.
enum class PassPhase : std::uint8_t { in_phase, at_any_phase };

inline constexpr int kSimulatedTeeth = 4;  // from 1
inline constexpr std::array<double, 28> kSimulatedFeeds{
    0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7,  0.8, 0.9,  1.0, 1.1,  1.2, 1.3,  1.4,
    1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.25, 2.5, 2.75, 3.0, 3.25, 3.5, 3.75, 4.0};  // a, from 0
inline constexpr int kFineTips = 50, kCoarseTips = 16;
inline constexpr double kFineTip = 0.04, kCoarseTip = 0.25;  // between them
inline constexpr int kSimulatedTips = kFineTips + kCoarseTips + 1;

/// Returns b of a node; the last one stands for all beyond it, too.
constexpr double simulated_tip(int node) noexcept {
  return node <= kFineTips ? kFineTip * node
                           : kFineTip * kFineTips + kCoarseTip * (node - kFineTips);
}

/// The heights above 1, as part of a^2, in thousandths, by passes, teeth, b and a: made by
/// scripts/generate roughness.
using SimulatedHeights = std::array<std::array<std::uint16_t, kSimulatedFeeds.size()>,
                                    static_cast<std::size_t>(kSimulatedTips)>;
extern const std::array<std::array<SimulatedHeights, kSimulatedTeeth>, 2> kSimulatedHeights;

/// Returns the largest height at feeds up to `feed`; above the simulated feeds, an upper bound.
double edge_height(PassPhase passes, int teeth, double feed, double tip) noexcept;
/// Returns the largest feed up to which no height is above `height`; 0 for heights of 1 and less.
double edge_feed(PassPhase passes, int teeth, double height, double tip) noexcept;

}  // namespace softcnc
