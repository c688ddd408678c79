// SPDX-License-Identifier: MIT
// A person at the machine: programs, lines, moves by hand, hold and abort, and what the machine
// does in each of its states.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/backends/backend.hpp"
#include "motion/core/result.hpp"
#include "motion/model/outputs.hpp"
#include "runtime/operator/homing.hpp"
#include "runtime/operator/jog_move.hpp"
#include "runtime/operator/machine_mode.hpp"
#include "runtime/operator/open_text.hpp"
#include "runtime/operator/position_status.hpp"
#include "runtime/operator/probing.hpp"
#include "runtime/session/session.hpp"

namespace softcnc::runtime {

/// The machine as its operator meets it. It has no clock: each step() is one period, and whoever
/// calls it decides when. A request that is not possible in the present state is refused (SC5080)
/// and changes nothing; mode_rule() is the table. It is not thread-safe, and stays where it was
/// made.
class Operator {
 public:
  /// `machine`, `backend` and `sink` must outlive it; `sink` takes every row and may be null.
  /// `options.state` says where the machine stands. What is wrong with lines goes to `report`.
  Operator(const Machine& machine, const ChannelOptions& options, hal::Backend& backend,
           RowSink* sink = nullptr, Diagnostics::Sink report = {});
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  // Requests
  // ---------------------------------------------------------------------------------------

  /// Runs lines, with the modes that the lines before have left, and without a stop between them
  /// where they come in time: within kPatience at rest, and in motion before the machine has to
  /// brake for the end of those before. What is wrong with the first kReadAtOnce blocks is reported
  /// before this returns. Lines that open a loop or a subprogram wait until it is closed. Errors:
  /// SC5070, SC5080.
  Status line(std::string_view text);
  /// Returns whether line() waits for the end of a loop or a subprogram.
  bool is_line_open() const noexcept { return open_.is_open(); }
  /// Forgets the lines of a loop or a subprogram that is not closed.
  void forget_lines() { open_.forget(); }
  /// Runs a program from its beginning, with the modes at the start of a program; what it calls is
  /// looked for in `folder`. Where it changes a tool, spindle and coolant go off, the machine moves
  /// to the place of the machine file, if that has one, and waits in Hold. Errors: SC5070, SC5080.
  Status start(std::string_view program, const std::string& folder = {});
  /// Moves by hand, behind the jogs before; in Hold too, from where resume() comes back first.
  /// Where the position is not known it is slow, and no end of travel counts; in Alarm, after a
  /// limit switch, only slowly away from that. Errors: SC4001, SC5080.
  Status jog(const Jog& jog);
  /// Ends jogs within the limits of the machine.
  Status cancel();
  /// Searches the home switches of all axes that have one, in the order of the machine file, and
  /// sets the machine coordinates by them; from then on the position is known, if every axis has
  /// one. Where a switch is not where it should be, the machine comes to rest and Alarm follows
  /// (SC5090 in `report`); where homing is ended, nothing is set, and Alarm stays where it has
  /// begun there. Errors: SC5080.
  Status home();
  /// Sets the origin of the active work system so that the machine stands at `value` mm there.
  Status touch_off(int axis, double value);

  /// Comes to rest on the path. A jog ends.
  Status hold();
  /// Goes on after a hold, a pause or a closed door: first back to return_point(), in X and Y at
  /// the greater of both heights; then, after a door or a change of the tool, once the spindle has
  /// its speed.
  Status resume();
  /// Comes to rest on the path and ends the program, or the jog.
  Status abort();
  /// Does the same, and puts all modes back to those at the start of a program; from motion it ends
  /// in Alarm. Spindle and coolant go off.
  Status reset();
  /// The door is open: comes to rest; spindle and coolant off.
  Status door();
  /// The door is closed again: resume() is possible, unless an input of the backend says otherwise.
  void door_closed() noexcept { door_open_ = door_input_; }
  /// Leaves Alarm. Errors: SC5080; SC5031 to SC5033 where an input of the port is still on.
  Status unlock();
  /// Begins or ends that lines are only judged.
  Status check();
  /// Switches outputs off until reset().
  Status sleep();

