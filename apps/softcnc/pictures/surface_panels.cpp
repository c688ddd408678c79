// SPDX-License-Identifier: MIT
#include "pictures/surface_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"
#include "pictures/chart.hpp"
#include "pictures/legend.hpp"
#include "pictures/line_thinning.hpp"

namespace softcnc::app {
namespace {

constexpr double kWidth = 1000, kSheetMargin = 16, kBetweenPanels = 20, kTitle = 46;  // px
constexpr double kColumn = (kWidth - 2 * kSheetMargin - kBetweenPanels) / 2;
constexpr double kInner = kColumn - kAxisLeft - kBarRight;  // px: the longer side of a map
constexpr double kProfile = 110;                            // px
constexpr double kLeastNumber = 30;                         // px of a region with a number in it
const Colour kGouged{204, 51, 17}, kMissed{204, 51, 17}, kProfileColour{0, 114, 178};

/// A rectangle of the grid, and where its map is drawn.
struct MapArea {
  Rectangle inner;
  double x = 0, y = 0, width = 0, height = 0;  // mm

  /// As large as a square of kInner allows, at the top of a column.
  MapArea(Spot corner, double from_x, double from_y, double wide, double high)
      : x(from_x), y(from_y), width(wide), height(high) {
    const double scale = kInner / std::max(wide, high);
    inner = {corner.x + kAxisLeft, corner.y + kHeadingLine + 6, std::max(1.0, wide * scale),
             std::max(1.0, high * scale)};
  }

  Chart chart() const { return {inner, {"X, mm", x, x + width}, {"Y, mm", y, y + height}}; }
};

class SurfacePage {
 public:
  SurfacePage(const surface::StockGrid& grid, const SurfaceMiddle& middle,
              const surface::RoughnessMap& map)
      : grid_(grid),
        middle_(middle),
        map_(map),
        canvas_(kWidth, page_height(), PictureFormat::png) {}

  Result<std::string> draw(const std::string& title, const Pixels& lit) {
    const TextLook look{.size = 15, .bold = true};
    canvas_.text({kSheetMargin, kSheetMargin + 16},
                 canvas_.shortened(title, look, kWidth - 2 * kSheetMargin), look);
    draw_whole({kSheetMargin, kTitle}, lit);
    draw_middle({kSheetMargin + kColumn + kBetweenPanels, kTitle});
    const double second = kTitle + kHeadingLine + 6 + kInner + kAxisBelow + 16;
    draw_rmax({kSheetMargin, second});
    draw_profiles({kSheetMargin + kColumn + kBetweenPanels, second});
    return canvas_.bytes();
  }

 private:
  static double page_height() {
    return std::ceil(kTitle + 2 * (kHeadingLine + 6 + kInner + kAxisBelow + 16) + kHeadingLine);
  }

  void heading(Spot corner, const std::string& text, const std::vector<LegendEntry>& entries = {}) {
    draw_heading(canvas_, corner, text, entries, kColumn);
  }

  MapArea whole(Spot corner) const {
    return {corner, grid_.corner[0], grid_.corner[1], (grid_.columns - 1) * grid_.step,
            (grid_.rows - 1) * grid_.step};
  }

  void draw_whole(Spot corner, const Pixels& lit) {
    heading(corner, fmt::format("Surface, its roughness {:.0f} times as steep", kRelief));
    const MapArea area = whole(corner);
    canvas_.image(area.inner, lit);
    area.chart().draw_axes(canvas_);
  }

