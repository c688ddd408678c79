// SPDX-License-Identifier: MIT
// The figures of docs/pulses.md: circles by each interpolator (Table 3 of paper 003 among them),
// and the feed over slope and angle. Tab-separated, for scripts/pulse_docs.py.
#include <cstdio>
#include <cstring>

#include "motion/pulse_clock.hpp"
#include "motion/pulse_line.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;

constexpr std::int64_t kPaperRadius = 4000;  // BLU

void print_radius(std::int64_t radius) {
  for (const PulseMethod method : test::kPulseMethods) {
    const test::Walk walk = test::walk_quadrant(radius, method);
    std::printf("%lld\t%s\t%lld\t%lld\t%.6f\t%.6f\n", static_cast<long long>(radius),
                name(method).data(), static_cast<long long>(walk.places),
                static_cast<long long>(walk.moves), walk.mean, walk.max);
  }
}

void print_radii() {
  print_radius(kPaperRadius);
  for (std::int64_t radius = 10; radius <= 1'000'000; radius *= 10) print_radius(radius);
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
  if (count == 2 && std::strcmp(arguments[1], "radii") == 0) {
    softcnc::print_radii();
  } else if (count == 2 && std::strcmp(arguments[1], "feeds") == 0) {
    softcnc::print_feeds();
  } else {
    std::fputs("usage: pulse_table radii | feeds\n", stderr);
    return 2;
  }
  return 0;
}
