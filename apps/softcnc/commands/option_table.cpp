// SPDX-License-Identifier: MIT
#include "commands/option_table.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "commands/help_page.hpp"
#include "hal/trace/trace.hpp"
#include "motion/core/spelling.hpp"
#include "motion/core/units.hpp"
#include "motion/model/machine.hpp"
#include "runtime/comparison/method_comparison.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

constexpr int kMostLines = 1'000'000;                // of --worst
constexpr int kMostPhases = 1000;                    // of --phases
constexpr double kShortest = 0.001, kLongest = 1e6;  // s, of a measurement

constexpr CommandEntry kCommands[] = {
    {CommandName::run, "run", "Check a part program, then run it on the machine"},
    {CommandName::check, "check", "Check part programs without motion"},
    {CommandName::blocks, "blocks", "Print the blocks of a part program, one JSON object per line"},
    {CommandName::convert, "convert",
     "Write a part program with curves for chords, or the reverse"},
    {CommandName::operate, "operate",
     "Stand at the machine: home, jog, set offsets, run programs, in a full-screen terminal"},
    {CommandName::serve, "serve",
     "Serve the machine to the senders of grbl, on a pseudo-terminal or by TCP"},
    {CommandName::record, "record", "Run a part program and record what replay needs"},
    {CommandName::replay, "replay", "Run recordings again and compare row by row"},
    {CommandName::diff, "diff", "Compare two runs: programs, traces or recordings"},
    {CommandName::report, "report",
     "Show a run on one page: path, time, limits, errors, line by line"},
    {CommandName::surface, "surface",
     "Compute the surface that a part program machines, with its Rmax"},
    {CommandName::compare, "compare",
     "Compare interpolation methods on part programs, at several sampling phases"},
    {CommandName::circle, "circle",
     "Measure the circles of a run: deviations, reversals, both directions (ISO 230-4)"},
    {CommandName::identify, "identify", "Find the drives of a machine from a trace of its motion"},
    {CommandName::machine, "machine", "Print the machine, with the origin of each value"},
    {CommandName::state, "state",
     "Print a state file, or set an offset or the position of the machine in it"},
    {CommandName::latency, "latency", "Measure scheduling latency and the feed it permits"},
    {CommandName::pulses, "pulses", "Check step and direction pulses against the drivers' timing"},
    {CommandName::codes, "codes", "Explain the codes of part programs and of diagnostics"},
};

/// A set of commands.
class Commands {
 public:
  constexpr Commands(std::initializer_list<CommandName> commands) {
    for (const CommandName command : commands) bits_ |= bit(command);
  }
  constexpr bool contains(CommandName command) const { return (bits_ & bit(command)) != 0; }

 private:
  static constexpr unsigned bit(CommandName command) {
    return 1U << static_cast<unsigned>(command);
  }
  unsigned bits_ = 0;
};

/// An option of some commands. One that means something else in another command has two entries.
struct OptionEntry {
  Commands commands;
  const char* names;  // as CLI11 takes them
  const char* value;  // what the help calls its value
  const char* help;
  void (*add)(CLI::App& app, const OptionEntry& entry, Options& options);
};

/// Accepts the names that an option knows; of any other the nearest of them is suggested.
CLI::Validator one_of(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](const std::string& word) {
        if (std::find(names.begin(), names.end(), word) != names.end()) return std::string();
        const std::vector<std::string_view> known(names.begin(), names.end());
        return fmt::format("'{}' is not one of {}{}", word, fmt::join(names, ", "),
                           did_you_mean(nearest_name(word, known)));
      },
      "");
}

/// CLI::Range would accept "nan".
CLI::Validator between(double least, double most) {
  const CLI::Range range(least, most);
  return CLI::Validator(
      [range](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && std::isnan(value))
          return text + " is not a number";
        return range(text);
      },
      "");
}

/// Adds the methods that a word names: "all", or the name of one; each once.
void add_methods(std::vector<Method>& methods, const std::string& word) {
  for (const Method method : runtime::all_methods())
    if ((word == "all" || word == name(method)) &&
        std::find(methods.begin(), methods.end(), method) == methods.end())
      methods.push_back(method);
}

template <auto Member>
void flag(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_flag(entry.names, options.*Member, entry.help);
}

template <auto Member>
void text(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.*Member, entry.help)->type_name(entry.value);
}

