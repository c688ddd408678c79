// SPDX-License-Identifier: MIT
// Sessions: programs that come line by line, and requests of an operator.
#include "runtime/session/session.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/session/simulate.hpp"
#include "support/files.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using Catch::Matchers::WithinAbs;

namespace {

Machine machine_without_backend() {
  Machine machine;
  machine.control.backend = BackendKind::none;
  return machine;
}

/// A session with what it needs, and all of its rows.
struct Shop {
  Machine machine = machine_without_backend();
  std::unique_ptr<hal::Backend> backend = std::move(*hal::open_backend(machine));
  Session session{machine, {}, *backend};
  std::vector<Setpoint> rows;

  explicit Shop(const std::function<void(Machine&)>& change = [](Machine&) {})
      : machine([&] {
          Machine changed = machine_without_backend();
          change(changed);
          return changed;
        }()) {}

  /// Steps until the session gives no row; returns how many there were.
  std::size_t run() {
    const std::size_t before = rows.size();
    while (const auto row = session.step()) rows.push_back(row->setpoint);
    return rows.size() - before;
  }
  void run(int periods) {
    for (int i = 0; i < periods; ++i) {
      const auto row = session.step();
      REQUIRE(row);
      rows.push_back(row->setpoint);
    }
  }
  double x() const { return rows.back().position[0]; }
  double v() const { return rows.back().v; }
  bool keeps_limits() {
    Diagnostics excess;
    report_excess(session.measured(), {}, machine, excess);
    return excess.all().empty();
  }
};

struct Kept final : RowSink {
  std::vector<Setpoint> rows;
  std::vector<std::vector<double>> values;
  bool row(const Setpoint& setpoint, std::span<const double> backend_values) override {
    rows.push_back(setpoint);
    values.emplace_back(backend_values.begin(), backend_values.end());
    return true;
  }
};

double largest_difference(const std::vector<std::vector<double>>& a,
                          const std::vector<std::vector<double>>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k)
      largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
  return largest;
}

bool same(const Setpoint& a, const Setpoint& b) {
  return a.period == b.period && a.line == b.line && a.block == b.block && a.s == b.s &&
         a.v == b.v && a.a == b.a && a.feed == b.feed && a.limit == b.limit &&
         a.position == b.position;
}

}  // namespace

TEST_CASE("a program that is fed moves as it does from a file, in every row",
          "[runtime][session]") {
  for (const char* name : {"01_line.nc", "03_arc.nc", "08_butterfly.nc"}) {
    INFO(name);
    const std::string text = test::program_text(name);
    for (const BackendKind kind : {BackendKind::none, BackendKind::sim}) {
      Machine machine;
      machine.control.backend = kind;
      const auto expected_backend = hal::open_backend(machine);
      Diagnostics diagnostics;
      Kept expected;
      ipr::Reader reader = ipr::Reader::from_text(text);
      simulate(reader, -1, machine, {}, **expected_backend, diagnostics, &expected, nullptr);

      const auto backend = hal::open_backend(machine);
      Kept fed;
      Session session(machine, {}, **backend, &fed);
      for (std::size_t at = 0; at < text.size(); at += 700)
        REQUIRE(session.feed(std::string_view(text).substr(at, 700)));
      session.end();
      while (session.step()) {
      }
      CHECK(session.status() == SessionStatus::done);
      CHECK(session.errors() == 0);
      REQUIRE(fed.rows.size() == expected.rows.size());
      CHECK(std::equal(fed.rows.begin(), fed.rows.end(), expected.rows.begin(), same));
      // contour errors, um: the path they are measured from is laid in batches
      CHECK(largest_difference(fed.values, expected.values) < 2e-3);
    }
  }
}

TEST_CASE("a line waits for the next one until the session is asked to rest",
          "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X10 F3000\n"));
  shop.run();
  CHECK(shop.session.status() == SessionStatus::waiting);
  const double stuck = shop.rows.empty() ? 0 : shop.x();
  CHECK(stuck < 10);
  shop.session.rest();
  CHECK(shop.run() > 0);
  CHECK(shop.session.status() == SessionStatus::waiting);
  CHECK(shop.x() == 10);
  CHECK(shop.v() == 0);
  REQUIRE(shop.session.feed("X20 Y5\n"));
  shop.session.rest();
  shop.run();
  CHECK(shop.x() == 20);
  CHECK(shop.v() == 0);
  shop.session.end();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.x() == 20);
  CHECK(shop.session.errors() == 0);
  CHECK(shop.keeps_limits());
}

