// SPDX-License-Identifier: MIT
// A program performed on its machine: what `run` and `record` have in common.
#pragma once

#include <string>
#include <vector>

#include "commands/options.hpp"
#include "hal/files/temporary_file.hpp"
#include "job/program.hpp"
#include "realtime/realtime_cycle.hpp"
#include "session/channel.hpp"

namespace softcnc::app {

/// A program and what it runs on.
struct Job {
  Program program;
  Machine machine;
  std::string machine_file;  // beside the program; empty: its machine is another one
  ChannelOptions options;
};
Result<Job> open_job(const Options& options);

enum class Ending : std::uint8_t { done, stopped, alarm, error };
std::string_view name(Ending ending) noexcept;

/// A file that a run has left, under its final name.
struct WrittenFile {
  std::string what;  // "trace", "edges", ...
  std::string file;
};

/// All that is known after a run: summary and report are made of it.
struct Performance {
  Ending ending = Ending::error;
  int status = 0;      // exit status
  bool moved = false;  // false: refused before anything moved; the rest means nothing
  Outcome outcome;
  std::array<double, kAxes> following_error{};  // mm, largest; NaN: not measured
  AxisVector settled = AxisVector::Zero();      // mm, where a following error is measured
  std::optional<hal::Backend::Tally> tally;     // of rows sent elsewhere
  std::optional<Punctuality> punctuality;       // of a run by the clock
  std::vector<Diagnostic> diagnostics;
  std::vector<WrittenFile> written;
};

/// What the backend itself does not tell by finish().
bool is_of_axis(Alarm alarm) noexcept;
/// Such an alarm in words: SC5001, SC5002, SC5020.
Diagnostic alarm_diagnostic(const Outcome& outcome);

/// SC5040; SC5041 where the rights were missing. Expects that periods have been missed.
Diagnostic missed_periods(const Punctuality& punctuality, const std::string& program);

/// Where the rows of a run go.
struct TracePlace {
  std::string file;                      // empty: nowhere, unless
  hal::TemporaryFile* packed = nullptr;  // they are for a recording
};

/// Pre-flight (except for a dry run), then motion; the rows go to `trace`. Diagnostics are shown.
Performance perform(Job& job, const Options& options, const TracePlace& trace);

/// The report where one is asked for, and the summary, which names what has been written. Returns
/// the exit status of it all.
int conclude(Job& job, const Options& options, Performance& performance);

}  // namespace softcnc::app
