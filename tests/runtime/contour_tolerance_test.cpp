// SPDX-License-Identifier: MIT
// The table of the simulated mill where control.contour_tolerance_um limits what its drives leave.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/session/session.hpp"
#include "support/files.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

constexpr double kBlu = 0.0025;

Machine tolerant_mill(double tolerance, double jerk = 0) {
  Machine machine;
  machine.control.contour_tolerance = tolerance;
  for (Axis& axis : machine.axes) axis.jerk = jerk;
  return machine;
}

struct Motion {
  std::vector<Setpoint> rows;
  std::vector<double> lags;  // mm, by row: of all axes together
  double contour = 0;        // mm: of cutting moves and of rapids, at every instant
  Measured measured;
};

Motion finish(Session& session, std::span<const std::string> columns) {
  Motion motion;
  std::vector<std::size_t> errors;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].ends_with("_err_um")) errors.push_back(i);
  for (; session.status() == SessionStatus::running;) {
    const auto step = session.step();
    if (!step) break;
    motion.rows.push_back(step->setpoint);
    double square = 0;
    for (const std::size_t i : errors) square += step->values[i] * step->values[i];
    motion.lags.push_back(1e-3 * std::sqrt(square));
  }
  CHECK(session.errors() == 0);
  const ContourReport contour = session.contour().value();
  motion.contour = std::max(contour.cutting.max, contour.rapids.max);
  motion.measured = session.measured();
  return motion;
}

Motion run_motion(const std::string& text, const Machine& machine) {
  const auto backend = hal::open_backend(machine);
  Session session(machine, {}, **backend);
  REQUIRE(session.feed(text));
  session.end();
  return finish(session, (*backend)->columns());
}

/// Lines at 100 mm/s with tangent arcs of many radii between them, by many angles.
std::string bends() {
  std::ostringstream text;
  text.precision(9);
  text << std::fixed << "G21 G17 G90 G61 F6000\n";
  double x = 0, y = 0, heading = 0, side = 1;
  for (const double radius : {0.05, 0.2, 1.0, 5.0, 20.0})
    for (const double angle : {0.2, 0.7, 1.57, 3.0}) {
      x += 30 * std::cos(heading), y += 30 * std::sin(heading);
      text << "G1 X" << x << " Y" << y << "\n";
      const double i = -side * radius * std::sin(heading), j = side * radius * std::cos(heading);
      heading += side * angle;
      x += i + side * radius * std::sin(heading), y += j - side * radius * std::cos(heading);
      text << (side > 0 ? "G3" : "G2") << " X" << x << " Y" << y << " I" << i << " J" << j << "\n";
      side = -side;
    }
  text << "G1 X" << x + 30 * std::cos(heading) << " Y" << y + 30 * std::sin(heading) << "\nM30\n";
  return text.str();
}

constexpr const char* kExactCircle =
    "G21 G17 G90 G61 G1 X50 F15000\nG3 X50 I-50\nG3 X50 I-50\nG1 X0\nM30\n";
constexpr const char* kExactSquare = "G21 G17 G90 G61 F6000\nG1 X20\nY20\nX0\nY0\nM30\n";

}  // namespace

