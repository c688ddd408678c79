// SPDX-License-Identifier: MIT
// What the parts of the module _core have in common.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include <softcnc/diagnostic.hpp>
#include <softcnc/program.hpp>

namespace softcnc::python {

namespace py = pybind11;
using Names = std::vector<std::string>;

void add_diagnostics(py::module_& module);
void add_machine(py::module_& module);
void add_runs(py::module_& module);
void add_session(py::module_& module);
void add_nurbs(py::module_& module);

/// Raises softcnc.Error with these diagnostics. Requires the GIL.
[[noreturn]] void raise(const std::vector<api::Diagnostic>& diagnostics);

/// Returns the value, or raises the errors that explain why there is none.
template <typename T>
T value_of(api::Expected<T> expected) {
  if (!expected) raise(expected.errors());
  return std::move(*expected);
}

/// How a program is run: the values that the package hands over, one for each option.
struct Options {
  std::string dialect = "linuxcnc";
  double feed_override = 1;
  bool block_skip = false, optional_stop = false;
  std::vector<std::string> subprograms;
  std::map<std::string, double> define;
  api::State state;
  py::object limit = py::none();  // a function: position, tangent, curvature, feed, rapid -> mm/s
};

}  // namespace softcnc::python
