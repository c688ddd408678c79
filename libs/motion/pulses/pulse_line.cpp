// SPDX-License-Identifier: MIT
// The recurrences of the line: additions and signs, nothing else.
#include "motion/pulses/pulse_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace softcnc {
namespace {

/// The length of the line in whole BLU; half a BLU more or less does not matter.
std::int64_t whole_length(const GridPoint& displacement) noexcept {
  double squares = 0;
  for (const std::int64_t b : displacement)
    squares += static_cast<double>(b) * static_cast<double>(b);
  return std::llround(std::sqrt(squares));
}

}  // namespace

LinePulses::LinePulses(const GridPoint& displacement, PulseMethod method) noexcept
    : method_(method) {
  const bool dda = method_ == PulseMethod::dda;
  const auto further = [](std::int64_t a, std::int64_t b) { return std::abs(a) < std::abs(b); };
  const auto longest = std::max_element(displacement.begin(), displacement.end(), further);
  const std::int64_t most = std::abs(*longest);
  if (most == 0) return;
  distance_ = dda ? std::max(whole_length(displacement), most) : most;
  left_ =
      dda ? distance_ - (distance_ - 1) / most : most;  // until the last register has overflowed
  for (auto axis = displacement.begin(); axis != displacement.end(); ++axis) {
    const Step step(static_cast<int>(axis - displacement.begin()), *axis);
    if (axis == longest && !dda) {
      always_ = step;
    } else if (*axis != 0) {
      const std::int64_t b = std::abs(*axis);
      all_joiners_[joiner_count_++] = {step, b, preset(b)};
      if (method_ == PulseMethod::sam) left_ += b;
    }
  }
}

/// M_SAM, M_DSM and DDA are one recurrence and differ in where it begins. An axis moves where
///   m_sam  D <= 0
///   m_dsm  D + a - b is nearer to 0 than D - b, that is, 2 D - 2 b + a < 0
///   dda    its register, which begins with a - 1 and takes b each clock, reaches a
std::int64_t LinePulses::preset(std::int64_t distance) const noexcept {
  if (method_ == PulseMethod::dsm) return 0;
  if (method_ == PulseMethod::m_dsm) return distance_ - 2 * distance;
  return method_ == PulseMethod::dda ? -distance : -1;
}

std::size_t LinePulses::fill(std::span<Step> out) noexcept {
  const auto n = std::min<std::int64_t>(left_, std::ssize(out));
  out = out.first(static_cast<std::size_t>(n));
  left_ -= n;
  if (method_ == PulseMethod::sam)
    run_stairs(out);
  else if (method_ == PulseMethod::dsm)
    run_search(out);
  else
    run_recurrence(out);
  return out.size();
}

/// One axis after the other over the whole run: each adds its part to the steps.
void LinePulses::run_recurrence(std::span<Step> out) noexcept {
  std::fill(out.begin(), out.end(), always_);
  const std::int64_t scale = method_ == PulseMethod::m_dsm ? 2 : 1;
  const std::int64_t up = scale * distance_;
  for (Joiner& joiner : joiners()) {
    const Step joining = joiner.step;
    const std::int64_t down = scale * joiner.distance;
    std::int64_t d = joiner.d;
    for (Step& step : out) {
      const bool joins = d < 0;
      step = step.with_if(joins, joining);
      d += (joins ? up : 0) - down;
    }
    joiner.d = d;
  }
}

/// SAM: the axis furthest below the line moves until none is on or below it; then the long one.
void LinePulses::run_stairs(std::span<Step> out) noexcept {
  const auto lower = [](const Joiner& a, const Joiner& b) { return a.d < b.d; };
  for (Step& step : out) {
    const auto lowest = std::min_element(joiners().begin(), joiners().end(), lower);
    if (joiner_count_ > 0 && lowest->d < 0) {
      step = lowest->step;
      lowest->d += distance_;
    } else {
      step = always_;
      for (Joiner& joiner : joiners()) joiner.d -= joiner.distance;
    }
  }
}

/// DSM: the smallest |D| after moving the long axis, the diagonal or the other axis. The last is
/// never nearer than the diagonal: while |D| <= a / 2, |D + a| >= |D + a - b|. It is evaluated
/// nevertheless, as the method does.
void LinePulses::run_search(std::span<Step> out) noexcept {
  for (Step& step : out) {
    step = always_;
    for (Joiner& joiner : joiners()) {
      const std::int64_t along = joiner.d - joiner.distance;
      const std::int64_t diagonal = along + distance_;
      const std::int64_t aside = joiner.d + distance_;
      const bool joins = std::min(std::abs(diagonal), std::abs(aside)) < std::abs(along);
      step = step.with_if(joins, joiner.step);
      joiner.d = joins ? diagonal : along;
    }
  }
}

}  // namespace softcnc
