// SPDX-License-Identifier: MIT
// The box around a path that is seen from a corner, with a scale along each axis.
#pragma once

#include "pictures/canvas.hpp"
#include "pictures/path_view.hpp"

namespace softcnc::app {

/// Draws the floor, the two walls after the path, and ticks along the three edges in front.
void draw_isometric_axes(Canvas& canvas, const Box& box, const Placing& placing);

}  // namespace softcnc::app
