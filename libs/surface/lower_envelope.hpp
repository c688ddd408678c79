// SPDX-License-Identifier: MIT
// The lower envelope of balls: those that leave the surface, of all that cut it.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace softcnc::surface {

/// The centre of a ball, mm; z upwards.
struct Ball {
  double a, b, z;
};

/// Places at even steps around a middle, as many to each side along a and b.
struct Lattice {
  double a, b;            // mm: the middle
  double half_a, half_b;  // mm: to the outermost
  int steps_a, steps_b;   // from the middle to the outermost
};

/// Returns the centre whose ball reaches lowest at (0, 0); null where none reaches it. `seen`
/// makes a Ball of each.
template <typename Centre, typename Seen>
const Centre* lowest_ball(std::span<const Centre> centres, double radius, Seen&& seen) {
  const Centre* found = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Centre& centre : centres) {
    const Ball ball = seen(centre);
    const double square = radius * radius - ball.a * ball.a - ball.b * ball.b;
    const double over = ball.z - least;  // what reaches no deeper has less below its centre
    if (square <= 0 || (over >= 0 && square <= over * over)) continue;
    found = &centre;
    least = ball.z - std::sqrt(square);
  }
  return found;
}

/// Returns the balls that reach lowest at some place of the lattice, in their order: what other
/// balls have left there, they have cut away.
std::vector<Ball> lower_envelope(std::span<const Ball> balls, double radius,
                                 const Lattice& lattice);

}  // namespace softcnc::surface
