// SPDX-License-Identifier: MIT
#include "runtime/session/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipr/interpreter/memory.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

constexpr int kNoDescriptor = -1;

/// What is fed may end at rest anywhere and be overridden at any time.
ChannelOptions of_session(ChannelOptions options) {
  options.skims = false;
  options.keeps_state = true;
  options.events.clear();
  options.largest_override = kLargestOverride;
  options.interpreter.remembers = true;
  return options;
}

}  // namespace

Session::Session(const Machine& machine, const ChannelOptions& options, hal::Backend& backend,
                 RowSink* sink, Diagnostics::Sink report)
    : machine_(machine),
      options_(of_session(options)),
      backend_(backend),
      sink_(sink),
      diagnostics_(std::move(report)),
      requests_(options.feed_override),
      values_(row_columns(backend).size()) {
  last_.position = options.state.place();
  last_.period = -1;  // of no row
  begin();
}

/// The text that comes is read by a pipeline of its own: an error ends no other.
void Session::begin() {
  of_text_ = Diagnostics([this](const Diagnostic& found) {
    Diagnostic counted = found;
    if (counted.pos.file == 0 && counted.pos.line > 0) counted.pos.line += before_it_;
    diagnostics_.pass_on(std::move(counted));
  });
  of_text_.set_file(diagnostics_.file());
  channel_.emplace(reader_, kNoDescriptor, machine_, options_, requests_, of_text_);
  verification_.emplace(machine_);
  if (knows_contour(backend_)) contour_.emplace(machine_.control.period);
  channel_->feeder().show(verification_->programmed());
  planned_s_ = 0;
}

void Session::go_on() {
  const bool is_done = status_ == SessionStatus::done && !fed_;
  if (status_ != SessionStatus::error && !is_done) return;
  if (requests_.stops()) {
    options_.state = channel_->feeder().states().present();
    return begin_again(nullptr);
  }
  ipr::Memory memory = channel_->feeder().memory();
  begin_again(&memory);
}

void Session::begin_again(ipr::Memory* memory) {
  if (memory != nullptr) {
    memory->stand_at(last_.position);
    options_.state = memory->modal.state;
  }
  options_.state.position = KeptPosition{last_.position};
  options_.outputs = programmed_outputs();
  before_ = last_;
  before_.period += 1;
  before_it_ = lines_;
  options_.interpreter.memory = memory;
  const double feed_override = requests_.control().feed_override;
  options_.feed_override = feed_override > 0 ? feed_override : 1;
  channel_.reset();
  requests_.begin_again();
  reader_ = ipr::Reader::fed();
  begin();
  options_.interpreter.memory = nullptr;
  pushed_ = 0;
  rests_ = false;
  status_ = SessionStatus::waiting;
}

void Session::count_on_from(const Setpoint& row) {
  before_.period += row.period - last_.period;
  before_.s += row.s - last_.s;
  before_.block += row.block - last_.block;
  const bool in_program = requests_.control().hold || status_ == SessionStatus::paused;
  last_ = row;
  if (in_program) return;
  ipr::Memory memory = channel_->feeder().memory();
  begin_again(&memory);
}

/// Where the program has not been ended by whoever feeds it, an error is not the end.
SessionStatus Session::end_of_motion() noexcept {
  const bool can_go_on = channel_->feeder().memory().format != ipr::Format::commands;
  const bool goes_on = of_text_.errors() > 0 && can_go_on && !fed_ && !requests_.stops();
  return goes_on ? SessionStatus::error : SessionStatus::done;
}

/// Where all that has been fed has been run, lines without a block count too.
bool Session::is_all_run() const noexcept {
  const bool is_run = (rests_ && status_ == SessionStatus::waiting) ||
                      status_ == SessionStatus::done || status_ == SessionStatus::error;
  return is_run && !requests_.stops();
}

MachineState Session::state() const {
  MachineState state = is_all_run() ? memory().modal.state : channel_->feeder().states().present();
  state.position = KeptPosition{last_.position};
  return state;
}

void Session::rest() noexcept {
  rests_ = true;
  channel_->come_to_rest();
}

/// As a row of the whole session.
Setpoint Session::counted_on(Setpoint setpoint) const noexcept {
  setpoint.period += before_.period;
  setpoint.s += before_.s;
  setpoint.block += before_.block;
  if (setpoint.line > 0) setpoint.line += before_it_;
  return setpoint;
}

Status Session::feed(std::string_view text) {
  if (!takes_more()) return {};
  if (Status fed = reader_.feed(text); !fed) return fed;
  rests_ = false;
  lines_ += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  if (status_ == SessionStatus::waiting) status_ = SessionStatus::running;
  return {};
}

