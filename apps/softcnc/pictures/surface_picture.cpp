// SPDX-License-Identifier: MIT
#include "pictures/surface_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace softcnc::app {
namespace {

constexpr int kMiddleRegions = 6;  // along a side of what is enlarged
constexpr int kMost = 640;         // points along a side of what is shaded

/// The middle of a grid, without values yet.
SurfaceMiddle middle_of(const surface::StockGrid& grid, int region) {
  SurfaceMiddle middle;
  middle.columns = std::min({grid.columns, kMiddleRegions * region, 2 * kMost});
  middle.rows = std::min({grid.rows, kMiddleRegions * region, 2 * kMost});
  middle.first_column = (grid.columns - middle.columns) / 2;
  middle.first_row = (grid.rows - middle.rows) / 2;
  middle.deviations.assign(
      static_cast<std::size_t>(middle.columns) * static_cast<std::size_t>(middle.rows),
      std::numeric_limits<float>::quiet_NaN());
  return middle;
}

/// How many of `points` the shorter side has where the longer one has `longest`.
int in_proportion(int longest, int points, int of) {
  return static_cast<int>(static_cast<std::int64_t>(longest) * points / of);
}

}  // namespace

SurfacePicture::SurfacePicture(std::string title, const surface::StockGrid& grid, int region)
    : title_(std::move(title)),
      grid_(grid),
      columns_(std::min(grid.columns, kMost)),
      rows_(std::min(grid.rows, kMost)),
      middle_(middle_of(grid, region)) {
  if (grid.columns > grid.rows)
    rows_ = std::max(1, std::min(grid.rows, in_proportion(columns_, grid.rows, grid.columns)));
  if (grid.rows > grid.columns)
    columns_ = std::max(1, std::min(grid.columns, in_proportion(rows_, grid.columns, grid.rows)));
  light_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  points_.assign(light_.size(), 0);
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
      light_[pixel] += surface_light(slope(here, here + 1), slope(here, above));
      ++points_[pixel];
    }
}

void SurfacePicture::keep_middle(const surface::SurfaceBand& band) {
  for (int row = 0; row < middle_.rows; ++row) {
    const int from = middle_.first_row + row - band.first_row;
    if (from < 0 || from >= band.rows) continue;
    for (int column = 0; column < middle_.columns; ++column)
      middle_.deviations[middle_.index(column, row)] =
          band.deviations[band.index(middle_.first_column + column, from)];
  }
}

Result<std::string> SurfacePicture::draw(const surface::RoughnessMap& map) {
  if (map.from() == surface::HeightFrom::lowest) middle_.count_from_lowest();
  Pixels lit(columns_, rows_, kUnknownColour);
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(rows_ - 1 - y) * static_cast<std::size_t>(columns_) +
          static_cast<std::size_t>(x);
      if (points_[pixel] > 0) lit.at(x, y) = surface_grey(light_[pixel] / points_[pixel]);
    }
  return draw_surface(title_, grid_, lit, middle_, map);
}

}  // namespace softcnc::app
