// SPDX-License-Identifier: MIT
// A machine with its operator on a driven clock: every row is kept.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/operator/operator.hpp"
#include "support/run.hpp"

namespace softcnc::test {

inline Machine machine_to_operate(BackendKind backend, double jerk) {
  Machine machine;
  machine.control.backend = backend;
  machine.step_port.file.clear();  // pulses are counted, and not written
  for (Axis& axis : machine.axes) {
    axis.jerk = jerk;
    axis.home.search = 20;
    axis.home.place = 100;
  }
  return machine;
}

/// Requests what has no figures of its own, and something small of what has.
inline Status ask(runtime::Operator& operated, runtime::Request request,
                  std::string_view program = "G01 X20 F3000\nM30\n") {
  using runtime::Request;
  switch (request) {
    case Request::line:
      return operated.line("G04 P0.1\n");
    case Request::start:
      return operated.start(program);
    case Request::jog:
      return operated.jog({AxisVector(0, 1, 0), 50});
    case Request::cancel:
      return operated.cancel();
    case Request::hold:
      return operated.hold();
    case Request::resume:
      return operated.resume();
    case Request::abort:
      return operated.abort();
    case Request::reset:
      return operated.reset();
    case Request::door:
      return operated.door();
    case Request::unlock:
      return operated.unlock();
    case Request::check:
      return operated.check();
    case Request::sleep:
      return operated.sleep();
    case Request::home:
      return operated.home();
  }
  return {};
}

class Desk final : public runtime::RowSink {
 public:
  explicit Desk(BackendKind kind, double jerk = 0) : Desk(machine_to_operate(kind, jerk)) {}
  explicit Desk(const Machine& on) : Desk(on, std::move(*hal::open_backend(on))) {}
  Desk(const Machine& on, std::unique_ptr<hal::Backend> with)
      : machine(on),
        backend(std::move(with)),
        operated(machine, {}, *backend, this, [this](const Diagnostic& found) {
          if (found.severity() != Severity::error) return;
          errors.push_back(found.code);
          messages.push_back(render(found));
        }) {}

  bool row(const Setpoint& setpoint, std::span<const double>) override {
    if (operated.has_homed() && homed_from == 0) homed_from = places.size();
    periods.push_back(setpoint.period);
    places.push_back(setpoint.position);
    return true;
  }
  std::size_t rows() const { return places.size(); }

  /// For so many periods, or until something is the case.
  void run(
      int count, const std::function<bool()>& until = [] { return false; }) {
    for (int i = 0; i < count && !until(); ++i) operated.step();
  }
  /// Until nothing moves any more; at most a quarter of an hour.
  void settle() {
    const auto is_idle = [this] {
      const auto mode = operated.mode();
      return mode != runtime::MachineMode::run && mode != runtime::MachineMode::jog &&
             mode != runtime::MachineMode::home;
    };
    run(900'000, is_idle);
    REQUIRE(is_idle());
  }

  /// In every row, and from row to row, with the tolerance of the verification; rows count on.
  void check_limits() const {
    constexpr double kShare = 1 + 1e-3;
    const double period = machine.control.period;
    std::array<AxisVector, 4> last;  // places, the present one first
    last.fill(places.empty() ? AxisVector(AxisVector::Zero()) : places.front());
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (i == homed_from) last.fill(places[i]);
      std::rotate(last.begin(), last.end() - 1, last.end());
      last[0] = places[i];
      const AxisVector v = (last[0] - last[1]) / period;
      const AxisVector a = (last[0] - 2 * last[1] + last[2]) / (period * period);
      const AxisVector j =
          (last[0] - 3 * last[1] + 3 * last[2] - last[3]) / (period * period * period);
      for (int axis = 0; axis < kAxes; ++axis) {
        const Axis& limits = machine.axes[static_cast<std::size_t>(axis)];
        const bool is_kept =
            std::abs(v[axis]) <= limits.velocity * kShare &&
            std::abs(a[axis]) <= limits.acceleration * kShare &&
            (limits.jerk == 0 || std::abs(j[axis]) <= limits.jerk * (1 + kJerkShare));
        if (!is_kept)
          FAIL("row " << i << ", axis " << axis << ": " << v[axis] << " " << a[axis] << " "
                      << j[axis]);
      }
      if (periods[i] != periods[i - 1] + 1)
        FAIL("period of row " << i << ": " << periods[i] << " after " << periods[i - 1] << ", rows "
                              << periods.size());
    }
  }

  Machine machine;
  std::unique_ptr<hal::Backend> backend;
  std::vector<std::int64_t> periods;
  std::vector<AxisVector> places;
  std::size_t homed_from = 0;  // the first row in coordinates that homing has set
  std::vector<Code> errors;
  std::vector<std::string> messages;  // of the errors, as a user reads them
  runtime::Operator operated;
};

}  // namespace softcnc::test
