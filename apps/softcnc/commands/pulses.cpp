// SPDX-License-Identifier: MIT
// `softcnc pulses`: any list of edges, checked against the timing of a machine's drivers.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "hal/files/axis_name.hpp"
#include "hal/files/compressed_file.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/ports/port_timing.hpp"
#include "hal/signals/edge_reader.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "motion/core/units.hpp"
#include "motion/core/utf8.hpp"

namespace softcnc::app {
namespace {

using hal::PulseRule, hal::PulseRules;
using Json = nlohmann::ordered_json;

/// The columns of times, in the order in which they stand.
constexpr PulseRule kTimingRules[] = {PulseRule::interval, PulseRule::length, PulseRule::space,
                                      PulseRule::setup, PulseRule::hold};
constexpr const char* kTimeKeys[] = {"interval_ns", "length_ns", "space_ns", "setup_ns", "hold_ns"};
static_assert(std::size(kTimingRules) == hal::kTimedRules &&
              std::size(kTimeKeys) == hal::kTimedRules);

class SignalEdgeList {
 public:
  SignalEdgeList(std::string file, const hal::StepTiming& timing)
      : file_(file == "-" ? "<stdin>" : std::move(file)),
        timing_(timing),
        rules_(timing, [this](const hal::BrokenRule& broken) { report(broken); }) {}

  /// Exit status.
  int judge(const std::string& name);
  std::string table() const;
  std::string report_json() const;

 private:
  void visit(const hal::ReadEdge& read);
  void report(const hal::BrokenRule& broken);
  int fail(Diagnostic diagnostic);
  std::string row(int axis) const;
  bool moves(int axis) const {
    const PulseRules::Figures& own = rules_.figures(axis);
    return own.steps > 0 || own.broken > 0;
  }

  std::string file_;
  hal::StepTiming timing_;
  PulseRules rules_;
  Messages messages_;
  const hal::ReadEdge* at_ = nullptr;  // the edge that is being judged
  std::int64_t broken_ = 0;
};

void SignalEdgeList::visit(const hal::ReadEdge& read) {
  if (read.begins) return rules_.begin(read.edge);
  at_ = &read;
  rules_.read(read.edge);
  at_ = nullptr;
}

void SignalEdgeList::report(const hal::BrokenRule& broken) {
  ++broken_;
  Diagnostic diagnostic{.code = Code::SC4090, .message = hal::text(broken), .file = file_};
  if (at_) {
    diagnostic.pos = at_->pos;
    diagnostic.source_line = at_->line;
  }
  messages_.show(diagnostic);
}

int SignalEdgeList::fail(Diagnostic diagnostic) {
  diagnostic.file = file_;
  return messages_.fail(std::move(diagnostic));
}

int SignalEdgeList::judge(const std::string& name) {
  auto file = hal::CompressedFile::open(name, Code::SC6090, Code::SC6091);
  if (!file) return fail(std::move(file.error()));
  hal::EdgeReader reader([this](const hal::ReadEdge& read) { visit(read); });
  for (;;) {
    const auto bytes = file->next();
    if (!bytes) return fail(bytes.error());
    if (bytes->empty()) break;
    if (const Status read = reader.read(*bytes); !read) return fail(read.error());
  }
  if (const Status finished = reader.finish(); !finished) return fail(finished.error());
  rules_.finish();
  return broken_ > 0 ? exit_status({.code = Code::SC4090}) : 0;
}

std::string SignalEdgeList::row(int axis) const {
  const PulseRules::Figures& own = rules_.figures(axis);
  std::string text = fmt::format("  {:<6}{:>12}{:>12}", hal::axis_name(axis), own.steps,
                                 rules_.counts()[static_cast<std::size_t>(axis)]);
  for (const PulseRule rule : kTimingRules) {
    const auto& shortest = own.shortest[static_cast<std::size_t>(rule)];
    text += fmt::format("{:>11}", shortest ? std::to_string(*shortest) : "-");
  }
  return text + fmt::format("{:>9}\n", own.broken);
}

std::string SignalEdgeList::table() const {
  std::string text = fmt::format(
      "{}: {} edges, {} steps in {:.9g} s; {}. Shortest times in ns:\n\n"
      "  {:<6}{:>12}{:>12}{:>11}{:>11}{:>11}{:>11}{:>11}{:>9}\n",
      file_, rules_.edges(), rules_.steps(), s_from_ns(static_cast<double>(rules_.time())),
      broken_ > 0 ? fmt::format("rules are broken {} time{}", broken_, broken_ == 1 ? "" : "s")
                  : "no rule is broken",
      "axis", "steps", "counts", "interval", "length", "space", "set-up", "hold", "broken");
  for (int axis = 0; axis < kAxes; ++axis)
    if (moves(axis)) text += row(axis);
  text += fmt::format("  {:<30}", "required");
  for (const PulseRule rule : kTimingRules)
    text += fmt::format("{:>11}", hal::least(rule, timing_));
  return text + '\n';
}

std::string SignalEdgeList::report_json() const {
  Json report{{"file", as_utf8(file_)},
              {"edges", rules_.edges()},
              {"steps", rules_.steps()},
              {"time_s", s_from_ns(static_cast<double>(rules_.time()))},
              {"broken", broken_}};
  for (std::size_t i = 0; i < std::size(kTimingRules); ++i)
    report["asked"][kTimeKeys[i]] = hal::least(kTimingRules[i], timing_);
  for (int axis = 0; axis < kAxes; ++axis) {
    const PulseRules::Figures& own = rules_.figures(axis);
    Json& figures = report["axes"][hal::axis_name(axis)];
    figures = {{"steps", own.steps},
               {"counts", rules_.counts()[static_cast<std::size_t>(axis)]},
               {"broken", own.broken}};
    for (std::size_t i = 0; i < std::size(kTimingRules); ++i) {
      const auto& shortest = own.shortest[static_cast<std::size_t>(kTimingRules[i])];
      figures[kTimeKeys[i]] = shortest ? Json(*shortest) : Json();
    }
  }
  return report.dump(2) + '\n';
}

hal::StepTiming asked_by(const Machine& machine) {
  return machine.control.backend == BackendKind::parport ? hal::port_timing(machine).rules
                                                         : hal::step_timing(machine.step_port);
}

}  // namespace

int pulses(const Options& options) {
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  if (!machine) return failed(machine.error());
  const std::string& name = options.files.front();
  SignalEdgeList list(name, asked_by(*machine));
  int status = list.judge(name);
  if (status != 0 && status != exit_status({.code = Code::SC4090})) return status;
  StandardOutput out;
  out.write(list.table());
  status = worse_status(status, out.finish());
  if (options.report.empty()) return status;
  clear_leftovers(options.report);
  const auto written = hal::write_file(options.report, list.report_json());
  if (!written) return worse_status(status, failed(written.error()));
  spdlog::info("report written to {}", options.report);
  return status;
}

}  // namespace softcnc::app
