// SPDX-License-Identifier: MIT
#include "ipo/path/travel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/tuning.hpp"
#include "motion/geometry/extent.hpp"

namespace softcnc::ipo {
namespace {

/// Returns by how much the box lies below (negative) or above the travel of an axis, mm; 0: within.
/// What the move starts outside counts as within.
double excess(const Extent& box, const Axis& axis, const AxisVector& start, int i) {
  const double below = box.min[i] - std::min(axis.min, start[i]);
  const double above = box.max[i] - std::max(axis.max, start[i]);
  if (below < -tuning::path::kTravelTolerance && -below >= above) return box.min[i] - axis.min;
  return above > tuning::path::kTravelTolerance ? box.max[i] - axis.max : 0;
}

/// Formats a length with enough decimals to show two digits of the excess, without trailing zeros.
std::string length_text(double mm, double excess_mm) {
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(excess_mm))), 3, 9);
  std::string text = fmt::format("{:.{}f}", mm, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string beyond_travel(const Machine& machine, int axis, double excess) {
  const auto index = static_cast<std::size_t>(axis);
  const double min = machine.axes[index].min, max = machine.axes[index].max;
  const double size = std::abs(excess);
  return fmt::format("{} reaches {} mm, {} mm beyond its travel from {:.6g} to {:.6g} mm",
                     kAxisLetters[index], length_text((excess < 0 ? min : max) + excess, size),
                     length_text(size, size), min, max);
}

std::optional<Diagnostic> check_travel(const Move& move, const Machine& machine) {
  const AxisVector begin = start(move.path);
  const auto excess_in = [&](const Extent& box, int i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    return axis.present ? excess(box, axis, begin, i) : 0;
  };
  const Extent rough = bounds(move.path);
  bool within = true;
  for (int i = 0; i < kAxes; ++i) within = within && excess_in(rough, i) == 0;
  if (within) return std::nullopt;
  const Extent box = extent(move.path);
  std::string text;
  std::uint32_t beyond = 0;
  for (int i = 0; i < kAxes; ++i) {
    const double by = excess_in(box, i);
    if (by == 0) continue;
    text += (text.empty() ? "" : "; ") + beyond_travel(machine, i, by);
    beyond |= travel_end(i, by > 0);
  }
  if (text.empty()) return std::nullopt;
  return Diagnostic{Code::SC4001, {}, std::move(text), {}, {}, {}, beyond};
}

void report_travel(const Move& move, SourcePos source, const Machine& machine,
                   Diagnostics& diagnostics) {
  auto outside = check_travel(move, machine);
  if (!outside) return;
  outside->pos = source;
  diagnostics.report(std::move(*outside));
}

}  // namespace softcnc::ipo
