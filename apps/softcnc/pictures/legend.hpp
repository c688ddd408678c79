// SPDX-License-Identifier: MIT
// What colours mean: a row of categories, and a bar of numbers.
#pragma once

#include <string>
#include <vector>

#include "pictures/canvas.hpp"
#include "pictures/colour.hpp"

namespace softcnc::app {

struct LegendEntry {
  std::string label;
  Colour colour;
  bool dashed = false;
};

/// px of a line of the heading of a plot.
inline constexpr double kHeadingLine = 20;

/// Returns how many lines a heading with a legend needs within `width` px.
int heading_lines(Canvas& canvas, const std::string& heading,
                  const std::vector<LegendEntry>& entries, double width);

/// Draws a heading, and after it the entries, in lines of kHeadingLine px. `spot` is the left upper
/// corner.
void draw_heading(Canvas& canvas, Spot spot, const std::string& heading,
                  const std::vector<LegendEntry>& entries, double width);

/// The colours of numbers from 0 to `high`.
struct ColourScale {
  std::string label;  // with the unit
  double high = 1;
  bool dark_is_high = false;
  bool has_unknown = false;  // some of the path has no number

  Colour colour(double value) const noexcept;
};

/// px that a bar needs to the right of a rectangle.
inline constexpr double kBarRight = 92;

/// Draws the bar to the right of a rectangle, as high as that.
void draw_colour_bar(Canvas& canvas, const Rectangle& beside, const ColourScale& scale);

}  // namespace softcnc::app
