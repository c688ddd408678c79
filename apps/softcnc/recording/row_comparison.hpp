// SPDX-License-Identifier: MIT
// Two rows of a trace side by side, and whether they agree.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace softcnc::app {

/// What may differ between builds and computers: lengths by 1e-6 mm (so counts by none, but one
/// where a position lies within 1e-6 mm of a half), instants by 1e-9 s, and other numbers by 1e-6
/// of their size or of 1. Words and whole numbers (line, block, limit) may not.
bool same_value(std::string_view column, std::string_view a, std::string_view b);

/// Returns whether all columns agree. Rows are lines of CSV.
bool same_row(const std::vector<std::string>& columns, std::string_view a, std::string_view b);

/// Describes the columns that differ, with both values of the first, and what that means: the
/// same path at a different time, or a different path. Rows are whole.
std::string in_words(const std::vector<std::string>& columns, std::string_view recorded,
                     std::string_view replayed);

/// Returns a table of both with their differences; columns that differ are marked. An empty
/// row is one that is missing.
std::string side_by_side(const std::vector<std::string>& columns, std::string_view recorded,
                         std::string_view replayed);

std::vector<std::string> split(std::string_view line);

}  // namespace softcnc::app
