// SPDX-License-Identifier: MIT
#include "runtime/session/feeder.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "ipo/limits/following_limits.hpp"
#include "ipo/path/travel.hpp"
#include "runtime/figures/cpu_clock.hpp"
#include "runtime/program/descriptor.hpp"

namespace softcnc::runtime {
namespace {

/// Whether the program waits for a person there.
bool is_stop(const Block& block) {
  const auto* action = std::get_if<Action>(&block.what);
  if (action == nullptr) return false;
  constexpr int kM06 = 6;
  return action->kind == Action::Kind::stop ||
         (action->kind == Action::Kind::tool && action->code == kM06);
}

bool is_pause(const Block& block) {
  const auto* action = std::get_if<Action>(&block.what);
  return is_stop(block) || (action != nullptr && action->kind == Action::Kind::probe);
}

void end_at_rest(Block& block) {
  if (Move* move = std::get_if<Move>(&block.what)) move->path_mode = PathMode::stop;
}

double largest_override(const ChannelOptions& options) {
  double largest = std::max(options.feed_override, options.largest_override);
  for (const FeedEvent& event : options.events)
    if (event.kind == FeedEvent::Kind::override_) largest = std::max(largest, event.percent / 100);
  return largest;
}

}  // namespace

Feeder::Feeder(ipr::Reader& reader, int input, const Machine& machine,
               const ChannelOptions& options, Diagnostics& diagnostics)
    : input_(input),
      machine_(machine),
      path_machine_(ipo::planned_machine(machine)),
      options_(options),
      diagnostics_(diagnostics),
      parser_(reader, diagnostics),
      interpreter_(parser_, machine, diagnostics, options.interpreter, options.state),
      planner_(path_machine_, options.feed_override, diagnostics, {}, options.constraints),
      first_cut_delay_(options.first_cut_delay),
      delay_place_(delay_place(machine.control.interpolation)),
      states_(options.state),
      coordinates_(interpreter_.coordinates()),
      spindle_(machine.spindle.acceleration, options.outputs.spindle_rpm),
      patient_(!options.events.empty()),
      limit_(machine, largest_override(options)) {}

void Feeder::fill(ipo::BlockQueue& queue, double until) {
  CpuLaps cpu;
  until_ = std::exchange(waiting_, false) && patient_ ? until_ : until;
  while (queue.t_end() <= until_) {
    auto part = planner_.pop_part();
    if (!part && ended_) break;
    if (!part && read_block()) continue;
    if (!part && !patient_ && options_.hurries) part = planner_.pop_part_now();
    waiting_ = !part;
    if (waiting_) break;
    take(queue, std::move(*part));
  }
  cpu_ += cpu.lap();
}

void Feeder::read_ahead(ipo::BlockQueue& queue, int blocks) {
  CpuLaps cpu;
  for (; !ended_ && blocks > 0 && read_block(); --blocks)
    while (auto part = planner_.pop_part()) take(queue, std::move(*part));
  cpu_ += cpu.lap();
}

void Feeder::come_to_rest(ipo::BlockQueue& queue) {
  read_ahead(queue, std::numeric_limits<int>::max());
  CpuLaps cpu;
  constexpr double kPeriods = 2;  // so that a row at rest lies before the end of the queue
  if (!ended_ && !std::exchange(at_rest_, true)) {
    planner_.push({Dwell{kPeriods * machine_.control.period}, last_place_, last_number_});
    planner_.come_to_rest();
  }
  take_all(queue);
  waiting_ = !ended_;
  cpu_ += cpu.lap();
}

/// What comes after a rest may divide the last move before it: that has been timed by then.
void Feeder::take_all(ipo::BlockQueue& queue) {
  while (auto part = planner_.pop_part_now()) take(queue, std::move(*part));
}

void Feeder::look_ahead(ipo::BlockQueue& queue, double s, double t) {
  CpuLaps cpu;
  while (!waiting_ && queue.s_end().value_or(0) < s && queue.t_end() < t) {
    auto part = planner_.pop_part();
    if (!part && (ended_ || !read_block())) break;
    if (part) take(queue, std::move(*part));
  }
  cpu_ += cpu.lap();
}

void Feeder::take(ipo::BlockQueue& queue, ipo::TimedPart part) {
  const auto* timed = std::get_if<ipo::TimedBlock>(&part);
  std::optional<Diagnostic> late;
  if (timed != nullptr) find_pauses(*timed);
  if (timed != nullptr && diagnostics_.errors() == 0)
    late = limit_.check_end(timed->block, timed->t_end());
  queue.push(std::move(part));
  planned_ = queue.t_end();
  if (!late) return;
  diagnostics_.report(std::move(*late));
  if (ended_) return;
  end_at_last_block();
  read_on(std::nullopt);
}

void Feeder::end_at_last_block() {
  planner_.finish();
  ended_ = true;
}

/// Returns whether a block that has been read ends at rest for a single block.
bool Feeder::was_single(int number) const noexcept {
  const auto later =
      std::upper_bound(single_.begin(), single_.end(), number,
                       [](int block, const auto& change) { return block < change.first; });
  return later != single_.begin() && later[-1].second;
}

/// Behind every single block but the last, and those that wait by themselves.
void Feeder::find_pauses(const ipo::TimedBlock& timed) {
  const Block& block = timed.block;
  const bool is_next = last_block_ && *last_block_ != block.number;
  if (is_next && was_single(*last_block_) && !is_stop(block))
    pauses_.push_back({block, timed.t_start, true});
  last_block_ = block.number;
  if (is_pause(block) && block.number != answered_)
    pauses_.push_back({block, timed.t_end(), false});
}

void Feeder::replan(ipo::BlockQueue& queue, const ipo::State& now, double t,
                    const ipo::FeedControl& asked) {
  CpuLaps cpu;
  begin_replan(queue, asked);
  queue.begin_again(planner_.replan(queue.take_rest(), now, t, asked), t);
  if (at_rest_) take_all(queue);
  cpu_ += cpu.lap();
}

bool Feeder::stop_in_time(ipo::BlockQueue& queue, const ipo::State& now, double t,
                          const ipo::FeedControl& asked, const std::function<bool()>& in_time) {
  CpuLaps cpu;
  begin_replan(queue, asked);
  ipo::PartlyPassed rest = queue.take_rest();
  const bool stops = planner_.halt_in_time(rest, now, t, asked, in_time);
  if (stops)
    queue.begin_again(std::move(rest.blocks), t);
  else
    queue.put_back(std::move(rest));
  cpu_ += cpu.lap();
  return stops;
}

/// Blocks that come again bring their pauses; after a stop nothing more is read.
void Feeder::begin_replan(const ipo::BlockQueue& queue, const ipo::FeedControl& asked) {
  pauses_.clear();
  ended_ = ended_ || asked.stop;
  last_block_ = queue.front().block.number;
}

void Feeder::finish(ipo::BlockQueue& queue) {
  waiting_ = false;
  if (!std::exchange(ended_, true)) planner_.finish();
  while (auto part = planner_.pop_part()) queue.push(std::move(*part));
}

std::optional<Block> Feeder::next_block() {
  if (const double delay = std::exchange(first_cut_delay_, 0); delay > 0)
    pushed_ = with_first_cut_delayed([this] { return interpreter_.next(); }, delay, delay_place_);
  if (pushed_.empty()) return interpreter_.next();
  std::optional<Block> block(std::move(pushed_.front()));
  pushed_.pop_front();
  return block;
}

void Feeder::note_origin(const Block& block) {
  const Move* move = std::get_if<Move>(&block.what);
  if (move == nullptr || move->work_system == last_system_) return;
  last_system_ = move->work_system;
  if (last_system_ != kNoSystem)
    origins_.emplace(last_system_, interpreter_.state().work_system(last_system_).origin);
}

void Feeder::plan(Block block) {
  if (programmed_) programmed_->add(block);
  last_place_ = block.source;
  last_number_ = block.number;
  at_rest_ = false;
  planner_.push(std::move(block));
}

/// False if that would have to wait.
bool Feeder::read_block() {
  auto block = next_block();
  if (block) note_origin(*block);
  if (!block && interpreter_.waiting() && diagnostics_.errors() == 0) return false;
  if (block && options_.keeps_state) {
    states_.add(block->number, interpreter_.state());
    coordinates_.add(block->number, interpreter_.coordinates());
  }
  if (block && diagnostics_.errors() == 0)
    if (auto late = limit_.check(*block, planned_)) diagnostics_.report(std::move(*late));
  if (is_endless()) {
    end_at_last_block();
    read_unplanned(std::move(block));
    return true;
  }
  const bool good = block && diagnostics_.errors() == 0;
  if (good && (single_.empty() || single_.back().second != options_.single_block))
    single_.emplace_back(block->number, options_.single_block);
  if (good && options_.single_block) end_at_rest(*block);
  if (good) {
    if (auto wait = spindle_.before(*block)) plan(std::move(*wait));
    plan(*std::exchange(block, std::nullopt));
  }
  if (good && diagnostics_.errors() == 0) return true;
  end_at_last_block();
  read_on(std::move(block));
  return true;
}

/// Asked for seldom enough not to count.
bool Feeder::is_endless() {
  constexpr std::int64_t kSeldom = 4;
  if (!options_.is_endless || parser_.reader().bytes() == 0) return false;
  const std::int64_t again = parser_.bytes_read() - parser_.reader().bytes();
  if (again < read_again_) return false;
  read_again_ = kSeldom * again;
  return options_.is_endless();
}

/// The next block, however long it takes to come; a program that is fed has nobody to wait for.
std::optional<Block> Feeder::wait_for_block() {
  auto block = interpreter_.next();
  const std::stop_token& stop = options_.interpreter.stop;
  for (; !block && interpreter_.waiting() && !stop.stop_requested(); block = interpreter_.next()) {
    if (input_ < 0) break;
    wait_for_input(input_, stop);
  }
  return block;
}

/// Reads to the end of a program that has none: planning what it does would take long.
void Feeder::read_unplanned(std::optional<Block> block) {
  for (; block; block = wait_for_block())
    if (const Move* move = std::get_if<Move>(&block->what))
      ipo::report_travel(*move, block->source, machine_, diagnostics_);
}

/// Reads to the end of the program only to find what else is wrong. A move that is missing leaves a
/// gap, which no corner may round.
void Feeder::read_on(std::optional<Block> block) {
  if (diagnostics_.errors() == 0) return;
  ipo::Planner rest(path_machine_, options_.feed_override, diagnostics_);
  std::optional<AxisVector> end;  // of the move before
  if (!block) block = wait_for_block();
  for (; block; block = wait_for_block()) {
    if (const Move* move = std::get_if<Move>(&block->what)) {
      if (end && *end != start(move->path)) rest.push({Dwell{0}, block->source});
      end = softcnc::end(move->path);
    }
    rest.push(std::move(*block));
    while (rest.pop()) {
    }
  }
}

}  // namespace softcnc::runtime