template <auto Member>
void required_text(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.*Member, entry.help)->required()->type_name(entry.value);
}

/// A word out of a list, which set(options, index) stores.
void choice(CLI::App& app, const OptionEntry& entry, Options& options,
            const std::vector<std::string>& words, void (*set)(Options&, std::size_t)) {
  app.add_option_function<std::string>(
         entry.names,
         [&options, words, set](const std::string& word) {
           const auto found = std::find(words.begin(), words.end(), word);
           set(options, static_cast<std::size_t>(found - words.begin()));
         },
         entry.help)
      ->check(one_of(words))
      ->type_name(CLI::detail::join(words, "|"));
}

void one_file(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.files, entry.help)->required()->type_name("")->expected(1);
}

void files(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.files, entry.help)->required()->type_name("");
}

void two_files(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.files, entry.help)->required()->type_name("")->expected(2);
}

void optional_file(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.files, entry.help)->type_name("")->expected(1);
}

void words(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.files, entry.help)->type_name("");
}

void machine_file(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::string>(
         entry.names,
         [&options](const std::string& file) {
           if (file.empty()) throw CLI::ValidationError("--machine", "names no file");
           options.names_machine = true;
           options.machine_file = file == "builtin" ? std::string() : file;
         },
         entry.help)
      ->type_name(entry.value);
}

void machine_files(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& files) {
           for (const std::string& file : files) {
             if (file.empty()) throw CLI::ValidationError("--machine", "names no file");
             options.names_machine = true;
             options.machine_files.push_back(file == "builtin" ? std::string() : file);
           }
         },
         entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void settings(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.settings, entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void compared_settings(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.compared_settings, entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void backend(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {kBackendNames.begin(), kBackendNames.end()},
         [](Options& to, std::size_t index) {
           to.settings.push_back("control.backend=" + std::string(kBackendNames[index]));
         });
}

void dialect(CLI::App& app, const OptionEntry& entry, Options& options) {
  std::vector<std::string> words{ipr::kDialectNames.begin(), ipr::kDialectNames.end()};
  words.emplace_back(ipr::kGuessed);
  choice(app, entry, options, words, [](Options& to, std::size_t index) {
    to.guess_dialect = index == ipr::kDialects;
    if (!to.guess_dialect) to.dialect = ipr::kAllDialects[index];
  });
}

void format(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {"auto", "gcode", "commands"}, [](Options& to, std::size_t index) {
    constexpr ipr::Format kFormats[] = {ipr::Format::automatic, ipr::Format::gcode,
                                        ipr::Format::commands};
    to.format = kFormats[index];
  });
}

void curve_form(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {runtime::kCurveForms.begin(), runtime::kCurveForms.end()},
         [](Options& to, std::size_t index) {
           to.curve_form = static_cast<runtime::CurveForm>(index);
         });
}

void progress(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {"auto", "none", "json"},
         [](Options& to, std::size_t index) { to.progress = static_cast<ProgressMode>(index); });
}

void diagnostics(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {"text", "json", "sarif"}, [](Options& to, std::size_t index) {
    to.diagnostics = static_cast<DiagnosticsFormat>(index);
  });
}

void feed_override(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<double>(
         entry.names,
         [&options](double percent) {
           if (!(percent > 0 && percent <= 100 * runtime::kLargestOverride))
             throw CLI::ValidationError("--feed-override",
                                        "takes a percentage above 0 and at most 200");
           options.feed_override = percent / 100;
         },
         entry.help)
      ->type_name(entry.value);
}

void events(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             const auto event = runtime::parse_event(text);
             if (!event)
               throw CLI::ValidationError(
                   "--at",
                   "takes SECONDS:override=PERCENT (0 to 200), SECONDS:rapid=PERCENT (1 to 100), "
                   "SECONDS:hold or SECONDS:resume, not '" +
                       text + "'");
             options.events.push_back(*event);
           }
           runtime::sort_events(options.events);
         },
         entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void worst(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.worst, entry.help)
      ->check(CLI::Range(1, kMostLines).description(""))
      ->type_name(entry.value);
}

