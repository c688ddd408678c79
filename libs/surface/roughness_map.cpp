// SPDX-License-Identifier: MIT
#include "surface/roughness_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/core/units.hpp"

namespace softcnc::surface {
namespace {

constexpr float kGouge = 0.005F;       // mm: more than the ideal surface may be wrong by
constexpr float kResolved = 0.00001F;  // mm: what heights may be wrong by

float um(float mm) { return static_cast<float>(um_from_mm(static_cast<double>(mm))); }

}  // namespace

RoughnessMap::RoughnessMap(const StockGrid& grid, int side, HeightFrom from)
    : from_(from),
      side_(side),
      columns_((grid.columns + side - 1) / side),
      rows_((grid.rows + side - 1) / side),
      whole_columns_(std::max(1, grid.columns / side)),
      whole_rows_(std::max(1, grid.rows / side)) {
  const auto regions = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  highest_.assign(regions, -std::numeric_limits<float>::infinity());
  lowest_.assign(regions, std::numeric_limits<float>::infinity());
  target_.assign(regions, 0);
  excess_.assign(regions, -std::numeric_limits<float>::infinity());
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
      const float target = band.targets.empty() ? 0 : band.targets[band.block(column, row)];
      if (target <= 0) continue;
      float& least = target_[region];
      least = least > 0 ? std::min(least, target) : target;
      excess_[region] = std::max(excess_[region], deviation - target);
    }
  }
}

std::vector<float> RoughnessMap::rmax() const {
  std::vector<float> rmax(highest_.size(), kUnknown);
  for (std::size_t i = 0; i < rmax.size(); ++i)
    if (is_whole(i) && 2 * known_[i] >= all_[i] && known_[i] > 0) rmax[i] = um(height(i));
  return rmax;
}

/// A grid that is smaller than a region holds one.
bool RoughnessMap::is_whole(std::size_t region) const noexcept {
  const auto columns = static_cast<std::size_t>(columns_);
  return region % columns < static_cast<std::size_t>(whole_columns_) &&
         region / columns < static_cast<std::size_t>(whole_rows_);
}

/// mm.
float RoughnessMap::height(std::size_t region) const noexcept {
  if (from_ == HeightFrom::lowest) return highest_[region] - lowest_[region];
  if (highest_[region] < -kGouge) return kUnknown;
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
    if (lowest_[i] < -kGouge) gouges[i] = um(-lowest_[i]);
  return gouges;
}

std::vector<float> RoughnessMap::targets() const {
  std::vector<float> targets(target_.size(), kUnknown);
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (target_[i] > 0 && is_whole(i)) targets[i] = um(target_[i]);
  return targets;
}

std::vector<float> RoughnessMap::met() const {
  const std::vector<float> known = rmax();
  std::vector<float> met(known.size(), kUnknown);
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (std::isnan(known[i]) || target_[i] <= 0) continue;
    const float excess = from_ == HeightFrom::ideal ? excess_[i] : height(i) - target_[i];
    met[i] = excess <= kResolved ? 1 : 0;
  }
  return met;
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

TargetFigures target_figures(const RoughnessMap& map) {
  const std::vector<float> rmax = map.rmax(), targets = map.targets(), met = map.met();
  TargetFigures sum;
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (std::isnan(met[i])) continue;
    ++sum.judged;
    if (met[i] > 0) continue;
    const auto here = static_cast<double>(rmax[i]), target = static_cast<double>(targets[i]);
    if (++sum.missed == 1 || here / target > sum.rmax / sum.target) {
      sum.worst = i;
      sum.rmax = here;
      sum.target = target;
    }
  }
  return sum;
}

}  // namespace softcnc::surface