  void draw_middle(Spot corner) {
    heading(corner, "Its middle, by height above the ideal surface");
    const MapArea area(corner, grid_.corner[0] + middle_.first_column * grid_.step,
                       grid_.corner[1] + middle_.first_row * grid_.step,
                       middle_.columns * grid_.step, middle_.rows * grid_.step);
    const ColourScale scale = bar("height, µm", um_from_mm(middle_.highest()));
    Pixels pixels(middle_.columns, middle_.rows, kUnknownColour);
    for (int row = 0; row < middle_.rows; ++row)
      for (int column = 0; column < middle_.columns; ++column) {
        const float here = middle_.at(column, row);
        const float right = middle_.at(std::min(column + 1, middle_.columns - 1), row);
        const float above = middle_.at(column, std::min(row + 1, middle_.rows - 1));
        if (std::isnan(here + right + above)) continue;
        const double relief = kRelief / grid_.step;
        const double light = surface_light(relief * static_cast<double>(right - here),
                                           relief * static_cast<double>(above - here));
        pixels.at(column, middle_.rows - 1 - row) =
            lit_colour(scale.colour(um_from_mm(static_cast<double>(here))), 0.35 + 0.8 * light);
      }
    canvas_.image(area.inner, pixels);
    area.chart().draw_axes(canvas_);
    draw_colour_bar(canvas_, area.inner, scale);
  }

  static ColourScale bar(const std::string& label, double high) {
    return {label, high > 0 ? high : 1, false, false};
  }

  void draw_rmax(Spot corner) {
    const std::vector<float> rmax = map_.rmax(), gouges = map_.gouges(), met = map_.met();
    const surface::RegionFigures known = surface::figures(rmax);
    const surface::TargetFigures target = surface::target_figures(map_);
    std::vector<LegendEntry> entries;
    if (std::ranges::any_of(rmax, [](float value) { return std::isnan(value); }))
      entries.push_back({"unknown", kUnknownColour});
    if (surface::figures(gouges).marked > 0) entries.push_back({"gouged", kGouged});
    if (target.missed > 0) entries.push_back({"framed: above its target", kMissed});
    heading(corner, "Rmax by region", entries);
    const double region = map_.side() * grid_.step;
    const MapArea area(corner, grid_.corner[0], grid_.corner[1], map_.columns() * region,
                       map_.rows() * region);
    const ColourScale scale = bar("Rmax, µm", known.largest);
    Pixels pixels(map_.columns(), map_.rows(), kUnknownColour);
    for (int row = 0; row < map_.rows(); ++row)
      for (int column = 0; column < map_.columns(); ++column) {
        const std::size_t at = region_index(column, row);
        Colour& pixel = pixels.at(column, map_.rows() - 1 - row);
        if (gouges[at] > 0)
          pixel = kGouged;
        else if (!std::isnan(rmax[at]))
          pixel = scale.colour(static_cast<double>(rmax[at]));
      }
    canvas_.image(area.inner, pixels);
    write_regions(area, rmax);
    area.chart().draw_axes(canvas_);
    frame_missed(area, met);
    draw_colour_bar(canvas_, area.inner, scale);
    canvas_.text({corner.x, area.inner.bottom() + kAxisBelow + 10}, rmax_text(known, target),
                 kTickLook);
  }

  std::size_t region_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.columns()) +
           static_cast<std::size_t>(column);
  }

  Rectangle region_area(const MapArea& area, int column, int row) const {
    const double wide = area.inner.width / map_.columns(), high = area.inner.height / map_.rows();
    return {area.inner.x + column * wide, area.inner.bottom() - (row + 1) * high, wide, high};
  }

  static std::string rmax_text(const surface::RegionFigures& known,
                               const surface::TargetFigures& target) {
    if (known.regions == 0) return "Rmax is not known of any region";
    std::string text =
        fmt::format("Rmax at most {:.1f} µm, mean {:.1f} µm", known.largest, known.mean);
    if (target.judged > 0)
      text += fmt::format("; target met in {} of {} regions", target.judged - target.missed,
                          target.judged);
    return text;
  }

  /// Writes Rmax, and the target below it, into each region that is large enough.
  void write_regions(const MapArea& area, const std::vector<float>& rmax) {
    const std::vector<float> targets = map_.targets();
    for (int row = 0; row < map_.rows(); ++row)
      for (int column = 0; column < map_.columns(); ++column) {
        const Rectangle cell = region_area(area, column, row);
        const auto value = static_cast<double>(rmax[region_index(column, row)]);
        if (std::min(cell.width, cell.height) < kLeastNumber || std::isnan(value)) continue;
        const bool light = value > 0.55 * surface::figures(rmax).largest;
        const auto target = static_cast<double>(targets[region_index(column, row)]);
        const TextLook look{.size = 9, .colour = light ? kInk : kPaper, .anchor = Anchor::middle};
        const Spot middle{cell.x + cell.width / 2, cell.y + cell.height / 2};
        if (std::isnan(target)) {
          canvas_.text({middle.x, middle.y + 3}, fmt::format("{:.1f}", value), look);
          continue;
        }
        canvas_.text({middle.x, middle.y - 2}, fmt::format("{:.1f}", value), look);
        canvas_.text({middle.x, middle.y + 9}, fmt::format("≤ {:.3g}", target), look);
      }
  }

