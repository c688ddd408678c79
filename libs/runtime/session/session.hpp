// SPDX-License-Identifier: MIT
// A run that its user drives: lines or blocks in, a row per period out, and an operator's requests.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hal/backends/backend.hpp"
#include "ipr/text/reader.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/verification/contour_error.hpp"
#include "runtime/session/channel.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/requests.hpp"
#include "runtime/session/verification.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc::runtime {

enum class SessionStatus : std::uint8_t {
  running,  // step() gives the next row
  waiting,  // for more of the program; the last row may be at speed, unless rest() was called
  paused,   // at M00, M01 or M06: resume() goes on; or at probe(): probed() does
  done,     // the program, or what abort() has left of it, has come to its end
  alarm,    // of the backend: nothing moves any more
  error,    // a line was wrong: the machine stands where the last good block ends, see go_on()
};

/// One period of a session.
struct Row {
  Setpoint setpoint;               // its spans are valid until the next step()
  Feedback feedback;               // of the backend
  std::span<const double> values;  // of row_columns(), valid until the next step()
};

/// Runs a program that comes line by line or block by block. The session has no clock: each step()
/// is one period of the machine, and whoever calls it decides when. A session is not thread-safe,
/// and stays where it was made.
class Session {
 public:
  /// Makes a session. `machine`, `backend` and `sink` must outlive it; `sink` takes every row and
  /// may be null. What is wrong with the program goes to `report`, or is kept in diagnostics().
  Session(const Machine& machine, const ChannelOptions& options, hal::Backend& backend,
          RowSink* sink = nullptr, Diagnostics::Sink report = {});
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Adds text to the program; a line counts once its end has come. A subprogram, a loop and what a
  /// branch leaves out must come as one text. Ignored where takes_more() is false. Errors: SC6032.
  Status feed(std::string_view text);
  /// Adds a block to the program, before lines that have not been read yet. Its number is one more
  /// than that of the block before, if it is 0.
  void feed(Block block);
  /// Records that nothing more is fed.
  void end() noexcept;
  /// Returns whether more can be fed: neither end() nor abort() has been called, and the session
  /// has not ended.
  bool takes_more() const noexcept {
    return !fed_ && !requests_.stops() && status_ <= SessionStatus::paused;
  }
  /// After an error, as a control does when its operator has read it, and after the end of a
  /// program: what has been fed and was not run is forgotten, modes, offsets and variables are
  /// those behind the last line without an error, the machine stays where it stands, and more can
  /// be fed. A subprogram, a curve over several lines and cutter compensation end. After abort()
  /// modes are those at the start of a program. Ignored unless the status is `error`, or `done`
  /// without end(). A program in the commands of paper 003 is `done` after an error.
  void go_on();
  /// Another session has moved the machine to `row` while this one was at rest: rows count on
  /// behind it. In the middle of a program it must be where this one has left it.
  void count_on_from(const Setpoint& row);
  /// Lets the machine come to rest where what has been fed so far ends, instead of waiting there
  /// for more; more may be fed. Lines that an open curve or cutter compensation still holds stay
  /// where they are.
  void rest() noexcept;
  /// Returns whether it comes to rest there.
  bool rests() const noexcept { return rests_; }
  /// Reads what has been fed, at most so many blocks, so that what is wrong with it is reported
  /// now.
  void read_ahead(int blocks) noexcept { channel_->read_ahead(blocks); }

  /// Moves the machine by one period and returns the row; nothing unless the status is then
  /// `running`. Throws only std::bad_alloc.
  std::optional<Row> step();
  SessionStatus status() const noexcept { return status_; }

  /// Lets the machine come to rest on the path, and stay there until resume().
  void hold() noexcept { requests_.hold(); }
  /// Ends a hold or a pause.
  void resume() noexcept;
  /// Multiplies the programmed feed, up to 2; what is below 0.001 holds. NaN changes nothing.
  void set_feed_override(double feed_override) noexcept {
    requests_.set_feed_override(feed_override);
  }
  /// Multiplies the speed of rapids, from 0.01 to 1. NaN changes nothing.
  void set_rapid_override(double rapid_override) noexcept {
    requests_.set_rapid_override(rapid_override);
  }
  /// Multiplies the speed of the spindle, from 0.1 to 2; it stays within the machine's. NaN changes
  /// nothing.
  void set_spindle_override(double spindle_override) noexcept;
  /// Sets whether lines that begin with '/' are passed over, M01 stops, and every move ends at rest
  /// and waits, from the lines on that have not been read yet.
  void set_switches(bool block_skip, bool optional_stop, bool single_block) noexcept;
  /// Lets the machine come to rest on the path, and ends the program there.
  void abort() noexcept { requests_.stop(); }