  /// Rows end at once, without a ramp. The position is not known any more, unless the backend
  /// measures it.
  void estop();
  /// A switch at an end of an axis: comes to rest within the limits, then Alarm. `direction`: -1 or
  /// 1, towards the switch.
  void limit_switch(int axis, int direction);

  void set_feed_override(double feed_override) noexcept;
  void set_rapid_override(double rapid_override) noexcept;
  void set_spindle_override(double spindle_override) noexcept;
  /// Switches the coolant, until the program does; in Idle, Run, Hold and Jog.
  void set_coolant(bool mist, bool flood);
  /// In Hold, at rest: stops the spindle, or lets it turn again; resume() does that, too, and waits
  /// for its speed.
  void toggle_spindle();
  /// Count for the lines that have not been read yet: a running program is read ahead.
  void set_block_skip(bool on) noexcept;
  void set_optional_stop(bool on) noexcept;
  void set_single_block(bool on) noexcept;
  /// The shift of G92 is gone, as after a reset of grbl. Only at rest, outside programs.
  void forget_shift();
  /// The machine stands at `place`, mm, machine coordinates: somebody has looked. Errors: SC5080
  /// while it moves, or beyond what can be kept.
  Status set_position(const AxisVector& place);

  // Motion
  // -----------------------------------------------------------------------------------------

  /// Moves the machine by one period and returns the row. Nothing where nothing moves, or where the
  /// state has just changed.
  std::optional<Row> step();

  MachineMode mode() const noexcept { return mode_; }
  /// Returns whether step() may give a row that moves the machine.
  bool in_motion() const noexcept {
    return moving() || jog_ || mode_ == MachineMode::run || mode_ == MachineMode::home;
  }
  /// Returns whether a motion ends where an input changes: how soon, depends on how much of it has
  /// been planned by then.
  bool awaits_input() const noexcept { return homing_ || probing_; }
  /// Returns whether a program runs or is held.
  bool in_program() const noexcept { return running_ && is_program_; }
  /// Returns whether the last home() has found its switches.
  bool has_homed() const noexcept { return homed_; }
  /// Returns whether a motion by hand comes to its end and takes no more.
  bool ends_jog() const noexcept { return jog_ && !jog_->takes_more(); }
  /// Returns whether the last program has come to its end without an error.
  bool has_completed() const noexcept { return completed_; }
  /// Returns whether the machine has been held on its way to the place for tool changes: resume()
  /// leads there first.
  bool is_short_of_change() const noexcept { return to_change_.has_value(); }
  /// Returns what a program waits for in Hold; null: for nothing but resume().
  const Pause* pause() const noexcept { return running_ ? session_->pause() : nullptr; }
  bool moving() const noexcept { return last_.v > kStandstill; }
  /// Returns whether position() is where the machine is.
  bool knows_position() const noexcept { return known_; }
  const AxisVector& position() const noexcept { return last_.position; }
  /// Returns a place in the coordinates of the block that runs: Session::programmed().
  AxisVector programmed(const AxisVector& place) const noexcept {
    return session_->programmed(place);
  }
  /// Returns the length of the unit of lines that come next, mm.
  double mm_per_unit() const noexcept { return session_->mm_per_unit(); }
  /// Returns the modes of these lines.
  const ipr::Memory& memory() const noexcept { return session_->memory(); }
  /// Returns how many blocks of lines the machine has not come to.
  int blocks_ahead() const noexcept { return session_->blocks_ahead(); }
  /// Returns how far it is to the end of the present move, mm.
  AxisVector to_go() const noexcept;
  /// Returns the last row.
  const Setpoint& last() const noexcept { return last_; }
  /// Returns what is switched on.
  const Outputs& outputs() const noexcept { return outputs_; }
  /// Returns where resume() comes back to before the program goes on; nothing where the machine is
  /// there.
  std::optional<AxisVector> return_point() const noexcept;
  /// Returns what a new process has to know; in motion, and where it is not known, with the mark.
  MachineState state() const;

