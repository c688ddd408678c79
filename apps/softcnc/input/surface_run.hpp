// SPDX-License-Identifier: MIT
// The surface that a program leaves, for a report.
#pragma once

#include <optional>

#include "input/reported_run.hpp"
#include "job/job.hpp"
#include "job/terminal.hpp"

namespace softcnc::app {

/// Points of the grid that a report takes the time for; `softcnc surface` has no such limit.
inline constexpr double kMostSurfacePoints = 3e7;

/// Runs a program without errors again and cuts its stock. Nothing where it cannot be cut, with too
/// many points, or where the run is stopped. Errors: SC6003.
Result<std::optional<ReportedSurface>> cut_surface(Job& job, Terminal& terminal);

}  // namespace softcnc::app