/// Names between commas, or "all".
void columns(CLI::App& app, const OptionEntry& entry, Options& options) {
  const std::vector<std::string> known(runtime::kCurveColumnNames.begin(),
                                       runtime::kCurveColumnNames.end());
  std::vector<std::string> accepted = known;
  accepted.emplace_back("all");
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options, known](const std::vector<std::string>& asked) {
           for (const std::string& word : asked) {
             const auto found = std::find(known.begin(), known.end(), word);
             if (found == known.end()) {
               options.columns = runtime::all_curve_columns();
               return;
             }
             const auto column = static_cast<runtime::CurveColumn>(found - known.begin());
             if (std::find(options.columns.begin(), options.columns.end(), column) ==
                 options.columns.end())
               options.columns.push_back(column);
           }
         },
         entry.help)
      ->delimiter(',')
      ->check(one_of(accepted))
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

/// The two words "import FILE".
void import_words(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& words) {
           if (words.front() != "import")
             throw CLI::ValidationError(
                 "'" + words.front() + "'",
                 "is not known to 'softcnc machine'; 'softcnc machine import FILE' reads settings, "
                 "and --machine FILE.toml names a machine file");
           if (words.size() < 2)
             throw CLI::ValidationError("'import'", "needs the file of the settings");
           options.imported = words.back();
         },
         entry.help)
      ->expected(1, 2)
      ->type_name("");
}

void state_file(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.state, entry.help)->required()->type_name(entry.value);
}

/// The words "show", or "set" and what is set.
void state_words(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.action, entry.help)->required()->type_name("");
}

/// A folder that is not there is a name that is wrong.
template <auto Member>
void folders(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.*Member, entry.help)
      ->check(CLI::Validator(CLI::ExistingDirectory).description(""))
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void work_origins(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& texts) {
           options.work.clear();
           for (const std::string& text : texts) {
             const auto work = parse_work_origin(text);
             if (!work)
               throw CLI::ValidationError(
                   "--work",
                   "takes SYSTEM=X,Y,Z, with G54 to G59.3 or G54.1P1 to G54.1P300 and mm, such as "
                   "G54=-200,-150,-40, not '" +
                       text + "'");
             options.work.push_back(*work);
           }
         },
         entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void definitions(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& texts) {
           options.definitions.clear();
           for (const std::string& text : texts) {
             auto definition = ipr::parse_definition(text);
             if (!definition)
               throw CLI::ValidationError("--define",
                                          "takes NAME=VALUE, with the name of a global variable, "
                                          "which begins with '_', or "
                                          "the number of a variable, not '" +
                                              text + "'");
             options.definitions.push_back(*std::move(definition));
           }
         },
         entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void trace(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.trace, entry.help + (" (" + hal::trace_suffixes() + ")"))
      ->type_name(entry.value);
}

void methods(CLI::App& app, const OptionEntry& entry, Options& options) {
  std::vector<std::string> names{"all"};
  names.insert(names.end(), kMethodNames.begin(), kMethodNames.end());
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& asked) {
           options.methods.clear();
           for (const std::string& word : asked) add_methods(options.methods, word);
         },
         entry.help)
      ->check(one_of(names))
      ->type_name(entry.value)
      ->delimiter(',')
      ->allow_extra_args(false);
}

void phases(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.phases, entry.help)
      ->check(CLI::Range(1, kMostPhases).description(""))
      ->type_name(entry.value);
}

void plots(CLI::App& app, const OptionEntry& entry, Options& options) {
  const std::vector<std::string> names(kPlotNames.begin(), kPlotNames.end());
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options, names](const std::vector<std::string>& asked) {
           for (const std::string& word : asked)
             options.picture.plots.push_back(
                 static_cast<Plot>(std::find(names.begin(), names.end(), word) - names.begin()));
         },
         entry.help)
      ->delimiter(',')
      ->check(one_of(names))
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void colour(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {kColouringNames.begin(), kColouringNames.end()},
         [](Options& to, std::size_t index) { to.picture.colour = static_cast<Colouring>(index); });
}

void size(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::string>(
         entry.names,
         [&options](const std::string& text) {
           const auto asked = picture_size(text);
           if (!asked)
             throw CLI::ValidationError(
                 "--size",
                 "takes WIDTH or WIDTHxHEIGHT in px, 400x200 to 10000x10000, not '" + text + "'");
           options.picture.size = *asked;
         },
         entry.help)
      ->type_name(entry.value);
}

