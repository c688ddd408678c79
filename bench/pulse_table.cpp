// SPDX-License-Identifier: MIT
// The figures of docs/pulses.md: circles by each interpolator (Table 3 of paper 003 among them),
// and the feed over slope and angle. Tab-separated, for scripts/generate pulses.
#include <cstdio>
#include <cstring>
#include <limits>

#include "motion/pulses/pulse_clock.hpp"
#include "motion/pulses/pulse_line.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;

constexpr std::int64_t kPaperRadius = 4000;  // BLU

/// The least and the largest of several figures.
struct Spread {
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void add(double figure) {
    least = std::min(least, figure);
    most = std::max(most, figure);
  }
};

using Place = std::array<std::int64_t, 2>;

/// BLU between two places, along the axes.
std::int64_t gap(const GridPoint& at, const Place& place) {
  return std::abs(at[0] - place[0]) + std::abs(at[1] - place[1]);
}

/// Twelve places of the grid on a circle whose radius is a multiple of 5 BLU, in their order.
std::array<Place, 12> places_on_circle(std::int64_t radius) {
  const std::int64_t a = radius / 5 * 3, b = radius / 5 * 4;
  return {{{radius, 0},
           {b, a},
           {a, b},
           {0, radius},
           {-a, b},
           {-b, a},
           {-radius, 0},
           {-b, -a},
           {-a, -b},
           {0, -radius},
           {a, -b},
           {b, -a}}};
}

/// Figures of several arcs.
struct Arcs {
  Spread moves, mean, max;
  std::int64_t gap = 0;  // largest between the end and the one programmed

  void add(const PulseArc& arc, std::int64_t radius, PulseMethod method) {
    const test::Walk walk = test::walk_arc(arc, radius, method);
    moves.add(static_cast<double>(walk.moves));
    mean.add(walk.mean);
    max.add(walk.max);
    gap = std::max(gap, softcnc::gap(walk.at, arc.to));
  }
};

/// From each of the twelve places over five others, so that each quadrant is begun, ended and
/// passed in either direction.
Arcs arcs_across(std::int64_t radius, PulseMethod method) {
  Arcs arcs;
  const auto places = places_on_circle(radius);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (const int turn : {1, -1}) {
      const Place& from = places[i];
      const Place& to = places[(i + (turn > 0 ? 5 : 7)) % places.size()];
      const auto cross = static_cast<double>(from[0] * to[1] - from[1] * to[0]);
      const auto dot = static_cast<double>(from[0] * to[0] + from[1] * to[1]);
      const double angle = std::atan2(turn * cross, dot);  // in the direction of the turn
      arcs.add(
          test::arc_about_origin(from, to, radius, turn * (angle < 0 ? angle + 2 * pi : angle)),
          radius, method);
    }
  return arcs;
}

/// All quadrants in both directions.
Arcs quadrants(std::int64_t radius, PulseMethod method) {
  Arcs arcs;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const int turn : {1, -1})
      arcs.add(
          test::arc_about_origin(test::crossing(radius, quarter),
                                 test::crossing(radius, quarter + turn), radius, turn * pi / 2),
          radius, method);
  return arcs;
}

/// Whole turns from the four crossings in both directions: the largest gap that is left.
std::int64_t gap_of_turns(std::int64_t radius, PulseMethod method) {
  std::int64_t largest = 0;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const int turn : {1, -1}) {
      const Place from = test::crossing(radius, quarter);
      ArcPulses pulses(test::arc_about_origin(from, from, radius, turn * 2 * pi), method);
      GridPoint at{from[0], from[1], 0};
      test::for_each_step(pulses, [&](Step step) { advance(at, step); });
      largest = std::max(largest, gap(at, from));
    }
  return largest;
}

void print(const Spread& spread, int digits) {
  std::printf("\t%.*f\t%.*f", digits, spread.least, digits, spread.most);
}

