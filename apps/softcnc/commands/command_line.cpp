// SPDX-License-Identifier: MIT
// The command line by CLI11: parsing, and what is wrong with it.
#include "commands/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "commands/help_page.hpp"
#include "commands/option_table.hpp"
#include "commands/usage_errors.hpp"
#include "commands/version.hpp"
#include "input/reported_run.hpp"
#include "messages/standard_output.hpp"
#include "motion/core/spelling.hpp"
#include "process/standard_error.hpp"
#include "settings/file_clash.hpp"

namespace softcnc::app {
namespace {

/// Returns whether the last event leaves the machine at rest.
bool ends_in_hold(const Options& options) {
  ipo::FeedControl control;
  for (const runtime::FeedEvent& event : options.events) control = after(event, control);
  return control.halts();
}

int refuse(const std::string& reason) {
  write_to_stderr(reason + "\nRun with --help for more information.\n");
  return kWrongUsage;
}

/// Returns whether a word names a part program rather than a command.
bool looks_like_file(const std::string& word) {
  std::error_code ignored;
  return word == "-" || word.find_first_of("./") != word.npos ||
         std::filesystem::exists(word, ignored);
}

/// Returns the first word that is not an option; empty where there is none.
std::string first_of(std::span<const char* const> words) {
  const auto is_word = [](std::string_view word) { return word == "-" || !word.starts_with('-'); };
  const auto first = std::find_if(words.begin(), words.end(), is_word);
  return first == words.end() ? std::string() : *first;
}

/// Refuses a command line without a command.
int refuse_command(std::span<const char* const> words) {
  const std::string word = first_of(words);
  std::vector<std::string_view> names;
  for (const CommandEntry& command : command_table()) names.push_back(command.name);
  const std::string list = "; the commands are " + fmt::format("{}", fmt::join(names, ", "));
  if (word.empty())
    return refuse((words.empty() ? "a command" : std::string(words[0]) + ": a command") +
                  " is missing" + list);
  if (looks_like_file(word))
    return refuse(fmt::format("'{0}' is not a command; 'softcnc run {0}' runs it{1}", word, list));
  return refuse("'" + word + "' is not a command" + did_you_mean(nearest_name(word, names)) + list);
}

/// Returns the long option of a command that is most like `name`, as a question.
std::string option_like(const CLI::App& command, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& word : option->get_lnames()) known.push_back("--" + word);
  if (!name.starts_with("--")) return {};
  return did_you_mean(
      nearest_name(name, std::vector<std::string_view>(known.begin(), known.end())));
}

/// Returns the first word that looks like an option of the command but is not one; empty where
/// there is none.
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

/// Help and version are data. An unknown option is named first, whatever else is wrong.
int report_parse_error(const CLI::App& app, const CLI::ParseError& error,
                       std::span<const char* const> words) {
  std::ostringstream out;
  if (error.get_exit_code() == 0) {
    app.exit(error, out, out);
    StandardOutput output;
    output.write(out.str());
    return output.finish();
  }
  for (const CLI::App* command : app.get_subcommands())
    if (const auto name = unknown_option(*command, words.subspan(1)); !name.empty())
      return refuse(name + ": no such option of '" + command->get_name() + "'" +
                    option_like(*command, name));
  if (app.get_subcommands().empty()) return refuse_command(words.subspan(1));
  return refuse(usage_error(error.what()));
}

/// "help run" is "run --help", and "help" alone "--help".
std::vector<const char*> with_help_as_option(std::span<const char* const> words) {
  std::vector<const char*> all(words.begin(), words.end());
  if (all.size() < 2 || std::string_view(all[1]) != "help") return all;
  if (all.size() == 2) return {all[0], "--help"};
  for (const CommandEntry& command : command_table())
    if (std::string_view(all[2]) == command.name) return {all[0], all[2], "--help"};
  all.erase(all.begin() + 1);
  return all;
}

/// Whether anything that the run writes has further columns, or their figures.
bool shows_columns(const Options& options) {
  const std::string_view trace = options.trace;
  const auto is = [trace](std::string_view suffix) {
    return trace.ends_with(suffix) || trace.ends_with(std::string(suffix) + ".zst");
  };
  const bool has_rows = options.dry_run || !trace.empty();
  return !options.report.empty() || (has_rows && !is(".vcd") && !is(".hal"));
}

/// What is asked of rows that have been written down, which only a run can do.
std::string runs_nothing(const Options& options) {
  if (options.command != CommandName::report) return {};
  const bool is_run = input_kind(options.files.front()) == InputKind::program;
  const bool compares_file = !options.compared.empty() && !names_machine(options.compared);
  const bool runs_other =
      compares_file ? input_kind(options.compared) == InputKind::program : is_run;
  if (!options.compared_settings.empty() && !runs_other)
    return "--compare-set: a trace or a recording is compared, and runs on no machine";
  if (is_run) return {};
  if (options.what_if) return "--what-if needs a part program, not a trace or a recording";
  if (names_machine(options.compared))
    return "--compare: a trace or a recording does not run on another machine";
  const bool has_effect = runs_other && compares_file;  // on the second run
  if (!has_effect && (options.names_machine || !options.settings.empty() ||
                      !options.state.empty() || options.feed_override != 1))
    return "a trace or a recording is shown as it is: options of a run have no effect";
  return {};
}

/// What is asked of a page in a picture, or of a picture in a page; empty where nothing is.
std::string misplaced_option(const Options& options) {
  if (options.command != CommandName::report) return {};
  const bool is_picture = picture_format(options.output).has_value();
  if (is_picture && options.what_if) return "--what-if is shown by a page: -o FILE.html";
  if (!is_picture && options.picture != PictureOptions())
    return "--plot, --colour and --size choose what a picture shows: -o FILE.svg or FILE.png";
  return {};
}

/// What the command `machine` is asked for that does not go together; empty where all of it does.
std::string misplaced_machine_option(const Options& options) {
  if (options.command != CommandName::machine) return {};
  const bool imports = !options.imported.empty();
  if (imports && (options.toml || options.names_machine || !options.settings.empty()))
    return "import reads settings alone: without --toml, --machine, --set and --backend";
  if (!imports &&
      (!options.state.empty() || options.imports_inches || !options.allowed_folders.empty()))
    return "--state, --inch and --allow-include belong to 'softcnc machine import FILE'";
  if (!imports && !options.toml && !options.output.empty())
    return "-o needs --toml or 'import FILE'";
  return {};
}

/// Returns what is wrong where options exclude each other; empty where nothing is.
std::string conflict(const Options& options) {
  if (options.command == CommandName::codes) return {};
  if (ends_in_hold(options))
    return "--at: the last event holds the program for ever; a later SECONDS:resume, or an "
           "override above 0, must follow";
  if (options.progress == ProgressMode::json && options.diagnostics != DiagnosticsFormat::text)
    return "--progress json and --diagnostics both use standard error";
  const auto& files = options.files;
  if (options.watch && std::find(files.begin(), files.end(), "-") != files.end())
    return "--watch cannot watch standard input";
  const bool reads_several =
      options.command == CommandName::compare || options.command == CommandName::diff;
  if (reads_several && std::count(files.begin(), files.end(), "-") > 1)
    return "standard input is one program, and '-' is named more than once";
  if (options.bless && (options.names_machine || !options.settings.empty()))
    return "--bless makes recordings again on their own machines, without --machine and --set";
  if (options.bless && std::find(files.begin(), files.end(), "-") != files.end())
    return "--bless cannot write to standard input";
  if (!options.columns.empty() && !shows_columns(options))
    return "--columns needs a trace as CSV (--trace), or --report";
  if (std::string idle = runs_nothing(options); !idle.empty()) return idle;
  if (std::string misplaced = misplaced_option(options); !misplaced.empty()) return misplaced;
  if (std::string misplaced = misplaced_machine_option(options); !misplaced.empty())
    return misplaced;
  return file_clash(options);
}

}  // namespace

