// SPDX-License-Identifier: MIT
// `softcnc compare`: interpolation methods side by side, on programs and machines.
#include <spdlog/spdlog.h>

#include <deque>

#include "commands/commands.hpp"
#include "job/preflight.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "output/comparison_rows.hpp"
#include "runtime/comparison/method_comparison.hpp"
#include "settings/machine_choice.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

/// A program on a machine.
struct Pairing {
  runtime::Program* program;
  const Machine* machine;
  std::string machine_file;
  runtime::ChannelOptions options;
  double time = 0;  // s: of the program, by arc length
};

std::vector<Method> asked_methods(const Options& options) {
  if (!options.methods.empty()) return options.methods;
  const auto all = runtime::all_methods();
  return {all.begin(), all.end()};
}

/// Whether an error lies neither in the program nor in the method.
bool has_failed(const Diagnostic& error) {
  constexpr int kInputOrOutput = 5, kDefect = 70;
  return exit_status(error) == kInputOrOutput || exit_status(error) == kDefect;
}

class CompareJob {
 public:
  explicit CompareJob(const Options& options)
      : options_(options),
        methods_(asked_methods(options)),
        terminal_(options.progress, false, Machine().control.period),
        messages_([this] { terminal_.end(); }),
        machines_(options, messages_) {}

  int run();

 private:
  int open();
  int open_pairings(runtime::Program& program, const std::string& part, const MachineState& state);
  int check();
  int check(Pairing& pairing);
  int measure();
  int measure(const Pairing& pairing, Method method);
  int stopped() { return kSignalled + terminal_.signal(); }
  std::string text() const;

  const Options& options_;
  const std::vector<Method> methods_;
  Terminal terminal_;
  Messages messages_;
  MachineCache machines_;
  std::deque<runtime::Program> programs_;
  std::vector<Pairing> pairings_;
  std::vector<ComparisonRow> rows_;
  double done_ = 0;  // s of machine time
};

/// Everything is read, and wrong files are reported, before anything is checked.
int CompareJob::open() {
  auto state = open_state(options_, messages_);
  if (!state) return messages_.fail(state.error());
  int status = 0;
  for (const std::string& part : options_.files) {
    auto program = runtime::Program::open(part);
    if (!program)
      status = worse_status(status, messages_.fail(program.error()));
    else
      status = worse_status(
          status, open_pairings(programs_.emplace_back(std::move(*program)), part, *state));
  }
  return worse_status(status, machines_.status());
}

int CompareJob::open_pairings(runtime::Program& program, const std::string& part,
                              const MachineState& state) {
  std::vector<hal::MachineSource> sources;
  for (const std::string& file : options_.machine_files) sources.push_back({file, false});
  if (sources.empty()) sources.push_back(machine_source(part, options_));
  for (const hal::MachineSource& source : sources) {
    const Machine* machine = machines_.of(source);
    if (machine == nullptr) continue;
    runtime::ChannelOptions channel = channel_options(options_, program.folder());
    channel.state = state;
    channel.interpreter.called = &program.called();
    channel.interpreter.stop = terminal_.stop();
    pairings_.push_back({&program, machine, source.file, std::move(channel)});
  }
  return 0;
}

/// A program that is wrong on one machine is not tried on the others.
int CompareJob::check() {
  int status = 0;
  const runtime::Program* wrong = nullptr;
  terminal_.begin("checking", 0);
  for (Pairing& pairing : pairings_) {
    if (pairing.program == wrong) continue;
    const int own = check(pairing);
    if (terminal_.signal() != 0) return stopped();
    if (own != 0) wrong = pairing.program;
    status = worse_status(status, own);
  }
  terminal_.end();
  return status;
}

/// By arc length, which runs every program that can be run at all.
int CompareJob::check(Pairing& pairing) {
  Machine machine = *pairing.machine;
  machine.control.interpolation = Method::arc_length;
  const Preflight checked =
      preflight(*pairing.program, machine, pairing.options, messages_, &terminal_);
  pairing.time = checked.outcome.time;
  return checked.status;
}

int CompareJob::measure() {
  double total = 0;
  for (const Pairing& pairing : pairings_)
    total += pairing.time * options_.phases * static_cast<double>(methods_.size());
  terminal_.begin("comparing", total);
  for (const Pairing& pairing : pairings_)
    for (const Method method : methods_)
      if (const int status = measure(pairing, method); status != 0) return status;
  terminal_.end();
  return 0;
}

int CompareJob::measure(const Pairing& pairing, Method method) {
  runtime::MethodComparison comparison(*pairing.program, *pairing.machine, pairing.options, method,
                                       options_.phases);
  for (int i = 0; i < options_.phases; ++i) {
    terminal_.begin_run(done_, pairing.machine->control.period);
    comparison.run_next(&terminal_);
    if (terminal_.signal() != 0) return stopped();
    if (comparison.error() && has_failed(*comparison.error()))
      return messages_.fail(*comparison.error());
    done_ += pairing.time;
  }
  rows_.push_back({pairing.program->name(), pairing.machine->name, pairing.machine_file, method,
                   options_.phases, comparison.spreads(), comparison.note()});
  return 0;
}

std::string CompareJob::text() const {
  switch (options_.table) {
    case TableFormat::text:
      return comparison_text(rows_);
    case TableFormat::csv:
      return comparison_csv(rows_);
    case TableFormat::json:
      return comparison_json(rows_);
  }
  return {};
}

int CompareJob::run() {
  const bool to_file = !options_.output.empty() && options_.output != "-";
  if (to_file) clear_leftovers(options_.output);
  if (const int status = open(); status != 0) return status;
  auto file = hal::OutputFile::open(to_file ? options_.output : "-");  // before the long work
  if (!file) return messages_.fail(file.error());
  if (const int status = check(); status != 0) return status;
  if (const int status = measure(); status != 0) return status;
  Status written = (*file)->write(text());
  if (written) written = (*file)->finish();
  if (!written) return messages_.fail(written.error());
  if (to_file) spdlog::info("comparison written to {}", options_.output);
  return 0;
}

}  // namespace

int compare(const Options& options) { return CompareJob(options).run(); }

}  // namespace softcnc::app
