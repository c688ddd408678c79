// SPDX-License-Identifier: MIT
#include "output/contour_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "motion/core/units.hpp"
#include "motion/model/fastest_move.hpp"
#include "motion/model/position_loop.hpp"

namespace softcnc::app {
namespace {

std::string figures_text(const ContourFigures& figures) {
  return fmt::format("max {:.1f} µm (line {}, {:.3f} s), rms {:.1f} µm", um_from_mm(figures.max),
                     figures.line, figures.time, um_from_mm(figures.rms()));
}

void add_figures(const ContourFigures& figures, const std::string& prefix,
                 nlohmann::ordered_json& json) {
  json[prefix + "um_max"] = um_from_mm(figures.max);
  json[prefix + "um_rms"] = um_from_mm(figures.rms());
  if (figures.instants > 0) json[prefix + "at"] = {{"t_s", figures.time}, {"line", figures.line}};
}

/// The smallest and the largest gain of the axes' position loops, 1/s.
struct Gains {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
};
Gains gains(const Machine& machine) {
  Gains gains;
  for (const Axis& axis : machine.axes) {
    if (!axis.present) continue;
    gains.least = std::min(gains.least, axis.drive.kv);
    gains.largest = std::max(gains.largest, axis.drive.kv);
  }
  return gains;
}

/// The circle that turns as the path does where the error is largest, if that explains it.
std::string circle_text(const ContourFigures& worst, double kv) {
  if (!(worst.radius > 0)) return {};
  const double smaller = worst.speed * worst.speed / (2 * worst.radius * kv * kv);
  if (smaller > 1.5 * worst.max || worst.max > 1.5 * smaller) return {};
  return fmt::format(", here R {:.3g} mm at F{:.0f} by {:.1f} µm", worst.radius,
                     mm_min_from_mm_s(worst.speed), um_from_mm(smaller));
}

/// Of unequal gains: on a line between two axes the tool is v/2 times the difference of their 1/Kv
/// off.
std::string unequal_text(const Gains& gains) {
  return fmt::format(
      "\n  The gains of the axes differ, from {:.6g} to {:.6g} 1/s: so the tool leaves even "
      "straight"
      "\n  lines that are not along an axis, by up to v/2 times the difference of 1/Kv.",
      gains.least, gains.largest);
}

/// Two digits.
std::string feed_text(double mm_s) {
  const double feed = mm_min_from_mm_s(mm_s);
  const double unit = std::pow(10.0, std::floor(std::log10(feed)) - 1);
  return fmt::format("F{:.6g}", std::round(feed / unit) * unit);
}

/// "F43 in the tightest curve (R 0.0286 mm), F71 at corners": the feeds at which about kGoal is
/// left, as far as the machine can be faster.
std::string feeds_text(const ContourReport& report, const Machine& machine, const Gains& loop) {
  const auto matters = [most = fastest_move(machine), &loop](double lag) {
    return lag > 0 && lag * loop.least < most;
  };
  std::vector<std::string> feeds;
  if (matters(report.curve_lag))
    feeds.push_back(fmt::format("{} in the tightest curve (R {:.3g} mm)",
                                feed_text(report.curve_lag * loop.least),
                                report.curve_lag * report.curve_lag / (2 * ContourReport::kGoal)));
  if (matters(report.corner_lag))
    feeds.push_back(fmt::format("{} at corners", feed_text(report.corner_lag * loop.least)));
  const double on_lines = 2 * ContourReport::kGoal / (1 / loop.least - 1 / loop.largest);
  if (on_lines < fastest_move(machine))
    feeds.push_back(fmt::format("{} on lines", feed_text(on_lines)));
  return fmt::format("{}", fmt::join(feeds, ", "));
}

/// Up to here tolerances alone explain the error.
double tolerance_of_path(const Machine& machine) {
  return std::max(
      {ContourReport::kGoal, machine.control.corner_tolerance, machine.control.chord_tolerance});
}

/// What brings it down to kGoal: not a lower feed of the whole program, since where a curve follows
/// a rapid, the lag of the rapid remains.
std::string advice(const ContourReport& report, const Machine& machine) {
  constexpr double kFriction = 1.25;  // what it and counts add to a tolerance that is kept
  const Control& control = machine.control;
  if (control.follow != Follow::off || ignores_plan(control.interpolation)) return {};
  if (report.cutting.max <=
      kFriction * std::max(tolerance_of_path(machine), control.contour_tolerance))
    return {};
  const double goal = um_from_mm(ContourReport::kGoal);
  return fmt::format(
      "\n    to stay within {:.0f} µm: control.contour_tolerance_um={:.0f}, which slows down where "
      "needed,\n    or control.follow=model, which compensates for servo lag",
      goal, goal);
}

/// What commands ahead of the path leave.
std::string following_text(const Machine& machine) {
  return fmt::format(
      "\n  Commands are ahead of the path (control.follow = \"{}\"): what is left comes from "
      "counts,"
      "\n  and from what the machine file does not know of its axes.",
      kFollowNames[static_cast<std::size_t>(machine.control.follow)]);
}

std::string tolerance_text(const Machine& machine) {
  return fmt::format(
      "\n  Speeds and rests at corners are such that the lag of the drives leaves {:.6g} µm"
      "\n  (control.contour_tolerance_um); friction where an axis turns back, and counts, add "
      "some.",
      um_from_mm(machine.control.contour_tolerance));
}

std::string explanation(const ContourReport& report, const Machine& machine) {
  std::string text = limits_contour(machine.control) && !ignores_plan(machine.control.interpolation)
                         ? tolerance_text(machine)
                         : "";
  if (machine.control.follow != Follow::off) return text + following_text(machine);
  const Gains loop = gains(machine);
  text += fmt::format(
      "\n  A position loop of gain Kv ({:.6g} 1/s) makes a circle of radius R smaller by"
      "\n  v^2/(2 R Kv^2){}, and rounds corners.",
      loop.least, circle_text(report.cutting, loop.least));
  if (loop.least != loop.largest) text += unequal_text(loop);
  if (const std::string feeds = feeds_text(report, machine, loop); !feeds.empty())
    text += fmt::format("\n  About {:.0f} µm of that would be left at {}.",
                        um_from_mm(ContourReport::kGoal), feeds);
  return text;
}

}  // namespace

std::string contour_lines(const ContourReport& report, const Machine& machine) {
  std::string text = "\n  contour error  ";
  text += report.cutting.instants > 0 ? figures_text(report.cutting) : "none: nothing was cut";
  if (report.rapids.instants > 0)
    text += fmt::format("\n    of rapids    {}", figures_text(report.rapids));
  return text + advice(report, machine);
}

std::string contour_paragraph(const ContourReport& report, const Machine& machine) {
  const std::string text =
      "\n\n  The contour error is the distance of the tool from the path. The following error is "
      "how"
      "\n  far an axis is behind its command; most of it lies along the path.";
  const bool is_large = report.cutting.max > tolerance_of_path(machine);
  return is_large ? text + explanation(report, machine) : text;
}

void add_contour(const ContourReport& report, nlohmann::ordered_json& json) {
  add_figures(report.cutting, "contour_error_", json);
  add_figures(report.rapids, "contour_error_rapid_", json);
}

}  // namespace softcnc::app
