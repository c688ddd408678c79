// SPDX-License-Identifier: MIT
// The module _core of the Python package softcnc, which documents it.
#include "bindings.hpp"
#include "interruption.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace softcnc::python;
  module.attr("__version__") = SOFTCNC_VERSION;
  wait_at_exit();
  add_diagnostics(module);
  add_machine(module);
  add_nurbs(module);
  add_runs(module);
  add_session(module);
}
