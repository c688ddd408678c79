// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "circle/circle_test.hpp"
#include "motion/core/units.hpp"

namespace softcnc::app {
namespace {

using runtime::CircleFigures;

/// With so many decimals; what rounds to 0 has no sign.
std::string number(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == text.npos;
  return is_zero && text.starts_with('-') ? text.substr(1) : text;
}

std::string um(double mm) { return number(um_from_mm(mm), 1); }

std::string point(const Eigen::Vector2d& place) {
  return number(place.x(), 4) + ' ' + number(place.y(), 4);
}

void add_pass(std::string& text, const MeasuredPass& measured, runtime::CirclePlane plane) {
  const auto& [pass, figures] = measured;
  text += fmt::format("  {} from line {}, {:.0f} mm/min\n",
                      pass.clockwise ? "clockwise" : "anticlockwise", pass.line,
                      mm_min_from_mm_s(pass.speed));
  text += fmt::format("    least squares  centre {} mm, radius {} um off\n", point(figures.centre),
                      um(figures.radius - pass.radius));
  text += fmt::format("    deviation      F from {} to {} um, G {} um\n", um(figures.innermost),
                      um(figures.outermost), um(figures.circular));
  text += "    reversals     ";
  for (std::size_t i = 0; i < figures.reversals.size(); ++i)
    text += fmt::format("{} {} step {}, spike {}", i > 0 ? "," : "", side_name(plane, i),
                        um(figures.reversals[i].step), um(figures.reversals[i].spike));
  text += " um\n";
}

void add_both(std::string& text, const runtime::BothDirections& both, const MeasuredCircle& circle,
              runtime::CirclePlane plane) {
  const auto axes = runtime::plane_axes(plane);
  const auto letter = [&](std::size_t i) { return static_cast<char>(axes[i] - 'a' + 'A'); };
  text += fmt::format("  both directions: G(b) {} um, D {} um\n", um(both.circular), um(both.mean));
  text += fmt::format(
      "    squareness {} um/m, {} later than {} by {} ms, radius along {} larger by {} um\n",
      number(1e6 * both.squareness, 1), letter(0), letter(1), number(ms_from_s(both.lag), 3),
      letter(0), um(circle.passes.front().figures.ellipse));
}

}  // namespace

std::string circle_text(const CircleTest& test) {
  std::string text;
  for (const MeasuredCircle& circle : test.circles) {
    const runtime::CirclePass& first = circle.passes.front().pass;
    text += fmt::format("circle in {}: radius {:.4f} mm about {} mm\n",
                        runtime::kCirclePlaneNames[static_cast<std::size_t>(test.plane)],
                        first.radius, point(first.centre));
    for (const MeasuredPass& pass : circle.passes) add_pass(text, pass, test.plane);
    if (circle.both) add_both(text, *circle.both, circle, test.plane);
  }
  return text;
}

}  // namespace softcnc::app
