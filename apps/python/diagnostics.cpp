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

py::tuple state_of(const Diagnostic& d) {
  return py::make_tuple(d.code, static_cast<int>(d.severity), d.file, d.line, d.column, d.length,
                        d.message, d.source_line, d.text, d.help);
}

Diagnostic diagnostic_of_state(const py::tuple& state) {
  const auto text = [&](std::size_t i) { return state[i].cast<std::string>(); };
  const auto number = [&](std::size_t i) { return state[i].cast<int>(); };
  return {text(0),   static_cast<Severity>(number(1)),
          text(2),   number(3),
          number(4), number(5),
          text(6),   text(7),
          text(8),   text(9)};
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
      .def(py::pickle([](const Diagnostic& d) { return state_of(d); },
                      [](const py::tuple& state) { return diagnostic_of_state(state); }))
      .def("__eq__",
           [](const Diagnostic& a, const Diagnostic& b) { return state_of(a).equal(state_of(b)); })
      .def("__hash__", [](const Diagnostic& a) { return py::hash(state_of(a)); })
      .def("__str__", text_of)
      .def("__repr__", repr_of);
  error_class = PyErr_NewExceptionWithDoc(
      "softcnc.Error",
      "What is wrong with a program, a machine or a state.\n\n"
      "`diagnostics` lists all of it; str() shows the errors as `softcnc check` does.",
      nullptr, py::dict(py::arg("diagnostics") = py::list()).ptr());
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
