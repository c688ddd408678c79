// SPDX-License-Identifier: MIT
#include "operate/attended_machine.hpp"

#include <algorithm>
#include <utility>

#include "hal/machine/machine_file.hpp"
#include "hal/trace/trace.hpp"
#include "job/open_player.hpp"
#include "job/preflight.hpp"
#include "motion/core/units.hpp"
#include "runtime/operator/position_status.hpp"
#include "runtime/realtime/realtime.hpp"
#include "runtime/sinks/contour_rows.hpp"
#include "settings/file_clash.hpp"
#include "settings/machine_choice.hpp"

namespace softcnc::app {
namespace {

/// s of rows ahead of the clock, for a machine outside that must not wait for one: planning may
/// take so long.
constexpr double kLead = 0.1;
/// s: the same where a switch or a contact ends the motion, and nothing long is planned.
constexpr double kShortLead = 0.03;

Result<std::unique_ptr<hal::PortPlayer>> open_leading_player(const Machine& machine) {
  return open_player(machine, kLead);
}

Result<runtime::TraceRows> open_rows(const std::string& file, const Machine& machine,
                                     const hal::Backend& backend) {
  if (file.empty()) return runtime::TraceRows(nullptr);
  const hal::TraceHeader header{machine.control.period, "-",
                                hal::hash_hex(hal::machine_toml(machine))};
  auto writer = hal::TraceWriter::open(file, header, machine, runtime::row_columns(backend));
  if (!writer) return tl::make_unexpected(std::move(writer.error()));
  return runtime::TraceRows(std::move(*writer));
}

}  // namespace

double session_time() {
  static const std::int64_t begin = runtime::now_ns();
  return s_from_ns(static_cast<double>(runtime::now_ns() - begin));
}

Result<std::unique_ptr<AttendedMachine>> AttendedMachine::open(const Options& options,
                                                               Messages& messages,
                                                               Diagnostics::Sink report) {
  const std::string part = options.files.empty() ? "-" : options.files.front();
  auto choice = choose_machine(part, options, messages);
  if (!choice) return tl::make_unexpected(std::move(choice.error()));
  if (const std::string clash = file_clash(options, choice->machine); !clash.empty())
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC7072, .message = clash, .file = options.machine_file});
  MachineMemory memory;
  if (!options.state.empty()) {
    auto opened = MachineMemory::open(options.state);
    if (!opened) return tl::make_unexpected(std::move(opened.error()));
    memory = std::move(*opened);
  }
  auto state = open_state(options, messages);
  if (!state) return tl::make_unexpected(std::move(state.error()));
  if (options.work.empty()) memory.read(*state);
  std::unique_ptr<AttendedMachine> opened(
      new AttendedMachine(std::move(choice->machine), std::move(memory)));
  const Machine& machine = opened->machine_;
  opened->options_ = channel_options(options, {});
  opened->options_.state = std::move(*state);
  opened->settle_place(options.assume_position);
  auto backend = hal::open_backend(machine, open_leading_player);
  if (!backend) return tl::make_unexpected(std::move(backend.error()));
  opened->backend_ = std::move(*backend);
  auto rows = open_rows(options.trace, machine, *opened->backend_);
  if (!rows) return tl::make_unexpected(std::move(rows.error()));
  opened->rows_ = std::make_unique<LastingRows>(std::move(*rows));
  opened->control_.emplace(machine, opened->options_, *opened->backend_, opened->rows_.get(),
                           std::move(report));
  return opened;
}

/// A machine that can find its zero, and whose place was never kept, does not know where it is.
void AttendedMachine::settle_place(bool confirmed) {
  using enum runtime::PositionStatus;
  MachineState& state = options_.state;
  const auto status = runtime::position_status(state, machine_.control.backend);
  is_assumed_ = status == assumed;
  const bool is_new = !state.position && runtime::Homing::is_possible(machine_);
  const bool is_known = status == known || (is_assumed_ && confirmed);
  if (is_new || !is_known) state.position = KeptPosition{state.place(), true};
}

runtime::ChannelOptions AttendedMachine::checking_options() const {
  runtime::ChannelOptions options = options_;
  options.state = control_->state();
  options.outputs = control_->outputs();
  if (backend_->has_probe()) options.interpreter.contacts = ipr::Contacts::expected;
  return options;
}

Status AttendedMachine::mark_motion() {
  if (is_marked_ || !control_->in_motion()) return {};
  Status marked = memory_.mark_motion(control_->state());
  is_marked_ = marked.has_value();
  is_assumed_ = false;
  return marked;
}

Status AttendedMachine::keep_state() {
  if (control_->in_motion() || (is_kept_ && !is_marked_)) return {};
  is_kept_ = true;
  is_marked_ = false;
  MachineState state = control_->state();
  if (is_assumed_ && state.position) state.position->in_motion = false;
  const auto kept = memory_.keep(state);
  return kept ? Status() : tl::make_unexpected(kept.error());
}

Status AttendedMachine::advance(double now) {
  const bool leads = moves_machine(machine_.control.backend);
  next_ = std::max(next_.value_or(now), now - kMostLate);
  for (;; *next_ += machine_.control.period) {
    const double lead = control_->awaits_input() ? kShortLead : kLead;
    if (leads) backend_->follow(lead);
    if (*next_ > now + (leads ? lead : 0)) break;
    if (Status marked = mark_motion(); !marked) return marked;
    const bool is_of_program = control_->step() && control_->last().line > 0;
    program_rows_ = control_->in_program() ? program_rows_ + (is_of_program ? 1 : 0) : 0;
  }
  if (!rows_->ok() && !std::exchange(lost_rows_, true))
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6012, .message = "the trace cannot be written any more"});
  return keep_state();
}

Status AttendedMachine::finish() {
  note_change();
  Status ended = keep_state();
  if (Status rows = rows_->finish(); ended && !rows) ended = std::move(rows);
  if (Status backend = backend_->finish(); ended && !backend) ended = std::move(backend);
  return ended;
}

}  // namespace softcnc::app
