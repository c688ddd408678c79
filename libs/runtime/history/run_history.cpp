// SPDX-License-Identifier: MIT
#include "runtime/history/run_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace softcnc::runtime {

RunHistory::RunHistory(double period, const Machine* machine, Size size)
    : period_(period), size_(size), thinning_(std::make_unique<NodeThinning>(nodes_)) {
  for (int i = 0; machine != nullptr && i < kAxes; ++i) {
    const Axis& axis = machine->axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    acceleration_[i] = axis.acceleration;
    jerk_[i] = axis.jerk;
  }
}

/// Uses are parts of a limit already.
LargestValues RunHistory::ranges(double factor) const noexcept {
  LargestValues ranges;
  for (std::size_t i = 0; i < kLargest.size(); ++i) {
    const bool is_use =
        kLargest[i] == &HistoryNode::acceleration_use || kLargest[i] == &HistoryNode::jerk_use;
    ranges[i] = kRange * static_cast<float>(factor) * (is_use ? 1.0F : largest_[i]);
    if (level_ >= kRangeLevels) ranges[i] = std::numeric_limits<float>::infinity();
  }
  return ranges;
}

Thinning RunHistory::thinning(double factor) const noexcept {
  return {factor * kPosition,    factor * kSpeedOfAll * fastest_, factor * kSpeedPart,
          level_ < kLimitLevels, level_ < kMotionLevels,          ranges(factor)};
}

/// By differences of the rows, before which the machine is at rest.
void RunHistory::use_axes(const RunRow& row, HistoryNode& node) noexcept {
  if (rows_ == 0) last_.fill(row.position);
  const AxisVector first = row.position - last_[0];
  const AxisVector second = first - (last_[0] - last_[1]);
  const AxisVector third = second - (last_[0] - 2 * last_[1] + last_[2]);
  for (int i = 0; i < kAxes; ++i) {
    const double a = std::abs(second[i]) / (period_ * period_);
    const double j = std::abs(third[i]) / (period_ * period_ * period_);
    if (acceleration_[i] > 0)
      node.acceleration_use =
          std::max(node.acceleration_use, static_cast<float>(a / acceleration_[i]));
    if (jerk_[i] > 0) node.jerk_use = std::max(node.jerk_use, static_cast<float>(j / jerk_[i]));
  }
  last_ = {row.position, last_[0], last_[1]};
}

void RunHistory::take(const RunRow& row) {
  HistoryNode node{.period = row.period,
                   .position = row.position,
                   .s = row.s,
                   .v = row.v,
                   .feed = row.feed,
                   .motion = row.motion,
                   .limit = row.limit,
                   .tool = row.tool,
                   .chord_error = row.chord_error,
                   .contour = row.contour,
                   .deviation = row.deviation,
                   .rmax = row.rmax,
                   .rmax_target = row.rmax_target};
  use_axes(row, node);
  add_span(row);
  for (std::size_t i = 0; i < kLargest.size(); ++i)
    largest_[i] = std::fmax(largest_[i], node.*kLargest[i]);
  fastest_ = std::max(fastest_, std::abs(row.v));
  thinning_->add(node, thinning(factor_));
  ++rows_;
  last_period_ = row.period;
  if (nodes_.size() >= size_.nodes) thin_nodes();
}

/// The pending rows end with a node, so that what comes next begins at one.
void RunHistory::thin_nodes() {
  thinning_->finish();
  while (nodes_.size() > size_.nodes / 4 * 3) {
    ++level_;
    factor_ *= 2;
    error_ += factor_;
    std::vector<HistoryNode> all = std::exchange(nodes_, {});
    nodes_.reserve(size_.nodes);
    thinning_ = std::make_unique<NodeThinning>(nodes_);
    for (const HistoryNode& node : all) thinning_->add(node, thinning(factor_));
    thinning_->finish();
  }
  const HistoryNode last = nodes_.back();
  thinning_ = std::make_unique<NodeThinning>(nodes_);
  thinning_->resume(last);
}

void RunHistory::add_span(const RunRow& row) {
  if (!spans_.empty() && spans_.back().file == row.file && spans_.back().line == row.line) return;
  const std::int64_t from = rows_ == 0 ? row.period : last_period_;
  if (!spans_.empty() && from - spans_.back().period < shortest_span_) spans_.pop_back();
  spans_.push_back({from, row.file, row.line});
  if (spans_.size() >= size_.spans) thin_spans();
}

/// Spans that are too short become part of the one before them.
void RunHistory::thin_spans() {
  while (spans_.size() > size_.spans / 4 * 3) {
    shortest_span_ *= 2;
    std::vector<LineSpan> all = std::exchange(spans_, {});
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_last = i + 1 == all.size();
      if (is_last || i == 0 || all[i + 1].period - all[i].period >= shortest_span_)
        spans_.push_back(all[i]);
    }
  }
}

bool RunHistory::knows(float HistoryNode::*value) const noexcept {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [value](const HistoryNode& node) { return !std::isnan(node.*value); });
}

}  // namespace softcnc::runtime
