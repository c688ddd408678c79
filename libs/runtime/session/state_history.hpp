// SPDX-License-Identifier: MIT
// The state of the machine at each block: programs are read ahead of the motion, so a stop must
// return to an earlier state.
#pragma once

#include <deque>

#include "motion/model/machine_state.hpp"

namespace softcnc::runtime {

class StateHistory {
 public:
  explicit StateHistory(MachineState start) : kept_{{0, std::move(start)}} {}

  /// The state with which block `number` begins; numbers ascend.
  void add(int number, const MachineState& state) {
    if (kept_.back().state != state) kept_.push_back({number, state});
  }

  /// The machine is in block `number`.
  void pass(int number) {
    while (kept_.size() > 1 && kept_[1].number <= number) kept_.pop_front();
  }

  const MachineState& present() const noexcept { return kept_.front().state; }
  const MachineState& last() const noexcept { return kept_.back().state; }

 private:
  struct Kept {
    int number;
    MachineState state;
  };
  std::deque<Kept> kept_;  // where it changes, from the present block on
};

}  // namespace softcnc::runtime
