// SPDX-License-Identifier: MIT
// The passes of the cutting edges that come near a place, without testing all of them.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/cutting_edge_lines.hpp"
#include "surface/tool_track.hpp"

namespace softcnc::surface {

class PassIndex {
 public:
  explicit PassIndex(const ToolTrack& track);

  /// Returns the passes whose tool may touch something within, in order, as indices into the track.
  std::vector<std::uint32_t> near(const Rectangle& place) const;

  std::size_t memory() const noexcept;

 private:
  int column(double x) const noexcept;
  int row(double y) const noexcept;

  const ToolTrack& track_;
  Rectangle all_{0, 0, 0, 0};
  double side_ = 1;   // mm, of a bin
  double reach_ = 0;  // mm from the middle of a pass
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_;  // of each bin, in members_
  std::vector<std::uint32_t> members_;
};

/// Returns where the tip is during a pass, seen from above.
Rectangle footprint(const EdgePass& pass) noexcept;

/// Returns the square of the least distance between two rectangles, mm^2.
double square_distance(const Rectangle& a, const Rectangle& b) noexcept;

}  // namespace softcnc::surface
