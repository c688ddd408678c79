// SPDX-License-Identifier: MIT
// The plot of the limits: which one holds when, and the share of each in the time.
#pragma once

#include "pictures/canvas.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// A stretch of time with one limit.
struct LimitStretch {
  double from = 0, to = 0;  // s
  Limit limit = Limit::stop;
};

/// Returns which limit holds when, in stretches of at least `shortest` s: of what is shorter, the
/// limit that lasts longest in it.
std::vector<LimitStretch> limit_stretches(const runtime::RunHistory& history, double shortest);

/// Returns the limits that take at least 0.2 % of the time of a run, that with most time first.
std::vector<Limit> shown_limits(PictureRuns runs);

double limit_plot_height(PictureRuns runs);
void draw_limit_plot(Canvas& canvas, const Rectangle& area, PictureRuns runs);

}  // namespace softcnc::app