TEST_CASE("the table keeps the contour tolerance within one BLU", "[runtime][contour]") {
  const std::map<std::string, std::string> programs{
      {"butterfly", test::program_text("08_butterfly.nc")},
      {"circle", kExactCircle},
      {"square", kExactSquare},
      {"arcs", test::program_text("03_arc.nc")},
      {"rounded", test::program_text("19_rounded_corners.nc")},
      {"bends", bends()}};
  for (const auto& [name, text] : programs)
    for (const double jerk : {0.0, 50'000.0}) {
      if (test::kSanitized && name != "arcs" && name != "square") continue;
      const Motion motion = run_motion(text, tolerant_mill(0.01, jerk));
      CAPTURE(name, jerk, motion.contour);
      CHECK(motion.contour <= 0.01 + kBlu);
      CHECK(motion.measured.acceleration.maxCoeff() <= 1000 * 1.001);
      const bool limits = std::ranges::any_of(
          motion.rows, [](const Setpoint& row) { return row.limit == Limit::contour; });
      CHECK(limits == (name != "square"));  // lines and rests only
    }
  CHECK(run_motion(test::program_text("08_butterfly.nc"), tolerant_mill(0)).contour > 0.5);
}

TEST_CASE("a circle within the contour tolerance is as fast as the closed form",
          "[runtime][contour]") {
  for (const double tolerance : {0.005, 0.01, 0.04}) {
    double steady = 0;
    for (const Setpoint& row : run_motion(kExactCircle, tolerant_mill(tolerance)).rows)
      if (row.limit == Limit::contour && row.line == 3) steady = std::max(steady, row.v);
    // v = Kv sqrt(2 R e)
    CAPTURE(tolerance);
    CHECK(steady == Approx(30 * std::sqrt(2 * 50 * tolerance)).epsilon(0.03));
  }
}

TEST_CASE("at exact corners the plan rests until the lag is within the tolerance",
          "[runtime][contour]") {
  for (const double tolerance : {0.005, 0.01, 0.1})
    for (const double jerk : {0.0, 50'000.0}) {
      const Motion motion = run_motion(kExactSquare, tolerant_mill(tolerance, jerk));
      int corners = 0;
      for (std::size_t i = 1; i < motion.rows.size(); ++i) {
        if (!(motion.rows[i - 1].v == 0 && motion.rows[i].v > 0 && motion.rows[i].s > 1)) continue;
        ++corners;
        CAPTURE(tolerance, jerk, motion.rows[i].s, motion.lags[i - 1]);
        CHECK(motion.lags[i - 1] <= tolerance + 1e-6);
      }
      CHECK(corners == 3);
    }
}

TEST_CASE("a table that waits at acute corners is measured on the way to them",
          "[runtime][contour]") {
  const char* acute =
      "G21 G17 G90 G61 F3000\nG1 X1.2203 Y0.2508\nX0.9365 Y-0.2027\nX0.4182 Y1.4889\nM30\n";
  CHECK(run_motion(acute, tolerant_mill(0.02)).contour < 0.006);
  // A circle begins where a line has come along its tangent, and leads back.
  CHECK(run_motion("G21 G17 G90 G61 F3000\nG1 X0 Y-30\nG3 I-15\nM30\n", tolerant_mill(0.01))
            .contour <= 0.0125);
}

TEST_CASE("small corners between short moves need no long rests", "[runtime][contour]") {
  std::ostringstream chords;
  chords << "G21 G17 G90 G61 F3000\n";
  double x = 0, y = 0;
  for (int i = 0; i < 100; ++i) {
    x += 0.1 * std::cos(0.035 * i), y += 0.1 * std::sin(0.035 * i);
    chords << "G1 X" << x << " Y" << y << "\n";
  }
  chords << "M30\n";
  const Motion kept = run_motion(chords.str(), tolerant_mill(0.01)),
               free = run_motion(chords.str(), tolerant_mill(0));
  CHECK(kept.contour <= 0.0125);
  CHECK(2 * kept.rows.size() < 5 * free.rows.size());
  CHECK(kept.rows.size() > free.rows.size());
}

TEST_CASE("random programs keep the contour tolerance where friction allows it",
          "[runtime][contour]") {
  constexpr double kFriction = 0.012;  // mm: what it leaves where an axis turns back
  for (unsigned seed = 1; seed <= 24 / test::kPart; ++seed) {
    std::mt19937 random(seed);
    const double tolerance = seed % 2 == 0 ? 0.01 : 0.04;
    const Machine machine = tolerant_mill(tolerance, seed % 3 == 0 ? 30'000 : 0);
    const auto backend = hal::open_backend(machine);
    Session session(machine, {}, **backend);
    for (Block& block : test::random_program(random, 5)) session.feed(std::move(block));
    session.end();
    const Motion motion = finish(session, (*backend)->columns());
    CAPTURE(seed, tolerance, motion.contour);
    CHECK(motion.contour <= tolerance + kBlu + kFriction);
    CHECK(session.status() == SessionStatus::done);
  }
}

TEST_CASE("holds and overrides under a contour tolerance keep every limit", "[runtime][contour]") {
  for (unsigned seed = 1; seed <= (test::kSanitized ? 1 : 24); ++seed) {
    std::mt19937 random(seed);
    const Machine machine = tolerant_mill(0.02, seed % 3 == 0 ? 30'000 : 0);
    const auto backend = hal::open_backend(machine);
    Session session(machine, {}, **backend);
    for (Block& block : test::random_program(random, 5)) session.feed(std::move(block));
    session.end();
    double end = 0;
    bool goes_back = false;
    for (int row = 0; session.status() == SessionStatus::running; ++row) {
      if (random() % 200 == 0)
        session.set_feed_override(static_cast<double>(random() % 200 + 1) / 100);
      if (random() % 300 == 0) session.hold();
      if (random() % 50 == 0) session.resume();
      const auto step = session.step();
      if (!step) break;
      goes_back = goes_back || step->setpoint.s < end;
      end = step->setpoint.s;
    }
    const Measured& measured = session.measured();
    CAPTURE(seed, end);
    CHECK_FALSE(goes_back);
    CHECK(session.status() == SessionStatus::done);
    CHECK(session.errors() == 0);
    CHECK(measured.velocity.maxCoeff() <= 250 * 1.001);
    CHECK(measured.acceleration.maxCoeff() <= 1000 * 1.001);
  }
}
