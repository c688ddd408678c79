// SPDX-License-Identifier: MIT
// The report as one HTML file.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "input/reported_run.hpp"
#include "report/what_if.hpp"

namespace softcnc::app {

/// Returns the page of one run, or of two that are compared. Errors: SC6003.
Result<std::string> report_page(std::span<const ReportedRun> runs,
                                const std::optional<WhatIf>& what_if);

}  // namespace softcnc::app
