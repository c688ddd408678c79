// SPDX-License-Identifier: MIT
// A surface as a picture: shaded from above, its middle enlarged, Rmax by region, two profiles.
#pragma once

#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "pictures/surface_panels.hpp"
#include "surface/roughness_map.hpp"
#include "surface/surface_bands.hpp"

namespace softcnc::app {

/// Keeps what the picture needs of the bands: a few hundred points along each side.
class SurfacePicture {
 public:
  /// `title`: the program and its machine. `region` in points.
  SurfacePicture(std::string title, const surface::StockGrid& grid, int region);

  void add(const surface::SurfaceBand& band);

  /// Returns the bytes of a PNG. Call once after the last band. Errors: SC6012.
  Result<std::string> draw(const surface::RoughnessMap& map);

 private:
  void shade(const surface::SurfaceBand& band);
  void keep_middle(const surface::SurfaceBand& band);

  std::string title_;
  surface::StockGrid grid_;
  int columns_, rows_;         // of the shaded picture
  std::vector<double> light_;  // sums
  std::vector<int> points_;
  SurfaceMiddle middle_;
};

}  // namespace softcnc::app
