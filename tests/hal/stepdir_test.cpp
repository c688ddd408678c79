// SPDX-License-Identifier: MIT
// The backend of step and direction drives: its file, read back and judged by the validator.
#include "hal/backends/stepdir.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "hal/signals/edge_reader.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "motion/model/step_rate.hpp"
#include "support/folder.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::setpoint_at;

Machine stepper(const std::string& file) {
  Machine machine;
  machine.control.backend = BackendKind::stepdir;
  machine.step_port.file = file;
  return machine;
}

/// Moves by the given speeds, mm per period, each for as many periods.
void drive(Backend& backend, AxisVector& place, const AxisVector& speed, int periods) {
  for (int i = 0; i < periods; ++i) {
    place += speed;
    CHECK(backend.exchange(setpoint_at(place.x(), place.y(), place.z())).alarm == Alarm::none);
  }
}

}  // namespace

TEST_CASE("the file of edges keeps the driver's rules and the commanded counts", "[hal][pulse]") {
  const test::Folder folder;
  const auto* suffix = GENERATE(".vcd", ".edges");
  const std::string file = folder / "steps" + suffix;
  const Machine machine = stepper(file);
  auto backend = StepDir::open(machine);
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at(1, 2, 3));
  AxisVector place(1, 2, 3);
  drive(**backend, place, {0.25, -0.1, 0}, 40);
  drive(**backend, place, {-0.25, 0.03337, 0.0001}, 60);
  drive(**backend, place, {0, 0, 0}, 5);
  drive(**backend, place, {0.2, -0.25, 0.001}, 7);
  CHECK_FALSE(std::filesystem::exists(file));
  REQUIRE((*backend)->finish());

  const auto edges = read_edges(test::read(file));
  REQUIRE(edges);
  PulseRules rules(step_timing(machine.step_port));
  rules.read(*edges);
  CHECK(rules.broken().value_or("none") == "none");
  std::array<double, 3> counts{};
  (*backend)->values(counts);
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const Counts counts_of(machine.axes[i].blu);
    CHECK(rules.counts()[i] == counts_of(place[axis]) - counts_of(axis + 1.0));
    CHECK(counts[i] == static_cast<double>(counts_of(place[axis])));
  }
  CHECK(rules.steps() > 8000);
  CHECK(((*backend)->settle() - place).cwiseAbs().maxCoeff() <= 0.00125 + 1e-12);
}

TEST_CASE("at the fastest speed that is accepted no pulse is late", "[hal][pulse]") {
  const test::Folder folder;
  std::vector<std::int64_t> rates{300'000, 7'000'000, 333'333};
  for (std::uint32_t i = 0; i < 20; ++i) rates.push_back(2000 + (i * 2654435761U) % 3'000'000);
  for (const std::int64_t hertz : rates) {
    CAPTURE(hertz);
    Machine machine = stepper(folder / "fast.edges");
    const auto rate = static_cast<double>(hertz);
    machine.step_port = {machine.step_port.file, rate, 60e-9, 60e-9, 0, 0};
    machine.axes[0].blu = 0.001;
    const auto interval = static_cast<double>(step_interval(machine.step_port));  // ns
    auto backend = StepDir::open(machine);
    REQUIRE(backend);
    (*backend)->exchange(setpoint_at(0, 0, 0));
    for (int period = 1; period <= 50; ++period)
      (*backend)->exchange(setpoint_at(period * 1e6 / interval * 0.001, 0, 0));
    REQUIRE((*backend)->finish());
    const auto edges = read_edges(test::read(machine.step_port.file));
    REQUIRE(edges);
    std::vector<std::int64_t> rises;
    for (const SignalEdge& edge : *edges)
      if (edge.high) rises.push_back(edge.time);
    REQUIRE(static_cast<double>(rises.size()) >= 50e6 / interval - 1);
    for (std::size_t i = 0; i < rises.size(); ++i) {
      if (i > 0) REQUIRE((rises[i] - rises[i - 1]) * hertz >= 1'000'000'000);
      const double due = (static_cast<double>(i) + 0.5) * interval;
      REQUIRE(std::abs(static_cast<double>(rises[i]) - due) <= 2);
    }
  }
}

TEST_CASE("both forms of the file hold the same edges", "[hal][pulse]") {
  const test::Folder folder;
  std::vector<std::vector<SignalEdge>> forms;
  for (const char* name : {"steps.vcd", "steps.edges"}) {
    auto backend = StepDir::open(stepper(folder / name));
    REQUIRE(backend);
    (*backend)->exchange(setpoint_at(0, 0, 0));
    for (int i = 1; i <= 50; ++i)
      (*backend)->exchange(setpoint_at(0.1 * i, -0.05 * i, 0.2 * (i % 2)));
    REQUIRE((*backend)->finish());
    forms.push_back(read_edges(test::read(folder / name)).value());
  }
  CHECK(forms[0].size() > 1000);
  CHECK(forms[0] == forms[1]);
}

TEST_CASE("a waveform viewer finds every line by name", "[hal][pulse]") {
  const test::Folder folder;
  auto backend = StepDir::open(stepper(folder / "steps.vcd"));
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at(0, 0, 0));
  (*backend)->exchange(setpoint_at(0.0025, 0, -0.0025));
  REQUIRE((*backend)->finish());
  CHECK(test::read(folder / "steps.vcd") ==
        "$timescale 1 ns $end\n"
        "$scope module softcnc $end\n"
        "$var wire 1 ! x_step $end\n"
        "$var wire 1 \" x_direction $end\n"
        "$var wire 1 # y_step $end\n"
        "$var wire 1 $ y_direction $end\n"
        "$var wire 1 % z_step $end\n"
        "$var wire 1 & z_direction $end\n"
        "$upscope $end\n"
        "$enddefinitions $end\n"
        "#0\n"
        "$dumpvars\n0!\n0\"\n0#\n0$\n0%\n0&\n$end\n"
        "#495000\n1&\n"
        "#500000\n1!\n1%\n"
        "#502500\n0!\n0%\n");
}

