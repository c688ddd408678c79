// SPDX-License-Identifier: MIT
// Labelled axes around a rectangle, and where numbers lie in it.
#pragma once

#include <string>

#include "pictures/canvas.hpp"
#include "pictures/ticks.hpp"

namespace softcnc::app {

/// px that labels need to the left and below of the rectangle.
inline constexpr double kAxisLeft = 76, kAxisBelow = 44;

inline constexpr TextLook kTickLook{.size = 11, .colour = kFaintInk},
    kLabelLook{.size = 12, .colour = kInk}, kHeadingLook{.size = 13, .bold = true};

/// Factors from the units of a run to those of a label.
inline constexpr double kPercent = 100, kMinute = 60;
/// um that a scale of errors has at least: less is rounding.
inline constexpr double kLeastError = 0.001;
/// px beside a plot without a bar, and those that a line may be off where it is made of fewer
/// parts.
inline constexpr double kRight = 24, kStraight = 0.1;

/// The numbers of an axis, with what they are and their unit: "time, s".
struct AxisRange {
  std::string label;
  double low = 0, high = 1;
};

class Chart {
 public:
  /// `inner` is where the data is drawn.
  Chart(const Rectangle& inner, AxisRange x, AxisRange y);

  const Rectangle& inner() const noexcept { return inner_; }
  double x_at(double value) const noexcept;
  double y_at(double value) const noexcept;
  Spot at(double x, double y) const noexcept { return {x_at(x), y_at(y)}; }

  /// Draws the lines of the grid, below the data.
  void draw_grid(Canvas& canvas) const;
  /// Draws the frame, the ticks and the labels, on top of the data.
  void draw_axes(Canvas& canvas) const;

 private:
  Ticks x_ticks() const;
  Ticks y_ticks() const;

  Rectangle inner_;
  AxisRange x_, y_;
};

/// How many ticks a length of so many px has at most.
int most_ticks(double px, double apart) noexcept;

/// Draws the axis of the x alone below a rectangle.
void draw_x_axis(Canvas& canvas, const Rectangle& inner, const AxisRange& range);

}  // namespace softcnc::app
