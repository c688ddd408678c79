// SPDX-License-Identifier: MIT
#include "runtime/session/feed_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace softcnc::runtime {
namespace {

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// What a change of a speed is called, and between which percentages it lies.
struct SpeedEvent {
  FeedEvent::Kind kind;
  std::string_view name;
  double least, most;
};
constexpr std::array kSpeedEvents{
    SpeedEvent{FeedEvent::Kind::override_, "override=", 0, 100 * kLargestOverride},
    SpeedEvent{FeedEvent::Kind::rapid, "rapid=", 100 * kSmallestRapid, 100 * kLargestRapid}};

std::optional<FeedEvent> speed_event(double time, std::string_view what) {
  for (const SpeedEvent& event : kSpeedEvents) {
    if (!what.starts_with(event.name)) continue;
    const auto percent = parse_number(what.substr(event.name.size()));
    if (percent && *percent >= event.least && *percent <= event.most)
      return FeedEvent{time, event.kind, *percent};
  }
  return std::nullopt;
}

}  // namespace

std::optional<FeedEvent> parse_event(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto time = parse_number(text.substr(0, colon));
  if (!time || *time < 0) return std::nullopt;
  const std::string_view what = text.substr(colon + 1);
  if (what == "hold") return FeedEvent{*time, FeedEvent::Kind::hold, 100};
  if (what == "resume") return FeedEvent{*time, FeedEvent::Kind::resume, 100};
  return speed_event(*time, what);
}

std::string event_text(const FeedEvent& event) {
  for (const SpeedEvent& speed : kSpeedEvents)
    if (event.kind == speed.kind)
      return fmt::format("{}:{}{}", event.time, speed.name, event.percent);
  return fmt::format("{}:{}", event.time, event.kind == FeedEvent::Kind::hold ? "hold" : "resume");
}

ipo::FeedControl after(const FeedEvent& event, ipo::FeedControl control) noexcept {
  if (event.kind == FeedEvent::Kind::override_)
    control.feed_override = within_limits(event.percent / 100);
  else if (event.kind == FeedEvent::Kind::rapid)
    control.rapid_override = event.percent / 100;
  else
    control.hold = event.kind == FeedEvent::Kind::hold;
  return control;
}

void sort_events(std::vector<FeedEvent>& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const FeedEvent& a, const FeedEvent& b) { return a.time < b.time; });
}

}  // namespace softcnc::runtime
