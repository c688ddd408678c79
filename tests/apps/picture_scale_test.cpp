// SPDX-License-Identifier: MIT
// Ticks, colours and lines of pictures.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "pictures/canvas.hpp"
#include "pictures/colour.hpp"
#include "pictures/line_thinning.hpp"
#include "pictures/ticks.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::test;

namespace {

/// L* of CIELAB, from sRGB (IEC 61966-2-1) by the luminance of Rec. 709.
double lightness(Colour colour) {
  const auto linear = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y =
      0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
  return 116 * std::cbrt(y) - 16;
}

/// The first digit of a number, if all others are 0; otherwise 0.
int only_digit(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  const double digit = value / power;
  return std::abs(digit - std::round(digit)) < 1e-6 ? static_cast<int>(std::lround(digit)) : 0;
}

}  // namespace

TEST_CASE("ticks are round, within the range, and as many as fit", "[apps][pictures]") {
  holds(
      [] {
        const double size = std::pow(10.0, real(-6, 7));
        const double low = real(-1, 1) * size, high = low + real(0.01, 1) * size;
        const int most = integer(2, 20);
        const Ticks ticks = round_ticks(low, high, most);
        RC_ASSERT(ticks.count <= most);
        const int digit = only_digit(ticks.step);
        RC_ASSERT((digit == 1 || digit == 2 || digit == 5));
        const double slack = 1e-6 * ticks.step;
        for (int i = 0; i < ticks.count; ++i) {
          RC_ASSERT(ticks.at(i) >= low - slack);
          RC_ASSERT(ticks.at(i) <= high + slack);
          RC_ASSERT(std::abs(std::stod(ticks.label(i)) - ticks.at(i)) < slack);
        }
        RC_ASSERT((ticks.first - 1) * ticks.step < low);
        RC_ASSERT(ticks.at(ticks.count) > high);
        const double finer = digit == 5 ? ticks.step * 0.4 : ticks.step / 2;
        const auto finer_ones = std::floor(high / finer) - std::ceil(low / finer) + 1;
        RC_ASSERT((finer_ones > most || (high - low) / finer > most));
      },
      500);
}

TEST_CASE("ticks have the labels that a reader expects", "[apps][pictures]") {
  const Ticks quarter = round_ticks(0, 1, 6);
  CHECK(quarter.label(1) == "0.2");
  CHECK(quarter.label(5) == "1.0");
  const Ticks around = round_ticks(-25, 25, 6);
  CHECK(around.label(0) == "-20");
  CHECK(around.label(2) == "0");
  CHECK(round_ticks(0, 15000, 4).label(1) == "5000");
}

TEST_CASE("durations have a unit that suits them", "[apps][pictures]") {
  CHECK(time_unit(300).name == "s");
  CHECK(time_unit(301).name == "min");
  CHECK(time_unit(5 * 3600).seconds == 60);
  CHECK(time_unit(5 * 3600 + 1).name == "h");
}

TEST_CASE("the lightness of the scale rises evenly", "[apps][pictures]") {
  for (int i = 0; i <= 60; ++i) {
    CAPTURE(i);
    CHECK(lightness(shade(i / 60.0)) == Approx(20 + i).margin(1));
  }
  CHECK(shade(-1) == shade(0));
  CHECK(shade(2) == shade(1));
}

TEST_CASE("each limit has a colour and a name of its own", "[apps][pictures]") {
  std::set<std::array<int, 3>> colours;
  std::set<std::string_view> names;
  for (int i = 0; i < kLimits; ++i) {
    const Colour colour = limit_colour(static_cast<Limit>(i));
    colours.insert({colour.red, colour.green, colour.blue});
    names.insert(limit_label(static_cast<Limit>(i)));
  }
  CHECK(colours.size() == kLimits);
  CHECK(names.size() == kLimits);
}

TEST_CASE("a faded colour lies between white and itself", "[apps][pictures]") {
  CHECK(faded({10, 20, 30}, 1) == Colour{10, 20, 30});
  CHECK(faded({10, 20, 30}, 0) == Colour{255, 255, 255});
  CHECK(faded({55, 155, 255}, 0.5) == Colour{155, 205, 255});
}

TEST_CASE("a line over time keeps its lowest and highest spot in each column", "[apps][pictures]") {
  holds([] {
    const int count = integer(1, 2000);
    LineThinning thinning(0.5);
    std::vector<Spot> all;
    double x = 0;
    for (int i = 0; i < count; ++i) {
      x += real(0, 0.05);
      all.push_back({x, real(-100, 100)});
      thinning.add(all.back());
    }
    const std::vector<Spot> kept = thinning.take();
    RC_ASSERT(kept.front() == all.front());
    RC_ASSERT(kept.back() == all.back());
    RC_ASSERT(static_cast<double>(kept.size()) <= 4 * (x / 0.5 + 1));
    std::size_t at = 0;  // what is kept is a part of the line, in its order
    for (const Spot& spot : kept) {
      while (at < all.size() && !(all[at] == spot)) ++at;
      RC_ASSERT(at < all.size());
      ++at;
    }
    for (const Spot& spot : all) {  // and reaches as far as each spot, within its column
      bool above = false, below = false;
      for (const Spot& other : kept) {
        if (std::abs(other.x - spot.x) > 0.5) continue;
        above = above || other.y <= spot.y;
        below = below || other.y >= spot.y;
      }
      RC_ASSERT(above);
      RC_ASSERT(below);
    }
  });
}

TEST_CASE("a straightened line is nowhere farther away than allowed", "[apps][pictures]") {
  CHECK(straightened({{0, 0}, {1, 0.05}, {2, 0}, {3, 0}}, 0.1) ==
        std::vector<Spot>{{0, 0}, {3, 0}});
  CHECK(straightened({{0, 0}, {1, 0.5}, {2, 0}}, 0.1).size() == 3);
  std::vector<Spot> circle;
  for (int i = 0; i <= 1000; ++i)
    circle.push_back({100 * std::cos(i * 0.006), 100 * std::sin(i * 0.006)});
  const auto kept = straightened(circle, 0.1);
  // Arrow 0.1 of radius 100: chords of at most 2 sqrt(2 100 0.1) = 8.9, of an arc of 600.
  CHECK(kept.size() >= 68);
  CHECK(kept.size() < 200);
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const double chord = std::hypot(kept[i].x - kept[i - 1].x, kept[i].y - kept[i - 1].y);
    CHECK(chord * chord / 800 <= 0.1 * 1.01);
  }
}

TEST_CASE("long names keep their end", "[apps][pictures]") {
  Canvas canvas(300, 100, PictureFormat::svg);
  const TextLook look{.size = 12};
  const std::string name = "a/very/long/folder/with/a/Größe/part.nc";
  CHECK(canvas.shortened(name, look, 1000) == name);
  const std::string shorter = canvas.shortened(name, look, 100);
  CHECK(canvas.text_width(shorter, look) <= 100);
  CHECK(shorter.substr(0, 3) == "...");
  CHECK(shorter.substr(shorter.size() - 7) == "part.nc");
  CHECK(canvas.text_width("softcnc", look) < canvas.text_width("softcnc softcnc", look));
}
