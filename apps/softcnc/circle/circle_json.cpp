// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "circle/circle_test.hpp"
#include "motion/core/units.hpp"
#include "motion/core/utf8.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kCircleSchema = 1;

Json point_json(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }

Json reversals_json(const runtime::CircleFigures& figures, runtime::CirclePlane plane) {
  Json reversals = Json::array();
  for (std::size_t i = 0; i < figures.reversals.size(); ++i)
    reversals.push_back({{"side", side_name(plane, i)},
                         {"step_um", um_from_mm(figures.reversals[i].step)},
                         {"spike_um", um_from_mm(figures.reversals[i].spike)}});
  return reversals;
}

Json pass_json(const MeasuredPass& measured, runtime::CirclePlane plane) {
  const auto& [pass, figures] = measured;
  return {{"line", pass.line},
          {"direction", pass.clockwise ? "clockwise" : "anticlockwise"},
          {"feed_mm_min", mm_min_from_mm_s(pass.speed)},
          {"centre_mm", point_json(figures.centre)},
          {"radius_mm", figures.radius},
          {"f_max_um", um_from_mm(figures.outermost)},
          {"f_min_um", um_from_mm(figures.innermost)},
          {"g_um", um_from_mm(figures.circular)},
          {"ellipse_um", um_from_mm(figures.ellipse)},
          {"diagonal_um", um_from_mm(figures.diagonal)},
          {"reversals", reversals_json(figures, plane)}};
}

Json both_json(const std::optional<runtime::BothDirections>& both) {
  if (!both) return nullptr;
  return {{"g_b_um", um_from_mm(both->circular)},
          {"d_um", um_from_mm(both->mean)},
          {"squareness_um_m", 1e6 * both->squareness},
          {"lag_difference_ms", ms_from_s(both->lag)}};
}

}  // namespace

std::string circle_json(const CircleTest& test) {
  Json circles = Json::array();
  for (const MeasuredCircle& circle : test.circles) {
    const runtime::CirclePass& first = circle.passes.front().pass;
    Json passes = Json::array();
    for (const MeasuredPass& pass : circle.passes) passes.push_back(pass_json(pass, test.plane));
    circles.push_back({{"centre_mm", point_json(first.centre)},
                       {"radius_mm", first.radius},
                       {"passes", std::move(passes)},
                       {"both_directions", both_json(circle.both)}});
  }
  const Json json{{"schema", kCircleSchema},
                  {"file", as_utf8(test.file)},
                  {"plane", runtime::kCirclePlaneNames[static_cast<std::size_t>(test.plane)]},
                  {"circles", std::move(circles)}};
  return json.dump(2) + '\n';
}

}  // namespace softcnc::app