std::variant<Options, int> parse_command_line(int argc, const char* const* argv) {
  CLI::App app("softcnc runs part programs (G-code) on a simulated mill.", "softcnc");
  app.formatter(wrapping_formatter());
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.set_version_flag("-V,--version", version_text());
  app.set_help_flag("-h,--help", "Show this help");
  app.failure_message(CLI::FailureMessage::simple);
  app.require_subcommand(1);
  app.footer(
      "'softcnc help COMMAND' lists the options of a command, 'softcnc codes' the codes of part\n"
      "programs; 'softcnc codes G41' explains one of them.");
  Options options;
  for (const CommandEntry& command : command_table())
    add_options(*app.add_subcommand(command.name, command.help)->group("Commands"), command.id,
                options);
  const auto words = with_help_as_option({argv, static_cast<std::size_t>(argc)});
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::ParseError& error) {
    return report_parse_error(app, error, words);
  }
  for (const CommandEntry& command : command_table())
    if (app.got_subcommand(command.name)) options.command = command.id;
  if (const std::string clash = conflict(options); !clash.empty()) return refuse(clash);
  const bool silent = options.quiet || options.diagnostics != DiagnosticsFormat::text;
  if (silent && options.progress == ProgressMode::automatic) options.progress = ProgressMode::none;
  return options;
}

}  // namespace softcnc::app
