// SPDX-License-Identifier: MIT
// The panels of the plots over time: which values, in which colours.
#pragma once

#include <vector>

#include "pictures/time_panel.hpp"

namespace softcnc::app {

/// Returns the panel of achieved and programmed feed; of two runs, the achieved ones.
std::vector<TimePanel> feed_panels(PictureRuns runs);
/// Returns the panels of the axes: velocity, and the use of acceleration and jerk where it is
/// known.
std::vector<TimePanel> axis_panels(PictureRuns runs);
/// Returns a panel for each error that any row of the runs knows.
std::vector<TimePanel> error_panels(PictureRuns runs);

}  // namespace softcnc::app
