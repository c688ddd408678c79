// SPDX-License-Identifier: MIT
#include "report/node_columns.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;
using runtime::HistoryNode;

constexpr double kPart = 0.01;  // steps of a use
constexpr double kFeed = 1e-4;  // mm/s: as it is programmed

/// Steps of positions and speeds, as parts of what they may be off.
constexpr double kStep = 0.25;

/// Three digits of the largest: more cannot be seen.
double scale_of(const runtime::RunHistory& history, float HistoryNode::*value) {
  constexpr double kSteps = 1000;
  float largest = 0;
  for (const HistoryNode& node : history.nodes()) largest = std::fmax(largest, node.*value);
  return largest > 0 ? largest / kSteps : 1;
}

class NodeColumns {
 public:
  NodeColumns(const runtime::RunHistory& history, PackedData& data)
      : history_(history), data_(data) {}

  template <typename Of>
  void add(const char* name, double scale, Order order, Of&& of) {
    const auto& nodes = history_.nodes();
    json_[name] =
        data_.add_column(nodes.size(), scale, order, [&](std::size_t i) { return of(nodes[i]); });
  }
  /// Where any row knew of it.
  void add_known(const char* name, float HistoryNode::*value) {
    if (history_.knows(value))
      add(name, scale_of(history_, value), Order::values,
          [value](const HistoryNode& node) { return node.*value; });
  }
  /// Where there is such a limit.
  void add_use(const char* name, float HistoryNode::*value) {
    const auto& nodes = history_.nodes();
    if (std::any_of(nodes.begin(), nodes.end(),
                    [value](const HistoryNode& node) { return node.*value > 0; }))
      add(name, kPart, Order::values, [value](const HistoryNode& node) { return node.*value; });
  }
  Json take() { return std::move(json_); }

 private:
  const runtime::RunHistory& history_;
  PackedData& data_;
  Json json_;
};

}  // namespace

double with_steps(double error) noexcept { return error * (1 + kStep / 2); }

Json node_columns(const runtime::RunHistory& history, const Json& axes, PackedData& data) {
  NodeColumns columns(history, data);
  columns.add("row", 1, Order::differences, [](const HistoryNode& node) { return node.period; });
  const double mm = kStep * history.position_error();
  for (const Json& axis : axes) {
    const std::string name = axis;
    const int index = name[0] - 'x';
    columns.add(name.c_str(), mm, Order::second_differences,
                [index](const HistoryNode& node) { return node.position[index]; });
  }
  columns.add("s", mm, Order::second_differences, [](const HistoryNode& node) { return node.s; });
  const double mm_s = std::max(kStep * history.speed_error(), 1e-6);
  columns.add("v", mm_s, Order::differences, [](const HistoryNode& node) { return node.v; });
  columns.add("feed", kFeed, Order::differences, [](const HistoryNode& node) { return node.feed; });
  columns.add("motion", 1, Order::values,
              [](const HistoryNode& node) { return static_cast<int>(node.motion); });
  columns.add("limit", 1, Order::values,
              [](const HistoryNode& node) { return static_cast<int>(node.limit); });
  columns.add("tool", 1, Order::differences, [](const HistoryNode& node) { return node.tool; });
  columns.add_use("acceleration_use", &HistoryNode::acceleration_use);
  columns.add_use("jerk_use", &HistoryNode::jerk_use);
  columns.add_known("chord_error_um", &HistoryNode::chord_error);
  columns.add_known("contour_um", &HistoryNode::contour);
  columns.add_known("deviation_um", &HistoryNode::deviation);
  columns.add_known("rmax_um", &HistoryNode::rmax);
  columns.add_known("rmax_target_um", &HistoryNode::rmax_target);
  return columns.take();
}

Json span_columns(const runtime::RunHistory& history, PackedData& data) {
  const auto& spans = history.spans();
  const auto add = [&](Order order, auto&& of) {
    return data.add_column(spans.size(), 1, order, [&](std::size_t i) { return of(spans[i]); });
  };
  using runtime::LineSpan;
  return {{"row", add(Order::differences, [](const LineSpan& span) { return span.period; })},
          {"line", add(Order::differences, [](const LineSpan& span) { return span.line; })},
          {"file", add(Order::differences, [](const LineSpan& span) { return span.file; })}};
}

}  // namespace softcnc::app
