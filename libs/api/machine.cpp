// SPDX-License-Identifier: MIT
#include <softcnc/machine.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/data.hpp"
#include "hal/machine/machine_file.hpp"

namespace softcnc::api {
namespace {

Expected<softcnc::Machine> machine_of(hal::MachineOrErrors machine) {
  if (!machine) return diagnostics_of(machine.error());
  return std::move(*machine);
}

}  // namespace

Machine::Machine() : data_(std::make_unique<Data>()) {}
Machine::Machine(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
Machine::Machine(const Machine& other) : data_(std::make_unique<Data>(other.data())) {}
Machine::Machine(Machine&& other) noexcept = default;
Machine& Machine::operator=(Machine other) noexcept {
  std::swap(data_, other.data_);
  return *this;
}
Machine::~Machine() = default;

Expected<Machine> Machine::load(const std::string& file) {
  auto machine = machine_of(hal::load_machine(file, {}));
  if (!machine) return machine.errors();
  return Machine(std::make_unique<Data>(Data{std::move(*machine)}));
}

Expected<Machine> Machine::parse(const std::string& text, const std::string& name) {
  auto machine = machine_of(hal::parse_machine(text, name, {}));
  if (!machine) return machine.errors();
  return Machine(std::make_unique<Data>(Data{std::move(*machine)}));
}

Expected<Machine> Machine::with(const std::vector<std::string>& settings) const {
  auto machine = machine_of(hal::parse_machine(toml(), "machine", settings));
  if (!machine) return machine.errors();
  return Machine(std::make_unique<Data>(Data{std::move(*machine)}));
}

const Machine::Data& Machine::data() const noexcept {
  static const Data built_in{};
  return data_ ? *data_ : built_in;
}

double Machine::period() const noexcept { return data().machine.control.period; }
std::string Machine::toml() const {
  return hal::machine_toml(hal::with_whole_paths(data().machine));
}

}  // namespace softcnc::api
