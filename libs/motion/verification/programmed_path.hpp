// SPDX-License-Identifier: MIT
// The path as it was programmed, where what is run may leave it, and how far the samples really do.
#pragma once

#include <cstddef>
#include <deque>
#include <limits>

#include "motion/model/block.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc {

/// Uses moves and samples only: neither how corners are rounded nor what that allows.
class ProgrammedPath {
 public:
  /// Adds the next block of the program, before it is processed.
  void add(const Block& block);

  /// Takes the next sample of the motion along the blocks that have been added.
  void sample(const Setpoint& setpoint) noexcept;

  /// Ends the measurement after the last sample of a program that has run to its end, or to a stop.
  void finish() noexcept;

  /// The distance of samples from the programmed path, or of joints that may be rounded from the
  /// polyline through the samples; mm.
  struct Deviation {
    double off = 0;
    double allowed = 0;  // there: the larger one of P and Q
  };
  double largest() const noexcept { return largest_; }
  /// Returns the distance of the last sample, mm.
  double last() const noexcept { return last_; }
  /// Returns where it exceeds most what is allowed, or comes nearest to it; no limit, if nothing
  /// was rounded.
  const Deviation& worst() const noexcept { return worst_; }

 private:
  struct PathStretch {
    int number;  // of the block
    Path path;
    double s_start, s_end;  // mm of the programmed path
    double allowed;         // mm: on the stretch,
    double allowed_before;  // and where it begins
    bool follows;           // the stretch before it, without a stop
    double joint_off = std::numeric_limits<double>::infinity();  // of its start from the samples
  };

  void find(int number) noexcept;
  void measure_sample(const AxisVector& point) noexcept;
  enum class Search { near_guess, whole };
  Deviation deviation(const AxisVector& point, Search search) noexcept;
  static double nearest_on(const PathStretch& stretch, const AxisVector& point, double guess,
                           Search search) noexcept;
  void near_joints(const AxisVector& from, const AxisVector& to) noexcept;
  void forget() noexcept;
  bool is_record(const Deviation& found) const noexcept;
  void count(const Deviation& deviation) noexcept;
  void count_joint(const PathStretch& stretch) noexcept;

  std::deque<PathStretch> stretches_;
  std::size_t here_ = 0;  // that of the last sample
  double guess_ = 0;      // mm from its start: what was nearest to that sample
  double s_ = 0;          // mm programmed so far
  double allowed_ = 0;    // where that ends
  bool follows_ = false;  // what comes next continues the last stretch
  bool has_sample_ = false;
  AxisVector sample_ = AxisVector::Zero();
  double largest_ = 0, last_ = 0;
  Deviation worst_{0, std::numeric_limits<double>::infinity()};
};

}  // namespace softcnc