TEST_CASE("rests between the lines of a program keep every limit", "[runtime][session]") {
  const std::string text = test::program_text("08_butterfly.nc");
  for (const double jerk : {0.0, 50'000.0}) {
    INFO("jerk " << jerk);
    Shop shop([jerk](Machine& machine) {
      for (Axis& axis : machine.axes) axis.jerk = jerk;
    });
    std::stringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      REQUIRE(shop.session.feed(line + "\n"));
      shop.session.rest();
      shop.run();
    }
    shop.session.end();
    shop.run();
    CHECK(shop.session.status() == SessionStatus::done);
    CHECK(shop.session.errors() == 0);
    CHECK(shop.keeps_limits());
    CHECK(shop.session.measured().path_deviation < 1e-5);
  }
}

TEST_CASE("a hold rests on the path, and resume goes on to the end", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X100 F3000\n"));
  shop.session.end();
  shop.run(50);
  shop.session.hold();
  shop.run(100);
  CHECK(shop.v() == 0);
  const double held = shop.x();
  CHECK(held > 1);
  CHECK(held < 99);
  shop.run(100);
  CHECK(shop.x() == held);
  CHECK(shop.rows.back().limit == Limit::hold);
  shop.session.resume();
  shop.run();
  CHECK(shop.x() == 100);
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.keeps_limits());
}

TEST_CASE("a hold before the first move lets nothing move", "[runtime][session]") {
  Shop shop;
  shop.session.hold();
  REQUIRE(shop.session.feed("G01 X100 F3000\n"));
  shop.session.end();
  shop.run(200);
  CHECK(std::all_of(shop.rows.begin(), shop.rows.end(),
                    [](const Setpoint& row) { return row.position[0] < 1e-9; }));
  shop.session.resume();
  shop.run();
  CHECK(shop.x() == 100);
}

TEST_CASE("an override changes the feed while the machine moves", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X100 F1200\n"));
  shop.session.end();
  shop.run(80);
  CHECK_THAT(shop.v(), WithinAbs(20, 1e-9));
  shop.session.set_feed_override(0.5);
  shop.run(80);
  CHECK_THAT(shop.v(), WithinAbs(10, 1e-9));
  shop.session.set_feed_override(2);
  shop.run(60);
  CHECK_THAT(shop.v(), WithinAbs(40, 1e-9));
  shop.run();
  CHECK(shop.x() == 100);
  CHECK(shop.keeps_limits());
}

TEST_CASE("an abort rests on the path and ends the session", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X100 F3000\n"));
  shop.run(0);
  shop.session.end();
  shop.run(50);
  shop.session.abort();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.v() == 0);
  CHECK(shop.x() < 99);
  CHECK(shop.keeps_limits());
}

TEST_CASE("a session pauses at M00 until it is resumed", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X10 F3000\nM00\nX20\nM30\n"));
  shop.session.end();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::paused);
  CHECK(shop.x() <= 10);
  CHECK_FALSE(shop.session.step());
  shop.session.resume();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.x() == 20);
}

TEST_CASE("blocks can be fed instead of lines", "[runtime][session]") {
  Shop shop;
  const AxisVector origin = AxisVector::Zero(), corner(10, 0, 0), end(10, 10, 0);
  shop.session.feed({Move{Line(origin, corner), false, 20, PathMode::follow}});
  shop.session.feed({Move{Line(corner, end), false, 20, PathMode::follow}});
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::waiting);
  CHECK(shop.rows.back().position == end);
  CHECK(shop.rows.back().block == 2);
  CHECK(shop.keeps_limits());
}

TEST_CASE("an error ends the motion with the last good block", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X10 F3000\nG01 X\nX30\n"));
  shop.session.end();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.session.errors() == 1);
  CHECK(shop.session.diagnostics()[0].pos.line == 2);
  CHECK(shop.x() == 10);
}

TEST_CASE("after an error nothing is taken until the session goes on", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X10 F3000\nG01 X\nX30\n"));
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::error);
  CHECK(shop.session.errors() == 1);
  CHECK(shop.x() == 10);
  CHECK_FALSE(shop.session.takes_more());
  REQUIRE(shop.session.feed("X99\n"));  // ignored
  CHECK(shop.run() == 0);
  shop.session.go_on();
  CHECK(shop.session.status() == SessionStatus::waiting);
  CHECK(shop.session.position()[0] == 10);
  REQUIRE(shop.session.feed("X12\n"));  // by G01 and F3000, as before
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::waiting);
  CHECK(shop.x() == 12);
  REQUIRE(shop.session.feed("X\n"));
  shop.session.rest();
  shop.run();
  REQUIRE(shop.session.errors() == 2);
  CHECK(shop.session.diagnostics()[0].pos.line == 2);
  CHECK(shop.session.diagnostics()[1].pos.line == 5);
}

