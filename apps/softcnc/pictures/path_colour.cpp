// SPDX-License-Identifier: MIT
#include "pictures/path_colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "pictures/chart.hpp"

namespace softcnc::app {
namespace {

using runtime::HistoryNode;
using runtime::MotionKind;

struct ColouringLook {
  std::string_view heading, label;
  bool dark_is_high;     // what is remarkable is dark
  double least, factor;  // the scale ends there at least; from the node's unit to the label's
  float HistoryNode::*value;
};

/// In the order of the enumeration.
constexpr std::array<ColouringLook, kColouringNames.size()> kColouringLooks{
    {{"achieved feed", "achieved / programmed feed, %", false, kPercent, kPercent, nullptr},
     {"speed", "speed, mm/min", false, 0, kMinute, nullptr},
     {"what limits the feed", "", false, 0, 1, nullptr},
     {"use of acceleration", "acceleration, % of limit", true, kPercent, kPercent,
      &HistoryNode::acceleration_use},
     {"use of jerk", "jerk, % of limit", true, kPercent, kPercent, &HistoryNode::jerk_use},
     {"contour error", "contour error, µm", true, kLeastError, 1, &HistoryNode::contour},
     {"deviation from the program", "deviation, µm", true, kLeastError, 1, &HistoryNode::deviation},
     {"chord error", "chord error, µm", true, kLeastError, 1, &HistoryNode::chord_error},
     {"predicted Rmax", "Rmax, µm", true, kLeastError, 1, &HistoryNode::rmax},
     {"tool", "", false, 0, 1, nullptr}}};

const ColouringLook& look_of(Colouring by) noexcept {
  return kColouringLooks[static_cast<std::size_t>(by)];
}

template <typename Take>
void each_cut(PictureRuns runs, Take&& take) {
  for (const PictureRun& run : runs) {
    const auto& nodes = run.history->nodes();
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (nodes[i].motion == MotionKind::cutting)
        take(nodes[i - 1], nodes[i],
             static_cast<double>(nodes[i].period - nodes[i - 1].period) * run.history->period());
  }
}

}  // namespace

PathColours::PathColours(PictureRuns runs, Colouring by) : by_(by) {
  if (by == Colouring::limit)
    list_limits(runs);
  else if (by == Colouring::tool)
    list_tools(runs);
  else
    measure(runs);
}

std::string PathColours::heading() const {
  return fmt::format("Path, coloured by {}", look_of(by_).heading);
}

void PathColours::measure(PictureRuns runs) {
  const ColouringLook& look = look_of(by_);
  scale_ = {std::string(look.label), look.least, look.dark_is_high, false};
  each_cut(runs, [&](const HistoryNode& before, const HistoryNode& node, double) {
    const double number = value(before, node);
    if (std::isnan(number)) {
      scale_.has_unknown = true;
      return;
    }
    known_ = true;
    if (by_ != Colouring::feed) scale_.high = std::max(scale_.high, number);
  });
  if (!(scale_.high > 0)) scale_.high = 1;
}

void PathColours::list_limits(PictureRuns runs) {
  std::array<double, kLimits> seconds{};
  each_cut(runs, [&](const HistoryNode&, const HistoryNode& node, double time) {
    seconds[static_cast<std::size_t>(node.limit)] += time;
  });
  std::array<std::size_t, kLimits> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](auto a, auto b) { return seconds[a] > seconds[b]; });
  for (const std::size_t limit : order)
    if (seconds[limit] > 0)
      entries_.push_back({std::string(limit_label(static_cast<Limit>(limit))),
                          limit_colour(static_cast<Limit>(limit))});
  known_ = !entries_.empty();
}

void PathColours::list_tools(PictureRuns runs) {
  each_cut(runs, [&](const HistoryNode&, const HistoryNode& node, double) {
    const auto place = std::ranges::lower_bound(tools_, node.tool);
    if (place == tools_.end() || *place != node.tool) tools_.insert(place, node.tool);
  });
  for (std::size_t i = 0; i < tools_.size(); ++i)
    entries_.push_back({fmt::format("T{}", tools_[i]), category_colour(i)});
  known_ = !entries_.empty();
}

double PathColours::value(const HistoryNode& before, const HistoryNode& node) const noexcept {
  const ColouringLook& look = look_of(by_);
  const double speed = (before.v + node.v) / 2;
  if (by_ == Colouring::speed) return look.factor * speed;
  if (by_ == Colouring::feed)
    return node.feed > 0 ? std::min(look.factor * speed / node.feed, kPercent)
                         : std::numeric_limits<double>::quiet_NaN();
  return look.value == nullptr ? std::numeric_limits<double>::quiet_NaN()
                               : look.factor * static_cast<double>(node.*look.value);
}

Colour PathColours::category(const HistoryNode& node) const noexcept {
  if (by_ == Colouring::limit) return limit_colour(node.limit);
  const auto place = std::ranges::lower_bound(tools_, node.tool);
  return category_colour(static_cast<std::size_t>(place - tools_.begin()));
}

Colour PathColours::shade_of(double value) const noexcept {
  const double part = std::clamp(value / scale_.high, 0.0, 1.0);
  return scale_.colour(scale_.high * std::round((kShades - 1) * part) / (kShades - 1));
}

void ColourMean::add(const HistoryNode& before, const HistoryNode& node) {
  const auto time = static_cast<double>(node.period - before.period);
  if (is_category(colours_->by())) {
    const Colour colour = colours_->category(node);
    const auto known = std::ranges::find(categories_, colour, &std::pair<Colour, double>::first);
    if (known != categories_.end())
      known->second += time;
    else
      categories_.emplace_back(colour, time);
    return;
  }
  const double value = colours_->value(before, node);
  if (std::isnan(value)) return;
  sum_ += time * value;
  time_ += time;
  largest_ = std::max(largest_, value);
}

Colour ColourMean::take() {
  Colour colour = kUnknownColour;
  if (!categories_.empty())
    colour = std::ranges::max_element(categories_, {}, &std::pair<Colour, double>::second)->first;
  else if (largest_ >= 0)
    colour = colours_->shade_of(colours_->by() <= Colouring::speed && time_ > 0 ? sum_ / time_
                                                                                : largest_);
  *this = ColourMean(*colours_);
  return colour;
}

}  // namespace softcnc::app
