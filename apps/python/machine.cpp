// SPDX-License-Identifier: MIT
#include <softcnc/machine.hpp>
#include <softcnc/state.hpp>

#include "api/convert.hpp"
#include "bindings.hpp"
#include "hal/machine/machine_confinement.hpp"
#include "hal/machine/machine_file.hpp"

namespace softcnc::python {
namespace {

using Beside = std::pair<api::Machine, std::vector<api::Diagnostic>>;

/// Returns the machine of the file beside a program, as the command finds it, and warnings about
/// what in it does not count; nothing where there is no such file.
std::optional<Beside> beside(const std::string& part, const std::vector<std::string>& settings) {
  const std::string file = hal::machine_beside(part);
  if (file.empty() || file == part) return std::nullopt;
  const auto found = hal::find_machine({file, true}, settings);
  if (!found) raise(api::diagnostics_of(found.error()));
  return Beside{value_of(api::Machine::parse(hal::machine_toml(found->machine), file)),
                api::diagnostics_of(found->ignored)};
}

}  // namespace

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
  module.def("machine_beside", beside);
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
