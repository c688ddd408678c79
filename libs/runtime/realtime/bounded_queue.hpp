// SPDX-License-Identifier: MIT
// A queue between two threads that never allocates, never waits and loses nothing.
#pragma once

#include <readerwriterqueue.h>

#include <atomic>
#include <cstdint>

namespace softcnc::runtime {

/// One thread pushes, one takes. Both count the items so far: by these counts the one sees what the
/// other has done, and the queue keeps its bound to the item.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity), queue_(capacity) {}

  /// Adds an item; false if the queue is full. Realtime.
  bool push(const T& item) noexcept {
    const std::uint64_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - taken() >= capacity_ || !queue_.try_enqueue(item)) return false;
    pushed_.store(pushed + 1, std::memory_order_release);
    return true;
  }

  /// Takes an item; false if there is none. Realtime.
  bool take(T& item) noexcept {
    const std::uint64_t taken = taken_.load(std::memory_order_relaxed);
    if (pushed() == taken || !queue_.try_dequeue(item)) return false;
    taken_.store(taken + 1, std::memory_order_release);
    return true;
  }

  std::size_t capacity() const noexcept { return capacity_; }
  std::uint64_t pushed() const noexcept { return pushed_.load(std::memory_order_acquire); }
  std::uint64_t taken() const noexcept { return taken_.load(std::memory_order_acquire); }

 private:
  std::size_t capacity_;
  moodycamel::ReaderWriterQueue<T> queue_;
  std::atomic<std::uint64_t> pushed_{0}, taken_{0};
};

}  // namespace softcnc::runtime