 private:
  static constexpr double kStandstill = 1e-6;  // mm/s: rounding, where a move ends
  static constexpr double kSamePlace = 1e-6;   // mm: the same
  static constexpr double kPatience = 0.02;    // s: for the next line, at rest
  static constexpr int kReadAtOnce = 2000;     // blocks of lines: a loop may have no end

  struct Switch {
    int axis, direction;
  };

  std::optional<Status> answered(Request request) const;
  std::optional<Status> answered_to_run(Request request) const;
  void begin_session(const MachineState& state);
  Status run(std::string_view text, bool is_program);
  Status judge(std::string_view text);
  bool leads_off_switch(const Jog& jog) const noexcept;
  void move_by_hand(const AxisVector& to, double feed);
  void home_on();
  void begin_by_hand(const Machine& machine);
  void begin_probing();
  void probe_on();
  void look_around();
  void take_door(bool open);
  void fail(const Feedback& feedback);
  void stand_at(const AxisVector& place);
  void pause_motion();
  std::int64_t periods_in(double seconds) const noexcept;
  std::int64_t periods_to_speed() const noexcept;
  void go_on();
  void change_tool();
  void move_to_change();
  void move_over_to(const AxisVector& place);
  MachineMode mode_at_rest() const noexcept {
    return door_open_ ? MachineMode::door : locked_ ? MachineMode::alarm : MachineMode::idle;
  }
  void switch_off() noexcept;
  void send_outputs() noexcept;
  void end_in(MachineMode mode);
  void ended();
  std::optional<Row> step_of(Session& session);
  void follow_outputs() noexcept;
  void settle_jog();
  void settle_program();
  void set_switches() noexcept;

  const Machine& machine_;
  const Machine free_machine_;  // without ends of travel
  ChannelOptions options_;
  hal::Backend& backend_;
  std::unique_ptr<hal::Backend> nowhere_;  // of what is only judged
  RowSink* sink_;
  Diagnostics::Sink report_;
  MachineMode mode_ = MachineMode::idle;
  std::optional<Session> session_;  // of lines and programs
  std::optional<Session> jog_;
  std::optional<Session> judged_;            // in Check
  AxisVector jog_end_ = AxisVector::Zero();  // mm: of the last one that was requested
  std::optional<Homing> homing_;             // its legs are jogs
  std::optional<Probing> probing_;           // its move is one, too,
  bool probes_ = false;                      // and it is the present one
  bool locked_ = false;                      // it has begun in Alarm, and not come to its end
  OpenText open_;
  Setpoint last_;
  bool begun_ = false;                 // there is a last row
  bool rests_ = false;                 // since then, and the backend knows
  bool known_;                         // the position
  Outputs outputs_, programmed_;       // with the override of the spindle, and without
  std::optional<Outputs> before_off_;  // by a door or for a change of the tool
  bool running_ = false, is_program_ = false;
  std::optional<AxisVector> left_;       // mm: where a jog in Hold has left the program
  bool returning_ = false;               // to that place
  std::optional<AxisVector> to_change_;  // mm: the place for tool changes, on the way there
  bool completed_ = false;               // the last program
  bool homed_ = false;                   // by the last home()
  std::optional<MachineMode> rests_in_;  // once the machine is at rest,
  bool resets_ = false;                  // spindle and coolant go off then
  bool door_open_ = false;
  bool door_input_ = false;       // the same, by the backend's input
  std::int64_t waits_ = 0;        // periods: for the spindle
  std::int64_t dry_ = 0;          // periods: at rest, without a next line
  std::optional<Switch> switch_;  // at an end of an axis
  double feed_override_ = 1, rapid_override_ = 1, spindle_override_ = 1;
  std::vector<double> values_;  // of the row of an alarm
};

}  // namespace softcnc::runtime
