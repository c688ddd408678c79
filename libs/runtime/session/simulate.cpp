// SPDX-License-Identifier: MIT
// A run in batches: the cycle fills one with rows, which are then verified and written. In real
// time the rows come back later, and the real-time cycle writes them.
#include "runtime/session/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "runtime/figures/cpu_clock.hpp"
#include "runtime/program/descriptor.hpp"
#include "runtime/realtime/realtime_cycle.hpp"
#include "runtime/session/channel.hpp"
#include "runtime/session/output_events.hpp"
#include "runtime/session/verification.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::size_t kBatch = 256;      // rows
constexpr double kLongestBatch = 0.256;  // s: a backend may run in real time
constexpr std::size_t kFelt = 3;         // rows before one that its differences depend on
constexpr int kPause = 20;               // ms: where a pipe gives nothing for so long, it pauses
constexpr std::int64_t kFewQuiet = 32;   // rows: fewer are not worth passing over

std::size_t batch_of(const Machine& machine) {
  const double rows = std::round(kLongestBatch / machine.control.period);
  return static_cast<std::size_t>(std::clamp(rows, 1.0, static_cast<double>(kBatch)));
}

/// A Recorder that keeps the rows of a batch, with what the backend says of them if there is one:
/// its values, and where the axes were.
class RowBuffer {
 public:
  explicit RowBuffer(const hal::Backend* backend)
      : backend_(backend),
        columns_(backend ? row_columns(*backend).size() : 0),
        rows_(kBatch),
        pulses_(kBatch),
        fine_(kBatch),
        values_(kBatch * columns_),
        actual_(kBatch) {}

  void clear() noexcept { used_ = 0; }
  void record(const Setpoint& setpoint, const Feedback&) noexcept {
    if (backend_) keep_what_backend_knows();
    rows_[used_] = setpoint;
    if (!setpoint.pulses.empty()) keep_pulses(setpoint.pulses);
    if (!setpoint.fine.empty()) keep_fine(setpoint.fine);
    ++used_;
  }

  std::span<const Setpoint> rows() const noexcept { return std::span(rows_).first(used_); }
  std::span<double> values(std::size_t row) noexcept {
    return std::span(values_).subspan(row * columns_, columns_);
  }
  std::span<const AxisVector> actual(std::size_t row) const noexcept { return actual_[row]; }

 private:
  void keep_what_backend_knows() noexcept {
    const auto actual = backend_->actual();
    backend_->values(values(used_).first(backend_->columns().size()));
    actual_[used_].assign(actual.begin(), actual.end());
  }
  /// Those of the setpoint stand only until the next one is made.
  void keep_pulses(std::span<const TimedStep> pulses) noexcept {
    pulses_[used_].assign(pulses.begin(), pulses.end());
    rows_[used_].pulses = pulses_[used_];
  }
  void keep_fine(std::span<const FinePoint> fine) noexcept {
    fine_[used_].assign(fine.begin(), fine.end());
    rows_[used_].fine = fine_[used_];
  }

  const hal::Backend* backend_;
  std::size_t columns_, used_ = 0;
  std::vector<Setpoint> rows_;
  std::vector<std::vector<TimedStep>> pulses_;
  std::vector<std::vector<FinePoint>> fine_;
  std::vector<double> values_;
  std::vector<std::vector<AxisVector>> actual_;
};

/// A Source that ends with the batch, before the program waits or is to be planned again, or where
/// rows need not be looked at and no difference feels those before any more.
class Batch {
 public:
  Batch(Channel& channel, std::size_t rows, bool skims) noexcept
      : channel_(channel), left_(rows), skims_(skims) {}
  std::optional<Setpoint> step(const Panel& panel) noexcept {
    if (left_ == 0 || channel_.request_due() || channel_.pause_ahead()) return std::nullopt;
    if (skims_ && !quiet_ && left_ >= kFelt && channel_.quiet_ahead().rows >= kFewQuiet) {
      quiet_ = true;
      left_ = kFelt;
    }
    --left_;
    auto next = channel_.step(panel);
    at_end_ = !next && !channel_.waiting();
    return next;
  }

  /// Nothing follows the batch.
  bool at_end() const noexcept { return at_end_; }
  /// What follows is quiet, and no difference there feels the rows before the quiet ones.
  bool leads_into_quiet() const noexcept { return quiet_ && left_ == 0 && !at_end_; }

 private:
  Channel& channel_;
  std::size_t left_;
  bool skims_, quiet_ = false, at_end_ = false;
};

