// SPDX-License-Identifier: MIT
#include "motion/verification/sharpest_turn.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/paths.hpp"

using namespace softcnc;

namespace {

constexpr double kError = 0.01;  // mm

SharpestTurn turns_of(const std::vector<Path>& paths, bool rapid = false) {
  std::vector<CubicPiece> pieces;
  for (const Path& path : paths)
    append_pieces({&path, 0, length(path)}, pieces.empty() ? 0 : pieces.back().s1, {1, rapid},
                  pieces);
  SharpestTurn turns;
  turns.add(pieces, pieces.back().s1);
  return turns;
}

std::vector<Path> chords(double radius, int count) {
  std::vector<Path> paths;
  const auto point = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / count;
    return AxisVector(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  for (int i = 0; i < count; ++i) paths.push_back(test::line(point(i), point(i + 1)));
  return paths;
}

}  // namespace

TEST_CASE("a circle leaves v^2 / (2 R Kv^2)", "[motion][turn]") {
  for (const double radius : {0.5, 5.0, 50.0, 500.0})
    CHECK(turns_of({test::circle(radius)}).curve_lag(kError) ==
          Approx(std::sqrt(2 * radius * kError)).epsilon(0.02));
  CHECK(turns_of({test::circle(50)}).corner_lag(kError) == 0);
}

TEST_CASE("a circle of short chords counts as the circle", "[motion][turn]") {
  CHECK(turns_of(chords(50, 1000)).curve_lag(kError) == Approx(1).epsilon(0.2));
}

TEST_CASE("a corner leaves the lag times the sine of its angle over e", "[motion][turn]") {
  const SharpestTurn square =
      turns_of({test::line({0, 0, 0}, {9, 0, 0}), test::line({9, 0, 0}, {9, 9, 0})});
  CHECK(square.corner_lag(kError) == Approx(std::numbers::e * kError));
  CHECK(square.curve_lag(kError) == 0);
  const SharpestTurn blunt = turns_of(
      {test::line({0, 0, 0}, {9, 0, 0}), test::line({9, 0, 0}, {9 + 9 * std::sqrt(3.0), 9, 0})});
  CHECK(blunt.corner_lag(kError) == Approx(2 * std::numbers::e * kError));
}

TEST_CASE("the sharpest of all turns counts", "[motion][turn]") {
  const SharpestTurn turns = turns_of({test::circle(50), test::line({50, 0, 0}, {50, 30, 0}),
                                       Arc::make({{50, 30, 0}, {48, 30, 0}, {49, 30, 0}}).value(),
                                       test::line({48, 30, 0}, {48, 0, 0})});
  CHECK(turns.curve_lag(kError) == Approx(std::sqrt(2 * kError)).epsilon(0.02));
}

TEST_CASE("a straight path has no turns, and corners between rapids do not count",
          "[motion][turn]") {
  CHECK(turns_of({test::line({0, 0, 0}, {9, 0, 0})}).curve_lag(kError) == 0);
  CHECK(turns_of({test::line({0, 0, 0}, {9, 0, 0}), test::line({9, 0, 0}, {9, 9, 0})}, true)
            .corner_lag(kError) == 0);
}

TEST_CASE("of the path up to a place what follows does not count", "[motion][turn]") {
  std::vector<CubicPiece> pieces;
  const Path first = test::line({0, 0, 0}, {9, 0, 0}), second = test::line({9, 0, 0}, {9, 9, 0});
  append_pieces({&first, 0, 9}, 0, {1, false}, pieces);
  append_pieces({&second, 0, 9}, 9, {2, false}, pieces);
  SharpestTurn turns;
  turns.add(pieces, 8);
  CHECK(turns.corner_lag(kError) == 0);
}
