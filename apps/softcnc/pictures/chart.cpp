// SPDX-License-Identifier: MIT
#include "pictures/chart.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::app {
namespace {

constexpr double kApartX = 64, kApartY = 25;  // px between ticks, at least
constexpr double kTick = 4;                   // px
const Pen kAxisPen{.colour = kFrame, .width = 1};

double placed(double value, double low, double high, double from, double to) noexcept {
  return from + (value - low) / (high - low) * (to - from);
}

}  // namespace

int most_ticks(double px, double apart) noexcept {
  return std::max(2, static_cast<int>(px / apart));
}

Chart::Chart(const Rectangle& inner, AxisRange x, AxisRange y)
    : inner_(inner), x_(std::move(x)), y_(std::move(y)) {}

double Chart::x_at(double value) const noexcept {
  return placed(value, x_.low, x_.high, inner_.x, inner_.right());
}

double Chart::y_at(double value) const noexcept {
  return placed(value, y_.low, y_.high, inner_.bottom(), inner_.y);
}

Ticks Chart::x_ticks() const {
  return round_ticks(x_.low, x_.high, most_ticks(inner_.width, kApartX));
}

Ticks Chart::y_ticks() const {
  return round_ticks(y_.low, y_.high, most_ticks(inner_.height, kApartY));
}

void Chart::draw_grid(Canvas& canvas) const {
  const Pen pen{.colour = kGrid, .width = 1};
  const Ticks along = x_ticks(), upwards = y_ticks();
  for (int i = 0; i < along.count; ++i) {
    const double x = x_at(along.at(i));
    canvas.line({x, inner_.y}, {x, inner_.bottom()}, pen);
  }
  for (int i = 0; i < upwards.count; ++i) {
    const double y = y_at(upwards.at(i));
    canvas.line({inner_.x, y}, {inner_.right(), y}, pen);
  }
}

void Chart::draw_axes(Canvas& canvas) const {
  canvas.frame(inner_, kAxisPen);
  draw_x_axis(canvas, inner_, x_);
  const Ticks ticks = y_ticks();
  for (int i = 0; i < ticks.count; ++i) {
    const double y = y_at(ticks.at(i));
    canvas.line({inner_.x - kTick, y}, {inner_.x, y}, kAxisPen);
    TextLook look = kTickLook;
    look.anchor = Anchor::right;
    canvas.text({inner_.x - kTick - 3, y + 4}, ticks.label(i), look);
  }
  TextLook look = kLabelLook;
  look.anchor = Anchor::middle;
  look.upright = true;
  canvas.text({inner_.x - kAxisLeft + 16, inner_.y + inner_.height / 2}, y_.label, look);
}

void draw_x_axis(Canvas& canvas, const Rectangle& inner, const AxisRange& range) {
  const Ticks ticks = round_ticks(range.low, range.high, most_ticks(inner.width, kApartX));
  TextLook look = kTickLook;
  look.anchor = Anchor::middle;
  for (int i = 0; i < ticks.count; ++i) {
    const double x = placed(ticks.at(i), range.low, range.high, inner.x, inner.right());
    canvas.line({x, inner.bottom()}, {x, inner.bottom() + kTick}, kAxisPen);
    canvas.text({x, inner.bottom() + kTick + 12}, ticks.label(i), look);
  }
  look = kLabelLook;
  look.anchor = Anchor::middle;
  canvas.text({inner.x + inner.width / 2, inner.bottom() + kTick + 30}, range.label, look);
}

}  // namespace softcnc::app
