// SPDX-License-Identifier: MIT
#include "runtime/check/travel_survey.hpp"

#include <algorithm>

#include "motion/geometry/extent.hpp"

namespace softcnc::runtime {
namespace {

bool contains(const TravelSpan& span, const Extent& box) {
  return (span.min.array() <= box.min.array()).all() && (span.max.array() >= box.max.array()).all();
}

}  // namespace

void TravelSpan::include(int axis, double low, double high) noexcept {
  min[axis] = std::min(min[axis], low);
  max[axis] = std::max(max[axis], high);
}

/// Of a line only the end counts: it may begin where another system, or none, has led.
void TravelSurvey::add(const Move& move) {
  TravelSpan& span = spans_[move.work_system];
  if (const auto* line = std::get_if<Line>(&move.path)) {
    const AxisVector from = line->from(), to = line->to();
    for (int i = 0; i < kAxes; ++i)
      if (from[i] != to[i]) span.include(i, to[i], to[i]);
    return;
  }
  if (contains(span, bounds(move.path))) return;
  const Extent box = extent(move.path);
  for (int i = 0; i < kAxes; ++i)
    if (box.min[i] < box.max[i]) span.include(i, box.min[i], box.max[i]);
}

TravelSpan TravelSurvey::all() const noexcept {
  TravelSpan all;
  for (const auto& [system, span] : spans_)
    for (int i = 0; i < kAxes; ++i)
      if (!span.empty(i)) all.include(i, span.min[i], span.max[i]);
  return all;
}

}  // namespace softcnc::runtime
