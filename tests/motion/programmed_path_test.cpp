// SPDX-License-Identifier: MIT
#include "motion/verification/programmed_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace softcnc;

namespace {

std::vector<Block> numbered(const std::vector<Move>& moves) {
  std::vector<Block> blocks;
  for (const Move& move : moves) blocks.push_back({move, {}, static_cast<int>(blocks.size()) + 1});
  return blocks;
}

Move rounded(const Path& path, double p, double q = 0) {
  Move move{path, false, 10, PathMode::follow};
  move.corner_tolerance = p;
  move.chord_tolerance = q;
  return move;
}

struct Row {
  int block;
  AxisVector position;
};

ProgrammedPath driven(const std::vector<Block>& blocks, const std::vector<Row>& rows,
                      bool to_end = true) {
  ProgrammedPath path;
  for (const Block& block : blocks) path.add(block);
  for (const Row& row : rows) {
    Setpoint setpoint;
    setpoint.block = row.block;
    setpoint.position = row.position;
    path.sample(setpoint);
  }
  if (to_end) path.finish();
  return path;
}

/// Along x to 10, then along y to 10.
std::vector<Block> square_corner(double p, double q = 0) {
  return numbered(
      {rounded(Line({0, 0, 0}, {10, 0, 0}), p, q), rounded(Line({10, 0, 0}, {10, 10, 0}), p, q)});
}

const std::vector<Row> kCutCorner{
    {1, {0, 0, 0}}, {1, {9.6, 0, 0}}, {2, {10, 0.4, 0}}, {2, {10, 10, 0}}};

}  // namespace

TEST_CASE("a corner that is cut is as far off as the polyline through the rows is from it",
          "[programmed]") {
  const ProgrammedPath path = driven(square_corner(0.5), kCutCorner);
  CHECK(path.largest() == Approx(0.4 / std::numbers::sqrt2).epsilon(1e-12));
  CHECK(path.worst().allowed == 0.5);
}

TEST_CASE("a row beside the path is as far off as the path that is nearest", "[programmed]") {
  std::vector<Row> rows;
  for (int i = 0; i <= 100; ++i) rows.push_back({1, {0.1 * i, 0.3, 0}});
  for (int i = 4; i <= 100; ++i) rows.push_back({2, {10, 0.1 * i, 0}});
  const ProgrammedPath path = driven(square_corner(0.2, 0.25), rows);
  CHECK(path.largest() == Approx(0.3));
  CHECK(path.worst().off == Approx(0.3));
  CHECK(path.worst().allowed == 0.25);  // the larger one of P and Q
}

TEST_CASE("what has not been reached does not count", "[programmed]") {
  const std::vector<Row> rows{{1, {0, 0, 0}}, {1, {4, 0.01, 0}}, {1, {4, 0.01, 0}}};
  CHECK(driven(square_corner(0.5), rows, false).largest() == Approx(0.01));
}

TEST_CASE("the way from a dwell, and into one, passes corners as any other", "[programmed]") {
  std::vector<Block> blocks = square_corner(0.5);
  blocks.insert(blocks.begin(), Block{Dwell{1}, {}, 0});
  blocks.push_back({Dwell{1}, {}, 3});
  const std::vector<Row> rows{{0, {0, 0, 0}}, {0, {0, 0, 0}}, {3, {10, 10, 0}}, {3, {10, 10, 0}}};
  CHECK(driven(blocks, rows).largest() == Approx(10 / std::numbers::sqrt2));
  const std::vector<Row> around{{0, {0, 0, 0}}, {1, {9.9, 0, 0}}, {3, {10, 10, 0}}};
  CHECK(driven(blocks, around).largest() == Approx(0.1).epsilon(1e-3));
}

TEST_CASE("a corner at which the path stops may not be cut", "[programmed]") {
  auto blocks = square_corner(0.5);
  std::get<Move>(blocks[0].what).path_mode = PathMode::stop;
  CHECK(driven(blocks, kCutCorner).largest() == 0);  // no sample is off, and no joint is rounded
  std::vector<Row> rows = kCutCorner;
  rows.insert(rows.begin() + 2, {2, {9.9, 0.1, 0}});
  CHECK(driven(blocks, rows).largest() == Approx(0.1));
}

TEST_CASE("chords far shorter than what is allowed are searched on both sides", "[programmed]") {
  constexpr double kChord = 0.01;
  std::vector<Move> chords;
  const auto on_circle = [](double s) {
    return AxisVector(10 * std::cos(s / 10), 10 * std::sin(s / 10), 0);
  };
  for (int i = 0; i < 1000; ++i)
    chords.push_back(rounded(Line(on_circle(kChord * i), on_circle(kChord * (i + 1))), 0.05, 0.05));
  const auto blocks = numbered(chords);
  std::vector<Row> rows;  // 0.02 mm inside, reported three blocks late
  for (int i = 3; i < 1000; i += 7) rows.push_back({i + 1, 0.998 * on_circle(kChord * (i - 3))});
  const ProgrammedPath path = driven(blocks, rows, false);
  // Joints are a sagitta more from the chords of seven lines: 0.07^2 / 80.
  CHECK(path.largest() == Approx(0.02 + 6.1e-5).epsilon(1e-3));
}

TEST_CASE("a curve is searched wherever it comes near", "[programmed]") {
  const Arc arc =
      Arc::make({{10, 0, 0}, {10, 0, 0}, {0, 0, 0}, Plane::xy, true, 0}).value();  // a circle
  std::vector<Row> rows;
  for (const double angle : {0.0, 3.0, 1.0, 6.2})
    rows.push_back({1, 9.9 * AxisVector(std::cos(angle), std::sin(angle), 0)});
  CHECK(driven(numbered({rounded(arc, 0.01)}), rows).largest() == Approx(0.1).epsilon(1e-9));
}
