// SPDX-License-Identifier: MIT
#include "ipr/state/coordinates.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kRounding = 1e-12;  // mm

TEST_CASE("without offsets programmed coordinates are the machine's, to the bit",
          "[ipr][coordinates]") {
  const AxisVector point(0.1, -1e-17, 12345.678);
  CHECK(Coordinates().to_machine(point) == point);
  CHECK(Coordinates().to_program(point) == point);
  CHECK(!Coordinates().rotated());
}

TEST_CASE("the offsets of work, shift and tool add up", "[ipr][coordinates]") {
  const Coordinates coordinates({{100, 20, 3}, 0}, {1, 2, 3}, {0, 0, 50});
  CHECK(near(coordinates.to_machine({10, 10, 10}), {111, 32, 66}, kRounding));
  CHECK(near(coordinates.to_program({111, 32, 66}), {10, 10, 10}, kRounding));
}

TEST_CASE("a quarter turn moves X to Y after the shift and before origin and tool",
          "[ipr][coordinates]") {
  const Coordinates coordinates({{100, 20, 3}, std::numbers::pi / 2}, {1, 2, 3}, {0, 0, 50});
  CHECK(coordinates.rotated());
  CHECK(near(coordinates.to_machine({10, 0, 0}), {98, 31, 56}, kRounding));
  CHECK(near(coordinates.to_program({98, 31, 56}), {10, 0, 0}, kRounding));
  CHECK(near(coordinates.direction({1, 0, 7}), {0, 1, 7}, kRounding));
}

TEST_CASE("there and back again is where one was, at any angle", "[ipr][coordinates]") {
  for (int degrees = -370; degrees < 370; degrees += 13) {
    const Coordinates coordinates({{1, -2, 3}, degrees * std::numbers::pi / 180}, {4, 5, -6},
                                  {0.5, 0, 9});
    const AxisVector point(17, degrees, -3);
    CHECK(near(coordinates.to_program(coordinates.to_machine(point)), point, kRounding));
  }
}

}  // namespace
}  // namespace softcnc::ipr
