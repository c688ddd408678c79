// SPDX-License-Identifier: MIT
#include "pictures/legend.hpp"

#include <algorithm>
#include <cmath>

#include "pictures/chart.hpp"
#include "pictures/ticks.hpp"

namespace softcnc::app {
namespace {

constexpr double kSwatch = 12, kAfterSwatch = 5, kBetween = 16;  // px
constexpr double kBarGap = 16, kBarWidth = 14;                   // px

/// Calls place(entry, spot) for the heading and each entry: without an entry, the heading.
template <typename Place>
int arrange(Canvas& canvas, const std::string& heading, const std::vector<LegendEntry>& entries,
            double width, Place&& place) {
  place(nullptr, Spot{0, 0});
  double x = canvas.text_width(heading, kHeadingLook) + kBetween;
  int line = 0;
  for (const LegendEntry& entry : entries) {
    const double needed =
        kSwatch + kAfterSwatch + canvas.text_width(entry.label, kTickLook) + kBetween;
    if (x > 0 && x + needed - kBetween > width) {
      x = 0;
      ++line;
    }
    place(&entry, Spot{x, line * kHeadingLine});
    x += needed;
  }
  return line + 1;
}

void draw_swatch(Canvas& canvas, Spot spot, const LegendEntry& entry) {
  const double y = spot.y + kHeadingLine / 2;
  if (entry.dashed)
    canvas.line({spot.x, y}, {spot.x + kSwatch, y},
                {.colour = entry.colour, .width = 2, .dashed = true});
  else
    canvas.fill({spot.x, y - 5, kSwatch, 10}, entry.colour);
  canvas.text({spot.x + kSwatch + kAfterSwatch, y + 4}, entry.label, kTickLook);
}

}  // namespace

int heading_lines(Canvas& canvas, const std::string& heading,
                  const std::vector<LegendEntry>& entries, double width) {
  return arrange(canvas, heading, entries, width, [](const LegendEntry*, Spot) {});
}

void draw_heading(Canvas& canvas, Spot spot, const std::string& heading,
                  const std::vector<LegendEntry>& entries, double width) {
  arrange(canvas, heading, entries, width, [&](const LegendEntry* entry, Spot at) {
    const Spot placed{spot.x + at.x, spot.y + at.y};
    if (entry != nullptr)
      draw_swatch(canvas, placed, *entry);
    else
      canvas.text({placed.x, placed.y + kHeadingLine / 2 + 4.5}, heading, kHeadingLook);
  });
}

Colour ColourScale::colour(double value) const noexcept {
  if (std::isnan(value)) return kUnknownColour;
  const double part = std::clamp(value / high, 0.0, 1.0);
  return shade(dark_is_high ? 1 - part : part);
}

void draw_colour_bar(Canvas& canvas, const Rectangle& beside, const ColourScale& scale) {
  const Rectangle bar{beside.right() + kBarGap, beside.y, kBarWidth, beside.height};
  const int steps = std::max(2, static_cast<int>(bar.height / 2));
  const double high = bar.height / steps;
  for (int i = 0; i < steps; ++i)  // from the top; each goes on below the next one
    canvas.fill({bar.x, bar.y + i * high, bar.width, bar.height - i * high},
                scale.colour(scale.high * (steps - 1 - i) / (steps - 1)));
  const Pen pen{.colour = kFrame, .width = 1};
  canvas.frame(bar, pen);
  const Ticks ticks = round_ticks(0, scale.high, most_ticks(bar.height, 34));
  for (int i = 0; i < ticks.count; ++i) {
    const double y = bar.bottom() - ticks.at(i) / scale.high * bar.height;
    canvas.line({bar.right(), y}, {bar.right() + 4, y}, pen);
    canvas.text({bar.right() + 7, y + 4}, ticks.label(i), kTickLook);
  }
  TextLook look = kLabelLook;
  look.anchor = Anchor::middle;
  look.upright = true;
  canvas.text({bar.right() + 60, bar.y + bar.height / 2}, scale.label, look);
}

}  // namespace softcnc::app
