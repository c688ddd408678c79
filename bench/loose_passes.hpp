// SPDX-License-Identifier: MIT
// What passes next to each other leave at any phase, in either direction, and with the tool axis
// anywhere beside them: the most that edges turning on a ball can leave at an inclination along the
// feed.
//
// An edge passes a point, seen from the axis `w` along the feed and `y` beside it, when the turn
// w / feed + teeth / 2 pi atan2(y, w) is whole, except for the phase. So a pass has cut all of a
// line, whatever its phase, as far from the lowest point of the ball as it takes for one whole
// turn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace softcnc {

/// Lengths and heights as those of EdgeSurface in tests/support.
class LoosePasses {
 public:
  LoosePasses(double feed, double tip, int teeth)
      : feed_(feed),
        tip_(tip),
        farthest_(0.5 * (1 + 0.5 * teeth) * feed),
        share_(teeth / (2 * std::numbers::pi)) {
    const double far = std::max(tip, feed * teeth / 2) + kPasses;
    for (int i = 0; i <= far * kParts; ++i)
      squares_.push_back(square(reach(std::max(static_cast<double>(i) / kParts, kOffLine))));
  }

  /// Over all places of the axis, either side.
  double rmax() const {
    double most = 0;
    const int end = static_cast<int>(squares_.size()) - kPasses * kParts;
    for (int first = 0; first < end; ++first) most = std::max(most, highest(first));
    return most;
  }

 private:
  static constexpr int kParts = 64, kPasses = 8;  // of a pick-feed; that may cut a place
  static constexpr double kOffLine = 1e-9, kMiddle = (kPasses - 1) / 2.0;

  static double square(double x) { return x * x; }

  double turn(double w, double y) const { return w / feed_ + share_ * std::atan2(y, w); }

  /// Turns from a to b: whichever places between them differ most.
  double turns(double a, double b, double y) const {
    double low = std::min(turn(a, y), turn(b, y)), high = std::max(turn(a, y), turn(b, y));
    const double back = y * (feed_ * share_ - y);  // where edge and point turn about the axis alike
    for (const double sign : {-1.0, 1.0}) {
      const double at = back > 0 ? sign * std::sqrt(back) : a;
      if (at <= a || at >= b) continue;
      low = std::min(low, turn(at, y));
      high = std::max(high, turn(at, y));
    }
    return high - low;
  }

  /// How far from the lowest point a line beside the axis may remain uncut.
  double reach(double y) const {
    double least = 0, most = farthest_;
    for (int i = 0; i < 26; ++i) {
      const double middle = (least + most) / 2;
      (turns(-tip_ - middle, -tip_ + middle, y) < 1 ? least : most) = middle;
    }
    return most;
  }

  /// The highest point between passes of which one has the axis `first` parts beside it. The lines
  /// of others lie that much further, and those on the other side turn against the feed.
  double highest(int first) const {
    std::array<double, kPasses> left{};
    for (int pass = 0; pass < kPasses; ++pass)
      left[static_cast<std::size_t>(pass)] =
          squares_[static_cast<std::size_t>(std::abs(first - (pass - kPasses / 2) * kParts))];
    double most = 0;
    for (std::size_t a = 0; a < kPasses; ++a)
      for (std::size_t b = a + 1; b < kPasses; ++b) most = std::max(most, meet(left, a, b));
    return most;
  }

  /// Where what two passes leave is alike, if it lies between the two in the middle and no other
  /// leaves less.
  static double meet(const std::array<double, kPasses>& left, std::size_t a, std::size_t b) {
    const double pa = static_cast<double>(a), pb = static_cast<double>(b);
    const double at = (pb * pb + left[b] - pa * pa - left[a]) / (2 * (pb - pa));
    if (std::abs(at - kMiddle) > 0.5) return 0;
    const double height = square(at - pa) + left[a];
    for (std::size_t pass = 0; pass < kPasses; ++pass)
      if (square(at - static_cast<double>(pass)) + left[pass] < height * (1 - kOffLine)) return 0;
    return 4 * height;
  }

  double feed_, tip_, farthest_;
  double share_;                 // teeth / 2 pi
  std::vector<double> squares_;  // of reach(), by parts of a pick-feed from the axis
};

}  // namespace softcnc
