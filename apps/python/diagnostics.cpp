// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bindings.hpp"

namespace softcnc::python {
namespace {

using api::Diagnostic;
using api::Severity;

std::string severity_of(const Diagnostic& diagnostic) {
  switch (diagnostic.severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      break;
  }
  return "error";
}

/// The text ends with a newline, which print() adds.
std::string text_of(const Diagnostic& diagnostic) {
  return diagnostic.text.substr(0, diagnostic.text.find_last_not_of('\n') + 1);
}

std::string repr_of(const Diagnostic& diagnostic) {
  return "<" + severity_of(diagnostic) + " " + diagnostic.code + " " + diagnostic.file + ":" +
         std::to_string(diagnostic.line) + ": " + diagnostic.message + ">";
}

PyObject* error_class = nullptr;

}  // namespace

void add_diagnostics(py::module_& module) {
  py::class_<Diagnostic>(
      module, "Diagnostic",
      "What is wrong, and where: code (\"SC2103\"), severity (\"error\", \"warning\" or "
      "\"note\"),\nfile, line and column (from 1; 0: no place), length (characters), message, "
      "source_line, and help,\nwhich says what to do about it. str() shows it with a caret.")
      .def_readonly("code", &Diagnostic::code)
      .def_property_readonly("severity", severity_of)
      .def_readonly("file", &Diagnostic::file)
      .def_readonly("line", &Diagnostic::line)
      .def_readonly("column", &Diagnostic::column)
      .def_readonly("length", &Diagnostic::length)
      .def_readonly("message", &Diagnostic::message)
      .def_readonly("source_line", &Diagnostic::source_line)
      .def_readonly("help", &Diagnostic::help)
      .def("__str__", text_of)
      .def("__repr__", repr_of);
  error_class = PyErr_NewExceptionWithDoc(
      "softcnc.Error",
      "What is wrong with a program, a machine or a state.\n\n"
      "`diagnostics` lists all of it; str() shows the errors as `softcnc check` does.",
      nullptr, nullptr);
  module.attr("Error") = py::handle(error_class);
}

void raise(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == Severity::error) text += diagnostic.text;
  text.erase(text.find_last_not_of('\n') + 1);
  const py::object error = py::handle(error_class)(text);
  error.attr("diagnostics") = diagnostics;
  PyErr_SetObject(error_class, error.ptr());
  throw py::error_already_set();
}

}  // namespace softcnc::python
