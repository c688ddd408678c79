// SPDX-License-Identifier: MIT
// A shared library of someone else that uses softcnc.
#include <limits>
#include <memory>
#include <softcnc/softcnc.hpp>
#include <utility>

extern "C" double duration(const char* file) {
  const auto program = softcnc::Program::open(file);
  if (!program) return -1;
  const auto trajectory = softcnc::plan(*program, softcnc::Machine());
  return trajectory ? trajectory->duration() : -1;
}

namespace {

using softcnc::Machine;
using softcnc::Session;
using softcnc::SessionStatus;

/// Its counter has broken.
class NoPosition final : public softcnc::Backend {
 public:
  softcnc::Feedback exchange(const softcnc::Setpoint&) noexcept override {
    softcnc::Feedback feedback;
    feedback.position[1] = std::numeric_limits<double>::quiet_NaN();
    return feedback;
  }
};

bool ends_in_alarm(std::shared_ptr<softcnc::Backend> backend) {
  Session session = Session::on(std::move(backend), Machine());
  session.feed("G0 X1\nM2\n");
  session.end();
  session.step();
  return session.status() == SessionStatus::alarm && !session.step();
}

bool stays_empty(Session& moved) {
  moved.hold();
  moved.resume();
  moved.set_feed_override(1);
  moved.abort();
  moved.end();
  return !moved.feed("G0 X1\n") && !moved.step() && moved.status() == SessionStatus::done &&
         moved.diagnostics().empty() && moved.columns().empty();
}

/// Whether a plan and its setpoints begin with the offset that a session has left.
bool plans_with_state() {
  Session before = std::move(*Session::open(Machine()));
  before.feed("G10 L2 P1 X10\n");
  before.end();
  while (before.step()) {
  }
  const auto program = softcnc::Program::from_text("G0 X1\nM2\n");
  softcnc::RunOptions options;
  options.state = before.state();
  const auto trajectory = softcnc::plan(*program, Machine(), options);
  if (!trajectory || trajectory->at(trajectory->duration()).position[0] != 11) return false;
  double last = 0;
  trajectory->for_each_setpoint([&](const softcnc::Setpoint& setpoint) {
    last = setpoint.position[0];
    return true;
  });
  return last == 11;
}

}  // namespace

/// The number of the first mistake in the use of the library that it does not stand; 0: none.
extern "C" int mistakes() {
  if (!ends_in_alarm(nullptr)) return 1;
  if (!ends_in_alarm(std::make_shared<NoPosition>())) return 2;
  Machine machine = *Machine().with({"control.period_ms=2"});
  const Machine kept = std::move(machine);
  if (kept.period() != 0.002 || machine.period() != Machine().period()) return 3;  // NOLINT
  Session session = std::move(*Session::open(Machine()));
  Session other = std::move(session);
  if (!stays_empty(session)) return 4;  // NOLINT
  if (!other.feed("G0 X1\n")) return 5;
  other.abort();
  if (other.feed("G0 X2\n")) return 6;
  return plans_with_state() ? 0 : 7;
}
