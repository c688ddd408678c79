// SPDX-License-Identifier: MIT
// A probing move of a machine that reads a probe, and what it has found.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/model/block.hpp"
#include "motion/model/contact.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::runtime {

/// Moves nothing: blocks() says what is to be moved, and the rows of that go to sees().
class Probing {
 public:
  /// The backend reads its inputs up to `delay` s after the rows that they belong to.
  Probing(const ProbeRequest& request, const Machine& machine, double delay);

  /// Returns the move of a machine that rests at `place`, mm: between two pauses, in which the axes
  /// come to rest and the probe is read.
  std::vector<Block> blocks(const AxisVector& place);
  /// Takes the feedback of a row. Returns whether the move is to end as soon as the limits allow.
  bool sees(const Feedback& feedback) noexcept;
  /// Takes the inputs of a machine that rests in the middle of the move: it may have come there
  /// later than its rows.
  void sees_at_rest(const Feedback& feedback) noexcept;
  /// The machine has been moved by hand: it is looked once more whether the probe touches already.
  void begin_again() noexcept { begun_ = false; }
  /// Returns whether sees() has ended it.
  bool has_ended() const noexcept { return answer_.found != ProbeFound::nothing; }
  /// Returns what it has found, where the machine rests at `place`, mm.
  ProbeAnswer answer(const AxisVector& place) const noexcept;

  const ProbeRequest& request() const noexcept { return request_; }

 private:
  bool is_so(const Feedback& feedback) const noexcept {
    return feedback.probe == (request_.aim == ProbeAim::contact);
  }

  ProbeRequest request_;
  double pause_;             // s
  std::int64_t first_look_;  // rows: the pause before the move
  std::int64_t rows_ = 0;
  bool begun_ = false;  // it has been seen that the move may begin
  ProbeAnswer answer_;
};

}  // namespace softcnc::runtime
