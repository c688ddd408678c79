// SPDX-License-Identifier: MIT
#include "runtime/session/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

constexpr int kNoDescriptor = -1;
constexpr double kLargestOverride = 2, kSmallestOverride = 1e-3;

/// What is fed may end at rest anywhere and be overridden at any time.
ChannelOptions of_session(ChannelOptions options) {
  options.skims = false;
  options.keeps_state = true;
  options.events.clear();
  options.largest_override = kLargestOverride;
  return options;
}

}  // namespace

Session::Session(const Machine& machine, const ChannelOptions& options, hal::Backend& backend,
                 RowSink* sink, Diagnostics::Sink report)
    : backend_(backend),
      sink_(sink),
      diagnostics_(std::move(report)),
      channel_(reader_, kNoDescriptor, machine, of_session(options), diagnostics_),
      verification_(machine),
      values_(row_columns(backend).size()) {
  asked_.feed_override = options.feed_override;
  if (knows_contour(backend)) contour_.emplace(machine.control.period);
  channel_.feeder().show(verification_.programmed());
}

Status Session::feed(std::string_view text) {
  if (!takes_more()) return {};
  if (Status fed = reader_.feed(text); !fed) return fed;
  if (status_ == SessionStatus::waiting) status_ = SessionStatus::running;
  return {};
}

void Session::feed(Block block) {
  if (!takes_more()) return;
  if (block.number == 0) block.number = pushed_ + 1;
  pushed_ = block.number;
  channel_.feeder().push(std::move(block));
  if (status_ == SessionStatus::waiting) status_ = SessionStatus::running;
}

void Session::end() noexcept {
  fed_ = true;
  reader_.end_feed();
}

std::optional<Row> Session::step() {
  if (status_ == SessionStatus::done || status_ == SessionStatus::alarm) return std::nullopt;
  if (is_to_pause()) return std::nullopt;
  answer_requests();
  const auto setpoint = channel_.step(panel_);
  channel_.rethrow();
  if (!setpoint) {
    status_ = channel_.waiting() ? SessionStatus::waiting : SessionStatus::done;
    return std::nullopt;
  }
  return exchange(*setpoint);
}

/// Whether the machine stands at a pause that has not been answered.
bool Session::is_to_pause() noexcept {
  if (panel_.stop || !channel_.pause_ahead()) return false;
  if (status_ != SessionStatus::paused) backend_.rest();
  status_ = SessionStatus::paused;
  return true;
}

void Session::answer_requests() noexcept {
  if (!ask_ || panel_.stop || !channel_.can_be_asked()) return;
  channel_.ask(asked_);
  ask_ = false;
}

Row Session::exchange(const Setpoint& setpoint) {
  status_ = SessionStatus::running;
  const Feedback feedback = backend_.exchange(setpoint);
  if (feedback.alarm != Alarm::none) status_ = SessionStatus::alarm;
  backend_.values(std::span(values_).first(backend_.columns().size()));
  const std::span rows(&setpoint, 1);
  channel_.see_path_to(setpoint.s + Contour::kAhead);
  verification_.add(rows, channel_.queue());
  if (contour_) {
    add_path(rows, planned_s_, channel_.queue(), *contour_);
    measure_contour(setpoint, backend_.actual(), *contour_, values_);
  }
  planned_s_ = setpoint.s;
  channel_.feeder().states().pass(setpoint.block);
  channel_.forget_passed();
  if (sink_ && !sink_->row(setpoint, values_)) panel_.stop = true;
  return {setpoint, feedback, values_};
}

void Session::resume() noexcept {
  ask_ = ask_ || asked_.hold;
  asked_.hold = false;
  if (status_ != SessionStatus::paused) return;
  channel_.resume();
  status_ = SessionStatus::running;
}

void Session::set_feed_override(double feed_override) noexcept {
  if (std::isnan(feed_override)) return;
  const bool holds = feed_override < kSmallestOverride;
  asked_.feed_override = holds ? 0 : std::min(feed_override, kLargestOverride);
  ask_ = true;
}

std::optional<ContourReport> Session::contour() const {
  if (!contour_) return std::nullopt;
  return contour_->report();
}

}  // namespace softcnc::runtime
