// SPDX-License-Identifier: MIT
// A simulated surface as the page reads it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "input/reported_run.hpp"
#include "report/packed_data.hpp"

namespace softcnc::app {

nlohmann::ordered_json surface_json(const ReportedSurface& surface, PackedData& data);

}  // namespace softcnc::app
