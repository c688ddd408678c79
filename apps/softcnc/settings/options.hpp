// SPDX-License-Identifier: MIT
// What the command line asks for, as plain data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ipr/commands/format.hpp"
#include "ipr/expressions/definition.hpp"
#include "ipr/expressions/dialect.hpp"
#include "messages/diagnostic_document.hpp"
#include "messages/progress.hpp"
#include "motion/model/machine.hpp"
#include "pictures/picture_options.hpp"
#include "runtime/circle/circle_plane.hpp"
#include "runtime/conversion/curve_form.hpp"
#include "runtime/session/feed_script.hpp"
#include "runtime/sinks/curve_columns.hpp"
#include "settings/tolerance.hpp"

namespace softcnc::app {

enum class CommandName : std::uint8_t {
  run,
  check,
  blocks,
  record,
  replay,
  report,
  diff,
  surface,
  compare,
  identify,
  machine,
  state,
  latency,
  pulses,
  codes,
  circle,
  convert,
  operate,
  serve
};

/// How a table is written.
enum class TableFormat : std::uint8_t { text, csv, json };

/// Of --work: where a work system lies.
struct WorkOrigin {
  int system = 0;                                     // index, of MachineState::work_system()
  std::array<std::optional<double>, kAxes> origin{};  // mm; an axis without one stays
};

struct Options {
  CommandName command = CommandName::run;
  std::vector<std::string> files;  // PART, FILE.rec or a list of edges; "-": standard input

  std::string machine_file;                // of --machine; empty: the built-in machine
  bool names_machine = false;              // --machine is there; else a file beside PART counts
  std::vector<std::string> machine_files;  // compare: instead of machine_file, each as there
  std::vector<std::string> settings;       // KEY=VALUE, on top of it
  std::string state;                       // file; empty: none
  bool assume_position = false;            // run, record, operate: the machine stands where it says
  std::vector<std::string> action;         // state: "show", or "set" and what is set
  std::vector<WorkOrigin> work;            // of --work, on top of it

  bool toml = false;                         // machine: as a machine file
  std::string imported;                      // machine: settings of another control; empty: none
  bool imports_inches = false;               // machine: such a tool table is in inches
  std::vector<std::string> allowed_folders;  // machine: in which imported settings may name files

  std::vector<std::string> subprogram_folders;  // of --subprograms, before those of the machine
  std::vector<ipr::Definition> definitions;     // of --define

  double feed_override = 1;                // of the programmed feed
  std::vector<runtime::FeedEvent> events;  // in the order of time
  bool block_skip = false, optional_stop = false, single_block = false;
  bool rest_at_pauses = false;
  ipr::Dialect dialect = ipr::Dialect::linuxcnc;
  bool guess_dialect = false;
  ipr::Format format = ipr::Format::automatic;

  int worst = 0;  // run, check: so many lines that lose most time are named

  bool dry_run = false, watch = false;
  bool realtime = false;                      // run, record: as fast as the clock goes
  std::string trace, report;                  // files; empty: none
  std::string log;                            // operate, serve: file; empty: none
  std::string link, address;                  // serve: of a pseudo-terminal, of TCP; empty: none
  std::vector<runtime::CurveColumn> columns;  // run: further ones of the trace
  std::string output;                         // of record, surface, compare, identify, convert
  bool actual = false;                        // surface: cut by where the simulated mill is

  std::vector<Method> methods;            // compare: in the order of its rows; empty: all
  int phases = 16;                        // compare: places within the period
  TableFormat table = TableFormat::text;  // compare, diff, replay, circle, identify

  Tolerance tolerance;        // diff
  std::string junit;          // diff, replay: file; empty: none
  bool bless = false;         // replay: recordings that differ are made again
  int shard = 1, shards = 1;  // replay: the part of the recordings that is replayed, from 1

  std::string compared;  // report: another part, trace, recording or machine; empty: none
  std::vector<std::string> compared_settings;  // report: KEY=VALUE of the run that is compared
  bool what_if = false;                        // report
  PictureOptions picture;                      // report: where its output is a picture

  double seconds = 10, period = 0;  // latency: how long, s; of the loop, s; 0: the servo period

  DiagnosticsFormat diagnostics = DiagnosticsFormat::text;
  ProgressMode progress = ProgressMode::automatic;
  bool quiet = false, verbose = false;

  runtime::CurveForm curve_form = runtime::CurveForm::g06_2;  // convert

  runtime::CirclePlane plane = runtime::CirclePlane::xy;  // circle
  std::vector<double> centre;  // circle: mm, in the plane; empty: that of each circle's own points
};

}  // namespace softcnc::app
