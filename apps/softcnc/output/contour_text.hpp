// SPDX-License-Identifier: MIT
// The contour error in the summary and in the report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "motion/model/machine.hpp"
#include "motion/verification/contour_report.hpp"

namespace softcnc::app {

/// The lines of the summary: largest, where and when, and rms; where it is large, what brings it
/// down to 10 µm.
std::string contour_lines(const ContourReport& report, const Machine& machine);

/// Two paragraphs for -v: how it differs from the following error, and where it is large, why.
std::string contour_paragraph(const ContourReport& report, const Machine& machine);

/// The keys contour_error_um_max, contour_error_um_rms and contour_error_at, and those with
/// "rapid_" in them for rapids.
void add_contour(const ContourReport& report, nlohmann::ordered_json& json);

}  // namespace softcnc::app
