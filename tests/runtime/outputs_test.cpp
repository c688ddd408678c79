// SPDX-License-Identifier: MIT
// Outputs that a program sets: when, and with which backend.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/machine/machine_file.hpp"
#include "motion/geometry/path.hpp"
#include "runtime/session/output_events.hpp"
#include "runtime/session/session.hpp"
#include "runtime/session/simulate.hpp"
#include "support/folder.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using Catch::Matchers::WithinAbs;

namespace {

struct Ran {
  Outcome outcome;
  std::vector<Diagnostic> diagnostics;
};

Ran run_outputs(const std::string& text, const Machine& machine) {
  Diagnostics diagnostics;
  ipr::Reader reader = ipr::Reader::from_text(text);
  const auto backend = hal::open_backend(machine);
  REQUIRE(backend);
  Ran ran;
  ran.outcome = simulate(reader, -1, machine, {}, **backend, diagnostics, nullptr, nullptr);
  ran.diagnostics.assign(diagnostics.all().begin(), diagnostics.all().end());
  return ran;
}

Machine machine_with_outputs() {
  Machine machine;
  machine.control.backend = BackendKind::none;
  machine.outputs["pump"] = {2, SignalKind::digital};
  machine.outputs["lamp"] = {0, SignalKind::analog};
  InputPort& door = machine.inputs["door"];
  door.lines = {3};
  door.values = {1};
  door.after = {0.3};
  return machine;
}

}  // namespace

TEST_CASE("outputs are set when the motion before them has ended", "[runtime][outputs]") {
  // A rapid of 10 mm at 1000 mm/s^2 from rest to rest takes 2 sqrt(10/1000) s.
  const double rapid = 2 * std::sqrt(10.0 / 1000);
  const Ran ran =
      run_outputs("G0 X10\nM64 P2\nM66 P0 L3 Q5\nM68 E0 Q-1.5\nM62 P2 X[20+#5399]\nM63 P2\nM2\n",
                  machine_with_outputs());
  CHECK(ran.diagnostics.empty());
  const auto& outputs = ran.outcome.time_sheet.outputs;
  REQUIRE(outputs.size() == 3);
  CHECK_THAT(outputs[0].t, WithinAbs(rapid, 1e-6));
  CHECK(outputs[0].source.line == 2);
  CHECK(outputs[0].port.number == 2);
  CHECK(outputs[0].value == 1);
  CHECK_THAT(outputs[1].t, WithinAbs(rapid + 0.3, 1e-6));
  CHECK(outputs[1].source.line == 4);
  CHECK(outputs[1].port.kind == SignalKind::analog);
  CHECK(outputs[1].value == -1.5);
  CHECK(outputs[2].t == outputs[1].t);
  CHECK(outputs[2].source.line == 5);
  CHECK(ran.outcome.time_sheet.outputs_left_out == 0);
  CHECK_THAT(ran.outcome.last.s, WithinAbs(21, 1e-9));
}

TEST_CASE("an output within a path stops it there", "[runtime][outputs]") {
  const Machine machine = machine_with_outputs();
  const Ran without = run_outputs("F600 G1 X10\nX20\nM2\n", machine);
  const Ran with = run_outputs("F600 G1 X10\nM62 P2 X20\nM2\n", machine);
  // A stop from 10 mm/s at 1000 mm/s^2 and the start after it take 10 ms each for 5 ms of path.
  CHECK_THAT(with.outcome.time - without.outcome.time, WithinAbs(0.01, 1e-6));
  CHECK(with.outcome.time_sheet.rests_by(RestCause::output) == 1);
  REQUIRE(with.outcome.time_sheet.outputs.size() == 1);
  CHECK_THAT(with.outcome.time_sheet.outputs[0].t, WithinAbs(1.01, 1e-6));
}

TEST_CASE("of very many outputs the first are kept, and the others counted", "[runtime][outputs]") {
  const Ran ran =
      run_outputs("o1 repeat [5003]\nM64 P2\nM65 P2\no1 endrepeat\nM2\n", machine_with_outputs());
  CHECK(ran.outcome.time_sheet.outputs.size() == kMostOutputEvents);
  CHECK(ran.outcome.time_sheet.outputs_left_out == 6);
}

