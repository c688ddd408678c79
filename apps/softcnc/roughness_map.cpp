// SPDX-License-Identifier: MIT
#include "roughness_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/units.hpp"

namespace softcnc::app {
namespace {

constexpr float kGouge = 0.005F;  // mm: more than the ideal surface may be wrong by

}  // namespace

RoughnessMap::RoughnessMap(const hal::StockGrid& grid, int side, HeightFrom from)
    : from_(from),
      side_(side),
      columns_((grid.columns + side - 1) / side),
      rows_((grid.rows + side - 1) / side) {
  const auto regions = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  highest_.assign(regions, -std::numeric_limits<float>::infinity());
  lowest_.assign(regions, std::numeric_limits<float>::infinity());
  known_.assign(regions, 0);
  all_.assign(regions, 0);
}

void RoughnessMap::add(const SurfaceBand& band) {
  for (int row = 0; row < band.rows; ++row) {
    const auto first = static_cast<std::size_t>((band.first_row + row) / side_) *
                       static_cast<std::size_t>(columns_);
    for (int column = 0; column < band.columns; ++column) {
      const std::size_t region = first + static_cast<std::size_t>(column / side_);
      const float deviation = band.deviations[band.index(column, row)];
      ++all_[region];
      if (std::isnan(deviation)) continue;
      ++known_[region];
      highest_[region] = std::max(highest_[region], deviation);
      lowest_[region] = std::min(lowest_[region], deviation);
    }
  }
}

std::vector<float> RoughnessMap::rmax() const {
  std::vector<float> rmax(highest_.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < rmax.size(); ++i)
    if (2 * known_[i] >= all_[i] && known_[i] > 0)
      rmax[i] = static_cast<float>(um_from_mm(static_cast<double>(height(i))));
  return rmax;
}

/// mm.
float RoughnessMap::height(std::size_t region) const noexcept {
  if (from_ == HeightFrom::lowest) return highest_[region] - lowest_[region];
  if (highest_[region] < -kGouge) return std::numeric_limits<float>::quiet_NaN();
  return std::max(0.0F, highest_[region]);
}

std::pair<double, double> RoughnessMap::range() const noexcept {
  return {um_from_mm(static_cast<double>(*std::ranges::min_element(lowest_))),
          um_from_mm(static_cast<double>(*std::ranges::max_element(highest_)))};
}

std::vector<float> RoughnessMap::gouges() const {
  std::vector<float> gouges(lowest_.size(), 0);
  if (from_ == HeightFrom::lowest) return gouges;
  for (std::size_t i = 0; i < gouges.size(); ++i)
    if (lowest_[i] < -kGouge)
      gouges[i] = static_cast<float>(um_from_mm(static_cast<double>(-lowest_[i])));
  return gouges;
}

RegionFigures figures(const std::vector<float>& values) {
  RegionFigures sum;
  for (const float value : values) {
    if (std::isnan(value)) continue;
    sum.largest = std::max(sum.largest, static_cast<double>(value));
    sum.mean += static_cast<double>(value);
    ++sum.regions;
    if (value > 0) ++sum.marked;
  }
  if (sum.regions > 0) sum.mean /= static_cast<double>(sum.regions);
  return sum;
}

}  // namespace softcnc::app
