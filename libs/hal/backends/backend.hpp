// SPDX-License-Identifier: MIT
// Backends: they take setpoints and return feedback.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "hal/ports/port_player.hpp"
#include "motion/core/result.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

class Backend {
 public:
  virtual ~Backend() = default;

  /// Moves the machine over one period to the setpoint; the first setpoint says where it stands.
  /// Realtime.
  virtual Feedback exchange(const Setpoint& setpoint) noexcept = 0;

  /// Returns the names of further columns of the trace, such as "x_act_mm".
  virtual std::span<const std::string> columns() const noexcept { return {}; }

  /// Writes the values of columns() after the last exchange to `out`, which is as long as
  /// columns(). Realtime.
  virtual void values(std::span<double> out) const noexcept { static_cast<void>(out); }

  /// Returns where the axes really were in the period of the last exchange, mm: at evenly spaced
  /// instants of the position loop, the last one that of the setpoint. The first exchange has one.
  /// Returns an empty span if the backend does not know. Realtime.
  virtual std::span<const AxisVector> actual() const noexcept { return {}; }

  /// Returns how many such instants a period has; 0 if the backend does not know where the axes
  /// are.
  virtual std::size_t instants() const noexcept { return 0; }

  /// Returns the largest distance between command and axis over all exchanges so far, in mm by
  /// axis; NaN where nothing is measured: for axes that the machine does not have, and backends
  /// without feedback.
  virtual std::array<double, kAxes> following_error_max() const noexcept;

  /// Returns by which part of 1/Kv each axis has lagged more than its machine file says; NaN where
  /// that is not known.
  virtual std::array<double, kAxes> lag_misfit() const noexcept;

  /// The machine comes to rest at a place within a period behind the last setpoint, and the next
  /// exchange may take long.
  virtual void rest(const Setpoint& at) noexcept { static_cast<void>(at); }

  /// The next setpoint says again where the machine stands, as the first one did.
  virtual void begin_again() noexcept {}

  /// Returns whether the feedback tells of home switches, and of a probe.
  virtual bool has_home_switches() const noexcept { return false; }
  virtual bool has_probe() const noexcept { return false; }
  /// Returns how late inputs may come, s: in so much later a feedback than that of the setpoint at
  /// which the machine was. Feedback::switched and touched are where it was.
  virtual double delay() const noexcept { return 0; }
  /// From now on setpoints come no more than `lead` s before they are due: fewer of them have been
  /// planned when an input changes.
  virtual void follow(double lead) noexcept { static_cast<void>(lead); }
  /// From now on this tip may touch what the machine file states, where contacts are simulated.
  virtual void touch_with(const ProbeTip& tip) { static_cast<void>(tip); }
  /// Returns the inputs, as the last feedback had them or as they are now, and what is wrong, while
  /// nothing is exchanged.
  virtual Feedback look() noexcept { return {}; }
  /// Returns what an alarm has been about, unless it was one of an axis.
  virtual std::optional<Diagnostic> trouble() const { return std::nullopt; }
  /// After an alarm the machine is enabled again. Errors: what is still wrong.
  virtual Status recover() { return {}; }

  /// Writes what is left. Call once after the last exchange; without it a backend that writes a
  /// file leaves none. Errors: SC6012, SC6013, SC6071, and those of
  /// PortPlayer::finish().
  virtual Status finish() { return {}; }

  /// The rows that have gone to another program, so that it can be seen whether it got them all.
  struct Tally {
    std::int64_t rows = 0;
    std::string checksum;  // hash_hex() of their lines
  };
  virtual std::optional<Tally> tally() const { return std::nullopt; }

  /// Returns where the axes come to rest if the last command stands, in mm. Leaves the backend as
  /// it is.
  virtual AxisVector settle() const noexcept = 0;

  /// Returns the largest speed of what was sent so far, mm/s by axis; 0 where that is the path.
  virtual AxisVector command_velocity_max() const noexcept { return AxisVector::Zero(); }
};

/// Returns the machine with a backend that counts as before, but sends nothing.
Machine without_port(Machine machine);

/// Opens the port of a machine, with a player that writes to it in time.
using OpenPlayer = Result<std::unique_ptr<PortPlayer>> (*)(const Machine&);

/// Opens the backend that machine.control.backend names. Without `open_player` the pulses of
/// parport are counted and not sent. Errors: those of the backend's own open(), and of
/// `open_player`.
Result<std::unique_ptr<Backend>> open_backend(const Machine& machine,
                                              OpenPlayer open_player = nullptr);

}  // namespace softcnc::hal
