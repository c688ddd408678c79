// SPDX-License-Identifier: MIT
// Which straight lines from an anchor pass near all points since: the cone intersection of Williams
// (1978), "An efficient algorithm for the piecewise linear approximation of planar curves", here
// with time as the abscissa.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace softcnc::runtime {

/// Cones of several channels over the same instants.
template <std::size_t Channels>
class Cones {
 public:
  using Values = std::array<double, Channels>;

  /// Begins again at an anchor.
  void begin(double t, const Values& values) noexcept {
    t_ = t;
    anchor_ = values;
    low_.fill(-std::numeric_limits<double>::infinity());
    high_.fill(std::numeric_limits<double>::infinity());
  }

  /// Returns whether the line from the anchor to this point, at a later instant, passes every point
  /// that has been added within its tolerance.
  bool reaches(double t, const Values& values) const noexcept {
    for (std::size_t i = 0; i < Channels; ++i) {
      const double slope = (values[i] - anchor_[i]) / (t - t_);
      if (!(low_[i] <= slope && slope <= high_[i])) return false;
    }
    return true;
  }

  void add(double t, const Values& values, const Values& tolerances) noexcept {
    for (std::size_t i = 0; i < Channels; ++i) {
      const double rise = values[i] - anchor_[i];
      low_[i] = std::max(low_[i], (rise - tolerances[i]) / (t - t_));
      high_[i] = std::min(high_[i], (rise + tolerances[i]) / (t - t_));
    }
  }

 private:
  double t_ = 0;
  Values anchor_{}, low_{}, high_{};
};

}  // namespace softcnc::runtime
