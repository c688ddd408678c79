// SPDX-License-Identifier: MIT
// A run as the page reads it: figures as JSON, columns and texts packed.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "input/reported_run.hpp"
#include "report/packed_data.hpp"

namespace softcnc::app {

/// Adds the columns and texts of a run to `data`, and returns what finds them, with its figures:
/// docs/report.md.
nlohmann::ordered_json run_json(const ReportedRun& run, PackedData& data);

}  // namespace softcnc::app
