// SPDX-License-Identifier: MIT
// A run in batches: the cycle fills one with rows, which are then verified and written. With a
// clock the rows come back later, and whoever keeps the clock writes them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "channel.hpp"
#include "cpu_clock.hpp"
#include "descriptor.hpp"
#include "paced_cycle.hpp"
#include "verification.hpp"

namespace softcnc::app {
namespace {

constexpr std::size_t kBatch = 256;      // rows
constexpr double kLongestBatch = 0.256;  // s: a backend may keep pace with the clock

std::size_t batch_of(const Machine& machine) {
  const double rows = std::round(kLongestBatch / machine.control.period);
  return static_cast<std::size_t>(std::clamp(rows, 1.0, static_cast<double>(kBatch)));
}

/// A Recorder that keeps the rows of a batch, with what the backend says of them if there is one.
class RowBuffer {
 public:
  explicit RowBuffer(const hal::Backend* backend)
      : backend_(backend),
        columns_(backend ? backend->columns().size() : 0),
        rows_(kBatch),
        pulses_(kBatch),
        values_(kBatch * columns_) {}

  void clear() noexcept { used_ = 0; }
  void record(const Setpoint& setpoint, const Feedback&) noexcept {
    if (backend_) backend_->values(std::span(values_).subspan(used_ * columns_, columns_));
    rows_[used_] = setpoint;
    if (!setpoint.pulses.empty()) keep_pulses(setpoint.pulses);
    ++used_;
  }

  std::span<const Setpoint> rows() const noexcept { return std::span(rows_).first(used_); }
  std::span<const double> values(std::size_t row) const noexcept {
    return std::span(values_).subspan(row * columns_, columns_);
  }

 private:
  /// Those of the setpoint stand only until the next one is made.
  void keep_pulses(std::span<const TimedStep> pulses) noexcept {
    pulses_[used_].assign(pulses.begin(), pulses.end());
    rows_[used_].pulses = pulses_[used_];
  }

  const hal::Backend* backend_;
  std::size_t columns_, used_ = 0;
  std::vector<Setpoint> rows_;
  std::vector<std::vector<TimedStep>> pulses_;
  std::vector<double> values_;
};

/// A Source that ends with the batch, or before the program waits or is to be planned anew.
class Batch {
 public:
  Batch(Channel& channel, std::size_t rows) noexcept : channel_(channel), left_(rows) {}
  std::optional<Setpoint> step(const Panel& panel) noexcept {
    if (left_ == 0 || channel_.event_due() || channel_.pause_ahead()) return std::nullopt;
    --left_;
    auto next = channel_.step(panel);
    at_end_ = !next && !channel_.waiting();
    return next;
  }

  /// Nothing follows the batch.
  bool at_end() const noexcept { return at_end_; }

 private:
  Channel& channel_;
  std::size_t left_;
  bool at_end_ = false;
};

class Simulation {
 public:
  Simulation(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
             hal::Backend& backend, Diagnostics& diagnostics, PacedCycle* paced)
      : input_(input),
        channel_(reader, input, machine, options, diagnostics),
        backend_(backend),
        paced_(paced),
        buffer_(paced ? nullptr : &backend),
        batch_(batch_of(machine)),
        verification_(machine),
        diagnostics_(diagnostics),
        worst_lines_(options.worst_lines) {
    channel_.feeder().show(verification_.programmed());
  }

  Outcome run(RowSink* rows, Watcher* watcher) {
    do {
      channel_.answer_events();
      wait(rows, watcher);
      if (channel_.waiting()) wait_for_more(rows, watcher);
      if (watcher && !panel_.stop) panel_.stop = watcher->wants_stop();
    } while (run_batch(rows, watcher));
    channel_.rethrow();
    if (paced_) end_paced();
    return finish();
  }

 private:
  void wait(RowSink* rows, Watcher* watcher);
  void wait_for_more(RowSink* rows, Watcher* watcher) const;
  bool run_batch(RowSink* rows, Watcher* watcher);
  bool write(RowSink* rows, const CycleReport& cycle);
  bool collect();
  void end_paced();
  void keep_times();
  Outcome finish();