  /// Returns what was reported without a `report`. After an error the motion ends with the last
  /// good block.
  std::span<const Diagnostic> diagnostics() const noexcept { return diagnostics_.all(); }
  int errors() const noexcept { return diagnostics_.errors(); }

  /// Returns what the rows so far, or since go_on(), have reached, and how far they were from the
  /// path.
  Measured measured() const noexcept { return verification_->measured(); }
  std::optional<ContourReport> contour() const;
  /// Returns offsets, tools, variables and position as programs that follow find them.
  MachineState state() const;
  /// Returns the length of the unit in which the lines that follow are read, mm.
  double mm_per_unit() const noexcept { return channel_->feeder().memory().modal.mm_per_unit; }
  /// Returns what is switched on at the place of the last row, or of the pause, at the speed that
  /// the override of the spindle leaves. Rows have the same.
  Outputs outputs() const noexcept { return overridden(programmed_outputs()); }
  /// Returns the same at the speed that is programmed.
  const Outputs& programmed_outputs() const noexcept { return channel_->outputs(); }
  /// Everything is off, whatever the program has switched, until switch_on().
  void switch_off() noexcept { off_ = true; }
  void switch_on() noexcept { off_ = false; }
  bool is_off() const noexcept { return off_; }
  /// Switches the coolant, until the program does.
  void set_coolant(bool mist, bool flood) noexcept { channel_->set_coolant(mist, flood); }
  /// Returns the pause at which the session waits for resume(); null: at none.
  const Pause* pause() const noexcept {
    return status_ == SessionStatus::paused ? &channel_->feeder().pauses().front() : nullptr;
  }
  /// Returns the probing move at which the session waits for probed(); null: at none.
  const ProbeRequest* probe() const noexcept;
  /// Takes what another session, which has moved the machine there, has found: count_on_from() has
  /// its last row. The program goes on from where it rests.
  void probed(const ProbeAnswer& answer);
  /// Returns modes, offsets and variables of the lines that have been read: these are ahead of the
  /// motion.
  const ipr::Memory& memory() const noexcept { return channel_->feeder().memory(); }
  /// Returns a place of the machine in the coordinates of the block that runs, or, where all has
  /// been run, of those lines, mm.
  AxisVector programmed(const AxisVector& place) const noexcept;
  /// Returns how many blocks have been read that the machine has not come to.
  int blocks_ahead() const noexcept;
  /// Returns where the present move ends, mm, machine coordinates; nothing between moves.
  std::optional<AxisVector> goal() const noexcept;
  /// Returns the last row, without pulses and fine points; at a pause, where the machine rests.
  const Setpoint& last() const noexcept { return last_; }
  /// Returns where the last row was, mm; before the first one, where the session begins.
  const AxisVector& position() const noexcept { return last_.position; }

 private:
  bool is_all_run() const noexcept;
  void begin();
  void begin_again(ipr::Memory* memory);
  SessionStatus end_of_motion() noexcept;
  Setpoint counted_on(Setpoint setpoint) const noexcept;
  bool is_to_pause() noexcept;
  Outputs overridden(Outputs programmed) const noexcept;
  Row exchange(const Setpoint& setpoint);

  const Machine& machine_;
  ChannelOptions options_;
  hal::Backend& backend_;
  RowSink* sink_;
  Diagnostics diagnostics_;
  Diagnostics of_text_;  // since the beginning, or go_on()
  ipr::Reader reader_ = ipr::Reader::fed();
  Requests requests_;
  std::optional<Channel> channel_;
  std::optional<Verification> verification_;
  std::optional<Contour> contour_;
  std::vector<double> values_;
  double spindle_override_ = 1;
  bool off_ = false;      // whatever is programmed
  bool fed_ = false;      // all there is
  bool rests_ = false;    // where what has been fed ends
  double planned_s_ = 0;  // mm: of the last row
  int pushed_ = 0;        // the number of the last block that was fed
  Setpoint last_;
  Setpoint before_;    // go_on(): the last row, from which periods, lengths and blocks count on
  int lines_ = 0;      // that have been fed,
  int before_it_ = 0;  // and had been at go_on()
  SessionStatus status_ = SessionStatus::waiting;
};

}  // namespace softcnc::runtime
