// SPDX-License-Identifier: MIT
// Homing: which moves find the home switches of a machine, and what they have found.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::runtime {

/// Searches each group of axes for its switches, backs off, approaches them slowly, and backs off
/// again. It moves nothing: next() says what is to be moved, and the rows of that go to sees().
class Homing {
 public:
  /// A straight line from where the machine rests, and how long it rests behind it.
  struct Leg {
    AxisVector to;  // mm
    double feed;    // mm/s along the path
    double pause;   // s
  };

  /// The backend reads its inputs up to `delay` s after the rows that they belong to.
  explicit Homing(const Machine& machine, double delay = 0);

  /// Returns whether an axis of the machine has a home switch.
  static bool is_possible(const Machine& machine) noexcept;

  /// Returns the next leg of a machine that rests at `place`, mm; nothing once all switches are
  /// found, or homing has failed.
  std::optional<Leg> next(const AxisVector& place);
  /// Takes the feedback of a row. Returns whether the leg is to end as soon as the limits allow.
  bool sees(const Feedback& feedback);

  /// Returns what went wrong: SC5090.
  const std::optional<Diagnostic>& failure() const noexcept { return failure_; }
  /// Returns where the machine stands once all switches are found, mm, machine coordinates; of an
  /// axis without one, where it was taken to be.
  AxisVector found_place() const noexcept { return place_ + offset_; }
  /// Returns where it is to rest then, mm, machine coordinates: exactly `back_off` from each
  /// switch.
  AxisVector rest_place() const noexcept;
  /// Returns whether every axis of the machine has been found.
  bool finds_all() const noexcept;

 private:
  enum class Phase : std::uint8_t { search, back_off, latch, leave };

  struct Seeker {
    int axis;
    const Axis* of;
    double direction;  // towards the switch: -1 or 1
    double speed = 0;  // mm/s
    double range = 0;  // mm: how far it still may move towards the switch
    bool found = false;
    double edge = 0;        // mm: where the switch has closed
    double first_edge = 0;  // mm: the same, in the search
  };

  void begin_group();
  void begin_search();
  void begin_latch();
  void count_range(const AxisVector& place);
  double pause() const noexcept;
  Leg towards_switches(const AxisVector& place);
  Leg off_switches(const AxisVector& place);
  bool all_found() const noexcept;
  void check_range();
  void check_closed();
  void check_edges();
  void check_open();
  void take_edges();
  void fail(int axis, const std::string& what);

  const Machine& machine_;
  double delay_;  // s
  std::vector<Seeker> group_;
  int order_ = 0;  // of the group
  Phase phase_ = Phase::leave;
  std::array<bool, kAxes> closed_{};
  bool waited_ = false;                     // until the switches have been read,
  std::int64_t rows_ = 0;                   // over so many rows
  bool begun_ = false;                      // they have been seen
  AxisVector place_ = AxisVector::Zero();   // mm: where the machine rests
  AxisVector table_ = AxisVector::Zero();   // mm: where it was measured last
  AxisVector offset_ = AxisVector::Zero();  // mm: to machine coordinates
  std::optional<Diagnostic> failure_;
};

}  // namespace softcnc::runtime
