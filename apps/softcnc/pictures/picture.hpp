// SPDX-License-Identifier: MIT
// One or two runs as a picture for papers and pages: plots below one another, as SVG or PNG.
#pragma once

#include <string>

#include "motion/core/result.hpp"
#include "pictures/canvas.hpp"
#include "pictures/picture_options.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// Returns the bytes of a picture. A PNG has Canvas::kPngScale pixels along each px. Plots without
/// data say so. The same runs and options give the same bytes. Errors: SC6012 where drawing fails,
/// SC6062 where the height is too small for the plots. Requires one or two runs with a history.
Result<std::string> draw_picture(PictureRuns runs, const PictureOptions& options,
                                 PictureFormat format);

}  // namespace softcnc::app
