// SPDX-License-Identifier: MIT
// `softcnc report`: a run as one page to look at, and to share, or as a picture.
#include <spdlog/spdlog.h>

#include <vector>

#include "commands/commands.hpp"
#include "hal/files/suffix.hpp"
#include "input/run_input.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "pictures/picture.hpp"
#include "report/picture_runs.hpp"
#include "report/report_page.hpp"
#include "report/what_if.hpp"

namespace softcnc::app {
namespace {

class ReportJob {
 public:
  explicit ReportJob(const Options& options)
      : options_(options),
        terminal_(options.progress, false, Machine().control.period),
        messages_([this] { terminal_.end(); }) {}

  int run();

 private:
  int read();
  int read(const std::string& file, const Options& options);
  Options compared_options() const;
  int plan_again();
  Result<std::string> bytes() const;
  int write(hal::OutputFile& output);
  int stopped() { return kSignalled + terminal_.signal(); }

  const Options& options_;
  Terminal terminal_;
  Messages messages_;
  std::vector<ReportedRun> runs_;
  std::optional<WhatIf> what_if_;
  int status_ = 0;  // of the programs
};

int ReportJob::read(const std::string& file, const Options& options) {
  auto run = read_run(file, options, terminal_, messages_);
  terminal_.end();
  if (!run) return messages_.fail(run.error());
  if (terminal_.signal() != 0) return stopped();
  status_ = worse_status(status_, run->status);
  runs_.push_back(std::move(*run));
  return 0;
}

/// Of the second run: another file, another machine, or other settings.
Options ReportJob::compared_options() const {
  Options options = options_;
  if (names_machine(options_.compared)) {
    options.machine_file = options_.compared == "builtin" ? "" : options_.compared;
    options.names_machine = true;
  }
  options.settings.insert(options.settings.end(), options_.compared_settings.begin(),
                          options_.compared_settings.end());
  return options;
}

int ReportJob::read() {
  const std::string& file = options_.files.front();
  if (const int status = read(file, options_); status != 0) return status;
  if (options_.compared.empty() && options_.compared_settings.empty()) return 0;
  const bool other_file = !options_.compared.empty() && !names_machine(options_.compared);
  return read(other_file ? options_.compared : file, compared_options());
}

/// Of a program without errors.
int ReportJob::plan_again() {
  const bool planned = runs_.front().ending == Ending::done;
  if (!options_.what_if || !planned) return 0;
  auto job = open_job(options_);
  if (!job) return messages_.fail(job.error());
  terminal_.begin("planning again", 0);
  what_if_ = what_if(*job, terminal_);
  terminal_.end();
  if (terminal_.signal() != 0) return stopped();
  if (what_if_) spdlog::info("{}", what_if_text(*what_if_));
  return 0;
}

/// The bytes of the page, or of the picture where the name of the file ends as one.
Result<std::string> ReportJob::bytes() const {
  if (const auto format = picture_format(options_.output))
    return draw_picture(picture_runs(runs_), options_.picture, *format);
  return report_page(runs_, what_if_);
}

int ReportJob::write(hal::OutputFile& output) {
  auto whole = bytes();
  if (!whole) {
    whole.error().file = options_.output;
    return messages_.fail(whole.error());
  }
  Status written = output.write(*whole);
  if (written) written = output.finish();
  if (!written) return messages_.fail(written.error());
  spdlog::info("report written to {}", options_.output);
  return 0;
}

/// What the suffix of the output stands for, or an error for one that stands for nothing. What is
/// no regular file needs none.
Status known_form(const std::string& file) {
  const bool is_page = hal::has_suffix(file, ".html") || hal::has_suffix(file, ".htm");
  if (picture_format(file) || is_page || !hal::is_replaced(file)) return {};
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC6060,
      .message = "no form of a report has this suffix; known are .html, .htm, .svg, .png",
      .file = file});
}

int ReportJob::run() {
  if (Status known = known_form(options_.output); !known) return messages_.fail(known.error());
  clear_leftovers(options_.output);
  auto output = hal::OutputFile::open(options_.output);  // before the long work
  if (!output) return messages_.fail(output.error());
  if (const int status = read(); status != 0) return status;
  if (const int status = plan_again(); status != 0) return status;
  return worse_status(status_, write(**output));
}

}  // namespace

int report(const Options& options) { return ReportJob(options).run(); }

}  // namespace softcnc::app
