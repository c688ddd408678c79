// SPDX-License-Identifier: MIT
#include <softcnc/machine.hpp>
#include <softcnc/state.hpp>

#include "bindings.hpp"

namespace softcnc::python {

void add_machine(py::module_& module) {
  using api::Machine;
  using api::State;
  py::class_<Machine>(module, "Machine")
      .def(py::init<>())
      .def_static("load", [](const std::string& file) { return value_of(Machine::load(file)); })
      .def_static("parse",
                  [](const std::string& text, const std::string& name) {
                    return value_of(Machine::parse(text, name));
                  })
      .def("set",
           [](const Machine& machine, const std::vector<std::string>& values) {
             return value_of(machine.with(values));
           })
      .def_property_readonly("period", &Machine::period)
      .def("toml", &Machine::toml);
  py::class_<State>(module, "State")
      .def(py::init<>())
      .def_static("load", [](const std::string& file) { return value_of(State::load(file)); })
      .def_static("parse",
                  [](const std::string& text, const std::string& name) {
                    return value_of(State::parse(text, name));
                  })
      .def("toml", &State::toml);
}

}  // namespace softcnc::python
