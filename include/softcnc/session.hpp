// SPDX-License-Identifier: MIT
// A run that its user drives: lines in, a row per period out, and an operator's requests.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <softcnc/backend.hpp>
#include <softcnc/export.hpp>
#include <softcnc/program.hpp>
#include <softcnc/setpoint.hpp>

namespace softcnc::api {

enum class SessionStatus : std::uint8_t {
  running,  // step() gives the next row
  waiting,  // for more of the program; the last row may be at speed, unless rest() was called
  paused,   // at M00, M01 or M06: resume() goes on
  done,     // the program, or what abort() has left of it, has come to its end
  alarm,    // of the backend: nothing moves any more
  error,    // a line was wrong: the machine stands where the last good block ends, see go_on()
};

/// One period of a session.
struct Row {
  Setpoint setpoint;
  Feedback feedback;
};

/// The session has no clock: each step() is one period of the machine, and whoever calls it decides
/// when. Its rows are those of `softcnc run`. It is not thread-safe. One that has been moved from
/// has ended: it takes nothing, and gives nothing.
class SOFTCNC_API Session {
 public:
  /// Opens a session on the backend that the machine names, or on one of your own. Errors: those of
  /// the machine's backend. One of your own that is null, or that returns a position that is not
  /// finite, is an alarm.
  static Expected<Session> open(const Machine& machine, const RunOptions& options = {});
  static Session on(std::shared_ptr<Backend> backend, const Machine& machine,
                    const RunOptions& options = {});

  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;
  ~Session();

  /// Adds text to the program; a line counts once its end has come. A subprogram, a loop and what a
  /// branch leaves out must come as one text. Returns false, and adds nothing, after end() and
  /// abort(), where the session has ended, and where nothing more can be kept.
  bool feed(std::string_view text);
  /// After an error, as a control does when its operator has read it, and after the end of a
  /// program: what has been fed and was not run is forgotten, modes, offsets and variables are
  /// those behind the last line without an error, the machine stays where it stands, and more can
  /// be fed. A subprogram, a curve over several lines and cutter compensation end. After abort()
  /// modes are those at the start of a program. Ignored unless the status is `error`, or `done`
  /// without end().
  void go_on();
  /// Says that nothing more is fed: an error then ends the session.
  void end() noexcept;
  /// Lets the machine come to rest where what has been fed so far ends, instead of waiting there
  /// for more; more may be fed.
  void rest() noexcept;

  /// Moves the machine by one period and returns the row; nothing unless the status is then
  /// `running`, or `alarm` with the row of the alarm.
  std::optional<Row> step();
  SessionStatus status() const noexcept;

  /// Lets the machine come to rest on the path, and stay there until resume().
  void hold() noexcept;
  /// Ends a hold or a pause.
  void resume() noexcept;
  /// Multiplies the programmed feed, up to 2; what is below 0.001 holds. NaN changes nothing.
  void set_feed_override(double feed_override) noexcept;
  /// Multiplies the speed of rapids, from 0.01 to 1. NaN changes nothing.
  void set_rapid_override(double rapid_override) noexcept;
  /// Lets the machine come to rest on the path, and ends the program there.
  void abort() noexcept;

  /// Returns what has been reported so far. After an error the motion ends with the last good
  /// block.
  std::vector<Diagnostic> diagnostics() const;

  /// Returns where the last row was, mm, in machine coordinates; before the first one, where the
  /// session begins.
  AxisVector position() const noexcept;
  /// Returns what the program has left so far where the machine is, with position(): a session that
  /// begins with it goes on from there.
  State state() const;

  /// Returns the names of the backend's columns of a trace, such as "x_act_mm", and their values
  /// after the last step().
  const std::vector<std::string>& columns() const noexcept;
  const std::vector<double>& values() const noexcept;

  struct Data;

 private:
  explicit Session(std::unique_ptr<Data> data) noexcept;
  std::unique_ptr<Data> data_;
};

}  // namespace softcnc::api
