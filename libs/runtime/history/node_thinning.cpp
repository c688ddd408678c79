// SPDX-License-Identifier: MIT
#include "runtime/history/node_thinning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::runtime {
namespace {

/// Of known values.
float larger(float a, float b) noexcept { return std::fmax(a, b); }

template <std::size_t Count>
std::size_t most(const std::array<std::int64_t, Count>& periods) noexcept {
  return static_cast<std::size_t>(std::max_element(periods.begin(), periods.end()) -
                                  periods.begin());
}

}  // namespace

NodeThinning::Values NodeThinning::values(const HistoryNode& node) noexcept {
  return {node.position[0], node.position[1], node.position[2], node.v};
}

bool NodeThinning::leaves_range(const HistoryNode& node,
                                const LargestValues& ranges) const noexcept {
  for (std::size_t i = 0; i < kLargest.size(); ++i) {
    const float value = node.*kLargest[i], largest = (*pending_).*kLargest[i];
    if (std::isinf(ranges[i])) continue;
    if (std::isnan(value) != std::isnan(largest)) return true;
    if (value > smallest_[i] + ranges[i] || value < largest - ranges[i]) return true;
  }
  return false;
}

bool NodeThinning::begins_anew(const HistoryNode& node, const Thinning& thinning) const noexcept {
  const HistoryNode& last = *pending_;
  if (leaves_range(node, thinning.ranges)) return true;
  if (thinning.keeps_limits && (node.limit != last.limit || node.feed != last.feed)) return true;
  return thinning.keeps_motions && (node.motion != last.motion || node.tool != last.tool);
}

void NodeThinning::add(const HistoryNode& node, const Thinning& thinning) {
  if (nodes_.empty()) {
    nodes_.push_back(node);
    return resume(node);
  }
  const auto t = static_cast<double>(node.period);
  if (pending_ && (begins_anew(node, thinning) || !cones_.reaches(t, values(node)))) keep_pending();
  const double speed = thinning.speed + thinning.speed_part * std::abs(node.v);
  const double mm = thinning.position;
  cones_.add(t, values(node), {mm, mm, mm, speed});
  merge(node);
}

void NodeThinning::resume(const HistoryNode& last) {
  cones_.begin(static_cast<double>(last.period), values(last));
  before_ = last.period;
}

/// What was largest so far stays.
void NodeThinning::merge(const HistoryNode& node) {
  const std::int64_t periods = node.period - before_;
  before_ = node.period;
  periods_by_limit_[static_cast<std::size_t>(node.limit)] += periods;
  periods_by_motion_[static_cast<std::size_t>(node.motion)] += periods;
  const std::optional<HistoryNode> earlier = std::exchange(pending_, node);
  for (std::size_t i = 0; i < kLargest.size(); ++i) {
    const auto value = kLargest[i];
    smallest_[i] = earlier ? std::fmin(smallest_[i], node.*value) : node.*value;
    if (earlier) (*pending_).*value = larger((*earlier).*value, node.*value);
  }
}

void NodeThinning::keep_pending() {
  HistoryNode kept = *pending_;
  kept.limit = static_cast<Limit>(most(periods_by_limit_));
  kept.motion = static_cast<MotionKind>(most(periods_by_motion_));
  nodes_.push_back(kept);
  cones_.begin(static_cast<double>(kept.period), values(kept));
  periods_by_limit_.fill(0);
  periods_by_motion_.fill(0);
  pending_.reset();
}

void NodeThinning::finish() {
  if (pending_) keep_pending();
}

}  // namespace softcnc::runtime
