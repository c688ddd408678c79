// SPDX-License-Identifier: MIT
// The destination of the edges of step and direction lines: a file, or a port.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hal/signals/step_edges.hpp"
#include "motion/core/result.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// The inputs of a machine that do not stop it.
struct InputLevels {
  std::array<bool, kAxes> home{};  // closed
  bool probe = false;              // touches
  bool door = false;               // open
  bool operator==(const InputLevels&) const = default;
};

/// What a sink has read from the machine.
class EdgeInputs {
 public:
  using Counts = std::array<std::int64_t, kAxes>;  // steps of each axis, from the first edge on

  struct Change {
    InputLevels levels;
    Counts counts{};  // where the axes were
  };

  virtual ~EdgeInputs() = default;
  virtual bool has_homes() const noexcept = 0;
  virtual bool has_probe() const noexcept = 0;
  /// Returns how late a change may come, s.
  virtual double delay() const noexcept = 0;
  /// From now on edges come no more than `lead` s before they are due.
  virtual void follow(double lead) noexcept = 0;
  /// Takes the next change; false where there is none.
  virtual bool next_change(Change& change) noexcept = 0;
  /// Returns the steps of all edges so far.
  virtual const Counts& counts() const noexcept = 0;
  /// What is wrong now; what that has been about; and the end of it.
  virtual Alarm alarm() const noexcept = 0;
  virtual Diagnostic trouble() const = 0;
  /// After an alarm edges are taken again, from lines that are low. Errors: what is still wrong.
  virtual Status recover() = 0;
};

class EdgeSink {
 public:
  virtual ~EdgeSink() = default;

  /// Takes all edges before `until`, ns, that have not been taken yet, in order of time. Returns
  /// what is wrong, if anything is; then finish() describes it. Realtime.
  virtual Alarm take(std::span<const SignalEdge> edges, std::int64_t until) noexcept = 0;

  /// What is switched on from the end of the edges on that have been taken. Realtime.
  virtual void switch_outputs(const Outputs& outputs) noexcept { static_cast<void>(outputs); }

  /// Is called where the machine is at rest and more edges may take long.
  virtual void rest() noexcept {}

  /// Returns what it reads; null: nothing.
  virtual EdgeInputs* inputs() noexcept { return nullptr; }

  /// Ends the edges. To be called once, after the last one.
  virtual Status finish() = 0;
};

}  // namespace softcnc::hal
