// SPDX-License-Identifier: MIT
// The classes that users derive from have their tables here.
#include <softcnc/backend.hpp>
#include <softcnc/constraint.hpp>

namespace softcnc::api {

Constraint::~Constraint() = default;
Backend::~Backend() = default;

}  // namespace softcnc::api
