// SPDX-License-Identifier: MIT
// The command line by CLI11: a function per group of options, and which command takes which group.
#include "commands/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>

#include "commands/commands.hpp"
#include "hal/trace/trace.hpp"
#include "messages/standard_output.hpp"
#include "motion/core/spelling.hpp"
#include "motion/core/units.hpp"
#include "motion/model/machine.hpp"
#include "process/standard_error.hpp"
#include "settings/file_clash.hpp"

namespace softcnc::app {
namespace {

constexpr int kWrongUsage = 2;
constexpr int kMostLines = 1'000'000;                // of --worst
constexpr double kLargestOverride = 200;             // percent
constexpr double kShortest = 0.001, kLongest = 1e6;  // s: of a measurement
constexpr const char* kReadsState = "Begin with these work offsets, tool table and parameters";

/// The names that an option knows; of another one the nearest of them is named.
CLI::Validator one_of(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](const std::string& word) {
        if (std::find(names.begin(), names.end(), word) != names.end()) return std::string();
        const std::vector<std::string_view> known(names.begin(), names.end());
        return fmt::format("'{}' is none of {}{}", word, fmt::join(names, ", "),
                           did_you_mean(nearest_name(word, known)));
      },
      "");
}

void add_machine(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--machine",
          [&options](const std::string& file) {
            if (file.empty()) throw CLI::ValidationError("--machine", "names no file");
            options.names_machine = true;
            options.machine_file = file == "builtin" ? std::string() : file;
          },
          "Machine file; 'builtin' is the built-in mill (default: PART.toml beside PART, else the "
          "built-in mill)")
      ->type_name("FILE.toml");
  command
      .add_option("--set", options.settings,
                  "Set one value of the machine, as in axis.x.acceleration_mm_s2=500 (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_backend(CLI::App& command, Options& options, const char* says = "Where setpoints go") {
  const std::vector<std::string> names(kBackendNames.begin(), kBackendNames.end());
  command
      .add_option_function<std::string>(
          "--backend",
          [&options](const std::string& name) {
            options.settings.push_back("control.backend=" + name);
          },
          says)
      ->check(one_of(names))
      ->type_name(CLI::detail::join(names, "|"));
}

void add_state(CLI::App& command, Options& options, const char* says) {
  command.add_option("--state", options.state, says)->type_name("FILE.toml");
}

void add_interpreter(CLI::App& command, Options& options) {
  command.add_flag("--block-skip", options.block_skip, "Leave out lines that begin with '/'");
  command.add_flag("--optional-stop", options.optional_stop, "Stop at M01");
  command
      .add_option_function<std::string>(
          "--dialect",
          [&options](const std::string& word) {
            options.dialect =
                word == name(ipr::Dialect::fanuc) ? ipr::Dialect::fanuc : ipr::Dialect::linuxcnc;
          },
          "Whose reading counts where controllers contradict each other (default linuxcnc)")
      ->check(one_of({"fanuc", "linuxcnc"}))
      ->type_name("fanuc|linuxcnc");
  command
      .add_option_function<std::string>(
          "--format",
          [&options](const std::string& word) {
            options.format = word == name(ipr::Format::gcode)      ? ipr::Format::gcode
                             : word == name(ipr::Format::commands) ? ipr::Format::commands
                                                                   : ipr::Format::automatic;
          },
          "G-code, the commands of paper 003 (l, pcw, s ...), or whichever the first line is "
          "(auto)")
      ->check(one_of({"auto", "gcode", "commands"}))
      ->type_name("auto|gcode|commands");
}

void add_feed_override(CLI::App& command, Options& options) {
  command
      .add_option_function<double>(
          "--feed-override",
          [&options](double percent) {
            if (!(percent > 0 && percent <= kLargestOverride))
              throw CLI::ValidationError("--feed-override",
                                         "takes a percentage above 0, at most 200");
            options.feed_override = percent / 100;
          },
          "Multiply the programmed feed (default 100)")
      ->type_name("PERCENT");
}

void add_events(CLI::App& command, Options& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "--at",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto event = parse_event(text);
              if (!event)
                throw CLI::ValidationError(
                    "--at",
                    "takes SECONDS:override=PERCENT (0 to 200), SECONDS:hold or "
                    "SECONDS:resume, not '" +
                        text + "'");
              options.events.push_back(*event);
            }
            sort_events(options.events);
          },
          "Change the feed override, hold or resume while it runs, as in 1.5:override=50, 2:hold "
          "(repeatable)")
      ->type_name("SECONDS:WHAT")
      ->allow_extra_args(false);
}

