// SPDX-License-Identifier: MIT
#include "runtime/cutting/cutting_rows.hpp"

#include <algorithm>

#include "hal/files/axis_name.hpp"
#include "runtime/figures/elapsed.hpp"

namespace softcnc::runtime {

CuttingRows::CuttingRows(const Cutting& cutting, SpindlePhase phase, double period,
                         std::span<const std::string> columns)
    : cutting_(cutting), phase_(phase), period_(period) {
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto found = std::find(columns.begin(), columns.end(), hal::axis_name(axis) + "_act_mm");
    measured_[static_cast<std::size_t>(axis)] =
        found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
  }
}

/// Passes begin alike at the moment at which they begin, which is seldom that of a row.
void CuttingRows::change_until(const Setpoint& setpoint) {
  for (; next_ < cutting_.changes.size() && cutting_.changes[next_].block <= setpoint.block;
       ++next_) {
    const CuttingChange& change = cutting_.changes[next_];
    const bool aligns = change.begins_pass && phase_ == SpindlePhase::aligned;
    const double ago = elapsed((setpoint.position - change.start).norm(), setpoint);
    const double at = static_cast<double>(setpoint.period) * period_ - ago;
    if (aligns || change.cutter != now_.cutter) track_.begin(change.cutter, at);
    now_ = change;
  }
}

bool CuttingRows::row(const Setpoint& setpoint, std::span<const double> backend_values) {
  change_until(setpoint);
  surface::ToolRow row;
  row.t = static_cast<double>(setpoint.period) * period_;
  row.commanded = row.tip = setpoint.position;
  for (int axis = 0; axis < kAxes; ++axis)
    if (const int column = measured_[static_cast<std::size_t>(axis)]; column >= 0)
      row.tip[axis] = backend_values[static_cast<std::size_t>(column)];
  row.cutting = now_.cutting;
  row.target = now_.target;
  track_.add(row);
  return track_.kept();
}

Result<surface::ToolTrack> CuttingRows::finish() {
  if (Status kept = track_.finish(); !kept) return tl::make_unexpected(kept.error());
  return std::move(track_);
}

}  // namespace softcnc::runtime
