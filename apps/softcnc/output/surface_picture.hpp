// SPDX-License-Identifier: MIT
// A surface as a picture: shaded from above, its middle enlarged, Rmax by region, two profiles.
#pragma once

#include <vector>

#include "output/png_file.hpp"
#include "surface/roughness_map.hpp"
#include "surface/surface_bands.hpp"

namespace softcnc::app {

/// Keeps what the picture needs of the bands: a few hundred points along each side.
class SurfacePicture {
 public:
  /// `region` in points.
  SurfacePicture(const surface::StockGrid& grid, int region);

  void add(const surface::SurfaceBand& band);

  /// Call once after the last band.
  OldCanvas draw(const surface::RoughnessMap& map);

 private:
  void shade(const surface::SurfaceBand& band);
  void keep_middle(const surface::SurfaceBand& band);
  float middle(int column, int row) const noexcept {
    return middle_[static_cast<std::size_t>(row) * static_cast<std::size_t>(middle_columns_) +
                   static_cast<std::size_t>(column)];
  }
  void draw_whole(OldCanvas& canvas) const;
  void draw_middle(OldCanvas& canvas) const;
  void draw_rmax(OldCanvas& canvas, const surface::RoughnessMap& map) const;
  void draw_profiles(OldCanvas& canvas) const;

  surface::StockGrid grid_;
  int columns_, rows_;         // of the shaded picture
  std::vector<double> light_;  // sums
  std::vector<int> points_;
  int middle_column_, middle_row_, middle_columns_, middle_rows_;
  std::vector<float> middle_;  // mm above the ideal surface; NaN: not known
};

}  // namespace softcnc::app