TEST_CASE("files that are no lists of edges are distinguished from them", "[hal][pulse]") {
  CHECK_FALSE(read_edges(""));
  CHECK_FALSE(read_edges("$timescale 1 ps $end\n"));
  CHECK(read_edges("edges 1\n")->empty());
  CHECK(read_edges(std::string("edges 1\n\x05\x01", 10)).value() ==
        std::vector{SignalEdge{5, 0, Wire::step, true}});
  CHECK(read_edges(std::string("edges 1\n\x85\x01\x06", 11)).value() ==
        std::vector{SignalEdge{133, 1, Wire::direction, false}});
  CHECK_FALSE(read_edges(std::string("edges 1\n\x05", 9)));       // cut off
  CHECK_FALSE(read_edges(std::string("edges 1\n\x05\x0c", 10)));  // no such axis
}

TEST_CASE("an edge list that cannot be made is refused", "[hal][pulse][code]") {
  const auto unknown = StepDir::open(stepper("steps.txt"));
  REQUIRE_FALSE(unknown);
  CHECK(render(unknown.error()) ==
        "steps.txt: error: a list of edges ends in .vcd or .edges [SC6050]\n");
  const auto nowhere = StepDir::open(stepper("/no/such/folder/steps.vcd"));
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.error().code == Code::SC6011);
}

TEST_CASE("a full disk is an alarm of the port, and the file reports it", "[hal][pulse]") {
  const test::Folder folder;
  std::filesystem::create_symlink("/dev/full", folder / "full.edges");
  auto backend = StepDir::open(stepper(folder / "full.edges"));
  REQUIRE(backend);
  Alarm alarm = Alarm::none;
  for (int i = 0; i < 2000 && alarm == Alarm::none; ++i)
    alarm = (*backend)->exchange(setpoint_at(0.25 * i, 0.25 * i, 0)).alarm;
  CHECK(alarm == Alarm::port);
  const Status finished = (*backend)->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().code == Code::SC6012);
}

TEST_CASE("a backend without a file counts all the same", "[hal][pulse]") {
  auto backend = StepDir::open(stepper(""));
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at(0, 0, 0));
  const Feedback feedback = (*backend)->exchange(setpoint_at(0.0101, -0.0101, 0));
  CHECK((feedback.position - AxisVector(0.01, -0.01, 0)).norm() < 1e-15);
  CHECK((*backend)->finish());
}

}  // namespace softcnc::hal
