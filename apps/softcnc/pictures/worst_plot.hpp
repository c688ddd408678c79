// SPDX-License-Identifier: MIT
// The plot of the lines that lose most time.
#pragma once

#include "pictures/canvas.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

double worst_plot_height(PictureRuns runs);
void draw_worst_plot(Canvas& canvas, const Rectangle& area, PictureRuns runs);

}  // namespace softcnc::app
