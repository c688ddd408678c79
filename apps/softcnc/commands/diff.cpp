// SPDX-License-Identifier: MIT
// `softcnc diff`: two runs side by side, whatever files they come from.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands/commands.hpp"
#include "difference/compared_run.hpp"
#include "difference/difference_text.hpp"
#include "messages/standard_output.hpp"

namespace softcnc::app {
namespace {

constexpr int kDiffers = 1;                                // exit status
constexpr std::size_t kShownLines = 10, kJsonLines = 200;  // of a program, where none are asked for

std::size_t lines_asked(const Options& options) {
  if (options.worst > 0) return static_cast<std::size_t>(options.worst);
  return options.table == TableFormat::json ? kJsonLines : kShownLines;
}

/// Nothing is shown of runs that agree, except where a tolerance was asked for and they differ
/// within it.
bool is_worth_showing(const runtime::RunDifference& difference, const Options& options) {
  if (options.table == TableFormat::json || !difference.same()) return true;
  if (!options.tolerance.is_named()) return false;
  for (std::size_t i = 0; i < runtime::kAspects; ++i)
    if (difference.aspects[i].largest > runtime::replay_margins()[i].absolute) return true;
  return false;
}

std::string machines_remark(const ComparedPair& pair) {
  const std::size_t differing = machine_differences(pair).size();
  if (differing == 0) return {};
  return fmt::format("; {} value{} of their machines", differing,
                     differing == 1 ? " differs" : "s differ");
}

int write_junit(const Options& options, const ComparedPair& pair) {
  if (options.junit.empty()) return 0;
  clear_leftovers(options.junit);
  const Status written = hal::write_file(
      options.junit,
      junit_xml("softcnc diff", pair.a.name + " and " + pair.b.name, difference_cases(pair)));
  if (!written) return failed(written.error());
  spdlog::info("JUnit report written to {}", options.junit);
  return 0;
}

int show(const ComparedPair& pair, const Options& options) {
  StandardOutput out;
  const std::size_t lines = lines_asked(options);
  if (is_worth_showing(pair.difference, options))
    out.write(options.table == TableFormat::json ? difference_json(pair, lines)
                                                 : difference_text(pair, lines));
  int status = out.finish();
  if (pair.difference.same())
    spdlog::info("{} and {} agree: {} rows{}", pair.a.name, pair.b.name, pair.a.rows.rows().size(),
                 machines_remark(pair));
  else
    status = worse_status(status, kDiffers);
  return worse_status(status, write_junit(options, pair));
}

}  // namespace

int diff(const Options& options) {
  Terminal terminal(options.progress, false, Machine().control.period);
  Messages messages([&terminal] { terminal.end(); });
  std::vector<ComparedRun> runs;
  int status = 0;
  for (const std::string& file : options.files) {
    auto run = read_compared(file, options, messages, terminal);
    status = worse_status(status, run ? run->status : messages.fail(run.error()));
    if (status >= kSignalled) return status;
    if (run) runs.push_back(std::move(*run));
  }
  if (status != 0) return status;
  const auto difference = runtime::compare(runs[0].rows, runs[1].rows, options.tolerance.margins());
  return show({runs[0], runs[1], difference}, options);
}

}  // namespace softcnc::app
