// SPDX-License-Identifier: MIT
// What a person reads after a run.
#pragma once

#include <string>

#include "job/job.hpp"

namespace softcnc::app {

/// A line that names the machine file beside the program, with the newline before it; empty: the
/// machine is another one.
std::string machine_line(const Job& job);

/// What every user reads, in mm, mm/min and µm: ten to fifteen lines, without a newline at the end.
std::string summary(const Job& job, const JobResult& result);

/// What -v adds: the time by limit, following errors, counts, where the contour error comes from,
/// and the further limits. Likewise.
std::string details(const Job& job, const JobResult& result);

}  // namespace softcnc::app
