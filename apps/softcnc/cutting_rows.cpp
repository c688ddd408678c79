// SPDX-License-Identifier: MIT
#include "cutting_rows.hpp"

#include <algorithm>

#include "hal/axis_name.hpp"

namespace softcnc::app {

CuttingRows::CuttingRows(const Cutting& cutting, SpindlePhase phase, double period,
                         std::span<const std::string> columns)
    : cutting_(cutting), phase_(phase), period_(period) {
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto found = std::find(columns.begin(), columns.end(), hal::axis_name(axis) + "_act_mm");
    measured_[static_cast<std::size_t>(axis)] =
        found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
  }
}

/// The way to a row belongs to the block of the row.
void CuttingRows::change_until(int block) {
  for (; next_ < cutting_.changes.size() && cutting_.changes[next_].block <= block; ++next_) {
    const CuttingChange& change = cutting_.changes[next_];
    const bool aligns = change.begins_pass && phase_ == SpindlePhase::aligned;
    if (aligns || change.cutter != now_.cutter) track_.begin(change.cutter);
    now_ = change;
  }
}

bool CuttingRows::row(const Setpoint& setpoint, std::span<const double> backend_values) {
  change_until(setpoint.block);
  hal::ToolRow row;
  row.t = static_cast<double>(setpoint.period) * period_;
  row.commanded = row.tip = setpoint.position;
  for (int axis = 0; axis < kAxes; ++axis)
    if (const int column = measured_[static_cast<std::size_t>(axis)]; column >= 0)
      row.tip[axis] = backend_values[static_cast<std::size_t>(column)];
  row.cutting = now_.cutting;
  track_.add(row);
  return true;
}

hal::ToolTrack CuttingRows::finish() {
  track_.finish();
  return std::move(track_);
}

}  // namespace softcnc::app
