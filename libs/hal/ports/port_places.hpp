// SPDX-License-Identifier: MIT
// Where the axes are after each of the last words of a port.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "hal/signals/edge_sink.hpp"

namespace softcnc::hal {

class PortPlaces {
 public:
  /// Keeps at least the last `words`.
  explicit PortPlaces(std::size_t words) : kept_(std::bit_ceil(words)) {}

  /// Takes an edge of the next word.
  void add(const SignalEdge& edge) noexcept {
    if (edge.wire == Wire::direction) back_[edge.axis] = edge.high;
    if (edge.wire == Wire::step && edge.high) now_[edge.axis] += back_[edge.axis] ? -1 : 1;
  }
  void end_word() noexcept { kept_[index(++words_)] = now_; }
  /// Words are counted from 0 again, and lines are low.
  void begin_again() noexcept {
    words_ = 0;
    kept_[0] = now_;
    back_ = {};
  }

  const EdgeInputs::Counts& now() const noexcept { return now_; }
  /// Returns where they are after so many words, or after the first that is kept.
  const EdgeInputs::Counts& after(std::int64_t words) const noexcept {
    const auto kept = static_cast<std::int64_t>(kept_.size());
    return kept_[index(std::clamp(words, std::max<std::int64_t>(words_ - kept + 1, 0), words_))];
  }

 private:
  std::size_t index(std::int64_t word) const noexcept {
    return static_cast<std::size_t>(word) & (kept_.size() - 1);
  }

  std::vector<EdgeInputs::Counts> kept_;  // by number of words
  EdgeInputs::Counts now_{};
  std::array<bool, kAxes> back_{};
  std::int64_t words_ = 0;
};

}  // namespace softcnc::hal