void table(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {"text", "csv", "json"},
         [](Options& to, std::size_t index) { to.table = static_cast<TableFormat>(index); });
}

void text_or_json(CLI::App& app, const OptionEntry& entry, Options& options) {
  choice(app, entry, options, {"text", "json"}, [](Options& to, std::size_t index) {
    to.table = index == 0 ? TableFormat::text : TableFormat::json;
  });
}

void plane(CLI::App& app, const OptionEntry& entry, Options& options) {
  const auto& names = runtime::kCirclePlaneNames;
  choice(app, entry, options, {names.begin(), names.end()}, [](Options& to, std::size_t index) {
    to.plane = static_cast<runtime::CirclePlane>(index);
  });
}

void centre(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::string>(
         entry.names,
         [&options](const std::string& text) {
           double first = 0, second = 0;
           char end = 0;
           if (std::sscanf(text.c_str(), "%lf,%lf%c", &first, &second, &end) != 2 ||
               !std::isfinite(first) || !std::isfinite(second))
             throw CLI::ValidationError("--center", "'" + text + "' is not A,B, two numbers in mm");
           options.centre = {first, second};
         },
         entry.help)
      ->type_name(entry.value);
}

void tolerance(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::vector<std::string>>(
         entry.names,
         [&options](const std::vector<std::string>& lists) {
           for (const std::string& list : lists)
             if (const std::string wrong = options.tolerance.add(list); !wrong.empty())
               throw CLI::ValidationError("--tolerance", wrong);
         },
         entry.help)
      ->type_name(entry.value)
      ->allow_extra_args(false);
}

void shard(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<std::string>(
         entry.names,
         [&options](const std::string& text) {
           char end = 0;
           if (std::sscanf(text.c_str(), "%9d/%9d%c", &options.shard, &options.shards, &end) != 2 ||
               options.shard < 1 || options.shard > options.shards)
             throw CLI::ValidationError("--shard",
                                        "takes K/N, with K from 1 to N, not '" + text + "'");
         },
         entry.help)
      ->type_name(entry.value);
}

void seconds(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option(entry.names, options.seconds, entry.help)
      ->check(between(kShortest, kLongest))
      ->type_name(entry.value);
}

void period(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_option_function<double>(
         entry.names, [&options](double us) { options.period = s_from_ms(us / 1000); }, entry.help)
      ->check(between(1, 1e6))
      ->type_name(entry.value);
}

/// Comes after --quiet in the table, which it excludes.
void verbose(CLI::App& app, const OptionEntry& entry, Options& options) {
  app.add_flag(entry.names, options.verbose, entry.help)->excludes(app.get_option("--quiet"));
}

using enum CommandName;
constexpr Commands kRuns{run, record}, kDrives{run, record, operate, serve};
constexpr Commands kPlans{run, check, record, report, surface, compare, diff};
constexpr Commands kPrograms{run, check, blocks, convert, record, report, surface};
constexpr Commands kReads{run, check, blocks, convert, record, report, surface, compare, diff};
constexpr Commands kInterprets{run,     check,   blocks, convert, record, report,
                               surface, compare, diff,   operate, serve};
constexpr Commands kMachine{run,     check,    blocks,  convert, record, replay,  report, surface,
                            machine, identify, latency, pulses,  diff,   operate, serve};
constexpr Commands kReports{run,     check,   blocks,  convert, record, replay,
                            report,  surface, compare, machine, state,  identify,
                            latency, pulses,  diff,    operate, serve};
constexpr Commands kMachines{run,     check,   blocks,   convert, record, replay, report,  surface,
                             compare, machine, identify, latency, pulses, diff,   operate, serve};

