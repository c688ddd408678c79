// SPDX-License-Identifier: MIT
// The options of a run, from what the package hands over.
#pragma once

#include "api/data.hpp"
#include "bindings.hpp"
#include "interruption.hpp"

namespace softcnc::python {

/// Returns the options of the library; a Python function that limits the speed raises into
/// `interruption`, which must outlive the run. Raises ValueError for an unknown dialect.
api::RunOptions run_options(const Options& options, Interruption& interruption);

void add_options(py::module_& module);

}  // namespace softcnc::python
