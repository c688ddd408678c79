// SPDX-License-Identifier: MIT
// Chords of one length at constant feed: the comparison of paper 000, figure 10.
#include "ipo/methods/chords.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/curves.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

Machine chord_machine(double period = 8e-3) {
  Machine machine;
  machine.control.interpolation = Method::chords;
  machine.control.period = period;
  return machine;
}

double chord(const Run& run, std::size_t row) {
  return (run.rows[row].position - run.rows[row - 1].position).norm();
}

Arc quarter(double radius) {
  return Arc::make({{radius, 0, 0}, {0, radius, 0}, {0, 0, 0}, Plane::xy, true, 0}).value();
}

}  // namespace

TEST_CASE("a chord ends where the path is first so far away", "[methods][chords]") {
  const Path line = Line({0, 0, 0}, {10, 0, 0});
  CHECK(*ipo::chord_end(line, 2, 10, {2, 0, 0}, 3) == Approx(5).epsilon(1e-12));
  CHECK(*ipo::chord_end(line, 0, 10, {0, 3, 0}, 5) == Approx(4).epsilon(1e-12));
  CHECK_FALSE(ipo::chord_end(line, 2, 10, {2, 0, 0}, 8.5).has_value());
  const Path arc = quarter(20);
  CHECK(*ipo::chord_end(arc, 0, length(arc), {20, 0, 0}, 20) ==
        Approx(20 * 2 * std::asin(0.5)).epsilon(1e-12));
  // The path passes the point first, and leaves it only at its end.
  const Path across = Line({-3, 1e-6, 0}, {10, 1e-6, 0});
  CHECK(*ipo::chord_end(across, 0, 13, {0, 0, 0}, 5) == Approx(8).epsilon(1e-9));
}

TEST_CASE("every chord on a circle is F T long and off by its closed form", "[methods][chords]") {
  const double radius = 20, feed = 100, period = 8e-3, step = feed * period;
  const auto run = test::run(chord_machine(),
                             number_blocks({Move{quarter(radius), false, feed, PathMode::follow}}));
  const double turn = 2 * std::asin(step / (2 * radius));
  const double chords = std::floor(0.5 * M_PI / turn);
  REQUIRE(static_cast<double>(run.rows.size()) == chords + 2);
  for (std::size_t i = 1; i + 1 < run.rows.size(); ++i)
    REQUIRE(chord(run, i) == Approx(step).epsilon(1e-9));
  CHECK(run.measured.chord_error ==
        Approx(radius - std::sqrt(radius * radius - step * step / 4)).epsilon(1e-6));
  CHECK(run.rows.back().position == AxisVector(0, radius, 0));
  CHECK(run.rows.back().v == 0);
  CHECK(run.measured.path_deviation < 1e-9);
}

TEST_CASE("paper 000's setting leaves the tolerance far behind", "[methods][chords]") {
  // 2000 mm/min and 8 ms on the butterfly, whose smallest radius is 0.023 mm. The largest chord
  // error and the number of points were computed independently, by bisection.
  const double feed = 2000.0 / 60;
  const auto run =
      test::run(chord_machine(),
                number_blocks({Move{test::curve("butterfly"), false, feed, PathMode::follow}}));
  CHECK(run.measured.chord_error == Approx(0.161267).epsilon(0.002));
  CHECK(run.rows.size() == 1435);
  for (std::size_t i = 1; i + 1 < run.rows.size(); ++i)
    REQUIRE(chord(run, i) == Approx(feed * 8e-3).epsilon(1e-9));
  CHECK(run.rows.back().position == AxisVector(54.492, 52.139, 0));
}

TEST_CASE("a chord goes across the corner of two lines, and ends where the machine rests",
          "[methods][chords]") {
  const auto blocks = number_blocks({Move{Line({0, 0, 0}, {1, 0, 0}), false, 50, PathMode::follow},
                                     Move{Line({1, 0, 0}, {1, 1.5, 0}), false, 50, PathMode::stop},
                                     Dwell{0.03}, Move{Line({1, 1.5, 0}, {1, 1.5, 2}), true, 0}});
  const auto run = test::run(chord_machine(), blocks);
  // F T = 0.4: 0, 0.4, 0.8, then across the corner from (0.8, 0) to (1, y).
  CHECK(run.rows[2].position == AxisVector(0.8, 0, 0));
  CHECK(run.rows[3].position[0] == 1);
  CHECK(run.rows[3].position[1] == Approx(std::sqrt(0.16 - 0.04)).epsilon(1e-12));
  CHECK(chord(run, 3) == Approx(0.4).epsilon(1e-12));
  CHECK(run.rows[3].block == 2);
  // Two whole chords and a shorter one to the end, at which it waits 30 ms, not quite four periods.
  CHECK(run.rows[6].position == AxisVector(1, 1.5, 0));
  CHECK(chord(run, 6) < 0.4);
  CHECK(run.rows[9].position == AxisVector(1, 1.5, 0));
  CHECK(run.rows[10].position[2] > 0);
  // The rapid is as fast as the axis allows, 250 mm/s: 2 mm a period.
  CHECK(run.rows.back().position == AxisVector(1, 1.5, 2));
}

