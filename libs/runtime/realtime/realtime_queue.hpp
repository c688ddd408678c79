// SPDX-License-Identifier: MIT
// The queue from the thread that plans to the real-time thread, and when that may move.
#pragma once

#include <atomic>
#include <cstdint>

#include "runtime/realtime/bounded_queue.hpp"

namespace softcnc::runtime {

/// Motion begins when the queue is half full, or all there is before a rest has come.
template <typename T>
class RealtimeQueue {
 public:
  explicit RealtimeQueue(std::size_t capacity) : queue_(capacity) {}

  std::size_t capacity() const noexcept { return queue_.capacity(); }

  /// Adds an item; false if the queue is full. Realtime.
  bool push(const T& item) noexcept { return queue_.push(item); }

  /// Marks that the items so far end at rest, and that more may take long.
  void rest() noexcept { rest_at_ = queue_.pushed(); }

  enum class Next : std::uint8_t {
    item,
    stands,   // there is nothing to move for
    missing,  // there should be one: it has come to the end of what was pushed, and not to rest
  };

  /// Takes the next item, in the real-time thread. Realtime.
  Next take(T& item) noexcept {
    moves_ = moves_ || may_move();
    if (!moves_) return Next::stands;
    moves_ = queue_.take(item);
    if (moves_) return Next::item;
    return all_taken() ? Next::stands : Next::missing;
  }
  bool moves() const noexcept { return moves_; }

  /// Returns whether all that came before the last rest has been taken.
  bool all_taken() const noexcept { return queue_.taken() == rest_at_.load(); }

 private:
  bool may_move() const noexcept {
    const std::uint64_t taken = queue_.taken();
    return queue_.pushed() - taken >= queue_.capacity() / 2 || rest_at_.load() > taken;
  }

  BoundedQueue<T> queue_;
  std::atomic<std::uint64_t> rest_at_{0};  // items after which it may stand
  bool moves_ = false;                     // of the thread that takes
};

}  // namespace softcnc::runtime
