// SPDX-License-Identifier: MIT
// What intervals ask of the steps that touch them, spread over all that such a step can touch.
#pragma once

#include <cstdint>
#include <vector>

#include "ipo/path/chain.hpp"

namespace softcnc::ipo {

class StepSpread {
 public:
  /// `times`: the shortest of the intervals, s, by interval; those before interval `first` ask for
  /// nothing any more, and their times count from where they are felt on.
  StepSpread(Chain& chain, const std::vector<double>& times, double period, std::size_t first);

  /// No step that touches interval i may be longer than this speed allows. To be called with rising
  /// i.
  void ask(std::size_t i, const Cap& cap);

  /// Lowers the caps of nodes and intervals. What a neighbour that asks for no more lowers is left
  /// to it, so that everything is lowered about once however many intervals a step touches.
  void lower();

 private:
  struct Asked {
    Cap cap;
    std::size_t left = 0, right = 0;  // the last nodes that one step touches with the interval
  };

  bool beyond_a_step(std::size_t from, std::size_t to, double length) const noexcept;
  void lower_left_of(std::size_t i);
  void lower_right_of(std::size_t i);

  Chain& chain_;
  double period_;
  std::size_t first_, last_asked_;
  std::vector<Asked> asked_;         // by interval
  std::vector<std::int64_t> clock_;  // by node: so many parts of a period from the first one
};

}  // namespace softcnc::ipo
