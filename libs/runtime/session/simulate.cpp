// SPDX-License-Identifier: MIT
// A run in batches: the cycle fills one with rows, which are then verified and written. In real
// time setpoints wait for their instants first, and their rows come back later.
#include "runtime/session/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

#include "runtime/figures/cpu_clock.hpp"
#include "runtime/program/descriptor.hpp"
#include "runtime/realtime/setpoint_queue.hpp"
#include "runtime/session/batch.hpp"
#include "runtime/session/channel.hpp"
#include "runtime/session/output_events.hpp"
#include "runtime/session/verification.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::size_t kBatch = 256;      // rows
constexpr double kLongestBatch = 0.256;  // s: a backend may run in real time
constexpr int kPause = 20;               // ms: where a pipe gives nothing for so long, it pauses
constexpr double kStopAhead = 0.025;     // s from a request to the setpoint where its stop begins

std::size_t batch_of(const Machine& machine) {
  const double rows = std::round(kLongestBatch / machine.control.period);
  return static_cast<std::size_t>(std::clamp(rows, 1.0, static_cast<double>(kBatch)));
}

class Simulation {
 public:
  Simulation(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
             hal::Backend& backend, Diagnostics& diagnostics, RowSink* rows, Watcher* watcher,
             SetpointQueue* ahead)
      : input_(input),
        requests_(options.feed_override, options.events),
        channel_(reader, input, machine, options, requests_, diagnostics),
        backend_(backend),
        machine_(machine),
        rows_(rows),
        watcher_(watcher),
        ahead_(ahead),
        goes_back_(machine.control.interpolation == Method::arc_length),
        period_(machine.control.period),
        buffer_(backend, kBatch),
        batch_(batch_of(machine)),
        skims_(options.skims && !ahead && !(rows && rows->observer())),
        rests_at_pauses_(options.rests_at_pauses && options.events.empty()),
        verification_(machine),
        diagnostics_(diagnostics),
        worst_lines_(options.worst_lines),
        line_times_(options.line_times) {
    if (knows_contour(backend)) contour_.emplace(machine.control.period);
    channel_.feeder().show(verification_.programmed());
    if (rows) verification_.inform(rows->observer());
  }

  Outcome run() {
    do {
      if (channel_.request_due()) close_batch();
      channel_.answer_requests();
      wait();
      if (channel_.waiting()) wait_for_more();
      look_for_stop();
    } while (ahead_ ? plan_batch() : run_batch());
    channel_.rethrow();
    if (ahead_) end_ahead();
    return finish();
  }

 private:
  void wait();
  void wait_for_more();
  bool look_for_stop();
  void stop();
  bool run_batch();
  bool plan_batch();
  bool play_all();
  void close_batch();
  void take_back(std::size_t rows);
  void collect();
  void look_at_rows(const Feedback& last);
  void pass_quiet_rows();
  void verify();
  void write();
  void end_ahead();
  void keep_times();
  double lap() noexcept;
  std::optional<KeptPosition> kept_position() const;
  Outcome finish();

