// SPDX-License-Identifier: MIT
// One move after the other along a curve.
#include "motion/pulses/pulse_curve.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc {
namespace {

/// Newton's method stops this close to a grid point, in BLU; the linear correction that follows
/// leaves less than its square.
constexpr double kClose = 0.03;
constexpr int kGridSteps = 20;
/// Further from a grid point than this, in BLU, the tangent is of no use.
constexpr double kNear = 4;
/// Where no next grid point is found the curve is followed without pulses in steps of this part of
/// a BLU, or of the span where it stands still.
constexpr double kCreep = 0.25, kCreepFromRest = 1.0 / 1024;
/// An axis that moves by less than this part of the leading one stands.
constexpr double kStands = 1e-9;
/// A curve that makes less than this many BLU of a span from here stands still.
constexpr double kStillTravel = 1e-6;
constexpr double kLeastCreep = 1e-12;
/// BLU: an axis that is further from its grid point has left it.
constexpr double kFull = 1e-6;

AxisVector as_real(const GridPoint& grid) noexcept {
  AxisVector real;
  for (int i = 0; i < kAxes; ++i) real[i] = static_cast<double>(grid[static_cast<std::size_t>(i)]);
  return real;
}

/// The derivative of the place, times w.
AxisVector tangent(const TracePoint& point) noexcept {
  const double ratio = point.slope[3] / point.value[3];
  return point.slope.head<kAxes>() - ratio * point.value.head<kAxes>();
}

Step step_of(int axis, double direction) noexcept {
  return {axis, static_cast<std::int64_t>(direction)};
}

}  // namespace

CurvePulses::CurvePulses(Trace trace, const GridPoint& displacement, PulseMethod method)
    : trace_(std::move(trace)), method_(method), end_(as_real(displacement)) {
  std::visit(
      [this](const auto& t) {
        spans_ = t.spans();
        for (std::size_t i = 0; i < moves_.size(); ++i) moves_[i] = t.moves(static_cast<int>(i));
        begin_span(t, 0);
      },
      trace_);
}

std::size_t CurvePulses::fill(std::span<Step> out) noexcept {
  return std::visit([&](const auto& trace) { return run(trace, out); }, trace_);
}

double CurvePulses::arc_length() const noexcept {
  const auto at = [this](const auto& trace) {
    if (span_ == spans_) return trace.arc_length(spans_ - 1, 1.0);
    return trace.arc_length(span_, std::clamp(grip_.t + grip_.correction(), 0.0, 1.0));
  };
  return std::visit(at, trace_);
}

template <typename T>
std::size_t CurvePulses::run(const T& trace, std::span<Step> out) noexcept {
  const auto follow_by = [&](std::span<Step> rest) {
    switch (method_) {
      case PulseMethod::sam:
        return follow<PulseMethod::sam>(trace, rest);
      case PulseMethod::m_sam:
        return follow<PulseMethod::m_sam>(trace, rest);
      case PulseMethod::dsm:
        return follow<PulseMethod::dsm>(trace, rest);
      case PulseMethod::m_dsm:
        return follow<PulseMethod::m_dsm>(trace, rest);
      case PulseMethod::dda:
        break;
    }
    return run_registers(trace, rest);
  };
  std::size_t filled = 0;
  while (filled < out.size() && span_ < spans_) filled += follow_by(out.subspan(filled));
  return filled + close(out.subspan(filled));
}

// Spans and courses -------------------------------------------------------------------------------

template <typename T>
void CurvePulses::begin_span(const T& trace, int span) noexcept {
  span_ = span;
  if (span == spans_) return;
  grip_ = {};
  grip_.point = trace.at(span, 0.0);
}

/// False where the curve stands still.
bool CurvePulses::choose_course() noexcept {
  const AxisVector along = tangent(grip_.point);
  for (int axis = 0; axis < kAxes; ++axis)
    if (std::abs(along[axis]) > std::abs(along[lead_])) lead_ = axis;
  other_count_ = 0;
  for (int axis = 0; axis < kAxes; ++axis)
    if (axis != lead_ && moves_[static_cast<std::size_t>(axis)]) all_others_[other_count_++] = axis;
  direction_ = along[lead_] < 0 ? -1.0 : 1.0;
  grip_ = grip_at(grip_.t, grip_.point, at_[lead_]);
  return std::abs(along[lead_]) > kStillTravel * grip_.weight();
}

