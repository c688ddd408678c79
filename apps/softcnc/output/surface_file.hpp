// SPDX-License-Identifier: MIT
// A surface as a file: numpy arrays or a picture.
#pragma once

#include <memory>
#include <string>

#include "hal/files/output_file.hpp"
#include "surface/roughness_map.hpp"
#include "surface/surface_bands.hpp"

namespace softcnc::app {

class SurfaceFile {
 public:
  virtual ~SurfaceFile() = default;
  virtual Status add(const surface::SurfaceBand& band) = 0;

  /// Call once after the last band; without it no file is left.
  virtual Status finish(const surface::RoughnessMap& map) = 0;
};

/// Checks that the suffix names a format. Errors: SC6060.
Status known_surface_form(const std::string& file);

/// The form that the suffix of `name` names, into `output`. `title` is that of a picture: the
/// program and its machine. Errors: SC6003.
Result<std::unique_ptr<SurfaceFile>> open_surface_file(const std::string& name,
                                                       const std::string& title,
                                                       hal::OutputFile& output,
                                                       const surface::StockGrid& grid, int region);

}  // namespace softcnc::app
