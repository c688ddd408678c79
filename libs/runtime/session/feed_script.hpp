// SPDX-License-Identifier: MIT
// Changes of feed and rapids at given moments of a run: --at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipo/planner/feed_control.hpp"

namespace softcnc::runtime {

/// An override of the feed lies between these; a request below the smallest holds.
inline constexpr double kSmallestOverride = 1e-3, kLargestOverride = 2;
constexpr double within_limits(double feed_override) noexcept {
  return feed_override < kSmallestOverride ? 0 : std::min(feed_override, kLargestOverride);
}

/// What an operator can slow feed and spindle down to; to halt is a request of its own.
inline constexpr double kLeastOfOperator = 0.1;
/// An override of rapids lies between these.
inline constexpr double kSmallestRapid = 0.01, kLargestRapid = 1;

struct FeedEvent {
  enum class Kind : std::uint8_t { override_, rapid, hold, resume };

  double time = 0;  // s of the run
  Kind kind = Kind::resume;
  double percent = 100;  // of an override
};

/// Returns the event of "1.5:override=50", "1.5:rapid=25", "2:hold" or "3:resume" (times in s);
/// nothing if it is none of them.
std::optional<FeedEvent> parse_event(std::string_view text);

/// Returns the text that parse_event() reads as this event.
std::string event_text(const FeedEvent& event);

/// Returns what is asked for from the event on.
ipo::FeedControl after(const FeedEvent& event, ipo::FeedControl control) noexcept;

/// Sorts events by time; those of one moment keep their order.
void sort_events(std::vector<FeedEvent>& events);

}  // namespace softcnc::runtime