/// Whether the last event leaves the machine at rest.
bool held_for_ever(const Options& options) {
  ipo::FeedControl control;
  for (const FeedEvent& event : options.events) control = after(event, control);
  return control.halts();
}

void add_worst(CLI::App& command, Options& options) {
  command
      .add_option("--worst", options.worst,
                  "Name the N lines that lose most time against their feed, with the limit")
      ->check(CLI::Range(1, kMostLines).description(""))
      ->type_name("N");
}

void add_progress(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--progress",
          [&options](const std::string& word) {
            options.progress = word == "none"   ? ProgressMode::none
                               : word == "json" ? ProgressMode::json
                                                : ProgressMode::automatic;
          },
          "Progress on stderr: a bar where it is a terminal (auto), nothing, or JSON lines")
      ->check(one_of({"auto", "none", "json"}))
      ->type_name("auto|none|json");
}

void add_diagnostics(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--diagnostics",
          [&options](const std::string& word) {
            options.diagnostics = word == "json"    ? DiagnosticsFormat::json
                                  : word == "sarif" ? DiagnosticsFormat::sarif
                                                    : DiagnosticsFormat::text;
          },
          "How what is wrong is told: as text, or as one document for programs to read")
      ->check(one_of({"text", "json", "sarif"}))
      ->type_name("text|json|sarif");
}

void add_quiet(CLI::App& command, Options& options) {
  command.add_flag("-q,--quiet", options.quiet, "Say nothing but diagnostics");
}

void add_verbose(CLI::App& command, Options& options, const char* says) {
  command.add_flag("-v,--verbose", options.verbose, says)->excludes(command.get_option("--quiet"));
}

void add_part(CLI::App& command, Options& options) {
  command.add_option("PART", options.files, "Part program; - is standard input")
      ->required()
      ->type_name("")
      ->expected(1);
}

/// What `run` and `record` share.
void add_run(CLI::App& command, Options& options, const char* state) {
  add_part(command, options);
  add_machine(command, options);
  add_state(command, options, state);
  add_backend(command, options);
  add_feed_override(command, options);
  add_events(command, options);
  add_interpreter(command, options);
  command.add_flag("--single-block", options.single_block,
                   "End every block at rest, and wait for Enter before the next");
  command.add_flag("--realtime", options.realtime,
                   "Keep pace with the clock, and tell which periods were missed");
  command.add_option("--report", options.report, "Write the figures of the run as JSON")
      ->type_name("FILE.json");
  add_diagnostics(command, options);
  add_progress(command, options);
  add_quiet(command, options);
  add_verbose(command, options, "Say what pre-flight, planning and verification took");
}

void make_run(CLI::App& command, Options& options) {
  add_run(command, options, "Work offsets, tool table and parameters, read before and kept after");
  add_worst(command, options);
  command.add_flag("--dry-run", options.dry_run,
                   "No backend and no pre-flight; the trace goes to stdout as CSV");
  command
      .add_option("--trace", options.trace,
                  "Write one row per period (" + hal::trace_suffixes() + ")")
      ->type_name("FILE");
}

void make_check(CLI::App& command, Options& options) {
  command.add_option("PART", options.files, "Part programs; - is standard input")
      ->required()
      ->type_name("");
  add_worst(command, options);
  command.add_flag("--watch", options.watch, "Check again whenever a file changes, until Ctrl-C");
  add_machine(command, options);
  add_state(command, options, kReadsState);
  add_feed_override(command, options);
  add_interpreter(command, options);
  add_diagnostics(command, options);
  add_quiet(command, options);
  add_verbose(command, options, "Say time and length of each program on stderr");
}

void make_blocks(CLI::App& command, Options& options) {
  add_part(command, options);
  add_machine(command, options);
  add_state(command, options, kReadsState);
  add_interpreter(command, options);
  add_diagnostics(command, options);
  add_quiet(command, options);
}

void make_record(CLI::App& command, Options& options) {
  add_run(command, options, kReadsState);
  command.add_option("-o,--output", options.output, "The recording to write")
      ->required()
      ->type_name("FILE.rec");
}

void make_replay(CLI::App& command, Options& options) {
  command.add_option("FILE.rec", options.files, "Recordings")->required()->type_name("");
  add_machine(command, options);
  add_progress(command, options);
  add_diagnostics(command, options);
  add_quiet(command, options);
}

