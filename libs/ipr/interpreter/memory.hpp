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
    modal.restored.reset();
    modal.curve.reset();
    modal.points.reset();
    modal.curve_end.reset();
    modal.cutter.reset();
    modal.beside.reset();
    modal.ended = false;
    modal.position = modal.unplaced(place);
    if (modal.placement) modal.placement->reached = place;
  }
};

}  // namespace softcnc::ipr
