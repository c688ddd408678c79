// SPDX-License-Identifier: MIT
// THE PIPELINE: part program -> blocks -> timed blocks -> setpoints -> backend -> rows.
//
//   Reader -> Parser -> Interpreter -> Planner ==queue==> Interpolator -> run_cycle -> Backend
//   '---------------- Feeder -----------------'
//   '---------------------- Channel -----------------------'
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include "ipo/queue/block_queue.hpp"
#include "ipo/queue/interpolator.hpp"
#include "ipo/queue/quiet_stretch.hpp"
#include "motion/model/cycle.hpp"
#include "motion/model/outputs.hpp"
#include "runtime/figures/run_times.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/feeder.hpp"
#include "runtime/session/requests.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

/// A Source of setpoints for one thread: it plans whenever the queue runs low.
class Channel {
 public:
  Channel(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
          Requests& requests, Diagnostics& diagnostics);

  /// Returns whether a request is to be answered before the next step.
  bool request_due() const noexcept;
  /// Plans the rest of the path again for the requests that are due. To be called right after
  /// forget_passed().
  void answer_requests() noexcept;

  /// Returns the next setpoint; nothing at the end. On a stop by the panel the rest of the path is
  /// planned again, to rest as soon as the limits allow; it must not ask between two calls of
  /// forget_passed().
  std::optional<Setpoint> step(const Panel& panel) noexcept;

  /// Lets a machine that follows the plan to the instant, and has not come further than to the
  /// setpoint `last`, stop behind that: what has been stepped over since then is taken back.
  /// Returns false, and has changed nothing, if the stop is found and `in_time` says that it comes
  /// too late.
  bool stop_after(const Setpoint& last, const std::function<bool()>& in_time) noexcept;
  /// Returns the period from which on the path has been planned as it is now.
  std::int64_t planned_from() const noexcept { return planned_from_; }

  /// Ends the path at rest where what has come so far ends: see Feeder::come_to_rest().
  void come_to_rest() noexcept;
  /// Reads what has come so far: Feeder::read_ahead().
  void read_ahead(int blocks) noexcept;

  /// Returns the pause that the next step passes, if there is one; resume() lets it pass.
  const Pause* pause_ahead() noexcept;
  void resume() noexcept { feeder_.pass_pause(); }
  /// Returns where the machine rests at that pause, with what is on there, as a setpoint that is no
  /// row: the last row may lie up to a period before it. To be called once for each pause.
  Setpoint rest_at_pause() noexcept {
    return interpolator_.rest_at(feeder_.pauses().front().block.number);
  }

  /// Another has moved the machine while it rested there: it stands at `place`, mm.
  void stand_at(const AxisVector& place) noexcept {
    interpolator_.stand_at(feeder_.pauses().front().block.number, place);
  }

  /// Returns whether there is no next setpoint until more of the program comes.
  bool waiting() const noexcept {
    return feeder_.needs_more_first() ||
           (feeder_.waiting() && queue_.t_end() <= interpolator_.needs_until());
  }

  /// Rows that follow the last one within a stretch where none can come near a limit, and how many
  /// of them there are to one that still draws the path.
  struct Quiet {
    std::int64_t rows = 0, to_next = 0;
  };
  Quiet quiet_ahead();
  /// The next step is `rows` later than it would be; they must be quiet.
  void pass_over(std::int64_t rows) noexcept { interpolator_.pass_over(rows); }

  /// Returns the blocks from the one of the last forget_passed() to the present one.
  const ipo::BlockQueue& queue() const noexcept { return queue_; }
  /// Forgets what has been passed and ended by the instant `until`, s.
  void forget_passed(double until = ipo::kUnlimited);
  /// Returns what is on at the last setpoint, or at the pause where the machine rests.
  const Outputs& outputs() const noexcept { return interpolator_.outputs(); }
  /// Coolant by hand: up to the next block that switches it.
  void set_coolant(bool mist, bool flood) noexcept {
    Outputs outputs = interpolator_.outputs();
    outputs.mist = mist;
    outputs.flood = flood;
    interpolator_.set_outputs(outputs);
  }
  /// Returns whether the speed of the spindle is as programmed, whatever its override.
  bool keeps_spindle_speed() const noexcept {
    const Move* move = queue_.empty() ? nullptr : queue_.front().move();
    return move != nullptr && !move->speed_override;
  }
  /// Fills the queue with the path up to `s` mm along the program, as far as that is known and the
  /// machine comes there within seconds.
  void see_path_to(double s) noexcept;

  /// Passes on what an exception has broken off.
  void rethrow() const;

  /// The instant of the plan that has been reached, s: at the end, its duration. Of methods that go
  /// their own path through the curves, the instant of the last row.
  double time() const noexcept;
  /// Returns what the time was spent on. Nothing may be run after this call.
  const RunTimes& end_times();

  Feeder& feeder() noexcept { return feeder_; }
  const Feeder& feeder() const noexcept { return feeder_; }

 private:
  bool plan_ahead() noexcept;
  void replan() noexcept;
  void pass(const ipo::TimedBlock& timed);
  double request_time() const noexcept;
  void add_period(const Setpoint& next) noexcept;
  void add_passed();
  void add_present();

  const Machine& machine_;
  Requests& requests_;
  ipo::FeedControl control_;
  Feeder feeder_;
  ipo::BlockQueue queue_;
  bool follows_plan_;  // the rows lie where the plan is at their instants
  ipo::Interpolator interpolator_;
  RunTimes times_;                    // of what has been forgotten
  Limit limit_before_ = Limit::stop;  // of the last row
  bool started_ = false, stopping_ = false;
  std::int64_t planned_from_ = 0;  // period
  bool replanned_ = false;         // the interpolator does not know of it yet
  double quiet_start_ = -1;        // s: when that block begins
  ipo::QuietStretch quiet_;  // of the present block, from the instant on at which it was looked at
  std::exception_ptr broken_;
};

}  // namespace softcnc::runtime