TEST_CASE("each row has what is on from there on", "[runtime][outputs]") {
  Machine machine = machine_with_outputs();
  machine.control.backend = BackendKind::none;
  machine.control.interpolation =
      GENERATE(Method::arc_length, Method::chords, Method::taylor1, Method::acc_dec_linear);
  const int number = machine.outputs.begin()->second.number;
  const std::string p = "P" + std::to_string(number);
  const auto backend = hal::open_backend(machine);
  Session session(machine, {}, **backend);
  REQUIRE(session.feed("S1000 M03\nG01 X5 F3000\nM07\nM62 " + p + "\nX10\nM04\nM08\nX15\nM65 " + p +
                       "\nM09\nX20\nM05\nX25\nM30\n"));
  session.end();
  const std::uint64_t on = std::uint64_t{1} << number;
  const auto expected_at = [&](double x) -> Outputs {
    if (x < 5) return {1000, false, false, 0};
    if (x < 10) return {1000, true, false, on};
    if (x < 15) return {-1000, true, true, on};
    if (x < 20) return {-1000, false, false, 0};
    return {0, false, false, 0};
  };
  int rows = 0;
  while (const auto row = session.step()) {
    const double x = row->setpoint.position.x();
    if (std::abs(std::remainder(x, 5)) < 0.2) continue;  // near the places where they change
    CAPTURE(x);
    REQUIRE(row->setpoint.outputs == expected_at(x));
    REQUIRE(row->setpoint.outputs == session.programmed_outputs());
    ++rows;
  }
  CHECK(rows > 80);
}

namespace {

/// What a backend gets, rests among it.
class Listening final : public hal::Backend {
 public:
  Feedback exchange(const Setpoint& setpoint) noexcept override {
    keep(setpoint);
    return {setpoint.position, Alarm::none, -1};
  }
  void rest(const Setpoint& at) noexcept override {
    keep(at);
    rests.push_back(got.size() - 1);
  }
  AxisVector settle() const noexcept override { return got.back().position; }

  std::vector<Setpoint> got;
  std::vector<std::size_t> rests;  // their places among all

 private:
  void keep(const Setpoint& setpoint) {
    got.push_back(setpoint);
    got.back().pulses = {};
    got.back().fine = {};
  }
};

}  // namespace

TEST_CASE("where the program waits the machine rests, with what is on there",
          "[runtime][outputs]") {
  Machine machine = machine_with_outputs();
  machine.control.interpolation = GENERATE(Method::arc_length, Method::dda, Method::taylor1);
  const bool is_exact = machine.control.interpolation == Method::arc_length;
  for (int i = 0; i < 20; ++i) {  // the instant of rest lies anywhere within a period
    const double x = 3 + 0.000'37 * i;
    CAPTURE(x, machine.control.interpolation);
    Listening backend;
    Session session(machine, {}, backend);
    REQUIRE(session.feed("S1000 M03\nM08\nG01 X" + std::to_string(x) +
                         " F600\nM05\nM09\nM00\nM04\nX6\nM03 S500\nT2 M06\nX9\nM30\n"));
    session.end();
    while (session.step()) continue;
    REQUIRE(session.status() == SessionStatus::paused);
    REQUIRE(backend.rests.size() == 1);
    const Setpoint& rest = backend.got.back();
    CHECK(rest.outputs == Outputs());
    CHECK(session.outputs() == Outputs());
    CHECK(rest.v == 0);
    if (is_exact) CHECK(std::abs(rest.position.x() - x) < 1e-9);
    CHECK(session.last().v == 0);
    session.resume();
    while (session.step()) continue;
    REQUIRE(session.status() == SessionStatus::paused);
    REQUIRE(backend.rests.size() == 2);
    CHECK(backend.got[backend.rests[0] + 1].outputs == Outputs{-1000, false, false, 0});
    if (is_exact) CHECK(std::abs(backend.got.back().position.x() - 6) < 1e-9);
    session.resume();
    while (session.step()) continue;
    CHECK(session.status() == SessionStatus::done);
    CHECK(std::abs(backend.got.back().position.x() - 9) < 0.003);
    // no step is longer than the feed, and none of the acceleration too large, rests counted in
    if (!is_exact) continue;
    for (std::size_t k = 1; k < backend.got.size(); ++k)
      REQUIRE((backend.got[k].position - backend.got[k - 1].position).norm() <= 0.01 * 1.001);
  }
}

