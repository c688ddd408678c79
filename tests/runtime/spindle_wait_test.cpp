// SPDX-License-Identifier: MIT
// A spindle that takes time: the next cutting move waits until it has its speed.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "hal/backends/backend.hpp"
#include "motion/model/machine.hpp"
#include "runtime/session/session.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

struct SpindleRun {
  double time = 0;        // s
  double first_cut = -1;  // s: when the first one begins to move
};

/// `cut` is the number of the line that cuts.
SpindleRun spindle_run(const std::string& part, double acceleration, int cut,
                       Method method = Method::arc_length) {
  Machine machine;
  machine.control.backend = BackendKind::none;
  machine.control.interpolation = method;
  machine.spindle.acceleration = acceleration;
  const auto backend = hal::open_backend(machine);
  Session session(machine, {}, **backend);
  REQUIRE(session.feed(part));
  session.end();
  SpindleRun all;
  while (const auto row = session.step()) {
    const double t = static_cast<double>(row->setpoint.period) * machine.control.period;
    const bool cuts = row->setpoint.line == cut && std::abs(row->setpoint.position.y()) > 1e-6;
    if (cuts && all.first_cut < 0) all.first_cut = t;
    all.time = t;
  }
  CHECK(session.errors() == 0);
  return all;
}

}  // namespace

TEST_CASE("a cutting move waits for the spindle, a rapid does not", "[runtime][spindle]") {
  const Method method = GENERATE(Method::arc_length, Method::acc_dec_linear);
  const std::string part =
      "S6000 M03\n"
      "G00 X50\n"
      "G01 Y10 F600\n"
      "M30\n";
  const SpindleRun at_once = spindle_run(part, 0, 3, method),
                   slow = spindle_run(part, 2000, 3, method);
  CHECK(at_once.first_cut < 1.5);
  CHECK(slow.first_cut == Approx(3.0).margin(0.005));  // 6000 rpm at 2000 rpm/s
  if (method == Method::arc_length)                    // the other one passes the corner at speed
    CHECK(slow.time - slow.first_cut == Approx(at_once.time - at_once.first_cut).margin(0.005));
  const SpindleRun quick =
      spindle_run(part, 6e5, 3, method);  // it has its speed before the rapid ends
  if (method == Method::arc_length) CHECK(quick.time == Approx(at_once.time).margin(0.005));
}

TEST_CASE("a change of speed takes its share, and the other direction both", "[runtime][spindle]") {
  const auto wait = [](const std::string& change) {
    const std::string part = "S6000 M03\nG01 X1 F600\n" + change + "\nG01 X2\nM30\n";
    return spindle_run(part, 2000, 4).time - spindle_run(part, 0, 4).time;
  };
  CHECK(wait("S5000") == Approx(3.0 + 0.5).margin(0.005));
  CHECK(wait("S6000") == Approx(3.0).margin(0.005));
  CHECK(wait("M04") == Approx(3.0 + 6.0).margin(0.005));
  CHECK(wait("M05") == Approx(3.0).margin(0.005));
  CHECK(wait("M05\nM03") == Approx(3.0 + 3.0).margin(0.005));  // it may have stopped meanwhile
  CHECK(wait("G04 P2\nS5000\nG04 P2") == Approx(3.0).margin(0.005));  // at speed by then
}

TEST_CASE("a hold on the way counts for the spindle too", "[runtime][spindle]") {
  Machine machine;
  machine.control.backend = BackendKind::none;
  machine.spindle.acceleration = 2000;
  const auto backend = hal::open_backend(machine);
  Session session(machine, {}, **backend);
  REQUIRE(session.feed("S6000 M03\nG00 X50\nG01 X51 F600\nS3000\nG01 X52\nM30\n"));
  session.end();
  double begins = -1;
  while (const auto row = session.step()) {
    if (row->setpoint.period == 300) session.hold();
    if (row->setpoint.period == 2000) session.resume();
    if (begins < 0 && row->setpoint.position.x() > 50.001)
      begins = static_cast<double>(row->setpoint.period) * machine.control.period;
  }
  CHECK(begins == Approx(3.0).margin(0.02));  // held for 1.7 s of the 3 s
}
