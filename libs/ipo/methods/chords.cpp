// SPDX-License-Identifier: MIT
#include "ipo/methods/chords.hpp"

#include <algorithm>

namespace softcnc::ipo {
namespace {

constexpr double kRounding = 1e-13;  // of the chord: what counts as its length
constexpr double kLeastStep = 1e-3;  // of the chord: where the path hardly leaves the point
constexpr int kHalvings = 60;

double bisect(const Path& path, double nearer, double farther, const AxisVector& from,
              double chord) noexcept {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (nearer + farther);
    ((position(path, middle) - from).norm() < chord ? nearer : farther) = middle;
  }
  return farther;
}

}  // namespace

/// A path comes no further away than it is long, so a step by what is missing never goes too far.
std::optional<double> chord_end(const Path& path, double s0, double s1, const AxisVector& from,
                                double chord) noexcept {
  for (double s = s0; s < s1;) {
    const double missing = chord - (position(path, s) - from).norm();
    if (s > s0 && missing <= kRounding * chord) return s;
    const double next = std::min(s + std::max(missing, kLeastStep * chord), s1);
    const double distance = (position(path, next) - from).norm();
    if (distance >= chord * (1 - kRounding)) {
      const bool surely = next <= s + missing || distance <= chord * (1 + kRounding);
      return surely ? next : bisect(path, s, next, from, chord);
    }
    s = next;
  }
  return std::nullopt;
}

}  // namespace softcnc::ipo