void Session::feed(Block block) {
  if (!takes_more()) return;
  if (block.number == 0) block.number = pushed_ + 1;
  pushed_ = block.number;
  channel_->feeder().push(std::move(block));
  if (status_ == SessionStatus::waiting) status_ = SessionStatus::running;
}

void Session::end() noexcept {
  fed_ = true;
  reader_.end_feed();
}

std::optional<Row> Session::step() {
  if (status_ > SessionStatus::paused) return std::nullopt;
  if (is_to_pause()) return std::nullopt;
  channel_->answer_requests();
  const auto setpoint = channel_->step(requests_.panel());
  channel_->rethrow();
  if (!setpoint) {
    status_ = channel_->waiting() ? SessionStatus::waiting : end_of_motion();
    return std::nullopt;
  }
  return exchange(*setpoint);
}

/// Whether the machine stands at a pause that has not been answered.
bool Session::is_to_pause() noexcept {
  if (requests_.stops() || !channel_->pause_ahead()) return false;
  if (std::exchange(status_, SessionStatus::paused) == SessionStatus::paused) return true;
  Setpoint at = counted_on(channel_->rest_at_pause());
  at.period = last_.period;
  at.outputs = outputs();
  backend_.rest(at);
  at.pulses = {};
  at.fine = {};
  last_ = at;
  return true;
}

Row Session::exchange(const Setpoint& setpoint) {
  status_ = SessionStatus::running;
  Setpoint row = counted_on(setpoint);
  row.outputs = overridden(setpoint.outputs);
  const Feedback feedback = backend_.exchange(row);
  if (feedback.alarm != Alarm::none) status_ = SessionStatus::alarm;
  backend_.values(std::span(values_).first(backend_.columns().size()));
  const std::span rows(&setpoint, 1);
  channel_->see_path_to(setpoint.s + Contour::kAhead);
  verification_->add(rows, channel_->queue());
  if (contour_) {
    add_path(rows, planned_s_, channel_->queue(), *contour_);
    measure_contour(setpoint, backend_.actual(), *contour_, values_);
  }
  planned_s_ = setpoint.s;
  channel_->feeder().pass(setpoint.block);
  channel_->forget_passed();
  last_ = row;
  if (sink_ && !sink_->row(row, values_)) requests_.stop();
  return {row, feedback, values_};
}

AxisVector Session::programmed(const AxisVector& place) const noexcept {
  const auto& present = channel_->feeder().coordinates().present();
  return (is_all_run() ? memory().modal.coordinates : present).to_program(place);
}

int Session::blocks_ahead() const noexcept {
  return std::max(channel_->feeder().last_number() - (last_.block - before_.block), 0);
}

std::optional<AxisVector> Session::goal() const noexcept {
  const Move* move = channel_->queue().empty() ? nullptr : channel_->queue().front().move();
  return move == nullptr ? std::nullopt : std::optional(softcnc::end(move->path));
}

void Session::set_spindle_override(double spindle_override) noexcept {
  if (std::isnan(spindle_override)) return;
  spindle_override_ = std::clamp(spindle_override, kLeastOfOperator, kLargestOverride);
}

void Session::set_switches(bool block_skip, bool optional_stop, bool single_block) noexcept {
  options_.interpreter.block_skip = block_skip;
  options_.interpreter.optional_stop = optional_stop;
  options_.single_block = single_block;
  channel_->feeder().set_switches(block_skip, optional_stop, single_block);
}

Outputs Session::overridden(Outputs outputs) const noexcept {
  if (off_) return {};
  const double programmed = std::abs(outputs.spindle_rpm);
  if (programmed == 0 || channel_->keeps_spindle_speed()) return outputs;
  const Spindle& spindle = machine_.spindle;
  const double speed =
      std::clamp(spindle_override_ * programmed, std::min(spindle.min_rpm, programmed),
                 std::max(spindle.max_rpm, programmed));
  outputs.spindle_rpm = std::copysign(speed, outputs.spindle_rpm);
  return outputs;
}

void Session::resume() noexcept {
  requests_.resume();
  if (status_ != SessionStatus::paused) return;
  channel_->resume();
  status_ = SessionStatus::running;
}

const ProbeRequest* Session::probe() const noexcept {
  const Pause* at = pause();
  const auto* action = at == nullptr ? nullptr : std::get_if<Action>(&at->block.what);
  const bool is_probe = action != nullptr && !at->before && action->kind == Action::Kind::probe;
  return is_probe ? channel_->feeder().probe() : nullptr;
}

void Session::probed(const ProbeAnswer& answer) {
  channel_->feeder().probed(answer);
  channel_->stand_at(answer.rest);
  rests_ = false;
  resume();
}

std::optional<ContourReport> Session::contour() const {
  if (!contour_) return std::nullopt;
  return contour_->report();
}

}  // namespace softcnc::runtime
