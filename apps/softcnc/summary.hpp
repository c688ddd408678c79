// SPDX-License-Identifier: MIT
// What a person reads after a run.
#pragma once

#include <string>

#include "performance.hpp"

namespace softcnc::app {

/// Several lines, without a newline at the end.
std::string summary(const Job& job, const Performance& performance);

}  // namespace softcnc::app
