// SPDX-License-Identifier: MIT
// A curve without an equation in its coordinates as a staircase: NURBS, helix, spiral.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <variant>

#include "motion/pulses/pulse.hpp"
#include "motion/pulses/pulse_trace.hpp"

namespace softcnc {

/// Paper 003, chapter 4 and Table 4: the axis along which the tangent is longest leads. The
/// parameter at which the curve reaches the leading axis' next BLU is found by Newton's method; the
/// distance of the curve from the positions of the other axes is then the error D that decides
/// whether they move. Positions are whole; the parameter is real, and is determined again at every
/// move, so that no error accumulates. Three axes are two planes that share the leading one.
class CurvePulses {
 public:
  using Trace = std::variant<SplineTrace, ArcTrace>;

  /// `trace` counts from the grid point where the staircase starts; `displacement` is where it
  /// ends.
  CurvePulses(Trace trace, const GridPoint& displacement, PulseMethod method);

  /// Fills in the next clocks, as many as there are and fit; returns 0 at the end. Realtime.
  std::size_t fill(std::span<Step> out) noexcept;

  /// Returns the arc length of the curve at the staircase, mm.
  double arc_length() const noexcept;

 private:
  /// What is known of the position where the curve was last evaluated, in the terms of Newton's
  /// method: how far its leading coordinate is beyond that of the staircase, times w.
  struct Grip {
    double t = 0;
    TracePoint point{Homogeneous::Zero(), Homogeneous::Zero()};
    double gap = 0, slope = 0, inverse = 0;  // slope: of the gap by t

    double weight() const noexcept { return point.value[3]; }
    double correction() const noexcept { return -gap * inverse; }  // of t, to the very place
    bool is_close() const noexcept;
  };
  struct Other {
    double slope, error;  // of the curve against the staircase, times w
  };

  template <typename T>
  std::size_t run(const T& trace, std::span<Step> out) noexcept;
  template <PulseMethod method, typename T>
  std::size_t follow(const T& trace, std::span<Step> out) noexcept;
  template <PulseMethod method, typename T>
  std::optional<Step> move_of_leading(const T& trace) noexcept;
  template <PulseMethod method>
  Step move_to(const Grip& next) noexcept;
  template <typename T>
  std::size_t run_registers(const T& trace, std::span<Step> out) noexcept;

  template <typename T>
  void begin_span(const T& trace, int span) noexcept;
  template <typename T>
  void creep(const T& trace) noexcept;
  bool choose_course() noexcept;
  Grip grip_at(double t, const TracePoint& point, double level) const noexcept;
  std::span<const int> others() const noexcept { return {all_others_.data(), other_count_}; }
  Other other(int axis, const Grip& grip) const noexcept;
  double side_of(int axis, const Grip& grip) const noexcept;
  template <PulseMethod method>
  double joining(int axis, const Other& after, const Grip& next) const noexcept;
  Step move_alone() noexcept;
  Step nearer_alone(const Grip& next) noexcept;
  Step move_aside(int axis, const Grip& grip) noexcept;
  Step overflow() noexcept;
  std::size_t close(std::span<Step> out) noexcept;

  Trace trace_;
  PulseMethod method_;
  AxisVector end_, at_ = AxisVector::Zero();  // BLU: the end, and where the staircase stands
  int span_ = 0, spans_ = 0;
  int lead_ = 0;
  double direction_ = 1;
  std::array<bool, kAxes> moves_{};  // which axes the curve moves at all
  std::array<int, kAxes - 1> all_others_{};
  std::size_t other_count_ = 0;
  double steepest_ = 0;  // slope of the other axes at the last move, times w
  Grip grip_;
  double clock_left_ = 1;  // DDA: of the clock that a knot has cut, BLU
};

}  // namespace softcnc
