// SPDX-License-Identifier: MIT
// The arguments of G65: which variable takes which word.
#pragma once

#include <optional>
#include <vector>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {

/// Returns the values of #1 and up that the words after G65 give, by FANUC's lists I (a letter
/// each) and II (A B C, then I J K again and again). Returns nothing, after a report, if one is
/// wrong.
std::optional<std::vector<double>> macro_arguments(Task& task);

}  // namespace softcnc::ipr
