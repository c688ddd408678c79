// SPDX-License-Identifier: MIT
// G06.4 and G06.5: the roughness a program asks for (paper 004), and what it depends on.
#include <cmath>
#include <string>

#include "ipr/handlers/handlers.hpp"
#include "motion/core/units.hpp"
#include "motion/roughness/roughness.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::string_view kSurfaceWords = "DJHLRQ";

/// D, J, H, L, R and Q are the surface's: no other code of the line may take them.
bool is_alone(Task& task) {
  for (const auto& [code, word] : task.command.codes()) {
    if (code == &task.code || !LetterSet(code->words).has_any(kSurfaceWords)) continue;
    task.out.report(Code::SC3123, task.word.pos,
                    code_name(task.code) + " beside " + code_name(*code) +
                        ", which takes D, J, H, L, R or Q too");
    return false;
  }
  return true;
}

/// What the machine file says of the tool in the spindle.
Tool tool_in_use(const Task& task) {
  const auto found = task.machine.tools.find(task.modal.state.loaded_tool.value_or(0));
  return found == task.machine.tools.end() ? Tool{} : found->second;
}

/// A word left out, which the machine file does not know either.
void report_unknown(Task& task, char letter, const char* what) {
  const int tool = task.modal.state.loaded_tool.value_or(0);
  const std::string where = tool == 0
                                ? std::string("no tool is in the spindle")
                                : "the machine file has none for tool " + std::to_string(tool);
  task.out.report(Code::SC3125, task.word.pos,
                  std::string(1, letter) + ", " + what + ", is missing, and " + where);
}

void report_missing(Task& task, char letter, const char* what) {
  task.out.report(Code::SC3125, task.word.pos,
                  std::string(1, letter) + ", " + what + ", is missing");
}

/// A length above 0 by its word, mm; 0, after a report, if it is none.
double read_length(Task& task, char letter, const char* what, double mm_per_unit) {
  const Word& word = task.values.word(letter);
  const double length = word.value * mm_per_unit;
  if (length > 0 && is_near(length)) return length;
  task.out.report(Code::SC3124, word.pos,
                  std::string(1, letter) + ", " + what + ", must be " +
                      (length > 0 ? "1000000 mm at most" : "above 0"));
  return 0;
}

double read_radius(Task& task) {
  if (task.values.has('D'))
    return read_length(task, 'D', "the tool radius", task.modal.mm_per_unit);
  const double radius = tool_in_use(task).radius;
  if (radius <= 0) report_unknown(task, 'D', "the tool radius");
  return radius;
}

int read_teeth(Task& task) {
  if (!task.values.has('L')) {
    const int teeth = tool_in_use(task).teeth;
    if (teeth <= 0) report_unknown(task, 'L', "the number of teeth");
    return teeth;
  }
  const Word& word = task.values.word('L');
  if (const auto teeth = whole_from(1, word.value)) return *teeth;
  task.out.report(Code::SC3124, word.pos, "L, the number of teeth, is a whole number from 1");
  return 0;
}

double read_pick_feed(Task& task) {
  if (task.values.has('J')) return read_length(task, 'J', "the pick-feed", task.modal.mm_per_unit);
  report_missing(task, 'J', "the pick-feed");
  return 0;
}

double read_rmax(Task& task) {
  if (task.values.has('H')) return read_length(task, 'H', "the target Rmax", mm_from_um(1));
  report_missing(task, 'H', "the target Rmax in um");
  return 0;
}

/// 1/mm, from the radius of the surface across the feed; nothing, after a report, if no ball
/// touches it.
std::optional<double> read_transverse_curvature(Task& task, double tool_radius) {
  if (!task.values.has('R')) return 0;
  const Word& word = task.values.word('R');
  const double radius = word.value * task.modal.mm_per_unit;
  if (radius > 0 || -radius > tool_radius) return 1 / radius;
  task.out.report(
      Code::SC3124, word.pos,
      radius == 0
          ? "R, the radius across the feed, must not be 0: leave it out on a flat surface"
          : "R, a hollow of " + number_text(-radius) + " mm, is too tight for a tool radius of " +
                number_text(tool_radius) + " mm");
  return std::nullopt;
}

/// rad; 0 where it is level across; nothing, after a report, if it is no slope.
std::optional<double> read_slope_across(Task& task) {
  if (!task.values.has('Q')) return 0;
  const Word& word = task.values.word('Q');
  if (word.value >= 0 && word.value < 90) return rad_from_deg(word.value);
  task.out.report(Code::SC3124, word.pos,
                  "Q, the largest slope across the feed, is from 0 to below 90 degrees");
  return std::nullopt;
}

