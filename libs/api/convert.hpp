// SPDX-License-Identifier: MIT
// From the types of the libraries to those of the door, and back.
#pragma once

#include <span>
#include <vector>

#include <softcnc/diagnostic.hpp>
#include <softcnc/setpoint.hpp>

#include "motion/core/diagnostic.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::api {

/// Returns the diagnostic with its line and column as they are shown.
Diagnostic diagnostic_of(const softcnc::Diagnostic& diagnostic);
std::vector<Diagnostic> diagnostics_of(std::span<const softcnc::Diagnostic> diagnostics);
/// Returns the one diagnostic as a list, for an Expected.
std::vector<Diagnostic> error_of(const softcnc::Diagnostic& diagnostic);

/// `period` is the time from setpoint to setpoint, s.
Setpoint setpoint_of(const softcnc::Setpoint& setpoint, double period) noexcept;

}  // namespace softcnc::api
