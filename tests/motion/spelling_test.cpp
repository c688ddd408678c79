// SPDX-License-Identifier: MIT
#include "motion/core/spelling.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace softcnc;

namespace {

const std::vector<std::string_view> kKeys{
    "control.period_ms",  "control.servo_period_ms",   "axis.x.velocity_mm_min",
    "axis.x.min_mm",      "axis.x.acceleration_mm_s2", "axis.x.drive.kv_1_s",
    "limits.feed_mm_min", "spindle.max_rpm",           "surface.model"};
const std::vector<std::string_view> kCommands{"run",    "check",   "record", "replay",
                                              "blocks", "machine", "surface"};

}  // namespace

TEST_CASE("whole words and common beginnings weigh before letters", "[spelling]") {
  CHECK(nearest_name("axis.x.accel", kKeys) == "axis.x.acceleration_mm_s2");
  CHECK(nearest_name("axis.x.acc", kKeys) == "axis.x.acceleration_mm_s2");
  CHECK(nearest_name("Axis.X.Acceleration", kKeys) == "axis.x.acceleration_mm_s2");
  CHECK(nearest_name("axis.x.vel_mm_min", kKeys) == "axis.x.velocity_mm_min");
  CHECK(nearest_name("axis.x.min", kKeys) == "axis.x.min_mm");
  CHECK(nearest_name("period_ms", kKeys) == "control.period_ms");
  CHECK(nearest_name("control.servoperiod_ms", kKeys) == "control.servo_period_ms");
  CHECK(nearest_name("feed_mm_min", kKeys) == "limits.feed_mm_min");
  CHECK(nearest_name("spindle.maximum_rpm", kKeys) == "spindle.max_rpm");
}

TEST_CASE("a word with a wrong letter, or two, is like another", "[spelling]") {
  CHECK(nearest_name("rum", kCommands) == "run");
  CHECK(nearest_name("chek", kCommands) == "check");
  CHECK(nearest_name("rcord", kCommands) == "record");
  CHECK(nearest_name("replya", kCommands) == "replay");
  CHECK(nearest_name("report", kCommands) == "record");
  CHECK(nearest_name("machines", kCommands) == "machine");
}

TEST_CASE("what is like none has no nearest", "[spelling]") {
  CHECK(nearest_name("render", kCommands).empty());
  CHECK(nearest_name("xyzzy", kKeys).empty());
  CHECK(nearest_name("", kKeys).empty());
  CHECK(nearest_name("run", {}).empty());
  CHECK(did_you_mean("").empty());
  CHECK(did_you_mean("run") == "; did you mean 'run'?");
}

TEST_CASE("names are equal where only case and partings differ", "[spelling]") {
  CHECK(words_apart("feed-override", "feed_override") == 0);
  CHECK(words_apart("--Watch", "--watch") == 0);
  // Another word is one too many and one left out.
  CHECK(words_apart("a.b", "a.c") == Approx(0.8));
}