/// The ball reaches from one pass to the next.
bool has_close_passes(Task& task, const Surface& surface) {
  if (surface.tool_radius <= 0 || surface.pick_feed <= 0) return false;
  if (surface.pick_feed >= 2 * surface.tool_radius) {
    task.out.report(Code::SC3124, task.values.word('J').pos,
                    "J, the pick-feed, must be below twice the tool radius of " +
                        number_text(surface.tool_radius) + " mm");
    return false;
  }
  if (surface.pick_on_slope() >= 2 * surface.tool_radius) {
    task.out.report(Code::SC3124, task.values.word('Q').pos,
                    "Q, the slope across the feed, sets passes " +
                        number_text(surface.pick_on_slope()) +
                        " mm apart: that must be below twice the tool radius of " +
                        number_text(surface.tool_radius) + " mm");
    return false;
  }
  return true;
}

/// What passes next to each other can leave at all.
bool has_possible_rmax(Task& task, const Surface& surface) {
  const double least = least_rmax(surface);
  if (surface.rmax > least) return true;
  task.out.report(Code::SC3126, task.values.word('H').pos,
                  "an Rmax of " + number_text(um_from_mm(surface.rmax)) +
                      " um is unreachable: this pick-feed" +
                      (surface.slope_across > 0 ? ", slope" : "") + " and radius leave " +
                      number_text(um_from_mm(least)) + " um at any feed");
  return false;
}

/// Chips so thin that teeth rub are what no target gets.
void check_feed(Task& task, const Surface& surface) {
  const double least = least_feed_per_tooth(task.machine.surfacing.model, surface);
  if (least > kLeastFeedPerTooth) return;
  const Word& word = task.values.word('H');
  task.out.report(Code::SC3129, word.pos,
                  "an Rmax of " + number_text(um_from_mm(surface.rmax)) +
                      " um asks for less than " + number_text(um_from_mm(kLeastFeedPerTooth)) +
                      " um per tooth, where teeth rub; the target is not met there");
}

void keep_surface(Task& task, const Surface& surface) {
  if (!has_close_passes(task, surface) || surface.rmax <= 0) return;
  if (!has_possible_rmax(task, surface) || surface.teeth <= 0) return;
  task.modal.surface = surface;
  task.modal.rest_reported = false;
  check_feed(task, surface);
}

Surface read_surface(Task& task) {
  task.modal.surface.reset();
  return {read_radius(task), read_pick_feed(task), read_rmax(task), read_teeth(task)};
}

/// Why the spindle does not turn; nullptr if it does.
const char* rest_of_spindle(const Modal& modal) noexcept {
  if (!modal.spindle_speed) return "S is not set";
  if (*modal.spindle_speed == 0) return "S is 0";
  return modal.spindle_direction == 0 ? "neither M03 nor M04 is in force" : nullptr;
}

}  // namespace

void ask_for_surface(Task& task) {
  if (!is_alone(task)) return;
  Surface surface = read_surface(task);
  const auto curvature = read_transverse_curvature(task, surface.tool_radius);
  const auto slope = read_slope_across(task);
  surface.transverse_curvature = curvature.value_or(0);
  surface.slope_across = slope.value_or(0);
  if (curvature && slope)
    keep_surface(task, surface);
  else
    has_close_passes(task, surface);
}

void cancel_surface(Task& task) {
  if (is_alone(task)) task.modal.surface.reset();
}

void ask_for_surface_of_curve(Task& task) {
  if (task.values.letters().has_any(kSurfaceWordsOfCurve)) keep_surface(task, read_surface(task));
}

bool has_surface_speed(Modal& modal, Output& out, SourcePos word, std::string_view line) {
  const char* why = modal.surface ? rest_of_spindle(modal) : nullptr;
  if (why == nullptr) return true;
  if (!modal.rest_reported)
    out.report(Code::SC3128, word,
               std::string("a roughness is asked for, and the spindle does not turn: ") + why,
               line);
  modal.rest_reported = true;
  return false;
}

std::optional<Surface> surface_at_speed(const Modal& modal) noexcept {
  std::optional<Surface> surface = modal.surface;
  if (surface && rest_of_spindle(modal) == nullptr)
    surface->spindle = per_s_from_rpm(modal.spindle_speed.value_or(0));
  return surface;
}

}  // namespace softcnc::ipr
