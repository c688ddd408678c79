// SPDX-License-Identifier: MIT
// The panels of the picture of a surface, with axes in mm and bars in um.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "pictures/canvas.hpp"
#include "surface/roughness_map.hpp"
#include "surface/surface_bands.hpp"

namespace softcnc::app {

/// Roughness is shown so much steeper than it is.
inline constexpr double kRelief = 8;

/// The middle of a surface, point by point.
struct SurfaceMiddle {
  int first_column = 0, first_row = 0, columns = 0, rows = 0;
  std::vector<float> deviations;  // mm above the ideal surface; NaN: not known

  std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  float at(int column, int row) const noexcept { return deviations[index(column, row)]; }
  /// Deviations count from the lowest one, if that is below 0.
  void count_from_lowest() noexcept;
  /// Returns the largest deviation, mm; at least 0.
  double highest() const noexcept;
};

/// Returns how bright a surface with these slopes is, 0 to 1: light from the left, above.
double surface_light(double slope_x, double slope_y) noexcept;
/// Returns the grey of a brightness.
Colour surface_grey(double light) noexcept;

/// Returns the bytes of the picture as a PNG. `lit` is the shaded surface. Errors: SC6012.
Result<std::string> draw_surface(const std::string& title, const surface::StockGrid& grid,
                                 const Pixels& lit, const SurfaceMiddle& middle,
                                 const surface::RoughnessMap& map);

}  // namespace softcnc::app