TEST_CASE("rows count on after an error, and keep every limit", "[runtime][session]") {
  Shop shop;
  for (const char* text : {"G01 X10 F3000\n", "Y5\n", "Y\n", "G91 X-3\n", "G04 P0.01 Q\n",
                           "G04 P0.01\n", "X-3\n", "G999\n", "Z1\n"}) {
    if (shop.session.status() == SessionStatus::error) shop.session.go_on();
    REQUIRE(shop.session.feed(text));
    shop.session.rest();
    shop.run();
    CHECK(shop.keeps_limits());
  }
  CHECK(shop.session.errors() == 3);
  CHECK((shop.session.position() - AxisVector(4, 5, 1)).norm() < 1e-9);
  for (std::size_t i = 1; i < shop.rows.size(); ++i) {
    const Setpoint &before = shop.rows[i - 1], &row = shop.rows[i];
    CHECK(row.period == before.period + 1);
    CHECK(row.s >= before.s);
    CHECK(row.block >= before.block);
    CHECK((row.position - before.position).norm() <= 0.05 + 1e-9);  // F3000 in 1 ms
  }
  CHECK(shop.rows.back().s == Approx(22));
  CHECK(shop.rows.back().line == 9);
}

TEST_CASE("a line with an error changes nothing that an operator has set", "[runtime][session]") {
  Shop shop;
  const auto say = [&](const std::string& text) {
    if (shop.session.status() == SessionStatus::error) shop.session.go_on();
    REQUIRE(shop.session.feed(text));
    shop.session.rest();
    shop.run();
  };
  say("G91 G20 F100\n#1=2 #<_far>=3\n");
  say("G90 G21 F200 #1=7 X1 X2\n");  // X twice: none of it counts
  CHECK(shop.session.status() == SessionStatus::error);
  say("G01 X#1\n");  // inches, relative
  CHECK(shop.x() == Approx(50.8));
  say("G10 L2 P1 X0.5\nX#<_nowhere>\n");
  say("X1\n");
  CHECK(shop.session.state().work[0].origin[0] == Approx(12.7));
  CHECK(shop.x() == Approx(76.2));
  say("o1 if [1 EQ 1]\nX1\nX1 X1\no1 endif\n");  // ends within the branch
  CHECK(shop.x() == Approx(101.6));
  say("G90 X0\n");
  CHECK(shop.x() == Approx(12.7));
  CHECK(shop.session.errors() == 3);
}

TEST_CASE("after an error the machine rests where it stands, whatever comes first",
          "[runtime][session]") {
  Shop shop;
  for (const char* text : {"G01 X1 F6000\n", "X2 X3\n", "G04 P0.01\n", "X2\n", "M\n", "X3\n"}) {
    if (shop.session.status() == SessionStatus::error) shop.session.go_on();
    REQUIRE(shop.session.feed(text));
    shop.session.rest();
    shop.run();
  }
  CHECK(shop.x() == 3);
  for (std::size_t i = 1; i < shop.rows.size(); ++i)
    CHECK(shop.rows[i].position[0] >= shop.rows[i - 1].position[0]);
}

TEST_CASE("a move beyond the travel is refused, and the session goes on before it",
          "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X10 F3000\nX5000\nX20\n"));
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::error);
  CHECK(shop.x() == 10);
  shop.session.go_on();
  REQUIRE(shop.session.feed("#1=3 G91 X5000\n"));  // nothing of it counts
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::error);
  shop.session.go_on();
  REQUIRE(shop.session.feed("X11\n"));
  shop.session.end();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.x() == 11);
}

TEST_CASE("after an error in a curve over several lines none goes on", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G0 X0 Y0\nF600\nG5.2 X10 Y0 P1 L3\nX20 Y10 P1\nQ\n"));
  shop.session.rest();
  shop.run();
  REQUIRE(shop.session.status() == SessionStatus::error);
  shop.session.go_on();
  REQUIRE(shop.session.feed("X30 Y0 P1\n"));
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::error);
  CHECK(shop.session.position() == AxisVector(0, 0, 0));
}

