// SPDX-License-Identifier: MIT
// What grbl 1.1 reports, in its form.
#pragma once

#include <optional>
#include <string>

#include "operate/attended_machine.hpp"
#include "operate/requests.hpp"

namespace softcnc::app {

class GrblReports {
 public:
  /// "<Idle|MPos:0.000,0.000,0.000|...>". Work offsets and overrides come as seldom as grbl tells
  /// them: after a reset, after a change, and every now and then.
  std::string status(const AttendedMachine& machine, const Requests& requests,
                     const std::string& state);
  /// Work offsets have been set, even if to the same: the next report has them.
  void show_offset() noexcept { to_offset_ = 0; }
  /// As after a reset.
  void begin_again() noexcept { to_offset_ = 0, to_overrides_ = 1; }

  /// $$
  std::string settings(const Machine& machine) const;
  /// Sets $10 or $13, or confirms any other; returns false if it has another value.
  bool set(int number, double value, const Machine& machine);
  /// $#
  std::string offsets(const AttendedMachine& machine) const;
  /// $G
  std::string modes(const AttendedMachine& machine) const;
  /// Keeps where the machine was at the contact that has just been, and forgets it.
  void keep_probed(const AttendedMachine& machine);
  void lose_probed() noexcept { probed_.reset(); }
  /// [PRB:...] of the last contact
  std::string probed() const;
  /// $I
  static std::string build();
  /// $
  static std::string help();

 private:
  std::string place(const AxisVector& mm) const;

  int shown_ = 3;                         // $10: machine coordinates, and the buffer
  bool inches_ = false;                   // $13
  int to_offset_ = 0, to_overrides_ = 1;  // reports until they come again
  std::string offset_, overrides_;        // as reported last
  std::optional<AxisVector> probed_;      // mm, machine coordinates
};

}  // namespace softcnc::app
