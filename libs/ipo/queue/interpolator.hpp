// SPDX-License-Identifier: MIT
// The setpoint one period later.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ipo/methods/acc_dec.hpp"
#include "ipo/methods/parameter_walk.hpp"
#include "ipo/queue/block_queue.hpp"
#include "ipo/queue/fine_spline.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Returns how many fine points a period has, as its backend requires.
inline std::size_t fine_points(const Control& control) noexcept {
  const bool simulated = control.backend == BackendKind::sim;
  return static_cast<std::size_t>(
      parts_of_period(control, simulated ? loop_period(control) : fine_period(control)));
}

class Interpolator {
 public:
  /// `queue` and `machine` must outlive the interpolator. `start` is where the machine stands, mm,
  /// up to the first move.
  Interpolator(BlockQueue& queue, const Machine& machine,
               const AxisVector& start = AxisVector::Zero());

  /// Realtime. Returns the next setpoint; nothing after the last one, which rests at the end of the
  /// queue. The queue must hold every block up to needs_until(), or all there are.
  std::optional<Setpoint> step() noexcept;

  /// Sets the override of the programmed feed from the next setpoint on: what Setpoint::feed shows.
  void set_feed_override(double feed_override) noexcept { feed_override_ = feed_override; }
  double feed_override() const noexcept { return feed_override_; }

  /// Sets what is switched on from the next setpoint on.
  void set_outputs(const Outputs& outputs) noexcept { last_.outputs = outputs; }
  /// Returns what the blocks so far have switched on.
  const Outputs& outputs() const noexcept { return last_.outputs; }

  /// Returns the planned time, s, that the next step may reach.
  double needs_until() const noexcept;

  /// Returns the state of the machine in the front block of the queue. Planning side.
  State state() const noexcept;

  /// Returns the time in the present block, s of its profile. Planning side.
  double time_in_block() const noexcept { return t_; }
  /// Delays the next step by `periods`, within the present block.
  void pass_over(std::int64_t periods) noexcept { periods_ += periods; }

  /// Continues behind a setpoint that it has made, of a path of which the queue still holds all
  /// from there on. Only for methods that follow the plan to the instant. Planning side.
  void go_back_to(const Setpoint& setpoint) noexcept;

  /// Returns where the machine rests before the block `number`, with all that is switched before
  /// it: within a period behind the last setpoint, and no setpoint of its own. Methods that go
  /// their own way rest at their last setpoint. It is valid until the next step. Planning side.
  Setpoint rest_at(int number) noexcept;

  /// Passes all up to the block `number`, behind which another has moved the machine to `place`,
  /// mm.
  void stand_at(int number, const AxisVector& place) noexcept;

  /// Makes no setpoint any more: the last one rests at the end of the queue.
  void end() noexcept { done_ = true; }

  /// Continues where it is after the queue has been planned again from state(): the front block is
  /// the same one, and its profile starts there. Planning side.
  void replanned() noexcept;

  /// Returns the number of setpoints made so far.
  std::int64_t periods() const noexcept { return periods_; }
  /// Returns the instant of the last setpoint, s.
  double time() const noexcept { return static_cast<double>(periods_ - 1) * control_.period; }
  /// Returns the instant of state(), s: that of the last setpoint, or of the last rough one.
  double state_time() const noexcept;

 private:
  static constexpr std::size_t kPulses = 4096;  // per period without a further allocation
  static constexpr double kChordPeriods = 4;    // periods of path that a chord may cut off

  void enter_block() noexcept;
  void leave_block() noexcept;
  void follow_time() noexcept;
  void go_to(double t) noexcept;
  void look_between() noexcept;
  FinePoint point() noexcept;
  FinePoint ahead() const noexcept;
  std::span<const FinePoint> fine(const Setpoint& next) noexcept;
  void walk_pulses(double t, double s) noexcept;
  void follow_method(double period) noexcept;
  void follow_chord(double left) noexcept;
  bool pass_rest(double& left) noexcept;
  std::int64_t rough_periods(std::int64_t periods) const noexcept;
  Setpoint after_interpolation() noexcept;
  Setpoint lagging(const RoughPoint& average) noexcept;
  double place(const State& now) noexcept;
  Setpoint setpoint() noexcept;

  BlockQueue& queue_;
  const Control& control_;
  std::int64_t periods_ = 0;           // setpoints made so far
  double t_ = 0;                       // planned time within the front block
  std::size_t hint_ = 0;               // piece of its profile
  std::optional<ParameterWalk> walk_;  // through its NURBS, by a method of the literature
  std::optional<AccDec> acc_dec_;      // after interpolation
  Setpoint lagging_;                   // the last setpoint after it; last_ is that of the plan
  std::vector<TimedStep> pulses_;      // by a method of reference pulses: of the period
  std::vector<FinePoint> fine_;        // of the period
  FineSpline spline_;                  // where the fine points are not the plan itself
  double feed_override_ = 1;
  double planned_ = 0;           // integral of the planned speed since the last setpoint, mm
  double planned_from_ = 0;      // program length at the last setpoint, mm
  std::size_t before_rest_ = 0;  // fine points of the next setpoint
  Setpoint last_;
  bool done_ = false;
};

}  // namespace softcnc::ipo
