// SPDX-License-Identifier: MIT
// Where setpoints go: a machine that softcnc does not know.
#pragma once

#include <softcnc/export.hpp>
#include <softcnc/setpoint.hpp>

namespace softcnc::api {

/// Moves a machine. A session calls it from the thread that calls Session::step().
class SOFTCNC_API Backend {
 public:
  Backend() = default;
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;
  virtual ~Backend();

  /// Carries the machine over one period to the setpoint, and returns where it is then; the first
  /// setpoint says where it stands.
  virtual Feedback exchange(const Setpoint& setpoint) noexcept = 0;
  /// Returns whether the feedback tells of home switches; without them no Operator homes it.
  virtual bool has_home_switches() const noexcept { return false; }
  /// The machine stands where it has stood, and the next setpoint calls that place otherwise.
  virtual void begin_again() noexcept {}
  /// Is called where the machine comes to rest within the next period, which may take long to come.
  virtual void rest() noexcept {}
};

}  // namespace softcnc::api