constexpr OptionEntry kOptions[] = {
    {{run, record, blocks, convert, surface},
     "PART",
     "",
     "Part program; - is standard input",
     one_file},
    {{operate}, "PART", "", "Part program to load first", optional_file},
    {{serve}, "PART", "", "Part program that ~ begins in Idle", optional_file},
    {{check}, "PART", "", "Part programs, or folders of them; - is standard input", files},
    {{compare}, "PART", "", "Part programs; - is standard input", files},
    {{report},
     "FILE",
     "",
     "Part program, trace (.csv, .npz, also .zst) or recording (.rec)",
     one_file},
    {{circle}, "FILE", "", "Trace (.csv, .npz, also .zst) or recording (.rec)", one_file},
    {{replay}, "FILE.rec", "", "Recordings, or folders of them", files},
    {{diff},
     "FILE",
     "",
     "Two files: part programs (- is standard input), traces (.csv, .npz, also .zst), recordings "
     "(.rec)",
     two_files},
    {{pulses},
     "FILE",
     "",
     "List of edges: .vcd or .edges, also with .zst; - is standard input",
     one_file},
    {{machine},
     "ACTION",
     "",
     "'import FILE': make a machine file of a tool table (.tbl) or configuration (.ini) of "
     "LinuxCNC, "
     "or of what grbl answers to $$",
     import_words},
    {{state},
     "ACTION",
     "",
     "'show'; or 'set NAME X.. Y.. Z..', NAME being position, G28, G30, or a work system from G54 "
     "to G59.3 and G54.1P1 to G54.1P300",
     state_words},
    {{identify},
     "TRACE",
     "",
     "Trace with actual positions: .csv or .npz, also with .zst",
     one_file},
    {{codes},
     "CODE",
     "",
     "G02, SC2103, or the beginning of a code: SC21 (default: all codes of part programs)",
     words},

    {kMachine, "--machine", "FILE.toml",
     "Machine file, or 'builtin' for the built-in mill (default: PART.toml beside PART, else the "
     "built-in mill)",
     machine_file},
    {{compare},
     "--machine",
     "FILE.toml",
     "Machine file, or 'builtin' for the built-in mill; repeatable, for several machines (default: "
     "PART.toml beside PART, else the built-in mill)",
     machine_files},
    {kMachines, "--set", "KEY=VALUE",
     "Set one value of the machine, for example axis.x.acceleration_mm_s2=500 (repeatable)",
     settings},
    {{machine},
     "--toml",
     "",
     "Print a machine file that reads back to the same machine; with -v, the meaning of each key",
     flag<&Options::toml>},
    {{machine},
     "-o,--output",
     "FILE.toml",
     "With --toml and import: where the machine file is written (default: standard output)",
     text<&Options::output>},
    {{machine},
     "--state",
     "FILE.toml",
     "With import: write tool lengths and offsets to this new state file",
     text<&Options::state>},
    {{machine},
     "--inch",
     "",
     "With import of a tool table: its lengths are inches, not mm",
     flag<&Options::imports_inches>},
    {{machine},
     "--allow-include",
     "DIR",
     "With import: read files that the settings name from DIR too, not from their own folder alone "
     "(repeatable)",
     folders<&Options::allowed_folders>},
    {{run},
     "--state",
     "FILE.toml",
     "State file (position, work offsets, tool table, parameters), read before the run and written "
     "after it",
     text<&Options::state>},
    {{check, blocks, convert, record, report, surface, compare, diff},
     "--state",
     "FILE.toml",
     "State file (position, work offsets, tool table, parameters) to begin with",
     text<&Options::state>},
    {{operate, serve},
     "--state",
     "FILE.toml",
     "State file (position, work offsets, tool table, parameters), read first and written whenever "
     "the machine rests",
     text<&Options::state>},
    {{state}, "--state", "FILE.toml", "State file", state_file},
    {kDrives, "--assume-position", "",
     "With --state on a port: the machine stands where the state says, its drives have kept it "
     "there",
     flag<&Options::assume_position>},
    {kInterprets, "--work", "SYSTEM=X,Y,Z",
     "Set the origin of a work system before the first line, in mm and machine coordinates, for "
     "example G54=-200,-150,-40 (repeatable; kept by --state)",
     work_origins},
    {kInterprets, "--subprograms", "DIR",
     "Look for called files in DIR too, after the folder of the program and before program.path "
     "(repeatable)",
     folders<&Options::subprogram_folders>},
    {kInterprets, "--define", "NAME=VALUE",
     "Set a variable before the first line, for example _td=3 for #<_td>, or 100=3 for #100 "
     "(repeatable)",
     definitions},
    {{run, record, report, machine, operate, serve},
     "--backend",
     "",
     "Where setpoints are sent",
     backend},
    {{pulses}, "--backend", "", "With parport, the drivers' times are whole base periods", backend},

    {kPlans, "--feed-override", "PERCENT", "Scale the programmed feed, not rapids (default 100)",
     feed_override},
    {kRuns, "--at", "SECONDS:WHAT",
     "Change the override of the feed or of rapids, hold or resume during the run, for example "
     "1.5:override=50, 1.5:rapid=25 or 2:hold (repeatable)",
     events},
    {kReads, "--block-skip", "", "Skip lines that begin with '/'", flag<&Options::block_skip>},
    {kReads, "--optional-stop", "", "Stop at M01", flag<&Options::optional_stop>},
    {{run, check, blocks, convert, record, report, surface, compare, diff, operate},
     "--dialect",
     "",
     "Dialect to use where controls differ, auto: by the program "
     "(default linuxcnc)",
     dialect},
    {kPrograms, "--format", "",
     "Format of the program: G-code, the commands of paper 003 (l, pcw, s ...), or whichever the "
     "first line is in (auto)",
     format},
    {kRuns, "--single-block", "", "Stop after every block, and wait for Enter before the next",
     flag<&Options::single_block>},

    {{run},
     "--rest-at-pauses",
     "",
     "With --dry-run -: come to rest where the pipe pauses, instead of waiting there for the next "
     "line",
     flag<&Options::rest_at_pauses>},
    {{run},
     "--dry-run",
     "",
     "Run without backend or pre-flight and write the trace to stdout as CSV",
     flag<&Options::dry_run>},
    {kRuns, "--realtime", "", "Run in real time and report missed periods",
     flag<&Options::realtime>},
    {{check},
     "--watch",
     "",
     "Check again whenever a file changes, until Ctrl-C",
     flag<&Options::watch>},
    {{surface},
     "--actual",
     "",
     "Cut with the tool where the simulated mill is, not where it is commanded to be",
     flag<&Options::actual>},
    {{compare},
     "--methods",
     "NAME[,NAME]",
     "Methods to compare, as control.interpolation names them (default: all)",
     methods},
    {{compare},
     "--phases",
     "N",
     "Places within the period at which the first cutting move begins (default 16)",
     phases},
    {{compare}, "--format", "", "Format of the comparison (default text)", table},
    {{diff}, "--format", "", "Format of the differences (default text)", text_or_json},
    {{identify}, "--format", "", "Format of the figures (default text)", text_or_json},
    {{replay}, "--format", "", "Format of the results (default text)", text_or_json},
    {{circle}, "--format", "", "Format of the figures (default text)", text_or_json},
    {{circle}, "--plane", "", "Plane of the circles (default XY)", plane},
    {{circle},
     "--center",
     "A,B",
     "Centre of the radial deviations, in mm along the axes of the plane (default: that of the "
     "least squares of each circle)",
     centre},
    {{diff},
     "--tolerance",
     "LIST",
     "What has to agree, and how closely, for example 1um, or time=1%,path=0.01mm (repeatable; "
     "default: everything, as in a replay)",
     tolerance},
    {{diff, replay},
     "--junit",
     "FILE.xml",
     "Write the results as JUnit XML",
     text<&Options::junit>},
    {{replay}, "--bless", "", "Re-record those that differ", flag<&Options::bless>},
    {{replay}, "--shard", "K/N", "Replay the K-th of N parts of the recordings", shard},
    {{latency}, "--seconds", "SECONDS", "How long to measure (default 10)", seconds},
    {{latency},
     "--period-us",
     "MICROSECONDS",
     "Period of the loop (default: control.servo_period_ms)",
     period},

    {{run, operate, serve}, "--trace", "FILE", "Write one row per period", trace},
    {{serve},
     "--pty",
     "LINK",
     "Make a pseudo-terminal with this name in the file system, for senders that open a port",
     text<&Options::link>},
    {{serve},
     "--tcp",
     "[HOST:]PORT",
     "Listen on a port, of this computer alone unless a host is given",
     text<&Options::address>},
    {{operate, serve},
     "--log",
     "FILE",
     "Add a line for each action, and for what comes of it, to a file",
     text<&Options::log>},
    {{run},
     "--columns",
     "NAME,...",
     "Further columns of the trace, and their figures in the report: u, curvature_1_mm, "
     "chord_error_um, feed_fluctuation, inclination_deg, f_tooth_mm, rmax_um, or all; an .npz file "
     "has all of them",
     columns},
    {{record},
     "-o,--output",
     "FILE.rec",
     "The recording to write",
     required_text<&Options::output>},
    {{convert},
     "--to",
     "",
     "What curves are written as: NURBS (g06.2), splines by control points (g05.2), lines (g1), or "
     "lines and arcs (g1g2g3), these within control.chord_tolerance_um (default g06.2)",
     curve_form},
    {{convert},
     "-o,--output",
     "FILE",
     "The part program to write; - is standard output",
     required_text<&Options::output>},
    {{surface},
     "-o,--output",
     "FILE",
     "The surface to write: numpy arrays (.npz) or a picture (.png)",
     required_text<&Options::output>},
    {{report},
     "-o,--output",
     "FILE",
     "The page (.html) or the picture (.svg, .png) to write",
     required_text<&Options::output>},
    {{circle},
     "-o,--output",
     "FILE",
     "The picture of the deviations to write (.svg, .png)",
     text<&Options::output>},
    {{report},
     "--plot",
     "NAME,...",
     "The plots of a picture, from above to below: path, feed, limits, axes, error, worst "
     "(default: "
     "path,feed,limits)",
     plots},
    {{report}, "--colour", "", "What colours the path in a picture (default: feed)", colour},
    {{report},
     "--size",
     "WIDTH[xHEIGHT]",
     "Size of a picture in px (default: 900, as high as its plots need)",
     size},
    {{report},
     "--compare",
     "B",
     "Compare with another program, trace or recording, or with the same program on another "
     "machine (B.toml, or builtin)",
     text<&Options::compared>},
    {{report},
     "--compare-set",
     "KEY=VALUE",
     "Set one value of the machine of the run that is compared, for example "
     "control.interpolation=taylor2 (repeatable)",
     compared_settings},
    {{report},
     "--what-if",
     "",
     "Plan again with each axis limit 50 % higher, and show the seconds that this wins",
     flag<&Options::what_if>},
    {{compare},
     "-o,--output",
     "FILE",
     "Where the comparison is written (default: standard output)",
     text<&Options::output>},
    {{identify},
     "-o,--output",
     "FILE.toml",
     "Write the machine with the figures that have been found",
     text<&Options::output>},
    {kRuns, "--report", "FILE.json", "Write the figures of the run as JSON",
     text<&Options::report>},
    {{surface},
     "--report",
     "FILE.json",
     "Write the figures of the surface as JSON",
     text<&Options::report>},
    {{latency, pulses},
     "--report",
     "FILE.json",
     "Write the figures as JSON",
     text<&Options::report>},
    {{diff},
     "--worst",
     "N",
     "Name the N lines whose times differ most (default 10; 200 as JSON)",
     worst},
    {{run, check},
     "--worst",
     "N",
     "Name the N lines that lose the most time relative to the programmed feed, with the limit",
     worst},

    {{circle},
     "-q,--quiet",
     "",
     "Print nothing but diagnostics and figures",
     flag<&Options::quiet>},
    {kReports, "--diagnostics", "", "Diagnostics format: text, or one JSON or SARIF document",
     diagnostics},
    {{run, check, record, replay, report, surface, compare, diff},
     "--progress",
     "",
     "Progress on stderr: a bar on a terminal (auto), nothing, or JSON lines",
     progress},
    {kReports, "-q,--quiet", "", "Print nothing but diagnostics", flag<&Options::quiet>},
    {kRuns, "-v,--verbose", "",
     "Print more: times by limit and tool, drives, counts, contour error, jerk, cost", verbose},
    {{check}, "-v,--verbose", "", "Print time and length of each program to stderr", verbose},
    {{surface}, "-v,--verbose", "", "Print the cost of planning and cutting", verbose},
    {{replay}, "-v,--verbose", "", "Name each recording of a folder that agrees", verbose},
    {{machine}, "-v,--verbose", "", "Print the meaning of each value", verbose},
};

}  // namespace

std::span<const CommandEntry> command_table() noexcept { return kCommands; }

void add_options(CLI::App& app, CommandName command, Options& options) {
  for (const OptionEntry& entry : kOptions)
    if (entry.commands.contains(command)) entry.add(app, entry, options);
  arrange_help(app, command);
  if (command == CommandName::codes)
    app.footer([footer = app.get_footer()] {
      return footer + "\nThe codes of part programs, the words they take, what they do:\n" +
             list_of_codes();
    });
}

}  // namespace softcnc::app
