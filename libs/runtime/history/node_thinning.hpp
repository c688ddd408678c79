// SPDX-License-Identifier: MIT
// Nodes of a run thinned out: what lies between two that are kept is near the line between them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "motion/model/limit.hpp"
#include "runtime/history/cones.hpp"
#include "runtime/history/history_node.hpp"

namespace softcnc::runtime {

/// How far what is left out may be from the motion between the nodes, which is uniform, and which
/// changes begin a new node in any case.
struct Thinning {
  double position = 0;    // mm, along each axis
  double speed = 0;       // mm/s
  double speed_part = 0;  // and as a part of the speed itself
  bool keeps_limits = true, keeps_motions = true;
  LargestValues ranges{};  // within which values between two nodes lie; infinite: any
};

class NodeThinning {
 public:
  /// Kept nodes go to the end of `nodes`.
  explicit NodeThinning(std::vector<HistoryNode>& nodes) : nodes_(nodes) {}

  void add(const HistoryNode& node, const Thinning& thinning);
  /// Continues after a node that is kept already.
  void resume(const HistoryNode& last);
  /// Keeps the last node.
  void finish();

 private:
  using Values = Cones<4>::Values;

  static Values values(const HistoryNode& node) noexcept;
  void keep_pending();
  void merge(const HistoryNode& node);
  bool leaves_range(const HistoryNode& node, const LargestValues& ranges) const noexcept;
  bool begins_anew(const HistoryNode& node, const Thinning& thinning) const noexcept;

  std::vector<HistoryNode>& nodes_;
  Cones<4> cones_;
  std::optional<HistoryNode> pending_;  // with what is largest since the node before it
  LargestValues smallest_{};            // since then
  std::int64_t before_ = 0;             // the period of the last node that was added
  std::array<std::int64_t, kLimits> periods_by_limit_{};
  std::array<std::int64_t, 3> periods_by_motion_{};
};

}  // namespace softcnc::runtime