TEST_CASE("across the joint of two feeds a chord is as long as both allow", "[methods][chords]") {
  const double slow = GENERATE(5.0, 50.0, 80.0);
  const auto run =
      test::run(chord_machine(),
                number_blocks({Move{Line({0, 0, 0}, {1, 0, 0}), false, 50, PathMode::follow},
                               Move{Line({1, 0, 0}, {1, 2, 0}), false, slow, PathMode::follow}}));
  // At (0.8, 0) half of a period is left at the corner.
  const double across = 0.2 + 0.004 * slow;
  CHECK(chord(run, 3) == Approx(across).epsilon(1e-12));
  CHECK(run.rows[3].position[1] == Approx(std::sqrt(across * across - 0.04)).epsilon(1e-12));
  CHECK(run.rows[3].advance == Approx(across).epsilon(1e-12));
  CHECK(chord(run, 4) == Approx(0.008 * slow).epsilon(1e-9));
}

TEST_CASE("where a rapid meets a cutting move a chord ends", "[methods][chords]") {
  const bool rapid_first = GENERATE(false, true);
  const auto line = [](AxisVector from, AxisVector to, bool rapid) {
    return Move{Line(from, to), rapid, rapid ? 0.0 : 50.0, PathMode::follow};
  };
  const auto run =
      test::run(chord_machine(), number_blocks({line({0, 0, 0}, {4.5, 0, 0}, rapid_first),
                                                line({4.5, 0, 0}, {4.5, 4.5, 0}, !rapid_first)}));
  bool at_joint = false;
  for (std::size_t i = 1; i < run.rows.size(); ++i) {
    if (run.rows[i].position == AxisVector(4.5, 0, 0)) at_joint = true;
    CHECK(run.rows[i].advance == Approx(chord(run, i)).epsilon(1e-9));
  }
  CHECK(at_joint);
  CHECK(run.measured.feed_fluctuation < 1e-9);
}

TEST_CASE("a path that stays within a chord's length is passed all the same", "[methods][chords]") {
  std::vector<AxisVector> zigzag;
  for (int i = 0; i <= 400; ++i) zigzag.emplace_back(0.001 * i, i % 2 ? 0.1 : 0, 0);
  const auto run = test::run(chord_machine(), polyline(zigzag, 50));
  CHECK(run.rows.back().position == zigzag.back());
  CHECK(run.rows.size() > 25);  // 40 mm of path, at most 1.6 mm of it a period
  for (std::size_t i = 1; i < run.rows.size(); ++i) REQUIRE(chord(run, i) < 0.4 + 1e-9);
}

TEST_CASE("override, hold and stop count from the next chord on", "[methods][chords]") {
  const auto blocks = polyline({{0, 0, 0}, {40, 0, 0}, {40, 40, 0}}, 50);
  Controls controls;
  controls[10] = {0.5, false, false};
  controls[20] = {0.5, true, false};
  controls[30] = {1, false, false};
  controls[40] = {1, false, true};
  const auto run = test::run(chord_machine(), blocks, controls);
  CHECK(chord(run, 9) == Approx(0.4));
  CHECK(chord(run, 10) == Approx(0.2));
  CHECK(run.rows[10].limit == Limit::override_);
  CHECK(chord(run, 20) == 0);
  CHECK(run.rows[25].limit == Limit::hold);
  CHECK(chord(run, 30) == Approx(0.4));
  CHECK(run.rows.size() <= 42);
  CHECK(run.rows.back().position[0] == Approx(run.rows[39].position[0]).epsilon(1e-12));
  CHECK(run.rows.back().v == 0);
}

TEST_CASE("the rows of chords do not depend on how the blocks arrive", "[methods][chords]") {
  std::vector<AxisVector> points;
  for (int i = 0; i < 200; ++i)
    points.emplace_back(0.3 * i + 0.2 * std::sin(i), 5 * std::sin(0.1 * i), 0);
  const auto together = test::run(chord_machine(), polyline(points, 80), Controls{}, 0);
  const auto apart = test::run(chord_machine(), polyline(points, 80), Controls{}, kSlowly);
  REQUIRE(together.rows.size() == apart.rows.size());
  for (std::size_t i = 0; i < apart.rows.size(); ++i)
    REQUIRE(together.rows[i].position == apart.rows[i].position);
}
