// SPDX-License-Identifier: MIT
#include <softcnc/machine.hpp>
#include <softcnc/state.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/data.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/machine/state_file.hpp"

namespace softcnc::api {
namespace {

Expected<softcnc::Machine> machine_of(hal::MachineOrErrors machine) {
  if (!machine) return diagnostics_of(machine.error());
  return std::move(*machine);
}

Expected<State> state_of(hal::StateOrErrors state) {
  if (!state) return diagnostics_of(state.error());
  return State(std::make_unique<State::Data>(State::Data{std::move(*state)}));
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
State::State() : data_(std::make_unique<Data>()) {}
State::State(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
State::State(const State& other) : data_(std::make_unique<Data>(other.data())) {}
State::State(State&& other) noexcept = default;
State& State::operator=(State other) noexcept {
  std::swap(data_, other.data_);
  return *this;
}
State::~State() = default;

Expected<State> State::load(const std::string& file) { return state_of(hal::load_state(file)); }

Expected<State> State::parse(const std::string& text, const std::string& name) {
  return state_of(hal::parse_state(text, name));
}

const State::Data& State::data() const noexcept {
  static const Data nothing_set{};
  return data_ ? *data_ : nothing_set;
}

std::string State::toml() const { return hal::state_toml(data().state); }

std::string Machine::toml() const {
  return hal::machine_toml(hal::with_whole_paths(data().machine));
}

}  // namespace softcnc::api
