// SPDX-License-Identifier: MIT
#include "output/finish_job.hpp"

#include <spdlog/spdlog.h>

#include "messages/messages.hpp"
#include "output/report_json.hpp"
#include "output/summary.hpp"
#include "output/time_text.hpp"

namespace softcnc::app {
namespace {

/// After a stop, no reader is waited for.
void write_report(Job& job, const Options& options, JobResult& result) {
  std::stop_source stop;
  if (result.ending == Ending::stopped) stop.request_stop();
  const hal::Patience patience{
      result.ending == Ending::stopped ? stop.get_token() : std::stop_token(), -1};
  const auto written = hal::write_file(options.report, report_json(job, result), patience);
  if (written)
    result.written.push_back({"report", options.report});
  else
    result.status = worse_status(result.status, failed(written.error()));
}

/// The summary; with -v its details and the time sheet, too, and the worst lines where they are
/// asked for.
void print_summary(const Job& job, const Options& options, const JobResult& result) {
  spdlog::info("{}", summary(job, result));
  spdlog::debug("{}", details(job, result));
  spdlog::debug("{}", time_sheet_text(result.outcome.time_sheet));
  if (options.worst > 0) spdlog::info("{}", losses_text(result.outcome));
}

}  // namespace

int finish_job(Job& job, const Options& options, JobResult& result) {
  if (!options.report.empty()) write_report(job, options, result);
  if (result.moved && result.ending != Ending::error) print_summary(job, options, result);
  const std::size_t left = result.outcome.events_left;
  for (std::size_t i = job.options.events.size() - left;
       result.moved && result.ending == Ending::done && i < job.options.events.size(); ++i)
    spdlog::warn("--at {} was not reached: the program ended first",
                 runtime::event_text(job.options.events[i]));
  if (!result.moved && result.ending == Ending::stopped)
    spdlog::info("stopped before anything moved");
  return result.status;
}

}  // namespace softcnc::app
