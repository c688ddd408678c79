// SPDX-License-Identifier: MIT
// The circles of a run with their figures, and how they are shown.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "pictures/picture_options.hpp"
#include "runtime/circle/circle_figures.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

struct MeasuredPass {
  runtime::CirclePass pass;
  runtime::CircleFigures figures;
};

/// The passes along one circle, in order, and the figures of the first one in each direction.
struct MeasuredCircle {
  std::vector<MeasuredPass> passes;
  std::optional<runtime::BothDirections> both;
};

struct CircleTest {
  std::string file;
  runtime::CirclePlane plane = runtime::CirclePlane::xy;
  std::vector<MeasuredCircle> circles;  // in the order in which they begin
};

/// Measures the circles of a trace or a recording. Errors: those of reading it, SC6084 (no circle),
/// SC6085 (no actual positions).
Result<CircleTest> measure_circles(const Options& options);

std::string circle_text(const CircleTest& test);
std::string circle_json(const CircleTest& test);

/// Draws the deviations of the first circle around it, magnified. Errors: SC6012.
Result<std::string> circle_picture(const CircleTest& test, const PictureOptions& options,
                                   PictureFormat format);

/// Returns the name of the side at which an axis turns back: "+X". `reversal` counts from the first
/// axis, anticlockwise.
std::string side_name(runtime::CirclePlane plane, std::size_t reversal);

}  // namespace softcnc::app
