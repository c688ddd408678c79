// SPDX-License-Identifier: MIT
#include "hal/import/tool_table_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "hal/import/setting_value.hpp"
#include "motion/core/axes.hpp"

namespace softcnc::hal {
namespace {

constexpr std::string_view kLetters = "TPDXYZABCUVWIJQ";
constexpr double kMostTools = 1e9;
constexpr int kFarthestM = static_cast<int>(kFarthest) / 1000;

struct Entry {
  double value = 0;
  std::string_view text;  // with its letter
};
using ToolLine = std::map<char, Entry>;

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find(';')); }

/// The next word of a line, which it is taken from; empty at the end.
std::string_view take_word(std::string_view& rest) {
  rest = trimmed_setting(rest);
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
  rest.remove_prefix(word.size());
  return word;
}

/// Reads one line of a table. Nothing: it is wrong, which has been reported, or has no entries.
class ToolLineReader {
 public:
  ToolLineReader(const std::string& file, int number, const std::string& line, MachineDraft& draft)
      : file_(file), number_(number), line_(line), draft_(draft) {}

  std::optional<ToolLine> read() {
    ToolLine tool;
    std::string_view rest = without_comment(line_);
    while (true) {
      const std::string_view word = take_word(rest);
      if (word.empty()) break;
      if (!take(word, tool)) return std::nullopt;
    }
    if (tool.empty()) return std::nullopt;
    return is_complete(tool) ? std::optional(std::move(tool)) : std::nullopt;
  }

  GivenAt place(std::string_view part) const { return place_of(file_, number_, line_, part); }

 private:
  bool fail(Code code, std::string_view part, std::string message) {
    draft_.fail(code, place(part), std::move(message));
    return false;
  }

  bool take(std::string_view word, ToolLine& tool) {
    const char letter = capital(word.front());
    if (kLetters.find(letter) == kLetters.npos)
      return fail(Code::SC7034, word,
                  "'" + std::string(word) + "' is no entry of a tool table of LinuxCNC");
    const auto value = setting_number(word.substr(1));
    if (!value)
      return fail(Code::SC7035, word, "'" + std::string(word) + "' has no number after its letter");
    if (!tool.try_emplace(letter, Entry{*value, word}).second)
      return fail(Code::SC7034, word, std::string(1, letter) + " is given twice for one tool");
    return true;
  }

  bool is_complete(const ToolLine& tool) {
    const auto number = tool.find('T');
    if (number == tool.end())
      return fail(Code::SC7034, trimmed_setting(without_comment(line_)),
                  "a tool without its number T");
    const double t = number->second.value;
    if (t >= 0 && t <= kMostTools && t == std::floor(t)) return true;
    return fail(Code::SC7035, number->second.text,
                "'" + std::string(number->second.text) + "' is no number of a tool");
  }

  const std::string& file_;
  int number_;
  const std::string& line_;
  MachineDraft& draft_;
};

double value_of(const ToolLine& tool, char letter) {
  const auto found = tool.find(letter);
  return found == tool.end() ? 0 : found->second.value;
}

/// Whether a line names columns, as in tables of LinuxCNC before 2.4, which have no letters.
bool is_heading(std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = take_word(rest);
  return word.size() > 2 && std::all_of(word.begin(), word.end(), [](char c) {
           return capital(c) >= 'A' && capital(c) <= 'Z';
         });
}

/// Entries other than 0 that softcnc has no place for, in words.
std::string unused_entries(const ToolLine& tool) {
  std::string names;
  for (const char letter : std::string_view("ABCUVWIJQ"))
    if (value_of(tool, letter) != 0) names += (names.empty() ? "" : ", ") + std::string(1, letter);
  return names;
}

void take_tool(int number, const ToolLine& tool, const GivenAt& from, double mm_per_unit,
               MachineDraft& draft) {
  draft.set("tool." + std::to_string(number) + ".radius_mm",
            std::abs(value_of(tool, 'D')) * mm_per_unit / 2, from);
  const AxisVector length(value_of(tool, 'X'), value_of(tool, 'Y'), value_of(tool, 'Z'));
  if (!is_near(length * mm_per_unit))
    return draft.fail(Code::SC7035, from,
                      "a tool longer than " + std::to_string(kFarthestM) + " m");
  if (!length.isZero(0))
    draft.state().tools[number].length = (length * mm_per_unit).unaryExpr(&without_rounding);
  if (const std::string unused = unused_entries(tool); !unused.empty()) draft.leave(from, unused);
}

}  // namespace

void take_tool_table(std::string_view text, const std::string& file, double mm_per_unit,
                     MachineDraft& draft) {
  const std::vector<std::string> lines = setting_lines(text);
  std::set<int> known;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ToolLineReader reader(file, static_cast<int>(i) + 1, lines[i], draft);
    if (is_heading(without_comment(lines[i])))
      return draft.fail(
          Code::SC7034, reader.place(trimmed_setting(lines[i])),
          "a table with columns is one of LinuxCNC before 2.4; here each entry has its "
          "letter: T1 P1 D6 Z20");
    const auto tool = reader.read();
    if (!tool) continue;
    const Entry& t = tool->at('T');
    const int number = static_cast<int>(t.value);
    const GivenAt from = reader.place(t.text);
    if (number == 0) continue;  // an empty spindle
    if (known.insert(number).second)
      take_tool(number, *tool, from, mm_per_unit, draft);
    else
      draft.warn(Code::SC7036, from,
                 "T" + std::to_string(number) + " is given twice; the first line counts");
  }
}

bool is_tool_table(std::string_view text) {
  for (const std::string& line : setting_lines(text)) {
    std::string_view rest = without_comment(line);
    const std::string_view word = take_word(rest);
    if (word.empty()) continue;
    const char letter = capital(word.front());
    return (letter == 'T' || letter == 'P') && setting_number(word.substr(1)).has_value();
  }
  return false;
}

}  // namespace softcnc::hal