void print_circle(std::int64_t radius, PulseMethod method) {
  const Arcs quarters = quadrants(radius, method), across = arcs_across(radius, method);
  std::printf("%lld\t%s", static_cast<long long>(radius), name(method).data());
  print(quarters.moves, 0);
  print(quarters.mean, 6);
  print(quarters.max, 6);
  print(across.mean, 6);
  print(across.max, 6);
  const std::int64_t off = std::max({quarters.gap, across.gap, gap_of_turns(radius, method)});
  std::printf("\t%lld\n", static_cast<long long>(off));
}

void print_circles() {
  for (std::int64_t radius = 10; radius <= 1'000'000; radius *= 10)
    for (const PulseMethod method : test::kPulseMethods) print_circle(radius, method);
}

void print_radius(std::int64_t radius) {
  for (const PulseMethod method : test::kPulseMethods) {
    const test::Walk walk = test::walk_quadrant(radius, method);
    std::printf("%lld\t%s\t%lld\t%lld\t%.6f\t%.6f\n", static_cast<long long>(radius),
                name(method).data(), static_cast<long long>(walk.places),
                static_cast<long long>(walk.moves), walk.mean, walk.max);
  }
}

/// BLU of the path per clock.
double speed_of_line(double slope, PulseMethod method, bool constant_feed) {
  constexpr std::int64_t kWay = 100'000;
  const GridPoint way{kWay, std::llround(kWay * slope), 0};
  LinePulses pulses(way, method);
  ClockDropper dropper(method);
  double clocks = 0;
  test::for_each_step(pulses,
                      [&](Step step) { clocks += constant_feed ? dropper.clocks(step) : 1; });
  return std::hypot(static_cast<double>(way[0]), static_cast<double>(way[1])) / clocks;
}

/// Clocks along a quadrant in bins of 10 degrees.
std::array<double, 9> clocks_over_arc(PulseMethod method, bool constant_feed) {
  const PulseArc arc =
      test::arc_about_origin({kPaperRadius, 0}, {0, kPaperRadius}, kPaperRadius, pi / 2);
  ArcPulses pulses(arc, method);
  ClockDropper dropper(method);
  std::array<double, 9> clocks{};
  GridPoint at{kPaperRadius, 0, 0};
  test::for_each_step(pulses, [&](Step step) {
    advance(at, step);
    const double angle = std::atan2(static_cast<double>(at[1]), static_cast<double>(at[0]));
    const auto bin = static_cast<std::size_t>(std::clamp(angle * 18 / pi, 0.0, 8.0));
    clocks[bin] += constant_feed ? dropper.clocks(step) : 1;
  });
  return clocks;
}

void print_feeds() {
  for (const PulseMethod method : test::kPulseMethods)
    for (const bool constant_feed : {false, true}) {
      const double flat = speed_of_line(0, method, constant_feed);
      for (int degrees = 0; degrees <= 45; ++degrees) {
        const double slope = std::tan(degrees * pi / 180);
        std::printf("line\t%s\t%d\t%d\t%.4f\n", name(method).data(), constant_feed, degrees,
                    speed_of_line(slope, method, constant_feed) / flat);
      }
      const auto clocks = clocks_over_arc(method, constant_feed);
      for (std::size_t bin = 0; bin < clocks.size(); ++bin)
        std::printf("arc\t%s\t%d\t%zu\t%.4f\n", name(method).data(), constant_feed, 10 * bin + 5,
                    clocks[0] / clocks[bin]);
    }
}

}  // namespace
}  // namespace softcnc

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "paper") == 0) {
    softcnc::print_radius(softcnc::kPaperRadius);
  } else if (count == 2 && std::strcmp(arguments[1], "circles") == 0) {
    softcnc::print_circles();
  } else if (count == 2 && std::strcmp(arguments[1], "feeds") == 0) {
    softcnc::print_feeds();
  } else {
    std::fputs("usage: pulse_table paper | circles | feeds\n", stderr);
    return 2;
  }
  return 0;
}