class Simulation {
 public:
  Simulation(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
             hal::Backend& backend, Diagnostics& diagnostics, RealtimeCycle* realtime)
      : input_(input),
        requests_(options.feed_override, options.events),
        channel_(reader, input, machine, options, requests_, diagnostics),
        backend_(backend),
        backend_kind_(machine.control.backend),
        realtime_(realtime),
        buffer_(realtime ? nullptr : &backend),
        batch_(batch_of(machine)),
        skims_(options.skims && !realtime),
        rests_at_pauses_(options.rests_at_pauses && options.events.empty()),
        verification_(machine),
        diagnostics_(diagnostics),
        worst_lines_(options.worst_lines),
        line_times_(options.line_times) {
    if (knows_contour(backend)) contour_.emplace(machine.control.period);
    if (realtime_ && contour_) realtime_->measure(*contour_);
    channel_.feeder().show(verification_.programmed());
  }

  Outcome run(RowSink* rows, Watcher* watcher) {
    rows_ = rows;
    RowObserver* observer = rows ? rows->observer() : nullptr;
    verification_.inform(observer);
    skims_ = skims_ && !observer;
    do {
      channel_.answer_requests();
      wait(rows, watcher);
      if (channel_.waiting()) wait_for_more(rows, watcher);
      if (watcher && !requests_.stops() && watcher->wants_stop()) requests_.stop();
    } while (run_batch(rows, watcher));
    channel_.rethrow();
    if (realtime_) end_realtime();
    return finish();
  }

 private:
  void wait(RowSink* rows, Watcher* watcher);
  void wait_for_more(RowSink* rows, Watcher* watcher);
  bool run_batch(RowSink* rows, Watcher* watcher);
  void pass_quiet_rows(Watcher* watcher);
  void verify();
  bool write(RowSink* rows, const CycleReport& cycle);
  bool collect();
  void end_realtime();
  void keep_times();
  double lap() noexcept;
  std::optional<KeptPosition> kept_position() const;
  Outcome finish();

  int input_;
  Requests requests_;
  Channel channel_;
  hal::Backend& backend_;
  BackendKind backend_kind_;
  RealtimeCycle* realtime_;
  RowBuffer buffer_;
  std::size_t batch_;           // rows
  bool skims_, quiet_ = false;  // what follows
  bool rests_at_pauses_, rested_ = false;
  bool wanted_ = true;  // rows
  Verification verification_;
  const RowSink* rows_ = nullptr;
  Diagnostics& diagnostics_;
  std::size_t worst_lines_;
  bool line_times_;
  std::optional<Contour> contour_;
  double planned_s_ = 0;  // mm: of the last row that was planned
  Outcome outcome_;
  CpuLaps cpu_;
  double planning_ = 0;  // s of CPU: until the last lap
};

/// All rows so far are out; the machine rests in the next one, whatever the answer.
void Simulation::wait(RowSink* rows, Watcher* watcher) {
  while (const Pause* pause = channel_.pause_ahead()) {
    if (realtime_) realtime_->rest();
    backend_.rest();
    if (rows) rows->rest();
    if (watcher) watcher->pause(*pause);
    channel_.resume();
  }
}

/// A reader of the rows gets what there is, however long the next line of the program takes.
void Simulation::wait_for_more(RowSink* rows, Watcher* watcher) {
  if (rests_at_pauses_ && !rested_ && !has_input(input_, kPause)) {
    rested_ = true;
    return channel_.come_to_rest();
  }
  rested_ = false;
  if (realtime_) realtime_->rest();
  if (rows) rows->flush();
  if (watcher)
    watcher->wait_for_input(input_);
  else
    wait_for_input(input_);
}

/// The rows before have been in the stretch as long as a difference reaches back; those that the
/// first one after it depends on are shown again.
void Simulation::pass_quiet_rows(Watcher* watcher) {
  const Channel::Quiet quiet = channel_.quiet_ahead();
  constexpr std::int64_t felt{kFelt};
  std::int64_t left = quiet.rows - felt;
  while (left > 0 && !requests_.stops() && !(watcher && watcher->wants_stop())) {
    const std::int64_t rows = left > felt ? std::min(left - felt, quiet.to_next) : 1;
    channel_.pass_over(rows - 1);
    const auto row = channel_.step(requests_.panel());
    if (!row) return;
    verification_.pass_over(*row);
    outcome_.setpoints += rows;
    outcome_.last = *row;
    left -= rows;
  }
}

/// The CPU time since the last lap, without that of planning, which any stage may ask for.
double Simulation::lap() noexcept {
  const double planned = channel_.feeder().cpu();
  return std::max(cpu_.lap() - (planned - std::exchange(planning_, planned)), 0.0);
}

/// True if more may follow.
bool Simulation::run_batch(RowSink* rows, Watcher* watcher) {
  buffer_.clear();
  if (std::exchange(quiet_, false)) pass_quiet_rows(watcher);
  Batch batch(channel_, batch_, skims_);
  const CycleReport cycle = realtime_ ? run_cycle(batch, *realtime_, buffer_, requests_.panel())
                                      : run_cycle(batch, backend_, buffer_, requests_.panel());
  outcome_.cpu.cycle += lap();
  verify();
  outcome_.cpu.verification += lap();
  wanted_ = realtime_ ? collect() : write(rows, cycle);
  if (!wanted_) requests_.stop();  // the machine comes to rest on the path all the same
  quiet_ = batch.leads_into_quiet();
  if (watcher) {
    watcher->reads(channel_.feeder().read_to(), Reading::run);
    watcher->sees(outcome_.last);
  }
  channel_.feeder().states().pass(outcome_.last.block);
  channel_.forget_passed();
  outcome_.cpu.output += lap();
  if (outcome_.feedback.alarm != Alarm::none) outcome_.end = Outcome::End::alarm;
  return outcome_.end == Outcome::End::done && !batch.at_end();
}

