// SPDX-License-Identifier: MIT
// Methods beside one another: the median and the worst of runs that begin at several places within
// the period.
#include "runtime/comparison/method_comparison.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/comparison/compared_figure.hpp"
#include "runtime/session/first_cut_delay.hpp"
#include "runtime/session/simulate.hpp"
#include "support/files.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

Block moving(AxisVector from, AxisVector to, bool rapid, PathMode mode = PathMode::follow) {
  Move move{Line(from, to), rapid, rapid ? 0.0 : 10.0};
  move.path_mode = mode;
  return {move};
}
Block rapid(AxisVector from, AxisVector to, PathMode mode = PathMode::follow) {
  return moving(from, to, true, mode);
}
Block cut(AxisVector from, AxisVector to) { return moving(from, to, false); }
Block spindle() { return {Action{Action::Kind::spindle, 3, 1000}}; }

/// Where the dwell comes to stand among the blocks of a program, numbered from 1, and how many have
/// been read.
struct Delayed {
  std::size_t place = 0, blocks = 0;
};
Delayed delayed(std::vector<Block> blocks, DelayPlace where = DelayPlace::at_rest) {
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].number = static_cast<int>(i) + 1;
  std::size_t next = 0;
  const auto all = with_first_cut_delayed(
      [&] { return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt; }, 0.25,
      where);
  Delayed result{all.size(), all.size() - 1};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto* dwell = std::get_if<Dwell>(&all[i].what);
    if (dwell == nullptr || dwell->duration != 0.25) continue;
    REQUIRE(result.place == all.size());  // there is one
    result.place = i;
    CHECK(all[i].number == static_cast<int>(i));  // that of the block before it
  }
  return result;
}

/// The rows of a program on a machine without a backend.
struct Rows final : RowSink {
  std::vector<Setpoint> rows;
  bool row(const Setpoint& setpoint, std::span<const double>) override {
    rows.push_back(setpoint);
    return true;
  }
};
std::vector<Setpoint> rows_of_program(const std::string& text, Machine machine, double delay) {
  machine.control.backend = BackendKind::none;
  const auto backend = hal::open_backend(machine);
  REQUIRE(backend);
  ipr::Reader reader = ipr::Reader::from_text(text);
  Diagnostics diagnostics;
  ChannelOptions options;
  options.first_cut_delay = delay;
  Rows rows;
  simulate(reader, -1, machine, options, **backend, diagnostics, &rows, nullptr);
  CHECK(diagnostics.errors() == 0);
  return rows.rows;
}

}  // namespace

TEST_CASE("the spread of values is their median and the largest", "[compare]") {
  const auto check = [](const std::vector<double>& values, double median, double worst) {
    const Spread spread = spread_of(values);
    CHECK(spread.median == median);
    CHECK(spread.worst == worst);
  };
  check({3}, 3, 3);
  check({4, 1, 3}, 3, 4);
  check({4, 1, 3, 2}, 2.5, 4);
  check({-1, -5}, -3, -1);
  check({2, 2, 7, 2}, 2, 7);
}

TEST_CASE("a delay stands where the machine rests in any case before the first cut", "[compare]") {
  const AxisVector a(0, 0, 0), b(10, 0, 0), c(20, 0, 0), up(10, 10, 0);
  const auto place = [](std::vector<Block> blocks) { return delayed(std::move(blocks)).place; };
  CHECK(place({cut(a, b), cut(b, up)}) == 0);
  CHECK(place({rapid(a, b), cut(b, up)}) == 1);                 // the path turns there
  CHECK(place({rapid(a, b), cut(b, c)}) == 0);                  // it does not
  CHECK(place({rapid(a, b, PathMode::stop), cut(b, c)}) == 1);  // and rests all the same
  CHECK(place({rapid(a, b), spindle(), cut(b, c)}) == 2);       // after the spindle
  CHECK(place({spindle(), rapid(a, b), cut(b, c)}) == 1);       // the same
  CHECK(place({rapid(up, b), rapid(b, c), cut(c, up)}) == 2);   // a rapid may be rounded
  CHECK(place({rapid(up, a), rapid(a, b), cut(b, c)}) == 0);    // into another
  CHECK(place({}) == 0);
  CHECK(place({rapid(a, b), spindle()}) == 1);
}

TEST_CASE("where a delay may stand depends on the method", "[compare]") {
  const AxisVector a(0, 0, 0), b(10, 0, 0), c(20, 0, 0);
  const std::vector<Block> blocks{rapid(a, b), spindle(), rapid(b, c), cut(c, b)};
  const std::vector<Block> straight{rapid(a, b), cut(b, c)};
  CHECK(delayed(blocks, delay_place(Method::chords)).place == 3);
  CHECK(delayed(straight, delay_place(Method::chords)).place == 1);
  CHECK(delayed(straight, delay_place(Method::taylor1)).place == 0);
  CHECK(delayed(blocks, delay_place(Method::taylor1)).place == 3);
  CHECK(delayed(blocks, delay_place(Method::acc_dec_linear)).place == 0);
}

