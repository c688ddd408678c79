// SPDX-License-Identifier: MIT
// A set of few things, in one machine word.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace softcnc::ipr {

/// A set of `Item`s, which are numbered from `kFirst` on, 32 at most; an enumeration or letters.
/// `Self` is the set that derives from it.
template <typename Self, typename Item, Item kFirst = Item{}>
class SmallSet {
 public:
  constexpr SmallSet() = default;
  constexpr SmallSet(std::initializer_list<Item> items) noexcept {
    for (const Item item : items) add(item);
  }
  /// Returns the set of all items from the first to `last`, which is included.
  static constexpr Self up_to(Item last) noexcept {
    Self all;
    all.bits_ = bit(last) | (bit(last) - 1);
    return all;
  }

  constexpr void add(Item item) noexcept { bits_ |= bit(item); }
  constexpr void remove(Item item) noexcept { bits_ &= ~bit(item); }

  constexpr bool has(Item item) const noexcept { return (bits_ & bit(item)) != 0; }
  constexpr bool has_any(Self other) const noexcept { return (bits_ & other.bits_) != 0; }
  constexpr bool empty() const noexcept { return bits_ == 0; }

  constexpr Self& operator|=(Self other) noexcept {
    bits_ |= other.bits_;
    return static_cast<Self&>(*this);
  }
  friend constexpr Self operator|(Self one, Self other) noexcept { return one |= other; }
  friend constexpr bool operator==(Self one, Self other) noexcept {
    return one.bits_ == other.bits_;
  }
  constexpr Self without(Self other) const noexcept {
    Self rest;
    rest.bits_ = bits_ & ~other.bits_;
    return rest;
  }

 private:
  static constexpr std::uint32_t bit(Item item) noexcept {
    return 1U << ((static_cast<unsigned>(item) - static_cast<unsigned>(kFirst)) & 31U);
  }

  std::uint32_t bits_ = 0;
};

}  // namespace softcnc::ipr
