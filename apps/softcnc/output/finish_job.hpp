// SPDX-License-Identifier: MIT
// What a person and other programs get after a run: summary, report, exit status.
#pragma once

#include "job/job.hpp"

namespace softcnc::app {

/// The report where one is asked for, and the summary, which names what has been written. Returns
/// the exit status of it all.
int conclude(Job& job, const Options& options, Performance& performance);

}  // namespace softcnc::app
