// SPDX-License-Identifier: MIT
// Runs as pictures need them.
#pragma once

#include <span>
#include <vector>

#include "input/reported_run.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// Returns what is drawn of runs, which must outlive it.
std::vector<PictureRun> picture_runs(std::span<const ReportedRun> runs);

}  // namespace softcnc::app
