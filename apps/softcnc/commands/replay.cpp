// SPDX-License-Identifier: MIT
// `softcnc replay`: run recordings again; the first row that differs is shown.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "commands/commands.hpp"
#include "hal/files/output_file.hpp"
#include "hal/machine/machine_file.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "replay/recording_list.hpp"
#include "replay/replay_report.hpp"
#include "replay/replay_run.hpp"
#include "settings/file_clash.hpp"

namespace softcnc::app {
namespace {

class ReplayJob {
 public:
  explicit ReplayJob(const Options& options) : options_(options) {}

  int run();

 private:
  void replay(const ListedRecording& recording, std::size_t of);
  void show(const ReplayResult& result, bool found);
  int write_junit() const;
  int finish();

  const Options& options_;
  StandardOutput out_;
  std::vector<ReplayResult> results_;
  int status_ = 0;
};

int ReplayJob::run() {
  const auto listed = list_recordings(options_.files);
  if (!listed) return failed(listed.error());
  for (const ListedRecording& recording : *listed)
    if (same_file(recording.file, options_.junit))
      return failed({.code = Code::SC7072,
                     .message = "--junit names a recording that is replayed",
                     .file = recording.file});
  const auto part = shard_of(*listed, options_.shard, options_.shards);
  for (const ListedRecording& recording : part) {
    replay(recording, part.size());
    if (status_ >= kSignalled) return worse_status(status_, out_.finish());
  }
  const bool several = results_.size() != 1 || (*listed)[0].found || listed->size() > 1;
  if (several) spdlog::info("{}", replay_summary(results_));
  return finish();
}

void ReplayJob::replay(const ListedRecording& recording, std::size_t of) {
  const std::string label =
      of > 1 ? fmt::format("[{}/{}] {}", results_.size() + 1, of, recording.file) : recording.file;
  results_.push_back(replay_recording(recording.file, label, options_));
  show(results_.back(), recording.found);
  status_ = worse_status(status_, results_.back().status);
}

void ReplayJob::show(const ReplayResult& result, bool found) {
  const bool as_text = options_.table == TableFormat::text;
  if (as_text && !result.table.empty())
    out_.write(fmt::format("{}: {}", result.name, result.table));
  if (result.end == ReplayEnd::blessed)
    spdlog::info("{}: made again: {}", result.name, result.message);
  if (result.end != ReplayEnd::agrees) return;
  if (found)
    spdlog::debug("{}: {} rows agree", result.name, result.rows);
  else
    spdlog::info("{}: {} rows agree", result.name, result.rows);
}

int ReplayJob::write_junit() const {
  if (options_.junit.empty()) return 0;
  clear_leftovers(options_.junit);
  const Status written = hal::write_file(
      options_.junit, junit_xml("softcnc replay", "softcnc replay", replay_cases(results_)));
  if (!written) return failed(written.error());
  spdlog::info("JUnit report written to {}", options_.junit);
  return 0;
}

int ReplayJob::finish() {
  if (options_.table == TableFormat::json) out_.write(replay_json(results_));
  return worse_status(worse_status(status_, out_.finish()), write_junit());
}

}  // namespace

int replay(const Options& options) {
  if (options.names_machine)
    if (const auto given = hal::load_machine(options.machine_file, options.settings); !given)
      return failed(given.error());
  return ReplayJob(options).run();
}

}  // namespace softcnc::app
