// SPDX-License-Identifier: MIT
// The table of docs/surface.md: Rmax by the Z-map and by the model of paper 004, over feed per
// tooth and inclination, as its figure 6. Tab-separated, for scripts/generate surface.
#include <cstdio>

#include "support/milled.hpp"

namespace softcnc {
namespace {

constexpr double kRadius = 5, kPick = 0.5;  // mm
constexpr double kStep = 0.0025;            // mm, of the grid

/// Equations 2 to 4 of paper 004: the larger of the two surfaces counts below the angle at which
/// they meet.
double model(double feed, double incline) {
  const double rise = kRadius * std::sin(test::radians(incline));
  const double phase = kPick / (2 * std::numbers::pi);
  const double marks =
      (kPick * kPick + (feed - phase) * (feed - phase)) / (8 * kRadius);  // equation 2
  const double square = kRadius * kRadius - feed * feed + rise * rise;
  const double remains = kRadius - std::sqrt(square);  // equation 3
  return std::max(marks, remains);
}

}  // namespace
}  // namespace softcnc

int main() {
  using namespace softcnc;
  for (const double incline : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0})
    for (const double feed : {0.27, 0.30, 0.35, 0.40, 0.45, 0.50}) {
      const double cut = test::rmax({.feed = feed, .incline = incline}, kStep);
      std::printf("%g\t%.2f\t%.2f\t%.2f\n", incline, feed, 1000 * cut, 1000 * model(feed, incline));
    }
  std::printf("%g\t%.2f\t%.2f\t%.2f\n", 0.0, 0.33, 1000 * test::rmax({.feed = 0.33}, kStep),
              1000 * model(0.33, 0));
}