  int input_;
  Panel panel_;
  Channel channel_;
  hal::Backend& backend_;
  PacedCycle* paced_;
  RowBuffer buffer_;
  std::size_t batch_;  // rows
  Verification verification_;
  const Diagnostics& diagnostics_;
  std::size_t worst_lines_;
  Outcome outcome_;
  CpuLaps cpu_;
};

/// All rows so far are out; the machine rests in the next one, whatever the answer.
void Simulation::wait(RowSink* rows, Watcher* watcher) {
  while (const Pause* pause = channel_.pause_ahead()) {
    if (paced_) paced_->rest();
    backend_.rest();
    if (rows) rows->rest();
    if (watcher) watcher->pause(*pause);
    channel_.resume();
  }
}

/// Whoever reads the rows sees what there is, however long the next line of the program takes.
void Simulation::wait_for_more(RowSink* rows, Watcher* watcher) const {
  if (paced_) paced_->rest();
  if (rows) rows->flush();
  if (watcher)
    watcher->wait_for_input(input_);
  else
    wait_for_input(input_);
}

/// True if more may follow.
bool Simulation::run_batch(RowSink* rows, Watcher* watcher) {
  buffer_.clear();
  Batch batch(channel_, batch_);
  const CycleReport cycle = paced_ ? run_cycle(batch, *paced_, buffer_, panel_)
                                   : run_cycle(batch, backend_, buffer_, panel_);
  outcome_.cpu.cycle += cpu_.lap();
  verification_.add(buffer_.rows(), channel_.queue());
  outcome_.cpu.verification += cpu_.lap();
  const bool wanted = paced_ ? collect() : write(rows, cycle);
  if (watcher) watcher->sees(outcome_.last);
  channel_.feeder().states().pass(outcome_.last.block);
  channel_.forget_passed();
  outcome_.cpu.output += cpu_.lap();
  if (!wanted) outcome_.end = Outcome::End::broken_off;
  if (outcome_.feedback.alarm != Alarm::none) outcome_.end = Outcome::End::alarm;
  return outcome_.end == Outcome::End::done && !batch.at_end();
}

bool Simulation::write(RowSink* rows, const CycleReport& cycle) {
  outcome_.setpoints += cycle.setpoints;
  if (cycle.setpoints > 0) {
    outcome_.feedback = cycle.last;
    outcome_.last = buffer_.rows().back();
  }
  for (std::size_t i = 0; rows && i < buffer_.rows().size(); ++i)
    if (!rows->row(buffer_.rows()[i], buffer_.values(i))) return false;
  return true;
}

/// What has come back so far.
bool Simulation::collect() {
  const bool wanted = paced_->collect();
  outcome_.setpoints = paced_->rows();
  outcome_.feedback = paced_->feedback();
  outcome_.last = paced_->last();
  return wanted;
}

void Simulation::end_paced() {
  if (outcome_.end == Outcome::End::done) paced_->rest();
  paced_->stop();
  if (!collect()) outcome_.end = Outcome::End::broken_off;
  if (outcome_.feedback.alarm != Alarm::none) outcome_.end = Outcome::End::alarm;
  channel_.feeder().states().pass(outcome_.last.block);
}

void Simulation::keep_times() {
  const RunTimes& times = channel_.end_times();
  outcome_.time_by_limit = times.by_limit();
  outcome_.time_sheet = times.sheet();
  outcome_.worst_lines =
      times.lines().worst(worst_lines_, [this](int file) { return diagnostics_.file(file); });
}

Outcome Simulation::finish() {
  if (outcome_.end == Outcome::End::done) verification_.finish();  // otherwise it is not at rest
  if (outcome_.end == Outcome::End::done && panel_.stop) outcome_.end = Outcome::End::stopped;
  const StateHistory& states = channel_.feeder().states();
  outcome_.state = outcome_.end == Outcome::End::done ? states.last() : states.present();
  outcome_.time = channel_.time();
  keep_times();
  outcome_.measured = verification_.measured();
  outcome_.corner_deviation = verification_.programmed().largest();
  outcome_.deviation = verification_.programmed().worst();
  outcome_.surface = verification_.surface();
  outcome_.events_left = channel_.events_left();
  outcome_.planner = channel_.feeder().counts();
  outcome_.called_files = channel_.feeder().called_files();
  outcome_.missing_files = channel_.feeder().missing_files();
  outcome_.cpu.planning = channel_.feeder().cpu();
  outcome_.cpu.cycle -= outcome_.cpu.planning;
  return outcome_;
}

}  // namespace

Outcome simulate(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, hal::Backend& backend, Diagnostics& diagnostics,
                 RowSink* rows, Watcher* watcher, PacedCycle* paced) {
  return Simulation(reader, input, machine, options, backend, diagnostics, paced)
      .run(rows, watcher);
}

}  // namespace softcnc::app
