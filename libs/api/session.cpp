// SPDX-License-Identifier: MIT
#include "runtime/session/session.hpp"

#include <softcnc/session.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/custom_backend.hpp"
#include "api/data.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::api {
namespace {

SessionStatus status_of(runtime::SessionStatus status) noexcept {
  switch (status) {
    case runtime::SessionStatus::running:
      return SessionStatus::running;
    case runtime::SessionStatus::waiting:
      return SessionStatus::waiting;
    case runtime::SessionStatus::paused:
      return SessionStatus::paused;
    case runtime::SessionStatus::done:
      return SessionStatus::done;
    case runtime::SessionStatus::error:
      return SessionStatus::error;
    case runtime::SessionStatus::alarm:
      break;
  }
  return SessionStatus::alarm;
}

}  // namespace

struct Session::Data {
  Data(const softcnc::Machine& on, const RunOptions& options, std::unique_ptr<hal::Backend> with)
      : machine(on),
        setup(options, nullptr),
        backend(std::move(with)),
        session(machine, setup.channel(), *backend),
        columns(runtime::row_columns(*backend)),
        values(columns.size()) {}

  softcnc::Machine machine;
  RunSetup setup;
  std::unique_ptr<hal::Backend> backend;
  runtime::Session session;
  std::vector<std::string> columns;
  std::vector<double> values;
};

Session::Session(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

Expected<Session> Session::open(const Machine& machine, const RunOptions& options) {
  auto backend = hal::open_backend(machine.data().machine);
  if (!backend) return error_of(backend.error());
  return Session(std::make_unique<Data>(machine.data().machine, options, std::move(*backend)));
}

Session Session::on(std::shared_ptr<Backend> backend, const Machine& machine,
                    const RunOptions& options) {
  return Session(std::make_unique<Data>(
      machine.data().machine, options,
      std::make_unique<CustomBackend>(std::move(backend), machine.period())));
}

bool Session::feed(std::string_view text) {
  return data_ && data_->session.takes_more() && data_->session.feed(text).has_value();
}
void Session::go_on() {
  if (data_) data_->session.go_on();
}
void Session::end() noexcept {
  if (data_) data_->session.end();
}
void Session::rest() noexcept {
  if (data_) data_->session.rest();
}

std::optional<Row> Session::step() {
  const auto row = data_ ? data_->session.step() : std::nullopt;
  if (!row) return std::nullopt;
  data_->values.assign(row->values.begin(), row->values.end());
  return Row{setpoint_of(row->setpoint, data_->machine.control.period),
             {row->feedback.position, row->feedback.alarm != Alarm::none}};
}

SessionStatus Session::status() const noexcept {
  return data_ ? status_of(data_->session.status()) : SessionStatus::done;
}
void Session::hold() noexcept {
  if (data_) data_->session.hold();
}
void Session::resume() noexcept {
  if (data_) data_->session.resume();
}
void Session::set_feed_override(double feed_override) noexcept {
  if (data_) data_->session.set_feed_override(feed_override);
}
void Session::set_rapid_override(double rapid_override) noexcept {
  if (data_) data_->session.set_rapid_override(rapid_override);
}
void Session::abort() noexcept {
  if (data_) data_->session.abort();
}

std::vector<Diagnostic> Session::diagnostics() const {
  return data_ ? diagnostics_of(data_->session.diagnostics()) : std::vector<Diagnostic>();
}

AxisVector Session::position() const noexcept {
  return data_ ? data_->session.position() : AxisVector(AxisVector::Zero());
}
State Session::state() const {
  if (!data_) return {};
  return State(std::make_unique<State::Data>(State::Data{data_->session.state()}));
}

const std::vector<std::string>& Session::columns() const noexcept {
  static const std::vector<std::string> none;
  return data_ ? data_->columns : none;
}
const std::vector<double>& Session::values() const noexcept {
  static const std::vector<double> none;
  return data_ ? data_->values : none;
}

}  // namespace softcnc::api
