// SPDX-License-Identifier: MIT
// Step limits, spread over all that a step can touch: a minimum filter with a window that depends
// on the limits.
#pragma once

#include <cstdint>
#include <vector>

#include "ipo/path/chain.hpp"

namespace softcnc::ipo {

class StepLimitDilation {
 public:
  /// `times` are the shortest times of the intervals, s. Intervals before `first` require nothing
  /// any more; their times count from where they matter.
  StepLimitDilation(Chain& chain, const std::vector<double>& times, double period,
                    std::size_t first);

  /// Requires that no step that touches interval i is longer than this limit allows. Must be called
  /// with rising i.
  void ask(std::size_t i, const VelocityLimit& bound);

  /// Lowers the velocity limits of nodes and intervals. What a neighbour lowers that requires no
  /// more is left to it, so that everything is lowered about once however many intervals a step
  /// touches.
  void lower();

 private:
  struct Asked {
    VelocityLimit bound;
    std::size_t left = 0, right = 0;  // the last nodes that one step touches with the interval
  };

  bool beyond_a_step(std::size_t from, std::size_t to, double length) const noexcept;
  void lower_left_of(std::size_t i);
  void lower_right_of(std::size_t i);

  Chain& chain_;
  double period_;
  std::size_t first_, last_asked_;
  std::vector<Asked> asked_;         // by interval
  std::vector<std::int64_t> clock_;  // by node: parts of a period since the first one
};

}  // namespace softcnc::ipo
