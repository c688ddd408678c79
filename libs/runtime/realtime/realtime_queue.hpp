// SPDX-License-Identifier: MIT
// The queue from the thread that plans to the real-time thread, and when that may move.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

namespace softcnc::runtime {

/// Motion begins when the queue is half full, or as begin_at() says, or all there is before a rest
/// has come. Items are numbered as they are pushed, from 0 on, modulo 2^32; as long as they wait
/// they can be taken back, and others are pushed in their place.
template <typename T>
class RealtimeQueue {
 public:
  using Number = std::uint32_t;

  explicit RealtimeQueue(std::size_t capacity)
      : capacity_(capacity),
        begins_at_(capacity / 2),
        items_(std::bit_ceil(std::max(capacity, std::size_t{2}))) {}

  std::size_t capacity() const noexcept { return capacity_; }

  /// Motion begins when so many items wait.
  void begin_at(std::size_t waiting) noexcept { begins_at_ = waiting; }

  /// Adds an item; false if the queue is full. Realtime.
  bool push(const T& item) noexcept {
    const Counts counts = load();
    if (counts.waiting() >= capacity_) return false;
    items_[place(counts.pushed)] = item;
    counts_.fetch_add(std::uint64_t{1} << 32, std::memory_order_release);
    return true;
  }

  /// Marks that the items so far end at rest, and that more may take long.
  void rest() noexcept { rest_at_ = load().pushed; }

  enum class Next : std::uint8_t {
    item,
    stands,   // there is nothing to move for
    missing,  // there should be one: it has come to the end of what was pushed, and not to rest
  };

  /// Takes the next item, in the real-time thread. Realtime.
  Next take(T& item) noexcept {
    moves_ = moves_ || may_move();
    if (!moves_) return Next::stands;
    moves_ = take_item(item);
    if (moves_) return Next::item;
    return all_taken() ? Next::stands : Next::missing;
  }
  bool moves() const noexcept { return moves_; }

  /// Returns whether all that came before the last rest has been taken.
  bool all_taken() const noexcept { return load().taken == rest_at_.load(); }

  /// The items that wait, seen by the thread that pushes; meanwhile the first of them are taken.
  struct Counts {
    Number taken = 0, pushed = 0;
    Number waiting() const noexcept { return pushed - taken; }
  };
  Counts load() const noexcept { return unpacked(counts_.load(std::memory_order_acquire)); }
  const T& item(Number number) const noexcept { return items_[place(number)]; }

  /// Takes back the items from `number` on, and calls visit(item) for each, if at least `spare`
  /// items before them still wait, one or more; otherwise it does nothing and returns false. In the
  /// thread that pushes.
  template <typename Visit>
  bool take_back(Number number, Number spare, Visit&& visit) {
    std::uint64_t word = counts_.load(std::memory_order_acquire);
    Counts counts;
    do {
      counts = unpacked(word);
      if (counts.pushed - number > counts.waiting() || number - counts.taken < spare) return false;
    } while (!counts_.compare_exchange_weak(word, packed({counts.taken, number})));
    rest_at_ = number - 1;  // an item that waits: no end at rest
    for (Number i = number; i != counts.pushed; ++i) visit(items_[place(i)]);
    return true;
  }

 private:
  static Counts unpacked(std::uint64_t word) noexcept {
    return {static_cast<Number>(word), static_cast<Number>(word >> 32)};
  }
  static std::uint64_t packed(Counts counts) noexcept {
    return std::uint64_t{counts.pushed} << 32 | counts.taken;
  }
  std::size_t place(Number number) const noexcept { return number & (items_.size() - 1); }

  /// It tries again only where the other thread has changed the counts at the same time.
  bool take_item(T& item) noexcept {
    std::uint64_t word = counts_.load(std::memory_order_acquire);
    while (true) {
      const Counts counts = unpacked(word);
      if (counts.waiting() == 0) return false;
      item = items_[place(counts.taken)];
      if (counts_.compare_exchange_weak(word, packed({counts.taken + 1, counts.pushed})))
        return true;
    }
  }

  bool may_move() const noexcept {
    const Counts counts = load();
    const Number to_rest = rest_at_.load() - counts.taken;
    return counts.waiting() >= begins_at_ || (to_rest > 0 && to_rest <= counts.waiting());
  }

  std::size_t capacity_;
  std::atomic<std::size_t> begins_at_;
  std::vector<T> items_;
  std::atomic<std::uint64_t> counts_{0};
  std::atomic<Number> rest_at_{0};  // items after which it may stand
  bool moves_ = false;              // of the thread that takes
};

}  // namespace softcnc::runtime
