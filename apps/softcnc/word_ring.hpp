// SPDX-License-Identifier: MIT
// Words on their way from the thread that plans to the thread that writes to a port.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "hal/port_pins.hpp"

namespace softcnc::app {

/// One thread pushes, one takes; neither waits for the other, and both count the words so far.
class WordRing {
 public:
  explicit WordRing(std::size_t capacity) : words_(capacity) {}

  /// As many of them as there is room for; how many. Realtime.
  std::size_t push(std::span<const hal::PortWord> words) noexcept {
    const std::uint64_t pushed = pushed_.load(std::memory_order_relaxed);
    const std::uint64_t taken = taken_.load(std::memory_order_acquire);
    const std::size_t room = words_.size() - static_cast<std::size_t>(pushed - taken);
    const std::size_t count = std::min(room, words.size());
    for (std::size_t i = 0; i < count; ++i) words_[(pushed + i) % words_.size()] = words[i];
    pushed_.store(pushed + count, std::memory_order_release);
    return count;
  }

  /// False: there is none. Realtime.
  bool take(hal::PortWord& word) noexcept {
    const std::uint64_t taken = taken_.load(std::memory_order_relaxed);
    if (taken == pushed_.load(std::memory_order_acquire)) return false;
    word = words_[taken % words_.size()];
    taken_.store(taken + 1, std::memory_order_release);
    return true;
  }

  std::uint64_t pushed() const noexcept { return pushed_.load(std::memory_order_acquire); }
  std::uint64_t taken() const noexcept { return taken_.load(std::memory_order_acquire); }

 private:
  std::vector<hal::PortWord> words_;
  std::atomic<std::uint64_t> pushed_{0}, taken_{0};
};

}  // namespace softcnc::app