template <typename T>
void CurvePulses::creep(const T& trace) noexcept {
  const double speed = tangent(grip_.point).norm() / grip_.weight();
  const double dt = std::clamp(kCreep / speed, kLeastCreep, kCreepFromRest);
  if (grip_.t + dt >= 1.0) return begin_span(trace, span_ + 1);
  grip_.t += dt;
  grip_.point = trace.at(span_, grip_.t);
}

bool CurvePulses::Grip::is_close() const noexcept {
  return slope > 0 && std::abs(gap) <= kClose * weight();
}

CurvePulses::Grip CurvePulses::grip_at(double t, const TracePoint& point,
                                       double level) const noexcept {
  const double gap = direction_ * (point.value[lead_] - level * point.value[3]);
  const double slope = direction_ * (point.slope[lead_] - level * point.slope[3]);
  const bool leads_on = slope > 0 && std::abs(gap) <= kNear * point.value[3];
  return {t, point, gap, slope, leads_on ? 1.0 / slope : 0.0};
}

CurvePulses::Other CurvePulses::other(int axis, const Grip& grip) const noexcept {
  const TracePoint& point = grip.point;
  const double slope = point.slope[axis] - at_[axis] * point.slope[3];
  return {slope, point.value[axis] - at_[axis] * point.value[3] + grip.correction() * slope};
}

// Moves -------------------------------------------------------------------------------------------

/// As long as one axis leads and the first step of Newton's method is good enough; then one move,
/// or a bit of the curve without one, with more care.
template <PulseMethod method, typename T>
std::size_t CurvePulses::follow(const T& trace, std::span<Step> out) noexcept {
  if (!choose_course()) {
    creep(trace);
    return 0;
  }
  std::size_t filled = 0;
  while (filled < out.size()) {
    if constexpr (method == PulseMethod::sam)
      if (const Step alone = move_alone(); alone.is_pulse()) {
        out[filled++] = alone;
        continue;
      }
    const double t = grip_.t + (grip_.weight() - grip_.gap) * grip_.inverse;
    if (!(t > grip_.t && t <= 1.0)) break;
    const Grip next = grip_at(t, trace.at(span_, t), at_[lead_] + direction_);
    if (!next.is_close()) break;
    out[filled++] = move_to<method>(next);
    if (steepest_ > next.slope) return filled;
  }
  if (filled == out.size()) return filled;
  if (const auto step = move_of_leading<method>(trace)) out[filled++] = *step;
  return filled;
}

template <PulseMethod method, typename T>
std::optional<Step> CurvePulses::move_of_leading(const T& trace) noexcept {
  const double level = at_[lead_] + direction_;
  Grip next = grip_at(grip_.t, grip_.point, level);
  if (next.gap >= 0) return move_to<method>(next);  // passed before
  for (int i = 0; i < kGridSteps && next.inverse > 0; ++i) {
    const double t = next.t + next.correction();
    if (t < grip_.t) break;
    if (t > 1.0 && next.t == 1.0) {
      begin_span(trace, span_ + 1);
      return std::nullopt;
    }
    next = grip_at(std::min(t, 1.0), trace.at(span_, std::min(t, 1.0)), level);
    if (next.is_close()) return move_to<method>(next);
  }
  creep(trace);
  return std::nullopt;
}

/// The move by which the leading axis reaches its next place, together with the axes that move with
/// it.
template <PulseMethod method>
Step CurvePulses::move_to(const Grip& next) noexcept {
  if constexpr (method == PulseMethod::dsm)
    if (const Step alone = nearer_alone(next); alone.is_pulse()) return alone;
  Step step = step_of(lead_, direction_);
  steepest_ = 0;
  for (const int axis : others()) {
    const Other after = other(axis, next);
    steepest_ = std::max(steepest_, std::abs(after.slope));
    const double joins = joining<method>(axis, after, next);
    at_[axis] += joins;
    step = step | step_of(axis, joins);
  }
  at_[lead_] += direction_;
  grip_ = next;
  return step;
}