void make_surface(CLI::App& command, Options& options) {
  add_part(command, options);
  add_machine(command, options);
  add_state(command, options, kReadsState);
  add_feed_override(command, options);
  add_interpreter(command, options);
  command
      .add_option("-o,--output", options.output,
                  "The surface to write: numpy arrays (.npz) or a picture (.png)")
      ->required()
      ->type_name("FILE");
  command.add_flag("--actual", options.actual,
                   "Cut with the tool where the simulated mill is, not where it is told to be");
  command.add_option("--report", options.report, "Write the figures of the surface as JSON")
      ->type_name("FILE.json");
  add_diagnostics(command, options);
  add_progress(command, options);
  add_quiet(command, options);
  add_verbose(command, options, "Say what planning and cutting took");
}

void make_machine(CLI::App& command, Options& options) {
  add_machine(command, options);
  add_backend(command, options);
  add_diagnostics(command, options);
  add_quiet(command, options);
  add_verbose(command, options, "Say what each value means");
}

/// CLI::Range would let "nan" pass.
CLI::Validator between(double least, double most) {
  const CLI::Range range(least, most);
  return CLI::Validator(
      [range](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && std::isnan(value))
          return text + " is no number";
        return range(text);
      },
      "");
}

void make_latency(CLI::App& command, Options& options) {
  add_machine(command, options);
  command.add_option("--seconds", options.seconds, "How long to measure (default 10)")
      ->check(between(kShortest, kLongest))
      ->type_name("SECONDS");
  command
      .add_option_function<double>(
          "--period-us", [&options](double us) { options.period = s_from_ms(us / 1000); },
          "Period of the loop (default: control.servo_period_ms)")
      ->check(between(1, 1e6))
      ->type_name("MICROSECONDS");
  command.add_option("--report", options.report, "Write the figures as JSON")
      ->type_name("FILE.json");
  add_diagnostics(command, options);
  add_quiet(command, options);
}

void make_pulses(CLI::App& command, Options& options) {
  command
      .add_option("FILE", options.files,
                  "List of edges: .vcd or .edges, also with .zst; - is standard input")
      ->required()
      ->type_name("")
      ->expected(1);
  add_machine(command, options);
  add_backend(command, options, "With parport the drivers' times are whole base periods");
  command.add_option("--report", options.report, "Write the figures as JSON")
      ->type_name("FILE.json");
  add_diagnostics(command, options);
  add_quiet(command, options);
}

void make_codes(CLI::App& command, Options& options) {
  command
      .add_option("CODE", options.files,
                  "G02, SC2103, or how a code begins: SC21 (default: all codes of programs)")
      ->type_name("");
  command.footer([] {
    return "The codes of programs, the words they take, what they do:\n" + list_of_codes();
  });
}

struct CommandRow {
  Command command;
  const char* name;
  const char* says;
  void (*make)(CLI::App&, Options&);
};

constexpr CommandRow kCommands[] = {
    {Command::run, "run", "Check a part program, then run it on the machine", make_run},
    {Command::check, "check", "Check part programs without motion", make_check},
    {Command::blocks, "blocks", "Show the blocks of a part program, one JSON object per line",
     make_blocks},
    {Command::record, "record", "Run a part program and keep what replay needs", make_record},
    {Command::replay, "replay", "Run recordings again and compare row by row", make_replay},
    {Command::surface, "surface", "Show the surface that a part program machines, with its Rmax",
     make_surface},
    {Command::machine, "machine", "Show the machine, each value with where it came from",
     make_machine},
    {Command::latency, "latency", "Show how late this computer wakes, and what feed that allows",
     make_latency},
    {Command::pulses, "pulses", "Judge step and direction pulses by what the machine's drivers ask",
     make_pulses},
    {Command::codes, "codes", "Say what codes of programs and of diagnostics mean", make_codes},
};

int refuse(const std::string& reason) {
  write_to_stderr(reason + "\nRun with --help for more information.\n");
  return kWrongUsage;
}

/// Whether a word names a part program rather than a command.
bool looks_like_file(const std::string& word) {
  std::error_code ignored;
  return word == "-" || word.find_first_of("./") != word.npos ||
         std::filesystem::exists(word, ignored);
}