void Simulation::verify() {
  const auto rows = buffer_.rows();
  if (rows.empty()) return;
  channel_.see_path_to(rows.back().s + Contour::kAhead);
  verification_.add(rows, channel_.queue());
  if (contour_) add_path(rows, planned_s_, channel_.queue(), *contour_);
  planned_s_ = rows.back().s;
  for (std::size_t i = 0; contour_ && !realtime_ && i < rows.size(); ++i)
    measure_contour(rows[i], buffer_.actual(i), *contour_, buffer_.values(i));
}

bool Simulation::write(RowSink* rows, const CycleReport& cycle) {
  outcome_.setpoints += cycle.setpoints;
  if (cycle.setpoints > 0) {
    outcome_.feedback = cycle.last;
    outcome_.last = buffer_.rows().back();
  }
  bool wanted = wanted_;
  for (std::size_t i = 0; rows && wanted && i < buffer_.rows().size(); ++i)
    wanted = rows->row(buffer_.rows()[i], buffer_.values(i));
  return wanted;
}

/// What has come back so far.
bool Simulation::collect() {
  const bool wanted = realtime_->collect();
  outcome_.setpoints = realtime_->rows();
  outcome_.feedback = realtime_->feedback();
  outcome_.last = realtime_->last();
  return wanted;
}

void Simulation::end_realtime() {
  if (outcome_.end == Outcome::End::done) realtime_->rest();
  realtime_->stop();
  wanted_ = collect();
  if (outcome_.feedback.alarm != Alarm::none) outcome_.end = Outcome::End::alarm;
  channel_.feeder().states().pass(outcome_.last.block);
}

void Simulation::keep_times() {
  const RunTimes& times = channel_.end_times();
  outcome_.time_by_limit = times.by_limit();
  outcome_.time_sheet = times.sheet();
  settle_outputs(outcome_.time_sheet, backend_kind_, diagnostics_);
  if (line_times_) outcome_.line_times = times.lines().times();
  outcome_.loss_causes = times.causes().causes();
  outcome_.worst_lines =
      times.lines().worst(worst_lines_, [this](int file) { return diagnostics_.file(file); });
}

/// Without motion the machine is where it was. After an alarm the axes have stopped short of
/// the last one; where nothing measures them, nobody knows where.
std::optional<KeptPosition> Simulation::kept_position() const {
  if (outcome_.last.s == 0) return channel_.feeder().states().last().position;
  const bool is_measured = backend_.instants() > 0 && !backend_.actual().empty();
  if (outcome_.end != Outcome::End::alarm) return KeptPosition{outcome_.last.position};
  return is_measured ? KeptPosition{backend_.actual().back()}
                     : KeptPosition{outcome_.last.position, true};
}

Outcome Simulation::finish() {
  if (!wanted_ && outcome_.end == Outcome::End::done) outcome_.end = Outcome::End::broken_off;
  if (outcome_.end == Outcome::End::done) verification_.finish();  // otherwise it is not at rest
  if (outcome_.end == Outcome::End::done && requests_.stops()) outcome_.end = Outcome::End::stopped;
  const StateHistory& states = channel_.feeder().states();
  outcome_.state = outcome_.end == Outcome::End::done ? states.last() : states.present();
  outcome_.state.position = kept_position();
  outcome_.time = channel_.time();
  keep_times();
  outcome_.measured = verification_.measured();
  outcome_.corner_deviation = verification_.programmed().largest();
  outcome_.deviation = verification_.programmed().worst();
  outcome_.surface = verification_.surface();
  if (contour_) outcome_.contour = contour_->report();
  if (rows_) outcome_.columns = rows_->column_figures();
  outcome_.events_left = requests_.script_left();
  outcome_.origins = channel_.feeder().origins();
  outcome_.stocks = channel_.feeder().stocks();
  outcome_.planner = channel_.feeder().counts();
  outcome_.called_files = channel_.feeder().called_files();
  outcome_.missing_files = channel_.feeder().missing_files();
  outcome_.cpu.planning = channel_.feeder().cpu();
  return outcome_;
}

}  // namespace

Outcome simulate(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, hal::Backend& backend, Diagnostics& diagnostics,
                 RowSink* rows, Watcher* watcher, RealtimeCycle* realtime) {
  return Simulation(reader, input, machine, options, backend, diagnostics, realtime)
      .run(rows, watcher);
}

}  // namespace softcnc::runtime
