// SPDX-License-Identifier: MIT
// What the thread that plans hands to the thread that keeps the clock, and when that may move.
#pragma once

#include <readerwriterqueue.h>

#include <atomic>
#include <cstdint>

namespace softcnc::app {

/// One thread pushes, one takes, and neither waits for the other. Motion begins when the queue is
/// half full, or all there is before a rest has come.
template <typename T>
class PacedQueue {
 public:
  explicit PacedQueue(std::size_t capacity) : capacity_(capacity), queue_(capacity) {}

  std::size_t capacity() const noexcept { return capacity_; }

  /// False: it is full. Realtime.
  bool push(const T& item) noexcept {
    const std::uint64_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - taken_.load(std::memory_order_acquire) >= capacity_ || !queue_.try_enqueue(item))
      return false;
    pushed_.store(pushed + 1, std::memory_order_release);
    return true;
  }

  /// What has been pushed so far ends at rest, and more may be long in coming.
  void rest() noexcept { rest_at_ = pushed_.load(); }

  enum class Next : std::uint8_t {
    item,
    stands,   // there is nothing to move for
    missing,  // there should be one: it has come to the end of what was pushed, and not to rest
  };

  /// For the thread that keeps the clock. Realtime.
  Next take(T& item) noexcept {
    moves_ = moves_ || may_move();
    if (!moves_) return Next::stands;
    moves_ = queue_.try_dequeue(item);
    if (!moves_) return all_taken() ? Next::stands : Next::missing;
    taken_.fetch_add(1, std::memory_order_release);
    return Next::item;
  }
  bool moves() const noexcept { return moves_; }

  /// Whether all that came before the last rest has been taken.
  bool all_taken() const noexcept { return taken_.load() == rest_at_.load(); }

 private:
  bool may_move() const noexcept {
    const std::uint64_t taken = taken_.load();
    return pushed_.load() - taken >= capacity_ / 2 || rest_at_.load() > taken;
  }

  std::size_t capacity_;
  moodycamel::ReaderWriterQueue<T> queue_;
  std::atomic<std::uint64_t> pushed_{0}, taken_{0};
  std::atomic<std::uint64_t> rest_at_{0};  // items after which it may stand
  bool moves_ = false;                     // of the thread that takes
};

}  // namespace softcnc::app