  int input_;
  Requests requests_;
  Channel channel_;
  hal::Backend& backend_;
  const Machine& machine_;
  RowSink* rows_;
  Watcher* watcher_;
  SetpointQueue* ahead_;  // of setpoints in real time
  bool goes_back_;        // where they are taken back
  double period_;         // s
  RowBuffer buffer_;
  std::size_t batch_;                // rows
  std::deque<std::size_t> batches_;  // rows planned ahead and not looked at, by batch,
  std::size_t planned_ = 0;          // and of the batch that is being planned
  bool skims_, quiet_ = false;       // what follows
  bool rests_at_pauses_, rested_ = false;
  bool wanted_ = true;  // rows
  Verification verification_;
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
void Simulation::wait() {
  while (const Pause* pause = channel_.pause_ahead()) {
    if (!play_all()) return;
    const Setpoint at = channel_.rest_at_pause();
    backend_.rest(at);
    if (rows_) rows_->rest(at);
    if (watcher_) watcher_->pause(*pause);
    channel_.resume();
  }
}

/// Lets all setpoints so far be played; false where a stop is requested before that, or an alarm
/// has come.
bool Simulation::play_all() {
  if (ahead_) ahead_->rest();
  close_batch();
  while (ahead_ && !ahead_->all_back()) {
    ahead_->wait();
    collect();
    if (look_for_stop()) return false;
  }
  if (ahead_) collect();
  return outcome_.end != Outcome::End::alarm;
}

bool Simulation::look_for_stop() {
  if (!watcher_ || requests_.stops() || !watcher_->wants_stop()) return false;
  stop();
  return true;
}

/// Setpoints that wait are taken back from a little ahead of now on, and the stop begins there. A
/// plan that is not made in time is made again for a later instant.
void Simulation::stop() {
  requests_.stop();
  if (!ahead_ || !goes_back_) return;
  for (double time = kStopAhead;; time *= 2) {
    const auto cut = ahead_->cut_in(time, channel_.planned_from());
    const std::size_t behind = cut ? ahead_->count_after(*cut) : 0;
    if (!cut || channel_.stop_after(cut->last, [&] { return ahead_->take_back(*cut); }))
      return take_back(behind);
  }
}

/// The last rows planned will not come.
void Simulation::take_back(std::size_t rows) {
  while (rows > planned_) {
    planned_ += batches_.back();
    batches_.pop_back();
  }
  planned_ -= rows;
}

/// The rows of a batch are looked at together, those that are planned ahead like others.
void Simulation::close_batch() {
  if (planned_ > 0) batches_.push_back(std::exchange(planned_, 0));
}

/// A reader of the rows gets what there is, however long the next line of the program takes.
void Simulation::wait_for_more() {
  if (rests_at_pauses_ && !rested_ && !has_input(input_, kPause)) {
    rested_ = true;
    return channel_.come_to_rest();
  }
  rested_ = false;
  if (ahead_ && !play_all()) return;
  if (rows_) rows_->flush();
  if (watcher_)
    watcher_->wait_for_input(input_);
  else
    wait_for_input(input_);
}

/// The rows before have been in the stretch as long as a difference reaches back; those that the
/// first one after it depends on are shown again.
void Simulation::pass_quiet_rows() {
  const Channel::Quiet quiet = channel_.quiet_ahead();
  constexpr std::int64_t felt{Batch::kFelt};
  std::int64_t left = quiet.rows - felt;
  while (left > 0 && !requests_.stops() && !(watcher_ && watcher_->wants_stop())) {
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
bool Simulation::run_batch() {
  buffer_.clear();
  if (std::exchange(quiet_, false)) pass_quiet_rows();
  Batch batch(channel_, batch_, skims_);
  const CycleReport cycle = run_cycle(batch, backend_, buffer_, requests_.panel());
  look_at_rows(cycle.last);
  quiet_ = batch.leads_into_quiet();
  channel_.forget_passed();
  return outcome_.end == Outcome::End::done && !batch.at_end();
}

/// Their rows come back from the queue.
struct NoRecorder {
  void record(const Setpoint&, const Feedback&) noexcept {}
};

/// Fills the queue of setpoints, as far as it has room. True if more may follow.
bool Simulation::plan_batch() {
  const std::size_t room = std::min(batch_ - planned_, ahead_->capacity_left());
  Batch batch(channel_, room, false);
  NoRecorder recorder;
  const CycleReport cycle = run_cycle(batch, *ahead_, recorder, requests_.panel());
  planned_ += static_cast<std::size_t>(cycle.setpoints);
  if (planned_ == batch_ || batch.ends_early()) close_batch();
  if (room == 0) ahead_->wait();
  collect();
  if (batch.at_end() && play_all()) return false;
  return outcome_.end == Outcome::End::done;
}

/// The batches that are back by now.
void Simulation::collect() {
  while (!batches_.empty() && ahead_->back() >= batches_.front()) {
    buffer_.clear();
    Feedback last = outcome_.feedback;
    ahead_->collect(batches_.front(), [&](const SetpointQueue::Row& row) {
      buffer_.add(row);
      last = row.feedback;
    });
    batches_.pop_front();
    look_at_rows(last);
    const auto passed = static_cast<double>(outcome_.last.period - 1) * period_;
    channel_.forget_passed(passed);
  }
}

void Simulation::look_at_rows(const Feedback& last) {
  outcome_.cpu.cycle += lap();
  verify();
  outcome_.cpu.verification += lap();
  if (const auto rows = buffer_.rows(); !rows.empty()) {
    outcome_.setpoints += static_cast<std::int64_t>(rows.size());
    outcome_.feedback = last;
    outcome_.last = rows.back();
    outcome_.last.pulses = {};
    outcome_.last.fine = {};
  }
  write();
  if (watcher_) {
    watcher_->reads(channel_.feeder().read_to(), Reading::run);
    watcher_->sees(outcome_.last);
  }
  channel_.feeder().pass(outcome_.last.block);
  outcome_.cpu.output += lap();
  if (outcome_.feedback.alarm != Alarm::none) outcome_.end = Outcome::End::alarm;
}

void Simulation::verify() {
  const auto rows = buffer_.rows();
  if (rows.empty()) return;
  channel_.see_path_to(rows.back().s + Contour::kAhead);
  verification_.add(rows, channel_.queue());
  if (contour_) add_path(rows, planned_s_, channel_.queue(), *contour_);
  planned_s_ = rows.back().s;
  for (std::size_t i = 0; contour_ && i < rows.size(); ++i)
    measure_contour(rows[i], buffer_.actual(i), *contour_, buffer_.values(i));
}

/// Where rows are no longer wanted the machine comes to rest on the path all the same.
void Simulation::write() {
  for (std::size_t i = 0; rows_ && wanted_ && i < buffer_.rows().size(); ++i)
    wanted_ = rows_->row(buffer_.rows()[i], buffer_.values(i));
  if (!wanted_ && !requests_.stops()) stop();
}

void Simulation::end_ahead() {
  ahead_->stop();
  close_batch();
  collect();
  channel_.forget_passed();
}

void Simulation::keep_times() {
  const RunTimes& times = channel_.end_times();
  outcome_.time_by_limit = times.by_limit();
  outcome_.time_sheet = times.sheet();
  settle_outputs(outcome_.time_sheet, machine_, diagnostics_);
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
  const BlockHistory<MachineState>& states = channel_.feeder().states();
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
                 RowSink* rows, Watcher* watcher, SetpointQueue* ahead) {
  return Simulation(reader, input, machine, options, backend, diagnostics, rows, watcher, ahead)
      .run();
}

}  // namespace softcnc::runtime
