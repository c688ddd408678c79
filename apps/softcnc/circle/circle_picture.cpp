// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "circle/circle_test.hpp"
#include "motion/core/units.hpp"
#include "pictures/canvas.hpp"
#include "pictures/chart.hpp"
#include "pictures/legend.hpp"
#include "pictures/ticks.hpp"

namespace softcnc::app {
namespace {

constexpr double kCircleMargin = 16, kHeading = 46;  // px
constexpr double kRing = 0.7;               // of the space around the centre: the nominal circle
constexpr double kHighestDeviation = 0.25;  // of it, at most: a deviation
constexpr int kBins = 1440;                 // of a turn: a line of more points would not show more

/// A polar plot: the nominal circle, and deviations from it on a larger scale.
struct Polar {
  Spot centre;
  double ring;    // px
  double per_mm;  // px of a deviation

  Spot at(double angle, double deviation) const {
    const double radius = std::max(0.0, ring + per_mm * deviation);
    return {centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
  }
};

double largest_deviation(const MeasuredCircle& circle) {
  double largest = 0;
  for (const MeasuredPass& pass : circle.passes)
    largest =
        std::max({largest, std::abs(pass.figures.outermost), std::abs(pass.figures.innermost)});
  return largest;
}

std::vector<Spot> round_line(const Polar& polar, double deviation) {
  std::vector<Spot> spots;
  for (int i = 0; i <= kBins / 4; ++i)
    spots.push_back(polar.at(kTurn * i / (kBins / 4), deviation));
  return spots;
}

/// The points of a profile, of each bin the innermost and the outermost.
std::vector<Spot> thinned(const Polar& polar,
                          const std::vector<runtime::RadialDeviation>& profile) {
  std::vector<Spot> spots;
  for (std::size_t begin = 0; begin < profile.size();) {
    const auto bin = [](double angle) { return std::floor(angle / kTurn * kBins); };
    std::size_t end = begin, low = begin, high = begin;
    for (; end < profile.size() && bin(profile[end].angle) == bin(profile[begin].angle); ++end) {
      if (profile[end].deviation < profile[low].deviation) low = end;
      if (profile[end].deviation > profile[high].deviation) high = end;
    }
    const auto [first, second] = std::minmax(low, high);
    spots.push_back(polar.at(profile[first].angle, profile[first].deviation));
    if (second != first)
      spots.push_back(polar.at(profile[second].angle, profile[second].deviation));
    begin = end;
  }
  return spots;
}

void draw_grid(Canvas& canvas, const Polar& polar, double step, runtime::CirclePlane plane) {
  const double end = polar.ring / kRing;
  for (const int ring : {-2, -1, 1, 2})
    if (polar.ring + polar.per_mm * ring * step < end)
      canvas.line(round_line(polar, ring * step), {.colour = kGrid});
  canvas.line({polar.centre.x - end, polar.centre.y}, {polar.centre.x + end, polar.centre.y},
              {.colour = kGrid});
  canvas.line({polar.centre.x, polar.centre.y - end}, {polar.centre.x, polar.centre.y + end},
              {.colour = kGrid});
  canvas.line(round_line(polar, 0), {.colour = kFrame});
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = kTurn / 4 * static_cast<double>(i);
    const Spot spot{polar.centre.x + end * std::cos(angle), polar.centre.y - end * std::sin(angle)};
    canvas.text({spot.x + 4, spot.y - 4}, side_name(plane, i), kLabelLook);
  }
}

std::vector<LegendEntry> legend_of(const MeasuredCircle& circle) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < circle.passes.size(); ++i) {
    const runtime::CirclePass& pass = circle.passes[i].pass;
    entries.push_back(
        {fmt::format("{}, line {}", pass.clockwise ? "clockwise" : "anticlockwise", pass.line),
         category_colour(i)});
  }
  return entries;
}

/// The largest of 1, 2 and 5 times a power of ten that is at most `value`.
double round_below(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return value >= 5 * power ? 5 * power : value >= 2 * power ? 2 * power : power;
}

}  // namespace

Result<std::string> circle_picture(const CircleTest& test, const PictureOptions& options,
                                   PictureFormat format) {
  const MeasuredCircle& circle = test.circles.front();
  const double width = options.size.width, wanted = options.size.height;
  Canvas canvas(width, wanted > 0 ? wanted : width, format);
  const double space =
      std::min(width, canvas.height() - kHeading) / 2 - kCircleMargin - kTickLook.size;
  const double largest = std::max(largest_deviation(circle), 1e-6);
  const double step = round_below(largest);
  const Polar polar{{width / 2, kHeading + (canvas.height() - kHeading) / 2},
                    kRing * space,
                    kHighestDeviation * space / largest};
  const double nominal = circle.passes.front().pass.radius;
  draw_heading(canvas, {kCircleMargin, kCircleMargin},
               fmt::format("Circle R {:.6g} mm, deviation x {:.0f}: {:.3g} um a ring", nominal,
                           nominal / polar.ring * polar.per_mm, um_from_mm(step)),
               legend_of(circle), width - 2 * kCircleMargin);
  draw_grid(canvas, polar, step, test.plane);
  for (std::size_t i = 0; i < circle.passes.size(); ++i)
    canvas.line(thinned(polar, circle.passes[i].figures.profile),
                {.colour = category_colour(i), .width = 1.4});
  return canvas.bytes();
}

}  // namespace softcnc::app
