// SPDX-License-Identifier: MIT
#include "output/finish_job.hpp"

#include <spdlog/spdlog.h>

#include "messages/messages.hpp"
#include "output/report_json.hpp"
#include "output/summary.hpp"
#include "output/time_text.hpp"

namespace softcnc::app {
namespace {

/// Once stopped, nobody waits for who reads it.
void write_report(Job& job, const Options& options, Performance& performance) {
  std::stop_source stop;
  if (performance.ending == Ending::stopped) stop.request_stop();
  const hal::Patience patience{
      performance.ending == Ending::stopped ? stop.get_token() : std::stop_token(), -1};
  const auto written = hal::write_file(options.report, report_json(job, performance), patience);
  if (written)
    performance.written.push_back({"report", options.report});
  else
    performance.status = worse_status(performance.status, failed(written.error()));
}

/// The summary; with -v its time sheet, too, and the worst lines where they are asked for.
void say(const Outcome& outcome, const Options& options, const std::string& summary) {
  spdlog::info("{}", summary);
  spdlog::debug("{}", time_sheet_text(outcome.time_sheet));
  if (options.worst > 0) spdlog::info("{}", worst_lines_text(outcome.worst_lines));
}

}  // namespace

int conclude(Job& job, const Options& options, Performance& performance) {
  if (!options.report.empty()) write_report(job, options, performance);
  if (performance.moved && performance.ending != Ending::error)
    say(performance.outcome, options, summary(job, performance));
  const std::size_t left = performance.outcome.events_left;
  for (std::size_t i = job.options.events.size() - left;
       performance.moved && performance.ending == Ending::done && i < job.options.events.size();
       ++i)
    spdlog::warn("--at {} was not reached: the program had ended",
                 event_text(job.options.events[i]));
  if (!performance.moved && performance.ending == Ending::stopped)
    spdlog::info("stopped before anything moved");
  return performance.status;
}

}  // namespace softcnc::app