TEST_CASE("a delay reads no further than the first cut, nor than so many blocks", "[compare]") {
  const AxisVector a(0, 0, 0), b(10, 0, 0), up(10, 10, 0);
  CHECK(delayed({rapid(a, b), cut(b, up), cut(up, a), cut(a, b)}).blocks == 2);
  std::vector<Block> rapids;
  for (int i = 0; i < 1500; ++i) rapids.push_back(i % 2 == 0 ? rapid(a, b) : rapid(b, a));
  CHECK(delayed(rapids).blocks == 1000);
}

TEST_CASE("a delayed cut begins later by exactly the delay", "[compare]") {
  const double delay = GENERATE(0.0, 0.0000625, 0.0005, 0.0009375);
  Machine machine;
  const double a = machine.axes[1].acceleration, period = machine.control.period;
  const double approach = 2 * std::sqrt(4 / a);  // up and down again over 4 mm
  const auto rows = rows_of_program("G90 G00 X4\nG01 Y10 F6000\nM30\n", machine, delay);
  int seen = 0;
  for (const Setpoint& row : rows) {
    const double t = static_cast<double>(row.period) * period - approach - delay;
    if (t <= 0 || t > 0.05) continue;  // before the cut, and after its ramp
    CHECK(row.position[1] == Approx(a * t * t / 2).epsilon(1e-9));
    ++seen;
  }
  CHECK(seen > 40);
}

TEST_CASE("a cut is delayed even where the machine waits for a setpoint in the corner before it",
          "[compare]") {
  const double part = GENERATE(0.0, 0.25, 0.5, 0.9375);
  Machine machine;
  machine.control.period = machine.control.servo_period = 0.008;
  machine.control.corner_tolerance = 0;
  const double a = machine.axes[1].acceleration, period = machine.control.period;
  const auto rows = rows_of_program("G90 G00 X4\nG01 Y10 F6000\nM30\n", machine, part * period);
  const auto first = std::find_if(rows.begin(), rows.end(),
                                  [](const Setpoint& row) { return row.position[1] > 0; });
  REQUIRE(first != rows.end());
  CHECK((first - 1)->position[0] == Approx(4).epsilon(1e-12));  // a setpoint in the corner
  const double t = (1 - part) * period;
  CHECK(first->position[1] == Approx(a * t * t / 2).epsilon(1e-9));
}

TEST_CASE("methods of the literature begin a curve when the plan does", "[compare]") {
  const double part = GENERATE(0.0, 0.25, 0.875);
  const std::string text = test::program_text("08_butterfly.nc");
  Machine machine;
  const double delay = part * machine.control.period;
  const auto begin = [&](Method method) {
    machine.control.interpolation = method;
    for (const Setpoint& row : rows_of_program(text, machine, delay))
      if (row.line > 13 && row.v > 0) return row;
    return Setpoint();
  };
  const Setpoint planned = begin(Method::arc_length);
  REQUIRE(planned.period > 0);
  for (const Method method : {Method::taylor1, Method::taylor2, Method::curvature3p}) {
    const Setpoint row = begin(method);
    CAPTURE(name(method), part);
    CHECK(row.period == planned.period);
    CHECK((row.position - planned.position).norm() < 1e-5);
  }
}

TEST_CASE("phases shift the setpoints along the curve, whatever the method", "[compare]") {
  // Where steps are limited by the chord tolerance or have one length, the first one is as much
  // shorter as the curve begins later.
  Machine machine;
  machine.control.period = machine.control.servo_period = 0.008;
  machine.control.chord_tolerance = 1e-3;
  for (Axis& axis : machine.axes) axis.acceleration = 1e6;
  const std::string circle =
      "G21 G90 G00 X20\nG06.2 P3 K0 X20 Y0 R1 F60000\nK0 X20 Y20 R0.7071067811865476\n"
      "K0 X0 Y20 R1\nK1\nK1\nK1\nM30\n";
  const double step = std::sqrt(8 * 1e-3 * 20);  // mm, of a chord 1 um off
  const double part = GENERATE(0.25, 0.5, 0.875);
  for (const Method method : {Method::curvature3p, Method::yeh_hsu_2002, Method::chords}) {
    machine.control.interpolation = method;
    const auto rows = rows_of_program(circle, machine, part * machine.control.period);
    const auto first = std::find_if(rows.begin(), rows.end(),
                                    [](const Setpoint& row) { return row.position[1] > 0; });
    REQUIRE(first != rows.end());
    CAPTURE(name(method), part);
    const double angle = std::atan2(first->position[1], first->position[0]);
    const double whole = method == Method::chords ? machine.limits.feed * 0.008 : step;
    CHECK(20 * angle == Approx((1 - part) * whole).epsilon(0.01));
  }
}

