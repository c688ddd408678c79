// SPDX-License-Identifier: MIT
// Parts of the program that are easier asked directly.
#include <catch2/catch.hpp>

#include "job/terminal.hpp"
#include "messages/duration_text.hpp"
#include "messages/messages.hpp"
#include "recording/row_comparison.hpp"
#include "runtime/session/verification.hpp"

using namespace softcnc;
using namespace softcnc::app;

TEST_CASE("durations read as a person says them", "[apps][parts]") {
  CHECK(duration_text(0) == "0.00 s");
  CHECK(duration_text(4.364) == "4.36 s");
  CHECK(duration_text(59.994) == "59.99 s");
  CHECK(duration_text(59.996) == "1 m 00.0 s");
  CHECK(duration_text(65.34) == "1 m 05.3 s");
  CHECK(duration_text(119.96) == "2 m 00.0 s");
  CHECK(duration_text(3599.94) == "59 m 59.9 s");
  CHECK(duration_text(3599.96) == "1 h 00 m 00 s");
  CHECK(duration_text(7390) == "2 h 03 m 10 s");
}

TEST_CASE("corners that are rounded by more than G64 allows are an error", "[apps][parts]") {
  const Machine machine;  // chords may add 1 um
  Diagnostics diagnostics;
  diagnostics.set_file("part.nc");
  runtime::report_excess({}, {0.0509, 0.05}, machine, diagnostics);
  CHECK(diagnostics.all().empty());
  runtime::report_excess({}, {0.0512, 0.05}, machine, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(render(diagnostics.all()[0]) ==
        "part.nc: error: the motion leaves the programmed path by 51.2 um, where G64 allows "
        "50 um [SC4002]\n");
}

TEST_CASE("rows above a limit are an error that names axis, value and limit", "[apps][parts]") {
  const Machine machine;
  Measured measured;
  measured.acceleration = {1000.9, 1001.1, 0};
  measured.velocity = {250.2, 250.3, 0};
  measured.chord_error = 0.0011;
  Diagnostics diagnostics;
  diagnostics.set_file("part.nc");
  runtime::report_excess(measured, {}, machine, diagnostics);
  REQUIRE(diagnostics.all().size() == 3);
  CHECK(diagnostics.status() == 3);
  CHECK(render(diagnostics.all()[0]) ==
        "part.nc: error: the velocity of Y reaches 250.3 mm/s, 0.12 % above its limit of "
        "250 mm/s [SC4002]\n");
  CHECK(render(diagnostics.all()[1]) ==
        "part.nc: error: the acceleration of Y reaches 1001.1 mm/s2, 0.11 % above its limit "
        "of 1000 mm/s2 [SC4002]\n");
  CHECK(render(diagnostics.all()[2]) ==
        "part.nc: error: the chord error reaches 1.1 um, 10 % above its limit of 1 um [SC4002]\n");
}

TEST_CASE("the same excess by a method of the literature is a note", "[apps][parts]") {
  Machine machine;
  machine.control.interpolation = Method::curvature3p;
  Measured measured;
  measured.chord_error = 0.0011;
  Diagnostics diagnostics;
  runtime::report_excess(measured, {}, machine, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.status() == 0);
  CHECK(render(diagnostics.all()[0]) ==
        "softcnc: note: curvature3p: the chord error reaches 1.1 um, 10 % above its limit "
        "of 1 um [SC4003]\n");
}

TEST_CASE("a large excess is reported in plain digits", "[apps][parts]") {
  Machine machine;
  machine.control.interpolation = Method::taylor1;
  Measured measured;
  measured.chord_error = 0.0156;
  Diagnostics diagnostics;
  runtime::report_excess(measured, {}, machine, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].message ==
        "taylor1: the chord error reaches 15.6 um, 1460 % above its limit of 1 um");
}

TEST_CASE("a defect of softcnc ends with 70", "[apps][parts]") {
  std::string shown;
  Messages messages([&](std::string_view text) { shown += text; }, false);
  CHECK(messages.fail({Code::SC9001, {}, "an axis is nowhere", {}, {}}) == 70);
  CHECK(shown == "softcnc: error: an axis is nowhere [SC9001]\n");
}

TEST_CASE("in colour a diagnostic says the same", "[apps][parts]") {
  std::string shown;
  Messages messages([&](std::string_view text) { shown += text; }, true);
  messages.show({Code::SC4001, {3, 1, 1}, "X is away", "a.nc", "X1"});
  CHECK(shown == "a.nc:3:1: \033[1;31merror:\033[0m X is away [SC4001]\n    3 | X1\n      | ^\n");
}

TEST_CASE("values of a trace are the same within what builds may differ by", "[apps][parts]") {
  CHECK(same_value("x_mm", "1", "1.0000009"));
  CHECK_FALSE(same_value("x_mm", "1", "1.0000011"));
  CHECK(same_value("x_err_um", "1", "1.0009"));
  CHECK_FALSE(same_value("x_err_um", "1", "1.0011"));
  CHECK(same_value("a_mm_s2", "1000", "1000.0009"));
  CHECK_FALSE(same_value("a_mm_s2", "1000", "1000.0011"));
  CHECK_FALSE(same_value("line", "12", "13"));
  CHECK_FALSE(same_value("limit", "feed", "chord"));
  CHECK_FALSE(same_value("x_mm", "1", ""));
}

TEST_CASE("only what a person has to do is asked for", "[apps][parts]") {
  using Kind = Action::Kind;
  const auto behind = [](Block block) { return instruction({std::move(block), 0, false}); };
  CHECK(behind({Action{Kind::tool, 6, 3}, {12, 1, 1}, 4}) == "line 12: M06 T3");
  CHECK(behind({Action{Kind::stop, 0, 0}, {7, 1, 1}, 4}) == "line 7: M00");
  CHECK(behind({Action{Kind::coolant, 8, 0}, {7, 1, 1}, 4}).empty());
  CHECK(behind({Dwell{1}, {7, 1, 1}, 4}).empty());
  CHECK(instruction({{Dwell{1}, {7, 1, 1}, 4}, 0, true}) == "line 7");
}
