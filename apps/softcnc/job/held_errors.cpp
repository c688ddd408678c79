// SPDX-License-Identifier: MIT
#include "job/held_errors.hpp"

#include <algorithm>
#include <utility>

#include "job/endless.hpp"

namespace softcnc::app {
namespace {

constexpr std::size_t kMostHeld = 100;
constexpr std::size_t kLongestText = 100'000;    // bytes
constexpr int kMostExecuted = 20'000;            // lines of one trial
constexpr auto kEnough = std::int64_t{1} << 40;  // bytes: more than are ever read

/// Empty if it is too long.
std::string text_of(Program& program) {
  std::string text;
  program.for_each_piece([&](std::string_view piece) {
    if (text.size() <= kLongestText) text += piece;
  });
  return text.size() <= kLongestText ? text : std::string();
}

bool is_error(const Diagnostic& diagnostic) { return diagnostic.severity() == Severity::error; }

}  // namespace

HeldErrors::HeldErrors(Program& program, const Machine& machine, const ChannelOptions& options,
                       Messages& messages, Watcher* watcher)
    : program_(program),
      machine_(machine),
      options_(options),
      watcher_(watcher),
      show_(messages.sink(program)),
      repeated_(&program),
      holding_(!program.streamed()) {}

Diagnostics::Sink HeldErrors::sink() {
  return [this](const Diagnostic& diagnostic) { take(diagnostic); };
}

void HeldErrors::show(const Diagnostic& diagnostic) {
  status_ = worse_status(status_, exit_status(diagnostic));
  show_(diagnostic);
}

void HeldErrors::take(const Diagnostic& reported) {
  Diagnostic diagnostic = reported;
  if (repeated_.takes(diagnostic)) return;
  const bool waits = holding_ && (!held_.empty() || is_error(diagnostic));
  if (!waits) return show(diagnostic);
  held_.push_back(diagnostic);
  if (held_.size() > kMostHeld) show_all();
}

/// From here on they are shown as they come.
void HeldErrors::show_all() {
  for (const Diagnostic& diagnostic : held_) show(diagnostic);
  held_.clear();
  holding_ = false;
}

void HeldErrors::finish() {
  if (std::count_if(held_.begin(), held_.end(), is_error) >= 2) leave_out();
  show_all();
  for (const Diagnostic& note : repeated_.notes()) show(note);
}

/// What follows from a loop without an end first: nothing that is told may follow from that.
void HeldErrors::leave_out() {
  const std::string text = text_of(program_);
  if (text.empty()) return;
  leave_out(follow_from_endless_loop(
      held_, [&](int block_limit) { return read_rounds(text, block_limit); }));
  leave_out(ipr::follow_from_others(text, held_,
                                    [&](const std::string& changed) { return judge(changed); }));
}

void HeldErrors::leave_out(const std::vector<bool>& follows) {
  std::vector<Diagnostic> rest;
  for (std::size_t i = 0; i < held_.size(); ++i)
    follows[i] ? repeated_.forget(held_[i]) : rest.push_back(std::move(held_[i]));
  held_ = std::move(rest);
}

Rounds HeldErrors::read_rounds(const std::string& text, int block_limit) const {
  Rounds rounds;
  ipr::InterpreterOptions reading = options_.interpreter;
  reading.lines_run = &rounds.run;
  read(text, block_limit, reading, [&](const Diagnostic& told) {
    if (told.pos.file != 0 || !leads_too_far(told)) return;
    rounds.first_told.try_emplace({told.pos.line, told.code}, rounds.run[told.pos.line]);
  });
  return rounds;
}

ipr::Verdict HeldErrors::judge(const std::string& text) const {
  ipr::Verdict verdict;
  if (watcher_ != nullptr && watcher_->wants_stop()) {
    verdict.work = kEnough;
    return verdict;
  }
  ipr::InterpreterOptions reading = options_.interpreter;
  reading.lines_run = &verdict.lines_run;
  reading.lines_in_doubt = &verdict.lines_in_doubt;
  RepeatedErrors repeated;
  verdict.work = read(text, kMostExecuted, reading, [&](Diagnostic reported) {
    if (!repeated.takes(reported) && is_error(reported))
      verdict.errors.push_back(std::move(reported));
  });
  return verdict;
}

/// Returns how many bytes of lines were read.
std::int64_t HeldErrors::read(const std::string& text, int block_limit,
                              ipr::InterpreterOptions reading, Diagnostics::Sink told) const {
  Machine machine = machine_;
  machine.program.block_limit = std::min(machine.program.block_limit, block_limit);
  ChannelOptions options = options_;
  options.interpreter = std::move(reading);
  options.interpreter.compare_dialects = false;
  Diagnostics diagnostics(std::move(told));
  ipr::Reader reader = ipr::Reader::from_text(text);
  return read_unplanned(reader, machine, options, diagnostics, watcher_).bytes_read;
}

}  // namespace softcnc::app