TEST_CASE("a machine without a backend has no contour error", "[compare]") {
  auto program = Program::open(SOFTCNC_SOURCE_DIR "/programs/03_arc.nc");
  REQUIRE(program);
  const auto known = [&](BackendKind backend) {
    Machine machine;
    machine.control.backend = backend;
    MethodComparison comparison(*program, machine, {}, Method::arc_length, 1);
    CHECK(comparison.run_next(nullptr));
    std::vector<bool> has;
    for (const auto& spread : comparison.spreads()) has.push_back(spread.has_value());
    return has;
  };
  const auto mill = known(BackendKind::sim), port = known(BackendKind::stepdir),
             none = known(BackendKind::none);
  CHECK(port == mill);
  for (std::size_t i = 0; i < mill.size(); ++i) {
    CAPTURE(compared_figures()[i].name);
    const bool is_contour = compared_figures()[i].name.starts_with("contour_error");
    CHECK(none[i] == (mill[i] && !is_contour));
    if (is_contour) CHECK(mill[i]);
  }
}

TEST_CASE("one phase has the figures of a run", "[compare]") {
  const Method method = GENERATE(Method::arc_length, Method::taylor1, Method::dsm);
  auto program = Program::open(SOFTCNC_SOURCE_DIR "/programs/08_butterfly.nc");
  REQUIRE(program);
  MethodComparison comparison(*program, Machine(), {}, method, 1);
  CHECK(comparison.run_next(nullptr));
  CHECK_FALSE(comparison.run_next(nullptr));
  CHECK(comparison.note() == "");

  Machine machine;
  machine.control.interpolation = method;
  const auto backend = hal::open_backend(machine);
  REQUIRE(backend);
  Diagnostics diagnostics;
  ipr::Reader reader = program->reader();
  const Outcome outcome = simulate(reader, program->descriptor(), machine, {}, **backend,
                                   diagnostics, nullptr, nullptr);
  const auto spreads = comparison.spreads();
  REQUIRE(spreads.size() == compared_figures().size());
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    const auto expected = compared_figures()[i].value(outcome, machine);
    CAPTURE(compared_figures()[i].name);
    REQUIRE(spreads[i].has_value() == expected.has_value());
    if (!expected) continue;
    CHECK(spreads[i]->median == *expected);
    CHECK(spreads[i]->worst == *expected);
  }
}

TEST_CASE("what means nothing for a method has no figure", "[compare]") {
  const auto known = [](Machine machine) {
    Outcome outcome;
    outcome.contour.emplace();
    std::string names;
    for (const ComparedFigure& figure : compared_figures())
      if (figure.value(outcome, machine)) names += std::string(figure.name) + ' ';
    return names;
  };
  Machine machine;
  const std::string fluctuations =
      "feed_fluctuation_max feed_fluctuation_rms feed_fluctuation_p99 ";
  const std::string rest = "path_deviation_um_max " + fluctuations +
                           "chord_fluctuation_max chord_fluctuation_rms chord_fluctuation_p99 "
                           "acceleration_over_limit ";
  const std::string always = "time_s chord_error_um_max chord_error_um_rms " + rest;
  CHECK(known(machine) == always);
  for (const Method method : {Method::acc_dec_linear, Method::acc_dec_bell, Method::two_step}) {
    machine.control.interpolation = method;  // what leaves the path has no chords of it
    CHECK(known(machine) == "time_s " + rest);
  }
  machine.control.interpolation = Method::chords;
  machine.axes[1].jerk = 50000;
  CHECK(known(machine) == always + "jerk_over_limit ");
  machine.control.interpolation = Method::dda;
  CHECK(known(machine) == "time_s path_deviation_um_max ");
  machine.control.pulse_clock = PulseClock::paper;
  CHECK(known(machine) == "time_s path_deviation_um_max " + fluctuations);
}

TEST_CASE("of several axes the one that takes most of its limit counts", "[compare]") {
  Machine machine;
  machine.axes[0].acceleration = 1000;
  machine.axes[1].acceleration = 500;
  machine.axes[2].present = false;
  Outcome outcome;
  outcome.measured.acceleration = {900, 550, 5000};
  const auto figures = compared_figures();
  const auto figure = std::find_if(figures.begin(), figures.end(), [](const ComparedFigure& each) {
    return each.name == "acceleration_over_limit";
  });
  REQUIRE(figure != figures.end());
  CHECK(figure->value(outcome, machine).value() == Approx(1.1).epsilon(1e-12));
}

TEST_CASE("a method that cannot run a program says why, and has no figures", "[compare]") {
  auto program = Program::open(SOFTCNC_SOURCE_DIR "/programs/08_butterfly.nc");
  REQUIRE(program);
  const auto note_of = [&](const Machine& machine, Method method) {
    MethodComparison comparison(*program, machine, {}, method, 4);
    int runs = 0;
    while (comparison.run_next(nullptr)) ++runs;
    CHECK(runs == 1);  // the others would not come to their end either
    for (const auto& spread : comparison.spreads()) CHECK_FALSE(spread);
    return comparison.note();
  };
  Machine machine;
  machine.control.pulse_clock = PulseClock::paper;
  machine.axes[1].blu = 0.005;
  CHECK(note_of(machine, Method::dda) ==
        "line 13: one reference clock cannot serve a BLU of 2.5 um of X and one of 5 um of Y "
        "[SC7080]");
  machine.axes[0].drive.following_error = 0.1;
  CHECK(note_of(machine, Method::arc_length).find("following error of X: it is ") !=
        std::string::npos);
}
