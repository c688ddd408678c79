// SPDX-License-Identifier: MIT
// Arcs as staircases, against Table 3 of paper 003 and against the circle.
#include "motion/pulses/pulse_arc.hpp"

#include <catch2/catch.hpp>

#include "support/property.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;
using test::integer;
using test::Walk;

/// Which of the moves brings a quadrant of Table 3 on, as its rules are worded there.
Step by_the_rule(PulseMethod method, std::int64_t x, std::int64_t y, std::int64_t radius) {
  const Step in(0, -1), up(1, 1);
  const auto d = [&](std::int64_t dx, std::int64_t dy) {
    return (x + dx) * (x + dx) + (y + dy) * (y + dy) - radius * radius;
  };
  const auto nearest = [&](std::initializer_list<std::array<int, 2>> moves) {
    const auto least = std::min_element(moves.begin(), moves.end(), [&](auto a, auto b) {
      return std::abs(d(a[0], a[1])) < std::abs(d(b[0], b[1]));
    });
    return Step(0, (*least)[0]) | Step(1, (*least)[1]);
  };
  switch (method) {
    case PulseMethod::sam:
      return d(0, 0) > 0 ? in : up;
    case PulseMethod::m_sam:
      if (x > y) return d(0, 0) > 0 ? in | up : up;
      return d(0, 0) > 0 ? in : in | up;
    case PulseMethod::dsm:
      return nearest({{-1, 0}, {-1, 1}, {0, 1}});
    default:
      return x > y ? nearest({{0, 1}, {-1, 1}}) : nearest({{-1, 0}, {-1, 1}});
  }
}

double off_circle(const GridPoint& p, double x, double y, double radius) {
  return std::abs(std::hypot(static_cast<double>(p[0]) - x, static_cast<double>(p[1]) - y) -
                  radius);
}

}  // namespace

TEST_CASE("Table 3 of paper 003 to all six digits", "[motion][pulse][paper]") {
  struct Row {
    PulseMethod method;
    std::int64_t places;
    const char *mean, *max;
  };
  const auto row = GENERATE(Row{PulseMethod::sam, 8001, "0.392587", "0.999875"},
                            Row{PulseMethod::m_sam, 5658, "0.302568", "0.999500"},
                            Row{PulseMethod::dda, 6284, "0.306079", "0.999500"},
                            Row{PulseMethod::dsm, 5658, "0.225151", "0.496906"},
                            Row{PulseMethod::m_dsm, 5658, "0.225151", "0.496906"});
  const Walk walk = test::walk_quadrant(4000, row.method);
  const auto six_digits = [](double value) { return std::to_string(value); };
  CAPTURE(name(row.method));
  CHECK(walk.places == row.places);
  CHECK(six_digits(walk.mean) == row.mean);
  CHECK(six_digits(walk.max) == row.max);
  CHECK(walk.at == GridPoint{0, 4000, 0});
}

TEST_CASE("the staircase of a quadrant is that of the rules, move by move", "[motion][pulse]") {
  const auto method =
      GENERATE(PulseMethod::sam, PulseMethod::m_sam, PulseMethod::dsm, PulseMethod::m_dsm);
  for (const std::int64_t r : {1, 2, 3, 5, 10, 25, 99, 1000, 4001}) {
    CAPTURE(name(method), r);
    ArcPulses pulses(test::arc_about_origin({r, 0}, {0, r}, r, pi / 2), method);
    GridPoint at{r, 0, 0};
    test::for_each_step(pulses, [&](Step step) {
      if (at[0] > 0 && at[1] < r) REQUIRE(step == by_the_rule(method, at[0], at[1], r));
      advance(at, step);
    });
    CHECK(at == GridPoint{0, r, 0});
  }
}

TEST_CASE("arcs in all quadrants and both directions are one another's images", "[motion][pulse]") {
  constexpr std::int64_t kRadius = 500;
  const int quadrant = GENERATE(range(0, 4));
  const bool ccw = GENERATE(true, false);
  const std::array<std::int64_t, 4> x{kRadius, 0, -kRadius, 0}, y{0, kRadius, 0, -kRadius};
  const auto i = static_cast<std::size_t>(quadrant);
  const std::size_t j = (i + (ccw ? 1 : 3)) % 4;
  for (const PulseMethod method : test::kPulseMethods) {
    const PulseArc arc =
        test::arc_about_origin({x[i], y[i]}, {x[j], y[j]}, kRadius, ccw ? pi / 2 : -pi / 2);
    const Walk walk = Walk::along(ArcPulses(arc, method), {x[i], y[i], 0},
                                  [](const auto& p) { return off_circle(p, 0, 0, kRadius); });
    const Walk first = test::walk_quadrant(kRadius, method);
    CHECK(walk.at == GridPoint{x[j], y[j], 0});
    CHECK(walk.moves == first.moves);
    CHECK(walk.max == Approx(first.max).epsilon(1e-12));
    CHECK(walk.mean == Approx(first.mean).epsilon(1e-12));
  }
}