TEST_CASE("rows for HAL keep the limits where the program waits", "[runtime][outputs]") {
  const test::Folder folder;
  Machine machine = machine_with_outputs();
  machine.control.backend = BackendKind::hal_stream;
  machine.control.period = GENERATE(0.001, 0.004, 0.01);
  machine.hal_stream.file = folder / "rows";
  const double axis_jerk = GENERATE(0.0, 20'000.0);
  for (Axis& axis : machine.axes) axis.jerk = axis_jerk;
  {
    const auto backend = hal::open_backend(machine);
    Session session(machine, {}, **backend);
    std::string text = "G01 F6000\n";
    for (int i = 1; i <= 12; ++i) text += "X" + std::to_string(4.00137 * i) + "\nM00\n";
    REQUIRE(session.feed(text + "M30\n"));
    session.end();
    int pauses = 0;
    while (session.status() != SessionStatus::done) {
      while (session.step()) continue;
      if (session.status() == SessionStatus::paused) ++pauses;
      session.resume();
    }
    CHECK(pauses == 12);
    REQUIRE((*backend)->finish());
  }
  std::vector<double> x;
  std::ifstream rows(folder / "rows");
  for (std::string line; std::getline(rows, line);)
    if (!line.starts_with('#')) x.push_back(std::stod(line));
  REQUIRE(x.size() > 700);
  constexpr double kServo = 0.001;
  for (std::size_t i = 3; i < x.size(); ++i) {
    CAPTURE(i, x[i]);
    REQUIRE(std::abs(x[i] - 2 * x[i - 1] + x[i - 2]) / (kServo * kServo) <= 1000 * 1.001);
    if (axis_jerk > 0)
      REQUIRE(std::abs(x[i] - 3 * x[i - 1] + 3 * x[i - 2] - x[i - 3]) / std::pow(kServo, 3) <=
              axis_jerk * 1.005 + 1);
  }
}

TEST_CASE("a backend that passes no outputs on reports that once", "[runtime][outputs]") {
  TimeSheet sheet;
  sheet.outputs.resize(2);
  const auto reported = [&](BackendKind backend, bool streams_outputs = false) {
    Diagnostics diagnostics;
    Machine machine;
    machine.control.backend = backend;
    machine.hal_stream.outputs = streams_outputs;
    settle_outputs(sheet, machine, diagnostics);
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics.all()) text += render(diagnostic);
    return text;
  };
  CHECK(reported(BackendKind::none).empty());
  CHECK(reported(BackendKind::sim).empty());
  CHECK(reported(BackendKind::stepdir) ==
        "softcnc: note: the program sets outputs 2 times, which backend stepdir does not pass on "
        "[SC5050]\n");
  CHECK(reported(BackendKind::hal_stream).find("backend hal-stream") != std::string::npos);
  sheet.outputs.resize(1);
  CHECK(reported(BackendKind::parport).find("outputs 1 time,") != std::string::npos);
  CHECK(reported(BackendKind::hal_stream, true).empty());
  CHECK_FALSE(reported(BackendKind::parport, true).empty());
  sheet.outputs[0].port.pin = -16;
  CHECK(reported(BackendKind::parport).empty());
  CHECK_FALSE(reported(BackendKind::stepdir).empty());
  sheet.outputs.clear();
  CHECK(reported(BackendKind::parport).empty());
}

TEST_CASE("the example of M codes runs on its machine", "[runtime][outputs]") {
  const std::string name = SOFTCNC_SOURCE_DIR "/programs/24_machine_codes";
  const std::vector<std::string> settings{"control.backend=none"};
  const auto machine = hal::load_machine(name + ".toml", settings);
  REQUIRE(machine);
  std::stringstream text;
  text << std::ifstream(name + ".nc").rdbuf();
  const Ran ran = run_outputs(text.str(), *machine);
  for (const Diagnostic& diagnostic : ran.diagnostics) CHECK(render(diagnostic).empty());
  REQUIRE(ran.outcome.time_sheet.outputs.size() == 7);
  CHECK(ran.outcome.time_sheet.outputs[0].source.line == 7);
  CHECK(ran.outcome.last.position[0] == 60);
}
