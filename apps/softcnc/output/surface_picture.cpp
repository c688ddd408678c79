// SPDX-License-Identifier: MIT
#include "output/surface_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "motion/core/units.hpp"

namespace softcnc::app {
namespace {

constexpr int kSide = 560, kMargin = 40, kHead = 60;
constexpr int kWidth = 2 * kSide + 4 * kMargin;
constexpr int kHeight = 2 * kSide + 2 * kHead + 2 * kMargin;
constexpr int kScale = 2;          // of letters
constexpr int kMiddleRegions = 6;  // along a side of what is enlarged
constexpr double kRelief = 8;      // roughness is shown so much steeper than it is
constexpr OldColour kPaper{250, 250, 248}, kInk{30, 30, 34}, kFaint{205, 205, 208},
    kNothing{226, 226, 230}, kLine{20, 80, 170}, kGouged{208, 38, 38}, kMissed{240, 60, 40};

std::uint8_t byte(double value) noexcept {
  return static_cast<std::uint8_t>(std::clamp(std::lround(255 * value), 0L, 255L));
}

/// Light from the left, above: of a surface with these slopes.
double lit(double slope_x, double slope_y) noexcept {
  constexpr double kX = -0.48, kY = 0.36, kZ = 0.8;
  return std::max(0.0, (-slope_x * kX - slope_y * kY + kZ) /
                           std::sqrt(1 + slope_x * slope_x + slope_y * slope_y));
}

OldColour grey(double light) noexcept {
  return {byte(0.12 + 0.80 * light), byte(0.14 + 0.80 * light), byte(0.17 + 0.80 * light)};
}

/// From dark blue over green to yellow, 0 to 1.
OldColour heat(double value) noexcept {
  const double v = std::clamp(value, 0.0, 1.0);
  return {byte(v < 0.5 ? 0.25 - 0.2 * v : 0.15 + 1.6 * (v - 0.5)), byte(0.05 + 0.85 * v),
          byte(v < 0.5 ? 0.35 + 0.4 * v : 0.55 - 0.9 * (v - 0.5))};
}

/// The same, lit.
OldColour lit_heat(double value, double light) noexcept {
  const OldColour base = heat(value);
  const double part = 0.35 + 0.8 * light;
  const auto dim = [part](std::uint8_t c) { return byte(part * c / 255.0); };
  return {dim(base.red), dim(base.green), dim(base.blue)};
}

struct Frame {
  int x, y, width, height;
};

/// As large as a square allows, whole pixels for each of columns and rows where there are few.
Frame fitted(int left, int top, double columns, double rows) {
  const double scale = kSide / std::max(columns, rows);
  return {left, top, std::max(1, static_cast<int>(columns * scale)),
          std::max(1, static_cast<int>(rows * scale))};
}

/// Calls paint(i, j, x, y) for each pixel; i and j are column and row, rows count upwards.
template <typename Paint>
void each_pixel(const Frame& frame, int columns, int rows, Paint&& paint) {
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      paint(static_cast<int>(static_cast<std::int64_t>(x) * columns / frame.width),
            static_cast<int>(static_cast<std::int64_t>(frame.height - 1 - y) * rows / frame.height),
            frame.x + x, frame.y + y);
}

void title(OldCanvas& canvas, int left, int top, const std::string& text) {
  canvas.write(left, top - 12 * kScale, text, kScale, kInk);
}

/// Draws a red frame around each region that is rougher than its target, where there is space.
void frame_missed(OldCanvas& canvas, const Frame& frame, const surface::RoughnessMap& map) {
  const std::vector<float> met = map.met();
  const auto at = [](int i, int pixels, int count) {
    return static_cast<int>(static_cast<std::int64_t>(i) * pixels / count);
  };
  for (int j = 0; j < map.rows(); ++j)
    for (int i = 0; i < map.columns(); ++i) {
      const std::size_t region =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(map.columns()) +
          static_cast<std::size_t>(i);
      if (met[region] != 0) continue;
      const int x0 = at(i, frame.width, map.columns()), x1 = at(i + 1, frame.width, map.columns());
      const int y0 = at(j, frame.height, map.rows()), y1 = at(j + 1, frame.height, map.rows());
      canvas.frame(frame.x + x0, frame.y + frame.height - y1, std::max(1, x1 - x0),
                   std::max(1, y1 - y0), kMissed);
    }
}

/// The lowest value, if that is below 0.
float base_of(const std::vector<float>& values) {
  float least = 0;
  for (const float value : values)
    if (!std::isnan(value)) least = std::min(least, value);
  return least;
}

float highest_of(const std::vector<float>& values) {
  float most = 0;
  for (const float value : values)
    if (!std::isnan(value)) most = std::max(most, value);
  return most;
}

}  // namespace

SurfacePicture::SurfacePicture(const surface::StockGrid& grid, int region)
    : grid_(grid),
      columns_(std::min(grid.columns, kSide)),
      rows_(std::min(grid.rows, kSide)),
      middle_columns_(std::min({grid.columns, kMiddleRegions * region, 2 * kSide})),
      middle_rows_(std::min({grid.rows, kMiddleRegions * region, 2 * kSide})) {
  if (grid.columns > grid.rows)
    rows_ = std::max(1, std::min(grid.rows, static_cast<int>(static_cast<std::int64_t>(columns_) *
                                                             grid.rows / grid.columns)));
  if (grid.rows > grid.columns)
    columns_ = std::max(
        1, std::min(grid.columns,
                    static_cast<int>(static_cast<std::int64_t>(rows_) * grid.columns / grid.rows)));
  middle_column_ = (grid.columns - middle_columns_) / 2;
  middle_row_ = (grid.rows - middle_rows_) / 2;
  light_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  points_.assign(light_.size(), 0);
  middle_.assign(static_cast<std::size_t>(middle_columns_) * static_cast<std::size_t>(middle_rows_),
                 std::numeric_limits<float>::quiet_NaN());
}

void SurfacePicture::add(const surface::SurfaceBand& band) {
  shade(band);
  keep_middle(band);
}

/// Every point is lit; a pixel is what its points are in the mean.
void SurfacePicture::shade(const surface::SurfaceBand& band) {
  const auto step = static_cast<float>(grid_.step);
  const auto slope = [&](std::size_t a, std::size_t b) {
    const float whole = (band.heights[b] - band.heights[a]) / step;
    const float rough = (band.deviations[b] - band.deviations[a]) / step;
    return static_cast<double>(
        std::isnan(rough) ? whole : whole + (static_cast<float>(kRelief) - 1) * rough);
  };
  for (int row = 0; row + 1 < std::max(band.rows, 2); ++row)
    for (int column = 0; column + 1 < band.columns; ++column) {
      const std::size_t here = band.index(column, row);
      const std::size_t above = row + 1 < band.rows ? band.index(column, row + 1) : here;
      const auto x =
          static_cast<std::size_t>(static_cast<std::int64_t>(column) * columns_ / grid_.columns);
      const auto y = static_cast<std::size_t>(static_cast<std::int64_t>(band.first_row + row) *
                                              rows_ / grid_.rows);
      const std::size_t pixel = y * static_cast<std::size_t>(columns_) + x;
      light_[pixel] += lit(slope(here, here + 1), slope(here, above));
      ++points_[pixel];
    }
}

void SurfacePicture::keep_middle(const surface::SurfaceBand& band) {
  for (int row = 0; row < middle_rows_; ++row) {
    const int from = middle_row_ + row - band.first_row;
    if (from < 0 || from >= band.rows) continue;
    for (int column = 0; column < middle_columns_; ++column)
      middle_[static_cast<std::size_t>(row) * static_cast<std::size_t>(middle_columns_) +
              static_cast<std::size_t>(column)] =
          band.deviations[band.index(middle_column_ + column, from)];
  }
}

void SurfacePicture::draw_whole(OldCanvas& canvas) const {
  const int left = kMargin, top = kHead;
  const Frame frame = fitted(left, top, columns_, rows_);
  each_pixel(frame, columns_, rows_, [&](int i, int j, int x, int y) {
    const std::size_t pixel = static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                              static_cast<std::size_t>(i);
    if (points_[pixel] > 0) canvas.set(x, y, grey(light_[pixel] / points_[pixel]));
  });
  canvas.frame(frame.x - 1, frame.y - 1, frame.width + 2, frame.height + 2, kInk);
  title(canvas, left, top,
        fmt::format("surface {:.4g} x {:.4g} mm", (grid_.columns - 1) * grid_.step,
                    (grid_.rows - 1) * grid_.step));
}

void SurfacePicture::draw_middle(OldCanvas& canvas) const {
  const int left = kSide + 3 * kMargin, top = kHead;
  const Frame frame = fitted(left, top, middle_columns_, middle_rows_);
  const float most = highest_of(middle_);
  canvas.fill(frame.x, frame.y, frame.width, frame.height, kNothing);
  each_pixel(frame, middle_columns_, middle_rows_, [&](int i, int j, int x, int y) {
    const float here = middle(i, j);
    const float right = middle(std::min(i + 1, middle_columns_ - 1), j);
    const float above = middle(i, std::min(j + 1, middle_rows_ - 1));
    if (std::isnan(here + right + above)) return;
    const double relief = kRelief / grid_.step;
    const double light =
        lit(relief * static_cast<double>(right - here), relief * static_cast<double>(above - here));
    canvas.set(x, y, lit_heat(most > 0 ? static_cast<double>(here / most) : 0, light));
  });
  canvas.frame(frame.x - 1, frame.y - 1, frame.width + 2, frame.height + 2, kInk);
  title(canvas, left, top,
        fmt::format("its middle {:.4g} x {:.4g} mm, 0 to {:.1f} um", middle_columns_ * grid_.step,
                    middle_rows_ * grid_.step, um_from_mm(static_cast<double>(most))));
}

void SurfacePicture::draw_rmax(OldCanvas& canvas, const surface::RoughnessMap& map) const {
  const int left = kMargin, top = kSide + 2 * kHead;
  const std::vector<float> rmax = map.rmax(), gouges = map.gouges();
  const Frame frame = fitted(left, top, map.columns(), map.rows());
  const double most = surface::figures(rmax).largest;
  canvas.fill(frame.x, frame.y, frame.width, frame.height, kNothing);
  each_pixel(frame, map.columns(), map.rows(), [&](int i, int j, int x, int y) {
    const std::size_t region =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(map.columns()) +
        static_cast<std::size_t>(i);
    const float value = rmax[region];
    if (gouges[region] > 0)
      canvas.set(x, y, kGouged);
    else if (!std::isnan(value))
      canvas.set(x, y, heat(most > 0 ? static_cast<double>(value) / most : 0));
  });
  canvas.frame(frame.x - 1, frame.y - 1, frame.width + 2, frame.height + 2, kInk);
  frame_missed(canvas, frame, map);
  constexpr int kBar = 160;
  for (int i = 0; i < kBar; ++i)
    canvas.fill(left + kSide - kBar + i, top - 12 * kScale, 1, 7 * kScale, heat(i / (kBar - 1.0)));
  const bool gouged = surface::figures(gouges).marked > 0;
  const surface::TargetFigures target = target_figures(map);
  title(canvas, left, top,
        fmt::format("rmax, 0 to {:.1f} um{}{}", most, gouged ? ", gouged red" : "",
                    target.missed > 0   ? fmt::format(", {} missed", target.missed)
                    : target.judged > 0 ? ", met"
                                        : ""));
}

void SurfacePicture::draw_profiles(OldCanvas& canvas) const {
  const int left = kSide + 3 * kMargin, top = kSide + 2 * kHead;
  constexpr int kHigh = (kSide - kHead) / 2;
  const double most = std::max(static_cast<double>(highest_of(middle_)), 1e-6);
  const auto draw = [&](int from_top, const std::string& name, int count, const auto& value) {
    canvas.frame(left - 1, from_top - 1, kSide + 2, kHigh + 2, kInk);
    for (int part = 1; part < 4; ++part)
      canvas.fill(left, from_top + part * kHigh / 4, kSide, 1, kFaint);
    int before = -1;
    for (int x = 0; x < kSide; ++x) {
      const auto deviation = static_cast<double>(value(x * count / kSide));
      if (std::isnan(deviation)) {
        before = -1;
        continue;
      }
      const int y =
          from_top + kHigh - 2 - static_cast<int>((kHigh - 6) * std::max(0.0, deviation) / most);
      const int last = before < 0 ? y : before;
      canvas.fill(left + x, std::min(y, last), 2, std::abs(y - last) + 2, kLine);
      before = y;
    }
    title(canvas, left, from_top, name);
  };
  draw(top,
       fmt::format("profile along x {:.4g} mm, 0 to {:.1f} um", middle_columns_ * grid_.step,
                   um_from_mm(most)),
       middle_columns_, [&](int i) { return middle(i, middle_rows_ / 2); });
  draw(top + kHigh + kHead, fmt::format("profile along y {:.4g} mm", middle_rows_ * grid_.step),
       middle_rows_, [&](int i) { return middle(middle_columns_ / 2, i); });
}

OldCanvas SurfacePicture::draw(const surface::RoughnessMap& map) {
  if (map.from() == surface::HeightFrom::lowest)
    for (const float base = base_of(middle_); float& value : middle_) value -= base;
  OldCanvas canvas(kWidth, kHeight, kPaper);
  draw_whole(canvas);
  draw_middle(canvas);
  draw_rmax(canvas, map);
  draw_profiles(canvas);
  return canvas;
}

}  // namespace softcnc::app
