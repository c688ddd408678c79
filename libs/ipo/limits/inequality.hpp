// SPDX-License-Identifier: MIT
// Constraint inequalities at a point of the path, in the form that both planners use.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include "motion/core/axes.hpp"

namespace softcnc::ipo {

/// The acceleration or the jerk of one coordinate x(s) of the motion stays within +-bound. With
/// q = v^2 and derivatives by arc length, its acceleration is x'' q + x' q' / 2, and its jerk is
/// (x''' q + 3/2 x'' q' + x' q'' / 2) sqrt(q).
struct Inequality {
  int axis;
  double dx, ddx, dddx;  // x', x'', x'''
  double bound;          // mm/s^2 or mm/s^3

  static constexpr int kPath = -1;  // the coordinate is the arc length itself
};

/// The inequalities at one point, in the order of the constraints.
class Inequalities {
 public:
  void add(const Inequality& inequality) noexcept {
    assert(count_ < kMost);
    all_[count_++] = inequality;
  }

  std::size_t size() const noexcept { return count_; }
  const Inequality& operator[](std::size_t i) const noexcept { return all_[i]; }
  const Inequality* begin() const noexcept { return all_.data(); }
  const Inequality* end() const noexcept { return all_.data() + count_; }

  /// One for the path and two for each axis; a further kind of limit needs room for its own.
  static constexpr std::size_t kMost = 2 * kAxes + 1;

 private:
  std::array<Inequality, kMost> all_;
  std::size_t count_ = 0;
};

}  // namespace softcnc::ipo
