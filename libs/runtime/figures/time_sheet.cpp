// SPDX-License-Identifier: MIT
#include "runtime/figures/time_sheet.hpp"

#include <algorithm>

namespace softcnc::runtime {
namespace {

/// Why the machine rests at a block that does not move; nothing at the end of the program.
std::optional<RestCause> cause_of(const Block& block) {
  constexpr int kM06 = 6;  // it stops the spindle before it changes the tool
  const auto* action = std::get_if<Action>(&block.what);
  if (action == nullptr) return RestCause::dwell;
  if (action->code == kM06) return RestCause::tool;
  switch (action->kind) {
    case Action::Kind::tool:
      return RestCause::tool;
    case Action::Kind::spindle:
      return RestCause::spindle;
    case Action::Kind::coolant:
      return RestCause::coolant;
    case Action::Kind::stop:
      return RestCause::stop;
    case Action::Kind::output:
      return RestCause::output;
    case Action::Kind::end:
    case Action::Kind::probe:
      return std::nullopt;
  }
  return std::nullopt;
}

/// Returns the seconds beyond those of the same path at the programmed feed.
double lost_in(const ipo::Profile::Span& span, double feed) {
  const double speed = feed > 0 ? feed : std::max(span.v0, span.v1);
  return speed > 0 ? std::max(span.t1 - span.t0 - (span.s1 - span.s0) / speed, 0.0) : 0.0;
}

}  // namespace

std::string_view name(RestCause cause) noexcept {
  constexpr std::array<std::string_view, kRestCauses> names{
      "corner", "dwell", "tool", "spindle", "coolant", "stop", "output", "hold", "planning"};
  return names[static_cast<std::size_t>(cause)];
}

ToolTime& TimeKeeper::tool() {
  auto& tools = sheet_.tools;
  if (!tools.empty() && tools.back().tool == tool_) return tools.back();
  const auto known = std::find_if(tools.begin(), tools.end(),
                                  [this](const ToolTime& one) { return one.tool == tool_; });
  if (known != tools.end()) return *known;
  return tools.emplace_back(ToolTime{tool_, 0, 0, 0, 0});
}

void TimeKeeper::add(const ipo::TimedBlock& timed, double until, double feed_override) {
  const Move* move = timed.move();
  if (move == nullptr) pass(timed);
  timed.profile.for_each_span(until, [&](const ipo::Profile::Span& span) {
    if (move != nullptr) return add(*move, span, feed_override);
    tool().dwell += span.t1 - span.t0;
  });
}

/// A block that does not move.
void TimeKeeper::pass(const ipo::TimedBlock& timed) {
  const Block& block = timed.block;
  if (const auto cause = cause_of(block); rests_ && cause) rest_for(*cause);
  rests_ = rests_at_corner_ = false;
  const auto* action = std::get_if<Action>(&block.what);
  if (action != nullptr && action->kind == Action::Kind::tool)
    tool_ = static_cast<int>(action->value);
  if (action != nullptr && action->kind == Action::Kind::output) keep_output(*action, timed);
}

void TimeKeeper::keep_output(const Action& action, const ipo::TimedBlock& timed) {
  if (sheet_.outputs.size() < kMostOutputEvents)
    sheet_.outputs.push_back({timed.t_start, timed.block.source, action.port, action.value});
  else
    ++sheet_.outputs_left_out;
}

void TimeKeeper::add(const Move& move, const ipo::Profile::Span& span, double feed_override) {
  const double duration = span.t1 - span.t0;
  if (span.moves()) {
    if (rests_) rest_for(RestCause::planning);
    rests_ = rests_at_corner_ = false;
    (move.rapid ? tool().rapid : tool().cutting) += duration;
  } else {
    tool().rest += duration;
  }
  if (span.limit == Limit::corner || rests_at_corner_)
    add_lost(move, span.moves() ? lost_in(span, asked_feed(move, feed_override)) : duration);
  if (span.ends_at_rest()) come_to_rest(span);
}

/// At a corner.
void TimeKeeper::add_lost(const Move& move, double seconds) {
  sheet_.corners.seconds += seconds;
  if (move.corner_tolerance > 0) return;
  sheet_.corners.roundable_seconds += seconds;
  if (move.exact) sheet_.corners.exact_seconds += seconds;
}

void TimeKeeper::come_to_rest(const ipo::Profile::Span& span) {
  if (span.limit == Limit::stop) return;
  if (span.limit == Limit::hold || span.limit == Limit::override_) return rest_for(RestCause::hold);
  rests_at_corner_ = span.limit == Limit::corner;
  rests_ = !rests_at_corner_;
  if (!rests_at_corner_) return;
  ++sheet_.corners.count;
  rest_for(RestCause::corner);
}

void TimeKeeper::rest_for(RestCause cause) { ++sheet_.rests[static_cast<std::size_t>(cause)]; }

}  // namespace softcnc::runtime