/// Returns the direction in which an axis moves together with the leading one: -1, 0 or 1.
template <PulseMethod method>
double CurvePulses::joining(int axis, const Other& after, const Grip& next) const noexcept {
  if constexpr (method == PulseMethod::m_dsm) {
    const double half = 0.5 * next.weight();
    return (after.error > half ? 1.0 : 0.0) - (after.error < -half ? 1.0 : 0.0);
  } else if constexpr (method == PulseMethod::dsm) {
    const double side = side_of(axis, next);
    return std::abs(after.error - side * next.weight()) < std::abs(after.error) ? side : 0.0;
  } else if constexpr (method == PulseMethod::m_sam) {
    const Other before = other(axis, grip_);
    const double side = side_of(axis, grip_);
    return side * before.error >= 0 ? side : 0.0;
  } else {
    return 0.0;
  }
}

/// The direction in which the curve takes an axis, 0 if it does not: a matter of the curve alone.
double CurvePulses::side_of(int axis, const Grip& grip) const noexcept {
  const TracePoint& point = grip.point;
  const double along = point.slope[axis] * point.value[3] - point.value[axis] * point.slope[3];
  if (std::abs(along) <= kStands * grip.slope * point.value[3]) return 0.0;
  return along < 0 ? -1.0 : 1.0;
}

/// SAM: the move of the axis that lags furthest behind the curve, if one is not ahead of it.
Step CurvePulses::move_alone() noexcept {
  int furthest = -1;
  double most = 0;
  for (const int axis : others()) {
    const double side = side_of(axis, grip_);
    const double behind = side * other(axis, grip_).error;
    if (side == 0 || behind < most) continue;
    furthest = axis;
    most = behind;
  }
  return furthest < 0 ? Step() : move_aside(furthest, grip_);
}

/// DSM: the move of another axis alone, where it brings that nearer, and nearer than a move of the
/// leading one would.
Step CurvePulses::nearer_alone(const Grip& next) noexcept {
  for (const int axis : others()) {
    const double side = side_of(axis, next);
    const double now = other(axis, grip_).error / grip_.weight();
    const double along = other(axis, next).error / next.weight();
    const double least = std::min({std::abs(now), std::abs(along), std::abs(along - side)});
    if (side != 0 && std::abs(now - side) < least) return move_aside(axis, next);
  }
  return {};
}

Step CurvePulses::move_aside(int axis, const Grip& grip) noexcept {
  const double side = side_of(axis, grip);
  at_[axis] += side;
  return step_of(axis, side);
}

/// DDA: a clock is a BLU of the curve; a register that begins full overflows as soon as its axis
/// leaves a place of the grid.
template <typename T>
std::size_t CurvePulses::run_registers(const T& trace, std::span<Step> out) noexcept {
  std::size_t filled = 0;
  while (filled < out.size() && span_ < spans_) {
    const double speed = tangent(grip_.point).norm() / grip_.weight();
    if (speed <= kStillTravel) {
      creep(trace);
      continue;
    }
    const double t = grip_.t + clock_left_ / speed;
    if (t >= 1.0) {  // the clock goes on in the next span
      clock_left_ -= (1.0 - grip_.t) * speed;
      begin_span(trace, span_ + 1);
      continue;
    }
    grip_ = {t, trace.at(span_, t), 0, 0, 0};
    clock_left_ = 1;
    out[filled++] = overflow();
  }
  return filled;
}

Step CurvePulses::overflow() noexcept {
  const AxisVector along = tangent(grip_.point);
  const AxisVector place = grip_.point.value.head<kAxes>() / grip_.weight();
  Step step;
  for (int axis = 0; axis < kAxes; ++axis) {
    const double side = along[axis] < 0 ? -1.0 : 1.0;
    if (side * (place[axis] - at_[axis]) <= kFull) continue;
    at_[axis] += side;
    step = step | step_of(axis, side);
  }
  return step;
}

/// What is left to the end, less than a BLU or two.
std::size_t CurvePulses::close(std::span<Step> out) noexcept {
  std::size_t filled = 0;
  for (; filled < out.size() && at_ != end_; ++filled) {
    Step step;
    for (int axis = 0; axis < kAxes; ++axis) {
      if (at_[axis] == end_[axis]) continue;
      const double side = end_[axis] < at_[axis] ? -1.0 : 1.0;
      at_[axis] += side;
      step = step | step_of(axis, side);
      if (method_ == PulseMethod::sam) break;
    }
    out[filled] = step;
  }
  return filled;
}

}  // namespace softcnc
