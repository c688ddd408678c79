// SPDX-License-Identifier: MIT
// One or two runs as a picture for papers and pages: plots below one another, as SVG or PNG.
#pragma once

#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "pictures/canvas.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

struct PictureOptions {
  std::vector<Plot> plots{Plot::path, Plot::feed, Plot::limits};  // from above to below
  Colouring colour = Colouring::feed;
  int width = kDefaultWidth, height = 0;  // px; height 0: what the plots need
  PictureFormat format = PictureFormat::svg;

  static constexpr int kDefaultWidth = 900;
};

/// Returns the bytes of a picture. A PNG has Canvas::kPngScale pixels along each px. Plots without
/// data say so. The same runs and options give the same bytes. Errors: SC6012 where drawing fails,
/// SC6062 where the height is too small for the plots. Requires one or two runs with a history, and
/// at least one plot.
Result<std::string> draw_picture(PictureRuns runs, const PictureOptions& options);

/// Returns the format that the suffix of a file stands for, in capitals too; none: no picture.
std::optional<PictureFormat> picture_format(std::string_view file);

}  // namespace softcnc::app
