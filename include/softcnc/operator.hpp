// SPDX-License-Identifier: MIT
// A person at the machine: lines, programs, moves by hand, and what each state of the machine
// allows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <softcnc/backend.hpp>
#include <softcnc/export.hpp>
#include <softcnc/program.hpp>
#include <softcnc/session.hpp>
#include <softcnc/setpoint.hpp>

namespace softcnc::api {

enum class MachineMode : std::uint8_t {
  idle,   // at rest, ready for a line, a program or a jog
  run,    // a program or lines
  hold,   // on its way to rest, or at rest, in the middle of a program; or at a pause
  jog,    // moved by hand
  alarm,  // stopped by a fault; nothing moves until unlock()
  check,  // lines are read and judged, and nothing moves
  door,   // the door is or was open: at rest, spindle and coolant off
  sleep,  // outputs off until reset()
  home,   // searches its home switches
};
/// Returns "Idle", "Run" and so on.
SOFTCNC_API std::string name(MachineMode mode);

/// A motion by hand. A continuous one goes in the direction of `distance` to the end of the travel,
/// unless it is cancelled.
struct Jog {
  AxisVector distance = AxisVector::Zero();  // mm, from where the jog before it ends
  double feed = 0;                           // mm/s along the path; more than the axes have is cut
  bool continuous = false;
};

/// What is switched on beside the axes.
struct Outputs {
  double spindle_rpm = 0;  // positive: M03, clockwise
  bool mist = false, flood = false;
};

/// The machine as its operator meets it. It has no clock: each step() is one period, and whoever
/// calls it decides when. Requests return why they are refused, and nothing where they are not: one
/// that is not possible in the present state (SC5080) changes nothing. docs/operating.md has the
/// table. It is not thread-safe.
class SOFTCNC_API Operator {
 public:
  using Refusal = std::optional<Diagnostic>;

  /// Opens the backend that the machine names, or takes one of your own. `options` say where the
  /// machine stands, and how programs are read. Errors: those of the machine's backend.
  static Expected<Operator> open(const Machine& machine, const RunOptions& options = {});
  static Operator on(std::shared_ptr<Backend> backend, const Machine& machine,
                     const RunOptions& options = {});

  Operator(Operator&& other) noexcept;
  Operator& operator=(Operator&& other) noexcept;
  ~Operator();

  /// Runs lines, with the modes that the lines before have left. Lines that open a loop or a
  /// subprogram wait until it is closed. What is wrong with them is in diagnostics().
  Refusal line(std::string_view text);
  bool is_line_open() const noexcept;
  /// Runs a program from its beginning, with the modes at the start of a program.
  Refusal start(std::string_view program);
  /// Moves by hand, behind the jogs before; in Hold too, from where resume() comes back first.
  /// Where the position is not known it is slow, and no end of travel counts; in Alarm, after a
  /// limit switch, only slowly away from that.
  Refusal jog(const Jog& jog);
  /// Ends jogs within the limits of the machine.
  Refusal cancel();
  /// Searches the home switches of all axes that have one, and sets the machine coordinates by
  /// them: docs/homing.md. If it fails, Alarm follows, and diagnostics() says why.
  Refusal home();
  /// Sets the origin of the active work system so that axis 0 to 2 stands at `value` mm there.
  Refusal touch_off(int axis, double value);

  /// Comes to rest on the path. A jog ends.
  Refusal hold();
  /// Goes on after a hold, a pause or a closed door.
  Refusal resume();
  /// Comes to rest on the path and ends the program, or the jog.
  Refusal abort();
  /// Does the same, and puts all modes back; from motion it ends in Alarm.
  Refusal reset();
  /// The door is open, or closed again.
  Refusal door();
  void door_closed() noexcept;
  /// Leaves Alarm.
  Refusal unlock();
  /// Begins or ends that lines are only judged.
  Refusal check();
  /// Switches outputs off until reset().
  Refusal sleep();
  /// Rows end at once, without a ramp. The position is not known any more, unless the backend
  /// measures it. softcnc is no safety function: the emergency stop must work without it.
  void estop();
  /// A switch at an end of axis 0 to 2: comes to rest within the limits, then Alarm. `direction`:
  /// -1 or 1, towards the switch.
  void limit_switch(int axis, int direction);
  /// The machine stands at `place`, mm, machine coordinates: somebody has looked.
  Refusal set_position(const AxisVector& place);

  /// Multiplies the programmed feed and the speed of the spindle, from 0.1 to 2; and the speed of
  /// rapids, from 0.01 to 1.
  void set_feed_override(double feed_override) noexcept;
  void set_rapid_override(double rapid_override) noexcept;
  void set_spindle_override(double spindle_override) noexcept;
  /// Count for the lines that have not been read yet: a running program is read ahead.
  void set_block_skip(bool on) noexcept;
  void set_optional_stop(bool on) noexcept;
  void set_single_block(bool on) noexcept;

  /// Moves the machine by one period and returns the row. Nothing where nothing moves, or where the
  /// state has just changed.
  std::optional<Row> step();

  MachineMode mode() const noexcept;
  bool moving() const noexcept;
  bool knows_position() const noexcept;
  /// Returns where the last row was, mm, in machine coordinates.
  AxisVector position() const noexcept;
  Outputs outputs() const noexcept;
  /// Returns where resume() comes back to before the program goes on; nothing where the machine is
  /// there.
  std::optional<AxisVector> return_point() const noexcept;
  /// Returns what the next process has to know; in motion, and where the position is not known,
  /// with that mark.
  State state() const;
  /// Returns what has been reported of lines and programs so far.
  std::vector<Diagnostic> diagnostics() const;

  struct Data;

 private:
  explicit Operator(std::unique_ptr<Data> data) noexcept;
  std::unique_ptr<Data> data_;
};

}  // namespace softcnc::api
