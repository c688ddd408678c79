// SPDX-License-Identifier: MIT
#include "circle/circle_test.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "input/reported_run.hpp"
#include "recording/recording.hpp"

namespace softcnc::app {
namespace {

using runtime::CirclePass;
using Passes = std::vector<CirclePass>;

Result<Passes> read_passes(Result<std::unique_ptr<hal::TraceReader>> trace,
                           runtime::CirclePlane plane) {
  if (!trace) return tl::make_unexpected(std::move(trace.error()));
  return runtime::read_circles(**trace, plane);
}

Result<Passes> read_recorded(const std::string& file, runtime::CirclePlane plane) {
  const auto recording = Recording::open(file);
  if (!recording) return tl::make_unexpected(recording.error());
  if (Status good = recording->check_trace(); !good) return tl::make_unexpected(good.error());
  auto entry = recording->trace();
  if (!entry) return tl::make_unexpected(std::move(entry.error()));
  return read_passes(hal::TraceReader::open(std::move(*entry), file), plane);
}

/// Puts a pass to those along the same circle.
void add(CircleTest& test, MeasuredPass measured) {
  const auto along = std::ranges::find_if(test.circles, [&](const MeasuredCircle& circle) {
    return runtime::same_circle(circle.passes.front().pass, measured.pass);
  });
  MeasuredCircle& circle = along == test.circles.end() ? test.circles.emplace_back() : *along;
  circle.passes.push_back(std::move(measured));
}

void add_both(MeasuredCircle& circle) {
  const auto first = [&](bool clockwise) {
    return std::ranges::find(circle.passes, clockwise,
                             [](const MeasuredPass& measured) { return measured.pass.clockwise; });
  };
  const auto left = first(false), right = first(true);
  if (left != circle.passes.end() && right != circle.passes.end())
    circle.both = runtime::both_directions(left->pass, right->pass);
}

}  // namespace

std::string side_name(runtime::CirclePlane plane, std::size_t reversal) {
  const auto axes = runtime::plane_axes(plane);
  const char letter = static_cast<char>(axes[reversal % 2] - 'a' + 'A');
  return std::string(reversal < 2 ? "+" : "-") + letter;
}

Result<CircleTest> measure_circles(const Options& options) {
  const std::string& file = options.files.front();
  auto passes = input_kind(file) == InputKind::recording
                    ? read_recorded(file, options.plane)
                    : read_passes(hal::TraceReader::open(file), options.plane);
  const auto refused = [&](Diagnostic error) {
    if (error.file.empty()) error.file = file;
    return tl::make_unexpected(std::move(error));
  };
  if (!passes) return refused(std::move(passes.error()));
  const std::string plane(runtime::kCirclePlaneNames[static_cast<std::size_t>(options.plane)]);
  if (passes->empty())
    return refused({.code = Code::SC6084, .message = "no full circle in the plane " + plane});
  std::optional<Eigen::Vector2d> centre;
  if (options.centre.size() == 2) centre = {options.centre[0], options.centre[1]};
  CircleTest test{file, options.plane, {}};
  for (CirclePass& pass : *passes) {
    auto figures = runtime::circle_figures(pass, centre);
    add(test, {std::move(pass), std::move(figures)});
  }
  for (MeasuredCircle& circle : test.circles) add_both(circle);
  return test;
}

}  // namespace softcnc::app
