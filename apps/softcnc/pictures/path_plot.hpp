// SPDX-License-Identifier: MIT
// The plot of the path: from above, or isometric, coloured.
#pragma once

#include "pictures/canvas.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// Returns the px that the plot needs in a picture of this width, so that the path fills it.
double path_plot_height(PictureRuns runs, Colouring by, double width);

/// Draws the paths, side by side where there are two, with one scale.
void draw_path_plot(Canvas& canvas, const Rectangle& area, PictureRuns runs, Colouring by);

}  // namespace softcnc::app
