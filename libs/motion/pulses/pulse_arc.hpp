// SPDX-License-Identifier: MIT
// An arc in a plane as a staircase.
#pragma once

#include <array>
#include <span>

#include "motion/pulses/pulse.hpp"

namespace softcnc {

/// An arc between two grid points. The circle itself need not lie on the grid: its centre and
/// radius are in parts of a BLU.
struct PulseArc {
  static constexpr int kPartBits = 8;
  static constexpr std::int64_t kPart = 1LL << kPartBits;  // parts in a BLU
  static constexpr std::int64_t kFurthest = 1LL << 42;     // BLU: coordinates from the center

  std::array<int, 2> axes{0, 1};             // of the plane
  std::array<std::int64_t, 2> from{}, to{};  // BLU, along these axes
  std::array<std::int64_t, 2> center{};      // parts
  std::int64_t radius = 0;                   // parts
  double sweep = 0;  // rad, all turns, counter-clockwise from the first axis to the second
};

/// The discriminant of Table 2 of paper 003, D = X^2 + Y^2 - R^2: outside the circle where D > 0. A
/// move along an axis changes it by 2 X + 1 or -2 X + 1 times the BLU, and that by 2 times the BLU.
///
/// The arc is run by quadrants, in which each axis moves in one direction: one of them inward, to
/// zero, the other outward. A quadrant ends in the grid point nearest to the end of that of the
/// circle, so circles close, and the axis that reaches it first waits for the other one.
class ArcPulses {
 public:
  /// Start and end must lie on the circle to within a BLU.
  ArcPulses(const PulseArc& arc, PulseMethod method) noexcept;

  /// Fills in the next clocks, as many as there are and fit; returns 0 at the end. Realtime.
  std::size_t fill(std::span<Step> out) noexcept;

 private:
  /// What one axis has to do in one quadrant.
  struct Side {
    std::size_t axis = 0;        // of the plane: 0 or 1
    std::int64_t direction = 0;  // 1 or -1
    std::int64_t left = 0;       // moves to the end of the quadrant
    std::int64_t over = 0;       // DDA: the register, in parts
    Step step;
  };

  void begin_quadrant() noexcept;
  Side side(std::size_t axis, std::int64_t direction) const noexcept;
  std::array<std::int64_t, 2> target() const noexcept;
  std::int64_t travelled(const Side& side) const noexcept;
  std::int64_t change(const Side& side) const noexcept;

  std::size_t run(std::span<Step> out) noexcept;
  std::size_t run_alone(Side& side, std::span<Step> out) noexcept;
  std::size_t run_stairs(std::span<Step> out) noexcept;
  std::size_t run_search(std::span<Step> out) noexcept;
  std::size_t run_octant(std::span<Step> out) noexcept;
  template <bool nearer>
  void lead_with(Side& lead, Side& other, std::int64_t sign, std::span<Step> out) noexcept;
  std::size_t run_registers(std::span<Step> out) noexcept;
  bool take(Side& side, std::int64_t amount) const noexcept;

  PulseArc arc_;
  PulseMethod method_;
  std::int64_t turn_;               // 1 counter-clockwise, -1 clockwise
  int quadrant_;                    // 0 to 3, clockwise arcs being mirrored at the first axis
  int crossings_;                   // quadrants that begin later
  std::array<std::int64_t, 2> at_;  // BLU: where the quadrant begins, then where it ends
  std::int64_t d_;                  // D in parts squared
  Side inward_, outward_;
};

}  // namespace softcnc
