// SPDX-License-Identifier: MIT
#include "surface/lower_envelope.hpp"

#include <algorithm>

namespace softcnc::surface {

std::vector<Ball> lower_envelope(std::span<const Ball> balls, double radius,
                                 const Lattice& lattice) {
  std::vector<char> touches(balls.size(), 0);
  for (int i = -lattice.steps_a; i <= lattice.steps_a; ++i)
    for (int j = -lattice.steps_b; j <= lattice.steps_b; ++j) {
      const double a = lattice.a + lattice.half_a * i / std::max(1, lattice.steps_a);
      const double b = lattice.b + lattice.half_b * j / std::max(1, lattice.steps_b);
      const Ball* found = lowest_ball(balls, radius, [&](const Ball& ball) {
        return Ball{ball.a - a, ball.b - b, ball.z};
      });
      if (found != nullptr) touches[static_cast<std::size_t>(found - balls.data())] = 1;
    }
  std::vector<Ball> left;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (touches[i]) left.push_back(balls[i]);
  return left;
}

}  // namespace softcnc::surface
