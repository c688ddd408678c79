// SPDX-License-Identifier: MIT
#include "commands/help_page.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "messages/messages.hpp"

namespace softcnc::app {
namespace {

constexpr std::size_t kNames = 30;        // columns before the descriptions
constexpr std::size_t kNarrowest = 60;    // columns of a terminal whose width counts
constexpr std::size_t kEasilyRead = 100;  // columns at most

/// Columns of standard output; without end where it is no terminal.
std::size_t width_of_output() {
  if (::isatty(STDOUT_FILENO) == 0) return std::numeric_limits<std::size_t>::max();
  return std::clamp(terminal_width(STDOUT_FILENO), kNarrowest, kEasilyRead);
}

/// Returns the text, which begins at column kNames, in lines that do too, of so many columns at
/// most.
std::string wrapped(std::string_view text, std::size_t width) {
  std::string lines;
  std::size_t at = kNames;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (at > kNames && end + at > width) {
      lines.back() = '\n';
      lines.append(kNames, ' ');
      at = kNames;
    }
    lines.append(text.substr(0, end)).append(1, ' ');
    at += end + 1;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!lines.empty()) lines.pop_back();
  return lines;
}

/// CLI11's lines, but broken, and without what an option excludes.
class WrappingFormatter final : public CLI::Formatter {
 public:
  WrappingFormatter() { column_width(kNames); }

  std::string make_option(const CLI::Option* option, bool positional) const override {
    std::string names = "  " + make_option_name(option, positional) + option_value(option);
    if (names.size() + 2 > kNames)
      names += '\n' + std::string(kNames, ' ');
    else
      names.resize(kNames, ' ');
    return names + wrapped(make_option_desc(option), width_) + '\n';
  }

  /// One blank line before each group, where CLI11 puts two.
  std::string make_usage(const CLI::App* app, std::string name) const override {
    return CLI::Formatter::make_usage(app, std::move(name)) + '\n';
  }
  std::string make_group(std::string group, bool positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = CLI::Formatter::make_group(std::move(group), positional, options);
    text.erase(0, text.find_first_not_of('\n'));
    return positional ? text + '\n' : text;
  }

 private:
  static std::string option_value(const CLI::Option* option) {
    if (option->get_type_size() == 0) return {};
    const std::string value = option->get_type_name();
    const bool repeats = option->get_expected_max() > 1;
    return (value.empty() ? "" : ' ' + value) + (repeats ? " ..." : "");
  }

  std::size_t width_ = width_of_output();
};

/// A group of options, by their long names.
struct Group {
  std::string_view title;
  std::string_view names;  // each between blanks
};

constexpr Group kGroups[] = {
    {"Machine", " machine set backend state assume-position work "},
    {"Program", " subprograms define dialect format block-skip optional-stop "},
    {"Run",
     " feed-override at single-block rest-at-pauses realtime dry-run watch methods phases actual "
     "seconds period-us worst "},
    {"Messages", " diagnostics progress quiet verbose help "},
};

std::string group_of(const CLI::Option& option, CommandName command) {
  using enum CommandName;
  if (option.get_lnames().empty()) return "Output";
  const bool reads_program = command != circle && command != identify && command != compare &&
                             command != diff && command != replay;
  if (option.get_lnames().front() == "format" && !reads_program) return "Output";
  const std::string name = ' ' + option.get_lnames().front() + ' ';
  for (const Group& group : kGroups)
    if (group.names.find(name) != std::string_view::npos) return std::string(group.title);
  return "Output";
}

/// Three things that people do with a command.
struct Examples {
  CommandName command;
  std::array<std::string_view, 3> lines;
};

using enum CommandName;
constexpr Examples kExamples[] = {
    {run,
     {"softcnc run part.nc --trace part.csv",
      "softcnc run part.nc --machine mill.toml --work G54=-200,-150,-40",
      "softcnc run part.nc --dry-run --trace - --columns all"}},
    {check,
     {"softcnc check part.nc", "softcnc check folder --machine mill.toml",
      "softcnc check part.nc --watch"}},
    {blocks,
     {"softcnc blocks part.nc", "softcnc blocks part.nc --dialect fanuc",
      "softcnc blocks - <part.nc"}},
    {convert,
     {"softcnc convert part.nc -o curves.nc", "softcnc convert part.nc -o lines.nc --to g1",
      "softcnc convert part.nc -o arcs.nc --to g1g2g3"}},
    {record,
     {"softcnc record part.nc -o part.rec",
      "softcnc record part.nc -o part.rec --machine mill.toml", "softcnc replay part.rec"}},
    {replay,
     {"softcnc replay recordings", "softcnc replay recordings --junit report.xml",
      "softcnc replay part.rec --bless"}},
    {diff,
     {"softcnc diff old.nc new.nc", "softcnc diff old.csv new.csv --format json",
      "softcnc diff part.rec part.nc"}},
    {report,
     {"softcnc report part.nc -o page.html", "softcnc report part.nc -o page.html --compare old.nc",
      "softcnc report part.nc -o path.svg"}},
    {surface,
     {"softcnc surface part.nc -o surface.npz", "softcnc surface part.nc -o surface.npz --actual",
      "softcnc surface part.nc -o surface.png"}},
    {compare,
     {"softcnc compare part.nc", "softcnc compare part.nc --phases 4",
      "softcnc compare part.nc --format csv"}},
    {circle,
     {"softcnc circle circle.csv", "softcnc circle circle.csv --plane ZX",
      "softcnc circle circle.rec -o circle.svg"}},
    {identify,
     {"softcnc identify moves.csv -o drives.toml", "softcnc identify moves.csv --machine mill.toml",
      "softcnc identify moves.csv --format json"}},
    {machine,
     {"softcnc machine --machine mill.toml", "softcnc machine --toml -v -o mill.toml",
      "softcnc machine import grbl.txt -o mill.toml"}},
    {state,
     {"softcnc state show --state mill.state.toml",
      "softcnc state set G54 X-200 Y-150 Z-40 --state mill.state.toml",
      "softcnc state set position X0 Y0 Z0 --state mill.state.toml"}},
    {latency,
     {"softcnc latency", "softcnc latency --seconds 60", "softcnc latency --period-us 250"}},
    {pulses,
     {"softcnc pulses edges.vcd", "softcnc pulses edges.vcd --machine mill.toml",
      "softcnc pulses - <edges.edges"}},
    {codes, {"softcnc codes G41", "softcnc codes SC2103", "softcnc codes tool length"}},
};

}  // namespace

std::shared_ptr<CLI::Formatter> wrapping_formatter() {
  return std::make_shared<WrappingFormatter>();
}

void arrange_help(CLI::App& app, CommandName command) {
  app.set_help_flag("-h,--help", "Show this help");  // again: the last one of its group
  for (CLI::Option* option : app.get_options())
    if (!option->get_positional()) option->group(group_of(*option, command));
  std::string text = "Examples:\n";
  for (const Examples& examples : kExamples)
    if (examples.command == command)
      for (const std::string_view line : examples.lines) text.append("  ").append(line) += '\n';
  app.footer(text);
}

}  // namespace softcnc::app
