// SPDX-License-Identifier: MIT
// The time sheet and the worst lines, for a person and for a report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "runtime/session/outcome.hpp"

namespace softcnc::app {

/// One line of the summary, with a newline before it: how often the machine rests, and why. Empty
/// where it never does.
std::string stops_line(const runtime::TimeSheet& sheet);

/// Lines without a newline at the end: what each tool did with its time, and the rests by cause.
std::string time_sheet_text(const runtime::TimeSheet& sheet);

/// Likewise: the lines that lose most, with the limit and the seconds, and what they lose it for.
std::string losses_text(const runtime::Outcome& outcome);

/// The keys `rests`, `time_sheet`, `worst_lines` and `loss_causes`: docs/cli.md.
void add_times(nlohmann::ordered_json& report, const runtime::Outcome& outcome);

}  // namespace softcnc::app
