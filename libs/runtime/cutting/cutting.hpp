// SPDX-License-Identifier: MIT
// What a program cuts with, block by block, found before it runs.
#pragma once

#include <optional>
#include <vector>

#include "motion/geometry/extent.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/watcher.hpp"
#include "surface/tool_track.hpp"

namespace softcnc::runtime {

/// From a block on, until the next change.
struct CuttingChange {
  int block = 0;  // its number
  surface::Cutter cutter;
  bool cutting = false;                   // moves are no rapids
  AxisVector start = AxisVector::Zero();  // mm, of the block
  double target = 0;                      // mm: the Rmax that is asked for; 0: none is
  bool begins_pass = false;  // the block is the first of a pass: it comes after a rapid or a turn
};

struct Cutting {
  std::vector<CuttingChange> changes;  // in the order of blocks
  std::optional<Extent> tips;          // of all cutting moves, mm
  double radius = 0;                   // mm, largest
  double feed_per_tooth = 0;           // mm, largest as programmed
  double pick_feed = 0;                // mm, largest that is stated; 0: none is
};

/// Reads the program as far as blocks, or until the watcher wants it to stop. Errors, beside those
/// of the interpreter: SC2380 (no tool), SC2381 (the spindle stands still), SC2382 (nothing to
/// cut), SC4041 (too many teeth).
Cutting read_cutting(Program& program, const Machine& machine, const ChannelOptions& options,
                     Diagnostics& diagnostics, Watcher& watcher);

}  // namespace softcnc::runtime
