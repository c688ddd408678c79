// SPDX-License-Identifier: MIT
#include "runtime/session/feed_script.hpp"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace

std::optional<FeedEvent> parse_event(std::string_view text) {
  constexpr std::string_view kOverride = "override=";
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto time = parse_number(text.substr(0, colon));
  if (!time || *time < 0) return std::nullopt;
  const std::string_view what = text.substr(colon + 1);
  if (what == "hold") return FeedEvent{*time, FeedEvent::Kind::hold, 100};
  if (what == "resume") return FeedEvent{*time, FeedEvent::Kind::resume, 100};
  if (!what.starts_with(kOverride)) return std::nullopt;
  const auto percent = parse_number(what.substr(kOverride.size()));
  if (!percent || *percent < 0 || *percent > 100 * kLargestOverride) return std::nullopt;
  return FeedEvent{*time, FeedEvent::Kind::override_, *percent};
}

std::string event_text(const FeedEvent& event) {
  if (event.kind == FeedEvent::Kind::override_)
    return fmt::format("{}:override={}", event.time, event.percent);
  return fmt::format("{}:{}", event.time, event.kind == FeedEvent::Kind::hold ? "hold" : "resume");
}

ipo::FeedControl after(const FeedEvent& event, ipo::FeedControl control) noexcept {
  if (event.kind == FeedEvent::Kind::override_)
    control.feed_override = within_limits(event.percent / 100);
  else
    control.hold = event.kind == FeedEvent::Kind::hold;
  return control;
}

void sort_events(std::vector<FeedEvent>& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const FeedEvent& a, const FeedEvent& b) { return a.time < b.time; });
}

}  // namespace softcnc::runtime
