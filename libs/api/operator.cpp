// SPDX-License-Identifier: MIT
#include "runtime/operator/operator.hpp"

#include <softcnc/operator.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/custom_backend.hpp"
#include "api/data.hpp"

namespace softcnc::api {
namespace {

Operator::Refusal refusal_of(const Status& status) {
  if (status) return std::nullopt;
  return error_of(status.error()).front();
}

}  // namespace

std::string name(MachineMode mode) {
  return std::string(runtime::kModeNames[static_cast<std::size_t>(mode)]);
}

struct Operator::Data {
  Data(const softcnc::Machine& on, const RunOptions& options, std::unique_ptr<hal::Backend> with)
      : machine(on),
        setup(options, nullptr),
        backend(std::move(with)),
        operated(machine, setup.channel(), *backend, nullptr,
                 [this](const softcnc::Diagnostic& found) { diagnostics.push_back(found); }) {}

  softcnc::Machine machine;
  RunSetup setup;
  std::unique_ptr<hal::Backend> backend;
  std::vector<softcnc::Diagnostic> diagnostics;
  runtime::Operator operated;
};

Operator::Operator(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
Operator::Operator(Operator&& other) noexcept = default;
Operator& Operator::operator=(Operator&& other) noexcept = default;
Operator::~Operator() = default;

Expected<Operator> Operator::open(const Machine& machine, const RunOptions& options) {
  auto backend = hal::open_backend(machine.data().machine);
  if (!backend) return error_of(backend.error());
  return Operator(std::make_unique<Data>(machine.data().machine, options, std::move(*backend)));
}

Operator Operator::on(std::shared_ptr<Backend> backend, const Machine& machine,
                      const RunOptions& options) {
  return Operator(std::make_unique<Data>(
      machine.data().machine, options,
      std::make_unique<CustomBackend>(std::move(backend), machine.period())));
}

Operator::Refusal Operator::line(std::string_view text) {
  return refusal_of(data_->operated.line(text));
}
bool Operator::is_line_open() const noexcept { return data_->operated.is_line_open(); }
Operator::Refusal Operator::start(std::string_view program) {
  return refusal_of(data_->operated.start(program));
}
Operator::Refusal Operator::jog(const Jog& jog) {
  return refusal_of(data_->operated.jog({jog.distance, jog.feed, jog.continuous}));
}
Operator::Refusal Operator::cancel() { return refusal_of(data_->operated.cancel()); }
Operator::Refusal Operator::home() { return refusal_of(data_->operated.home()); }
Operator::Refusal Operator::touch_off(int axis, double value) {
  return refusal_of(data_->operated.touch_off(axis, value));
}
Operator::Refusal Operator::hold() { return refusal_of(data_->operated.hold()); }
Operator::Refusal Operator::resume() { return refusal_of(data_->operated.resume()); }
Operator::Refusal Operator::abort() { return refusal_of(data_->operated.abort()); }
Operator::Refusal Operator::reset() { return refusal_of(data_->operated.reset()); }
Operator::Refusal Operator::door() { return refusal_of(data_->operated.door()); }
void Operator::door_closed() noexcept { data_->operated.door_closed(); }
Operator::Refusal Operator::unlock() { return refusal_of(data_->operated.unlock()); }
Operator::Refusal Operator::check() { return refusal_of(data_->operated.check()); }
Operator::Refusal Operator::sleep() { return refusal_of(data_->operated.sleep()); }
void Operator::estop() { data_->operated.estop(); }
void Operator::limit_switch(int axis, int direction) {
  data_->operated.limit_switch(axis, direction);
}
Operator::Refusal Operator::set_position(const AxisVector& place) {
  return refusal_of(data_->operated.set_position(place));
}
void Operator::set_feed_override(double feed_override) noexcept {
  data_->operated.set_feed_override(feed_override);
}
void Operator::set_rapid_override(double rapid_override) noexcept {
  data_->operated.set_rapid_override(rapid_override);
}
void Operator::set_spindle_override(double spindle_override) noexcept {
  data_->operated.set_spindle_override(spindle_override);
}
void Operator::set_block_skip(bool on) noexcept { data_->operated.set_block_skip(on); }
void Operator::set_optional_stop(bool on) noexcept { data_->operated.set_optional_stop(on); }
void Operator::set_single_block(bool on) noexcept { data_->operated.set_single_block(on); }

std::optional<Row> Operator::step() {
  const auto row = data_->operated.step();
  if (!row) return std::nullopt;
  return Row{setpoint_of(row->setpoint, data_->machine.control.period),
             {row->feedback.position, row->feedback.alarm != Alarm::none}};
}

MachineMode Operator::mode() const noexcept {
  return static_cast<MachineMode>(data_->operated.mode());
}
bool Operator::moving() const noexcept { return data_->operated.moving(); }
bool Operator::knows_position() const noexcept { return data_->operated.knows_position(); }
AxisVector Operator::position() const noexcept { return data_->operated.position(); }
Outputs Operator::outputs() const noexcept {
  const softcnc::Outputs& outputs = data_->operated.outputs();
  return {outputs.spindle_rpm, outputs.mist, outputs.flood};
}
std::optional<AxisVector> Operator::return_point() const noexcept {
  return data_->operated.return_point();
}
State Operator::state() const {
  return State(std::make_unique<State::Data>(State::Data{data_->operated.state()}));
}
std::vector<Diagnostic> Operator::diagnostics() const { return diagnostics_of(data_->diagnostics); }

}  // namespace softcnc::api
