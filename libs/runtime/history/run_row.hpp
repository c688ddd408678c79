// SPDX-License-Identifier: MIT
// A row of a run with what is known of it, wherever it comes from: a simulation, or a trace.
#pragma once

#include <cstdint>
#include <limits>

#include "motion/core/axes.hpp"
#include "motion/model/limit.hpp"

namespace softcnc::runtime {

enum class MotionKind : std::uint8_t { rest, cutting, rapid };

struct RunRow {
  /// The value of what is not known.
  static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

  std::int64_t period = 0;  // counts from 0; t = period * that of the machine
  int file = 0;             // of the line; 0: the program itself
  int line = 0;
  int block = 0;
  int tool = 0;  // its number; 0: none
  MotionKind motion = MotionKind::rest;
  Limit limit = Limit::stop;
  double s = 0;     // mm of path from the start of the program
  double v = 0;     // mm/s, planned
  double feed = 0;  // mm/s, as programmed, with its override; 0 in rapids and between moves
  AxisVector position = AxisVector::Zero();  // mm, commanded
  float chord_error = kUnknown;              // um
  float contour = kUnknown;                  // um
  float deviation = kUnknown;                // um: from the programmed path
  float rmax = kUnknown;                     // um; unknown where no roughness is requested
  float rmax_target = kUnknown;              // um; likewise
};

/// Takes the rows of a run, in order.
class RunRowSink {
 public:
  virtual ~RunRowSink() = default;
  virtual void take(const RunRow& row) = 0;
};

}  // namespace softcnc::runtime
