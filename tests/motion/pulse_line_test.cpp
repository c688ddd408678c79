// SPDX-License-Identifier: MIT
// Lines as staircases: ends, distances and the order of the moves.
#include "motion/pulses/pulse_line.hpp"

#include <catch2/catch.hpp>

#include "support/property.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

using test::integer;
using test::Walk;

__extension__ using Wide = __int128;

/// How far the axes of a place are from where the line has them at the place's longest axis, BLU.
double off_line(const GridPoint& p, const GridPoint& way) {
  const auto further = [](std::int64_t a, std::int64_t b) { return std::abs(a) < std::abs(b); };
  const auto lead = std::max_element(way.begin(), way.end(), further) - way.begin();
  const auto a = static_cast<std::size_t>(lead);
  double off = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Wide d = Wide(p[i]) * way[a] - Wide(p[a]) * way[i];
    off = std::max(off, std::abs(static_cast<double>(d) / static_cast<double>(way[a])));
  }
  return off;
}

Walk walk_line(const GridPoint& way, PulseMethod method) {
  return Walk::along(LinePulses(way, method), {},
                     [&](const GridPoint& p) { return off_line(p, way); });
}

std::string moves(const GridPoint& way, PulseMethod method) {
  LinePulses pulses(way, method);
  std::string text;
  test::for_each_step(pulses, [&](Step step) {
    constexpr char kLetters[] = "XYZ";
    if (!text.empty()) text += ' ';
    for (int axis = 0; axis < kAxes; ++axis)
      if (step[axis] != 0)
        text += step[axis] > 0 ? kLetters[axis] : static_cast<char>(kLetters[axis] + 32);
    if (!step.is_pulse()) text += '.';
  });
  return text;
}

bool is_nearest(PulseMethod method) {
  return method == PulseMethod::dsm || method == PulseMethod::m_dsm;
}

}  // namespace

TEST_CASE("a short line by each method", "[motion][pulse]") {
  // By hand: D = 5 y - 2 x, and registers of length 5.
  CHECK(moves({5, 2, 0}, PulseMethod::sam) == "Y X X X Y X X");
  CHECK(moves({5, 2, 0}, PulseMethod::m_sam) == "XY X X XY X");
  CHECK(moves({5, 2, 0}, PulseMethod::dsm) == "X XY X XY X");
  CHECK(moves({5, 2, 0}, PulseMethod::m_dsm) == "X XY X XY X");
  CHECK(moves({5, 2, 0}, PulseMethod::dda) == "XY X XY X X");
  CHECK(moves({3, 4, 0}, PulseMethod::dda) == "XY XY Y XY");
}

TEST_CASE("lines along an axis and along the diagonal", "[motion][pulse]") {
  for (const PulseMethod method : test::kPulseMethods) {
    CAPTURE(name(method));
    CHECK(moves({0, -3, 0}, method) == "y y y");
    CHECK(moves({0, 0, 0}, method).empty());
    if (method == PulseMethod::m_sam || method == PulseMethod::m_dsm)
      CHECK(moves({-3, 0, 3}, method) == "xZ xZ xZ");
  }
}

TEST_CASE("lines end exactly, and none strays by a BLU", "[motion][pulse][property]") {
  test::holds(
      [] {
        const auto component = [] {
          const int size = integer(0, 4);
          const double most = std::pow(10.0, size);
          return std::llround(test::real(-most, most));
        };
        const GridPoint way{component(), component(), component()};
        const std::int64_t longest =
            std::max({std::abs(way[0]), std::abs(way[1]), std::abs(way[2])});
        const std::int64_t sum = std::abs(way[0]) + std::abs(way[1]) + std::abs(way[2]);
        for (const PulseMethod method : test::kPulseMethods) {
          const Walk seen = walk_line(way, method);
          RC_ASSERT(seen.at == way);
          if (longest == 0) continue;
          if (method != PulseMethod::sam) RC_ASSERT(seen.max <= (is_nearest(method) ? 0.5 : 1.0));
          if (method == PulseMethod::sam) RC_ASSERT(seen.max <= 1.0 + (way[0] && way[1] && way[2]));
          if (method == PulseMethod::sam) RC_ASSERT(seen.moves == sum);
          if (is_nearest(method)) RC_ASSERT(seen.moves == longest);
        }
      },
      200);
}

TEST_CASE("the mirror image of a line has the mirror image of its pulses",
          "[motion][pulse][property]") {
  test::holds([] {
    const GridPoint way{integer(-300, 300), integer(-300, 300), integer(-300, 300)};
    const GridPoint mirror{-way[0], way[1], -way[2]};
    for (const PulseMethod method : test::kPulseMethods) {
      std::string image = moves(mirror, method);
      for (char& c : image)
        if (std::toupper(c) == 'X' || std::toupper(c) == 'Z')
          c = static_cast<char>(std::isupper(c) ? std::tolower(c) : std::toupper(c));
      RC_ASSERT(image == moves(way, method));
    }
  });
}

TEST_CASE("the beginnings of the longest lines keep within half a BLU", "[motion][pulse]") {
  const std::int64_t n = 1LL << 31;
  const auto method = GENERATE(PulseMethod::m_dsm, PulseMethod::dsm);
  for (const GridPoint& way : {GridPoint{n, n - 1, 0}, GridPoint{1 - n, n, n / 3},
                               GridPoint{LinePulses::kFurthest, -LinePulses::kFurthest / 7, 1}}) {
    LinePulses pulses(way, method);
    std::vector<Step> steps(1'000'000);
    GridPoint at{};
    REQUIRE(pulses.fill(steps) == steps.size());
    double worst = 0;
    for (const Step step : steps) {
      advance(at, step);
      worst = std::max(worst, off_line(at, way));
    }
    CHECK(worst <= 0.5);
  }
}

TEST_CASE("a line of 2^31 BLU ends exactly", "[motion][pulse][.slow]") {
  const GridPoint way{1LL << 31, -1'234'567'891, 987'654'321};
  const auto method = GENERATE(PulseMethod::m_dsm, PulseMethod::dsm);
  const Walk seen = walk_line(way, method);
  CHECK(seen.at == way);
  CHECK(seen.moves == way[0]);
  CHECK(seen.max <= 0.5);
}

TEST_CASE("DDA takes one clock for each BLU of the line", "[motion][pulse]") {
  for (const GridPoint& way :
       {GridPoint{3000, 4000, 0}, GridPoint{0, 5000, 0}, GridPoint{-2000, 1000, 2000}}) {
    const double length = std::hypot(static_cast<double>(way[0]), static_cast<double>(way[1]),
                                     static_cast<double>(way[2]));
    CHECK(static_cast<double>(walk_line(way, PulseMethod::dda).places - 1) ==
          Approx(length).margin(2));
  }
}

}  // namespace softcnc