/// The first word that is no option; empty: there is none.
std::string first_of(std::span<const char* const> words) {
  const auto is_word = [](std::string_view word) { return word == "-" || !word.starts_with('-'); };
  const auto first = std::find_if(words.begin(), words.end(), is_word);
  return first == words.end() ? std::string() : *first;
}

/// Of a command line without a command.
int refuse_command(std::span<const char* const> words) {
  const std::string word = first_of(words);
  std::vector<std::string_view> names;
  for (const CommandRow& row : kCommands) names.push_back(row.name);
  const std::string list = "; the commands are " + fmt::format("{}", fmt::join(names, ", "));
  if (word.empty())
    return refuse((words.empty() ? "a command" : std::string(words[0]) + ": a command") +
                  " is missing" + list);
  if (looks_like_file(word))
    return refuse(fmt::format("'{0}' is no command; 'softcnc run {0}' runs it{1}", word, list));
  return refuse("'" + word + "' is no command" + did_you_mean(nearest_name(word, names)) + list);
}

/// The name among the long options of a command that is most like `name`, as a question.
std::string option_like(const CLI::App& command, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& word : option->get_lnames()) known.push_back("--" + word);
  if (!name.starts_with("--")) return {};
  return did_you_mean(
      nearest_name(name, std::vector<std::string_view>(known.begin(), known.end())));
}

/// The first word that looks like an option of the command but is none; empty: there is none.
std::string unknown_option(const CLI::App& command, std::span<const char* const> words) {
  bool is_value = false;
  for (std::string word : words) {
    const bool looks = word.size() > 1 && word.starts_with('-') && word != "--";
    if (std::exchange(is_value, false) || !looks) continue;
    const std::string name = word.substr(0, word.starts_with("--") ? word.find('=') : 2);
    const CLI::Option* option = command.get_option_no_throw(name);
    if (!option) return name;
    is_value = name == word && option->get_items_expected_min() > 0;
  }
  return {};
}

/// Help and version are data. An unknown option is named, whatever else its value upsets.
int tell(const CLI::App& app, const CLI::ParseError& error, std::span<const char* const> words) {
  std::ostringstream out;
  if (error.get_exit_code() == 0) {
    app.exit(error, out, out);
    StandardOutput output;
    output.write(out.str());
    return output.finish();
  }
  for (const CLI::App* command : app.get_subcommands())
    if (const auto name = unknown_option(*command, words.subspan(1)); !name.empty())
      return refuse(name + ": no such option of " + command->get_name() +
                    option_like(*command, name));
  if (app.get_subcommands().empty()) return refuse_command(words.subspan(1));
  app.exit(error, out, std::cerr);
  return kWrongUsage;
}

/// What cannot be together; empty: nothing.
std::string contradiction(const Options& options) {
  if (options.command == Command::codes) return {};
  if (held_for_ever(options))
    return "--at: the last of them holds the program for ever; it takes a later SECONDS:resume, or "
           "override above 0";
  if (options.progress == ProgressMode::json && options.diagnostics != DiagnosticsFormat::text)
    return "--progress json and --diagnostics both want standard error";
  const auto& files = options.files;
  if (options.watch && std::find(files.begin(), files.end(), "-") != files.end())
    return "--watch cannot watch standard input";
  return file_clash(options);
}

}  // namespace

std::variant<Options, int> parse_command_line(int argc, const char* const* argv) {
  CLI::App app("softcnc runs part programs (G-code) on a simulated mill.", "softcnc");
  app.set_version_flag("--version", "softcnc " SOFTCNC_VERSION);
  app.set_help_flag("-h,--help", "Show this help");
  app.failure_message(CLI::FailureMessage::simple);
  app.require_subcommand(1);
  app.footer(
      "softcnc COMMAND --help tells the options of a command, softcnc codes the codes a program "
      "may\n"
      "use, softcnc codes G41 all about one of them.");
  Options options;
  for (const CommandRow& row : kCommands)
    row.make(*app.add_subcommand(row.name, row.says), options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return tell(app, error, std::span(argv, static_cast<std::size_t>(argc)));
  }
  for (const CommandRow& row : kCommands)
    if (app.got_subcommand(row.name)) options.command = row.command;
  if (const std::string clash = contradiction(options); !clash.empty()) return refuse(clash);
  const bool silent = options.quiet || options.diagnostics != DiagnosticsFormat::text;
  if (silent && options.progress == ProgressMode::automatic) options.progress = ProgressMode::none;
  return options;
}

}  // namespace softcnc::app
