// SPDX-License-Identifier: MIT
// What a control remembers from line to line, so that reading can go on after an error.
#pragma once

#include "ipr/expressions/parameters.hpp"
#include "ipr/lines/options.hpp"
#include "ipr/state/modal.hpp"

namespace softcnc::ipr {

/// Modes, offsets and variables behind a line that has been read without an error.
struct Memory {
  Modal modal = {};
  Parameters parameters = Parameters();
  Dialect dialect = Dialect::linuxcnc;  // in which the lines were read,
  Format format = Format::automatic;    // and their language

  /// Forgets what only the lines that follow could end: calls, a curve or a cycle over several
  /// lines, cutter compensation; and puts the machine at `place`, mm, machine coordinates.
  void stand_at(const AxisVector& place) {
    while (parameters.level() > 0) parameters.pop();
    modal.saved.resize(1);
    if (modal.saved.front()) modal.saved.front()->modes.cutter.reset();
    modal.restored.reset();
    if (modal.curve || modal.points) modal.motion = nullptr;  // its code would begin another one
    modal.curve.reset();
    modal.points.reset();
    modal.curve_end.reset();
    modal.cutter.reset();
    modal.ended = false;
    if (stands_beside(place)) return;
    modal.beside.reset();
    modal.position = modal.unplaced(place);
    if (modal.placement) modal.placement->reached = place;
  }

 private:
  /// Whether the tool is where G40 has left it.
  bool stands_beside(const AxisVector& place) const noexcept {
    constexpr double kSame = 1e-6;  // mm
    return modal.beside && (modal.beside->tool - modal.unplaced(place)).norm() < kSame;
  }
};

}  // namespace softcnc::ipr
