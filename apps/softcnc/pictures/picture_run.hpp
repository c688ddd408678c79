// SPDX-License-Identifier: MIT
// What a picture of a run is drawn from.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/core/axes.hpp"
#include "motion/model/limit.hpp"
#include "pictures/picture_options.hpp"
#include "runtime/history/run_history.hpp"

namespace softcnc::app {

/// A line that loses time against its feed.
struct LostLine {
  std::string place;  // "line 12", or with the file that the program calls
  double lost = 0;    // s
  Limit limit = Limit::feed;
};

struct PictureRun {
  const runtime::RunHistory* history = nullptr;
  std::string program, machine;                 // machine: empty where it is unknown
  std::string remark;                           // how the run ended, unless it is done
  double time = 0, length = 0;                  // s, mm
  std::array<double, kLimits> time_by_limit{};  // s
  std::vector<LostLine> worst_lines;            // the worst first
  std::optional<AxisVector> velocity_limits;    // mm/s
};

/// The runs of a picture: one, or two that are compared.
using PictureRuns = std::span<const PictureRun>;

/// Returns "A: " and "B: " for two runs, nothing for one.
inline std::string run_prefix(PictureRuns runs, std::size_t run) {
  return runs.size() < 2 ? std::string() : run == 0 ? "A: " : "B: ";
}

}  // namespace softcnc::app
