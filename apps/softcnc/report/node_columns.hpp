// SPDX-License-Identifier: MIT
// The nodes and spans of a history as packed columns.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/packed_data.hpp"
#include "runtime/history/run_history.hpp"

namespace softcnc::app {

/// Returns what rows may be off, with the rounding of the columns.
double with_steps(double error) noexcept;

/// `axes`: the names of those that have a column.
nlohmann::ordered_json node_columns(const runtime::RunHistory& history,
                                    const nlohmann::ordered_json& axes, PackedData& data);
nlohmann::ordered_json span_columns(const runtime::RunHistory& history, PackedData& data);

}  // namespace softcnc::app
