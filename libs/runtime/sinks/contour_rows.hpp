// SPDX-License-Identifier: MIT
// The contour error of a run's rows: what joins the planned path to the backend's positions.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "ipo/queue/block_queue.hpp"
#include "motion/core/units.hpp"
#include "motion/verification/contour_error.hpp"

namespace softcnc::runtime {

/// Returns whether the backend knows where the axes are.
inline bool knows_contour(const hal::Backend& backend) noexcept { return backend.instants() > 0; }

/// The columns of a row after the axes: those of the backend, then "contour_um" where it knows
/// where the axes are.
std::vector<std::string> row_columns(const hal::Backend& backend);

/// The path of these rows, which follow one that was `from` mm along the program, and what the
/// queue knows of the path ahead of them.
void add_path(std::span<const Setpoint> rows, double from, const ipo::BlockQueue& queue,
              Contour& contour);

/// Sets the last of a row's values, in whole pm: what is smaller depends on where batches end.
inline void measure_contour(const Setpoint& setpoint, std::span<const AxisVector> actual,
                            Contour& contour, std::span<double> values) noexcept {
  constexpr double kPicometres = 1e6;  // in a um
  values.back() =
      std::round(um_from_mm(contour.sample(setpoint, actual)) * kPicometres) / kPicometres;
}

}  // namespace softcnc::runtime
