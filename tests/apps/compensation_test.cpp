// SPDX-License-Identifier: MIT
// Compensated commands from outside: pulses within the timing of the drivers, traces that are what
// is sent, limits of commands while a run is held and slowed down.
#include <catch2/catch.hpp>
#include <cmath>

#include "apps/shell.hpp"
#include "support/period.hpp"

using namespace softcnc::app::test;

namespace {

using softcnc::test::kPeriod;

const std::string kScrews =
    " --set axis.x.backlash_um=80 --set axis.y.backlash_um=35"
    " --set 'axis.y.pitch_table=[[-20,5],[0,0],[30,12]]' ";

std::string run_output(const std::string& arguments) {
  const Ended ended = call("run -q " + arguments);
  CAPTURE(ended.err);
  CHECK(ended.status == 0);
  return ended.out;
}

}  // namespace

TEST_CASE("pulses of a compensated machine keep the timing of its drivers",
          "[apps][compensation]") {
  const Folder folder;
  const std::string edges = folder / "steps.vcd", trace = folder / "trace.vcd",
                    mill = " --machine $programs/machines/bench_mill.toml ";
  run_output("$programs/03_arc.nc --backend stepdir" + mill + kScrews +
             "--set backend.stepdir.file=" + edges + " --trace " + trace);
  CHECK(read(edges) == read(trace));
  const Ended judged = call("pulses " + edges + mill);
  CHECK(judged.status == 0);
  CHECK(shows(judged.out + judged.err, "no rule is broken"));
}

TEST_CASE("rows for HAL are compensated in the stream and in the trace", "[apps][compensation]") {
  const Folder folder;
  const std::string rows = folder / "rows.txt", trace = folder / "trace.hal";
  run_output("$programs/03_arc.nc --backend hal-stream" + kScrews +
             "--set backend.hal-stream.file=" + rows + " --trace " + trace);
  CHECK(read(rows) == read(trace));
  // The backlash is out again at the end; (0, 0) is off by no pitch.
  CHECK(shows(read(rows), "\n0 0 0 0 "));
}

TEST_CASE("compensated commands keep the velocity while a run is held", "[apps][compensation]") {
  const std::string at = GENERATE("0.5:hold --at 0.9:resume",
                                  "1:hold --at 1.02:resume --at 1.5:override=0 --at "
                                  "1.8:override=100");
  const std::string part = GENERATE("08_butterfly", "19_rounded_corners");
  const Trace trace =
      parse_trace(run_output("$programs/" + part + ".nc" + kScrews + "--trace - --at " + at));
  constexpr double kVelocity = 250, kAcceleration = 1000;
  double last = trace.number(0, "x_cmd_mm"), speed = 0, least = 0;
  for (std::size_t row = 1; row < trace.rows.size(); ++row) {
    const double here = trace.number(row, "x_cmd_mm"), now = (here - last) / kPeriod;
    REQUIRE(std::abs(now) <= kVelocity * 1.001);
    REQUIRE(std::abs(now - speed) / kPeriod <= 1.2 * kAcceleration * 1.002);
    least = std::min(least, here - trace.number(row, "x_mm"));
    last = here;
    speed = now;
  }
  CHECK(least == Approx(-0.08).margin(1e-9));
}