TEST_CASE("after an error the contour of before is not compensated again", "[runtime][session]") {
  for (const char* end : {"M72\nX30\n", "X30\n"}) {
    Shop shop;
    REQUIRE(shop.session.feed("F600\nG41.1 D4\nG1 X10\nX20\nM70\nG40\nQ\n"));
    shop.session.rest();
    shop.run();
    REQUIRE(shop.session.status() == SessionStatus::error);
    shop.session.go_on();
    REQUIRE(shop.session.feed(end));
    shop.session.rest();
    shop.run();
    CHECK((shop.session.position() - AxisVector(30, 0, 0)).norm() < 1e-9);
  }
}

TEST_CASE("the state of a session has what lines without motion have set", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G10 L2 P1 X5 Y6\nG55\nG92 X0\n#100=4\n"));
  shop.session.rest();
  shop.run();
  CHECK(shop.session.state().work[0].origin[1] == 6);
  CHECK(shop.session.state().active == 1);
  CHECK(shop.session.state().shift_on);
}

TEST_CASE("an error ends a session in the commands of paper 003", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("f 600\nl 10 0\nl 1 2 3 4\nl 5 0\n"));
  shop.session.rest();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.x() == 10);
}

TEST_CASE("a session begins where the machine stands, with what others have left",
          "[runtime][session]") {
  const Machine machine = machine_without_backend();
  const auto backend = hal::open_backend(machine);
  ChannelOptions options;
  options.state.position = KeptPosition{AxisVector(3, 4, 5)};
  options.state.work[0].origin = AxisVector(1, 0, 0);
  options.state.parameters[100] = 7;
  Session session(machine, options, **backend);
  CHECK(session.position() == options.state.place());
  REQUIRE(session.feed("G91 G01 Y1 F600\n#100=[#100+1]\nG10 L2 P2 X9\nG90 X[#100]\n"));
  session.end();
  std::optional<Row> first;
  while (const auto row = session.step())
    if (!first) first = row;
  REQUIRE(first);
  CHECK(first->setpoint.position == options.state.place());
  CHECK((session.position() - AxisVector(9, 5, 5)).norm() < 1e-9);
  CHECK(session.state().work[1].origin[0] == 9);
  CHECK(session.state().parameters.at(100) == 8);
  CHECK(session.state().place() == session.position());
}

TEST_CASE("a rest where nothing has come since the last one adds no row", "[runtime][session]") {
  Shop shop;
  shop.session.rest();
  shop.session.rest();
  CHECK(shop.run() <= 1);
  REQUIRE(shop.session.feed("G01 X10 F3000\n"));
  shop.session.rest();
  shop.run();
  for (int i = 0; i < 100; ++i) shop.session.rest();
  CHECK(shop.run() == 0);
}

TEST_CASE("a request during a pause does not bring it back", "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X10 F3000\nM00\nX20\nM30\n"));
  shop.session.end();
  shop.run();
  REQUIRE(shop.session.status() == SessionStatus::paused);
  shop.session.set_feed_override(1.5);
  shop.session.resume();
  shop.run();
  CHECK(shop.session.status() == SessionStatus::done);
  CHECK(shop.x() == 20);
}

TEST_CASE("an abort together with an override rests within the limits", "[runtime][session]") {
  for (int periods = 50; periods < 400; periods += 50) {
    INFO(periods);
    Shop shop([](Machine& machine) {
      for (Axis& axis : machine.axes) axis.jerk = 30'000;
    });
    shop.session.set_feed_override(0.01);
    REQUIRE(
        shop.session.feed("G21 G90 G17 F2000\nG41.1 D5\nG01 X10 Y10\nX30\nY30\nX10\nY10\nG4\n"));
    for (int i = 0; i < periods; ++i)
      if (const auto row = shop.session.step()) shop.rows.push_back(row->setpoint);
    shop.session.set_feed_override(1);
    shop.session.abort();
    shop.run();
    CHECK(shop.session.status() == SessionStatus::done);
    CHECK(shop.v() == 0);
    CHECK(shop.keeps_limits());
  }
}

TEST_CASE("an override that is no number changes nothing, and a tiny one holds",
          "[runtime][session]") {
  Shop shop;
  REQUIRE(shop.session.feed("G01 X100 F1200\n"));
  shop.session.end();
  shop.run(80);
  shop.session.set_feed_override(std::nan(""));
  shop.run(20);
  CHECK_THAT(shop.v(), WithinAbs(20, 1e-9));
  shop.session.set_feed_override(1e-300);
  shop.run(100);
  CHECK(shop.v() == 0);
  shop.session.set_feed_override(1);
  shop.run();
  CHECK(shop.x() == 100);
  CHECK(shop.session.errors() == 0);
}
