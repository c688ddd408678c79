// SPDX-License-Identifier: MIT
// The contour error in the summary and in the report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "motion/model/machine.hpp"
#include "motion/verification/contour_report.hpp"

namespace softcnc::app {

/// The line of the summary beside that of the chord error: largest, where and when, and rms.
std::string contour_line(const ContourReport& report);

/// The paragraph below the axes: how it differs from the following error, and where it is large,
/// why that is, and which feed would bring it down to 10 um.
std::string contour_paragraph(const ContourReport& report, const Machine& machine);

/// The keys contour_error_um_max, contour_error_um_rms and contour_error_at, and those with
/// "rapid_" in them for rapids.
void add_contour(const ContourReport& report, nlohmann::ordered_json& json);

}  // namespace softcnc::app
