// SPDX-License-Identifier: MIT
// What was in force at each block: programs are read ahead of the motion, so a stop must return to
// what was before.
#pragma once

#include <deque>
#include <utility>

namespace softcnc::runtime {

template <typename Value>
class BlockHistory {
 public:
  explicit BlockHistory(Value start) : kept_{{0, std::move(start)}} {}

  /// The value with which block `number` begins; numbers ascend.
  void add(int number, const Value& value) {
    if (!(kept_.back().value == value)) kept_.push_back({number, value});
  }

  /// The machine is in block `number`.
  void pass(int number) {
    while (kept_.size() > 1 && kept_[1].number <= number) kept_.pop_front();
  }

  const Value& present() const noexcept { return kept_.front().value; }
  const Value& last() const noexcept { return kept_.back().value; }

 private:
  struct Kept {
    int number;
    Value value;
  };
  std::deque<Kept> kept_;  // where it changes, from the present block on
};

}  // namespace softcnc::runtime
