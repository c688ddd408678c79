// SPDX-License-Identifier: MIT
// What check finds does not depend on the rows that it passes over.
#include <catch2/catch.hpp>
#include <cmath>

#include "apps/shell.hpp"
#include "hal/backends/backend.hpp"
#include "job/preflight.hpp"
#include "runtime/session/simulate.hpp"
#include "runtime/session/verification.hpp"

using namespace softcnc;
using namespace softcnc::app;
using app::test::Folder;
using app::test::write;

namespace {

runtime::Outcome outcome_of(const std::string& text, const Machine& machine, bool skims) {
  const Folder folder;
  write(folder / "part.nc", text);
  auto program = runtime::Program::open(folder / "part.nc");
  REQUIRE(program);
  Diagnostics diagnostics;
  const auto backend = hal::open_backend(runtime::without_backend(machine));
  REQUIRE(backend);
  runtime::ChannelOptions options;
  options.skims = skims;
  ipr::Reader reader = program->reader();
  runtime::Outcome outcome = runtime::simulate(reader, program->descriptor(), machine, options,
                                               **backend, diagnostics, nullptr, nullptr);
  CHECK(diagnostics.errors() == 0);
  runtime::report_excess(outcome.measured, outcome.deviation, machine, diagnostics);
  CHECK(diagnostics.all().empty());
  return outcome;
}

/// A wave in short lines, each of which turns a little.
std::string wave(const std::string& head) {
  std::string text = head + "\n";
  for (int i = 1; i <= 40; ++i)
    text += "G1 X" + std::to_string(0.4 * i) + " Y" + std::to_string(2 * std::sin(0.3 * i)) + "\n";
  return text + "G0 X0 Y0\nM2\n";
}

}  // namespace

TEST_CASE("rows that are passed over change nothing that is measured at limits", "[apps][skim]") {
  const std::string programs[]{
      "F60\nG2 X0 Y0 I5 J0\nG3 X0 Y0 I-3 J2 Z-1\nM2\n",
      "F30\nG1 X3\nG4 P1.5\nG0 X50\nG1 Y2 F120\nX0\nM2\n",
      wave("F60 G64 P0.02"),
      wave("F30 G61"),
      "F60\nG5.2 X0 Y0 P1 L3\nX10 Y5 P1\nX20 Y-5 P1\nX30 Y0 P1\nG5.3\nM2\n",
  };
  for (const std::string& text : programs)
    for (const double jerk : {0.0, 50'000.0}) {
      CAPTURE(text, jerk);
      Machine machine;
      for (Axis& axis : machine.axes) axis.jerk = jerk;
      const runtime::Outcome all = outcome_of(text, machine, false),
                             some = outcome_of(text, machine, true);
      CHECK(some.setpoints == all.setpoints);
      CHECK(some.measured.samples == all.measured.samples);
      CHECK(some.time == all.time);
      CHECK(some.time_by_limit == all.time_by_limit);
      CHECK(some.last.position == all.last.position);
      CHECK(some.last.s == all.last.s);
      CHECK(some.corner_deviation == Approx(all.corner_deviation).margin(2e-4));
      for (int i = 0; i < kAxes; ++i) {
        const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
        const auto same = [](double few, double every, double limit) {
          return few <= every * (1 + 1e-12) && (every < 0.5 * limit || few == Approx(every));
        };
        CHECK(same(some.measured.velocity[i], all.measured.velocity[i], axis.velocity));
        CHECK(same(some.measured.acceleration[i], all.measured.acceleration[i], axis.acceleration));
        if (jerk > 0) CHECK(same(some.measured.jerk[i], all.measured.jerk[i], axis.jerk));
      }
    }
}

TEST_CASE("check of 190 years at the smallest feed has an answer", "[apps][skim]") {
  const app::test::Ended ended = app::test::call("check --set program.motion_limit_h=0 -",
                                                 "G21 G90\nG01 X100 F0.000001\nM30\n");
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
}

TEST_CASE("check of a dwell of a year has an answer", "[apps][skim]") {
  CHECK(app::test::call("check -", "G04 P30000000\nM30\n").status == 0);
}