  void frame_missed(const MapArea& area, const std::vector<float>& met) {
    for (int row = 0; row < map_.rows(); ++row)
      for (int column = 0; column < map_.columns(); ++column)
        if (met[region_index(column, row)] == 0)
          canvas_.frame(region_area(area, column, row), {.colour = kMissed, .width = 1.2});
  }

  void draw_profiles(Spot corner) {
    const int row = middle_.rows / 2, column = middle_.columns / 2;
    draw_profile(corner, "Profile along X through the middle", "X, mm",
                 grid_.corner[0] + middle_.first_column * grid_.step, middle_.columns,
                 [&](int i) { return middle_.at(i, row); });
    draw_profile({corner.x, corner.y + kHeadingLine + 6 + kProfile + kAxisBelow + 14},
                 "Profile along Y through the middle", "Y, mm",
                 grid_.corner[1] + middle_.first_row * grid_.step, middle_.rows,
                 [&](int i) { return middle_.at(column, i); });
  }

  template <typename Value>
  void draw_profile(Spot corner, const std::string& text, const std::string& axis, double from,
                    int count, Value&& value) {
    heading(corner, text);
    const Rectangle inner{corner.x + kAxisLeft, corner.y + kHeadingLine + 6,
                          kColumn - kAxisLeft - kSheetMargin, kProfile};
    const double most = std::max(um_from_mm(middle_.highest()), 1e-3);
    const Chart chart(inner, {axis, from, from + count * grid_.step},
                      {"height, µm", 0, 1.06 * most});
    chart.draw_grid(canvas_);
    canvas_.clip(inner);
    LineThinning line(0.5);
    const Pen pen{.colour = kProfileColour, .width = 1.3};
    for (int i = 0; i < count; ++i) {
      const auto um = um_from_mm(static_cast<double>(value(i)));
      if (std::isnan(um))
        canvas_.line(line.take(), pen);
      else
        line.add(chart.at(from + i * grid_.step, um));
    }
    canvas_.line(line.take(), pen);
    canvas_.unclip();
    chart.draw_axes(canvas_);
  }

  const surface::StockGrid& grid_;
  const SurfaceMiddle& middle_;
  const surface::RoughnessMap& map_;
  Canvas canvas_;
};

}  // namespace

void SurfaceMiddle::count_from_lowest() noexcept {
  float lowest = 0;
  for (const float value : deviations)
    if (!std::isnan(value)) lowest = std::min(lowest, value);
  for (float& value : deviations) value -= lowest;
}

double SurfaceMiddle::highest() const noexcept {
  float most = 0;
  for (const float value : deviations)
    if (!std::isnan(value)) most = std::max(most, value);
  return static_cast<double>(most);
}

double surface_light(double slope_x, double slope_y) noexcept {
  constexpr double kX = -0.48, kY = 0.36, kZ = 0.8;
  return std::max(0.0, (-slope_x * kX - slope_y * kY + kZ) /
                           std::sqrt(1 + slope_x * slope_x + slope_y * slope_y));
}

Colour surface_grey(double light) noexcept {
  const auto byte = [light](double dark) {
    return static_cast<std::uint8_t>(
        std::clamp(std::lround(255 * (dark + 0.80 * light)), 0L, 255L));
  };
  return {byte(0.12), byte(0.14), byte(0.17)};
}

Result<std::string> draw_surface(const std::string& title, const surface::StockGrid& grid,
                                 const Pixels& lit, const SurfaceMiddle& middle,
                                 const surface::RoughnessMap& map) {
  return SurfacePage(grid, middle, map).draw(title, lit);
}

}  // namespace softcnc::app