TEST_CASE("circles close, after any number of turns", "[motion][pulse]") {
  for (const PulseMethod method : test::kPulseMethods)
    for (const int turns : {1, 2, 7})
      for (const double direction : {1.0, -1.0})
        for (const std::array<std::int64_t, 2> from : {std::array<std::int64_t, 2>{650, 0},
                                                       {-650, 0},
                                                       {0, 650},
                                                       {520, -390},
                                                       {-330, -560}}) {
          CAPTURE(name(method), turns, direction, from[0], from[1]);
          const PulseArc arc = test::arc_about_origin(from, from, 650, direction * turns * 2 * pi);
          const Walk walk = Walk::along(ArcPulses(arc, method), {from[0], from[1], 0},
                                        [](const auto& p) { return off_circle(p, 0, 0, 650); });
          CHECK(walk.at == GridPoint{from[0], from[1], 0});
          const auto quadrants = 4.0 * turns;
          const double moves =
              quadrants * static_cast<double>(test::walk_quadrant(650, method).moves);
          CHECK(static_cast<double>(walk.moves) == Approx(moves).margin(2 * quadrants));
          CHECK(walk.max < 1.25);  // (-330, -560) itself is 0.14 inside
        }
}

TEST_CASE("arcs of any sweep end exactly and stay by their circle", "[motion][pulse][property]") {
  test::holds(
      [] {
        const double radius = std::pow(10.0, test::real(1, 4.3));
        const double x = test::real(-1000, 1000), y = test::real(-1000, 1000);
        const double angle = test::real(-pi, pi);
        const double sweep = (integer(0, 1) ? 1 : -1) * test::real(2 / radius, 15);
        const auto on_grid = [&](double a) {
          return std::array<std::int64_t, 2>{std::llround(x + radius * std::cos(a)),
                                             std::llround(y + radius * std::sin(a))};
        };
        const auto parts = [](double v) { return std::llround(v * 256); };
        const PulseArc arc{
            {2, 0},        on_grid(angle), on_grid(angle + sweep), {parts(x), parts(y)},
            parts(radius), sweep};
        for (const PulseMethod method : test::kPulseMethods) {
          // Axes Z and X, as in the plane of G18.
          const Walk walk = Walk::along(ArcPulses(arc, method), {arc.from[1], 0, arc.from[0]},
                                        [&](const GridPoint& p) {
                                          return off_circle({p[2], p[0], 0}, x, y, radius);
                                        });
          RC_ASSERT(walk.at == (GridPoint{arc.to[1], 0, arc.to[0]}));
          const bool nearest = method == PulseMethod::dsm || method == PulseMethod::m_dsm;
          // The ends are up to sqrt(1/2) off, and so is what leads to them.
          RC_ASSERT(walk.max < (nearest ? 0.75 : 1.75));
          const double length = radius * std::abs(sweep);
          RC_ASSERT(static_cast<double>(walk.moves) < 1.42 * length + 4);
          RC_ASSERT(static_cast<double>(walk.moves) > 0.70 * length - 4);
        }
      },
      100);
}

TEST_CASE("the staircase does not depend on how many clocks are asked for at once",
          "[motion][pulse]") {
  for (const PulseMethod method : test::kPulseMethods) {
    const PulseArc arc = test::arc_about_origin({300, 400}, {-400, 300}, 500, 2.5 * pi);
    ArcPulses whole(arc, method), single(arc, method);
    test::for_each_step(whole, [&](Step step) {
      Step alone;
      REQUIRE(single.fill({&alone, 1}) == 1);
      REQUIRE(alone == step);
    });
    Step none;
    CHECK(single.fill({&none, 1}) == 0);
  }
}

TEST_CASE("a short piece of the largest circle overflows nothing", "[motion][pulse]") {
  // Around (R cos 1, R sin 1): D changes by up to 2^59 there.
  constexpr std::int64_t kRadius = PulseArc::kFurthest - 10'000'000;
  const auto on_grid = [](double angle) {
    const auto r = static_cast<long double>(kRadius);
    const long double a = angle;
    return std::array<std::int64_t, 2>{std::llround(r * std::cos(a)),
                                       std::llround(r * std::sin(a))};
  };
  const auto from = on_grid(1.0), to = on_grid(1.0 + 1e-8);
  for (const PulseMethod method : {PulseMethod::dsm, PulseMethod::m_dsm}) {
    const PulseArc arc = test::arc_about_origin(from, to, kRadius, 1e-8);
    long double worst = 0;
    const Walk walk =
        Walk::along(ArcPulses(arc, method), {from[0], from[1], 0}, [&](const auto& p) {
          const auto x = static_cast<long double>(p[0]), y = static_cast<long double>(p[1]);
          const auto r = static_cast<long double>(kRadius);
          worst = std::max(worst, std::abs(std::hypot(x, y) - r));
          return 0.0;
        });
    CHECK(walk.at == GridPoint{to[0], to[1], 0});
    CHECK(worst < 0.71L);
  }
}

TEST_CASE("an arc shorter than a BLU has no pulse or goes to its end", "[motion][pulse]") {
  Step steps[4];
  const auto pulses = [&](std::array<std::int64_t, 2> to, double sweep) {
    return ArcPulses(test::arc_about_origin({100, 0}, to, 100, sweep), PulseMethod::m_dsm)
        .fill(steps);
  };
  CHECK(pulses({100, 0}, 0.001) == 0);
  CHECK(pulses({100, 0}, -0.001) == 0);
  REQUIRE(pulses({100, 1}, 0.007) == 1);
  CHECK(steps[0] == Step(1, 1));
  REQUIRE(pulses({100, -1}, -0.007) == 1);
  CHECK(steps[0] == Step(1, -1));
}

}  // namespace softcnc
