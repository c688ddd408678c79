// SPDX-License-Identifier: MIT
// `softcnc codes`: what the codes of programs and of diagnostics mean, from their two tables.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "commands/command_line.hpp"
#include "commands/commands.hpp"
#include "ipr/codes/gcode.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "process/standard_error.hpp"

namespace softcnc::app {
namespace {

std::string upper(std::string_view text) {
  std::string word(text);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

/// "G02" for "g2", "G06.2" for "G6.2"; other words as they are.
std::string spelled_in_full(std::string word) {
  const bool short_of_zero = word.size() > 1 && (word[0] == 'G' || word[0] == 'M') &&
                             std::isdigit(static_cast<unsigned char>(word[1])) != 0 &&
                             (word.size() == 2 || word[2] == '.');
  return short_of_zero ? word.insert(1, "0") : word;
}

std::string spaced(std::string_view words) {
  std::string text;
  for (const char letter : words) (text += text.empty() ? "" : " ") += letter;
  return text;
}

std::string row(const ipr::GCode& code) {
  return fmt::format("{:<6}  {:<18}  {}\n", ipr::code_name(code), spaced(code.words), code.says);
}

/// The codes that exclude each other on a line.
std::string codes_of(ipr::Group group) {
  std::string text;
  for (const ipr::GCode& code : ipr::gcode_table())
    if (code.group == group) (text += text.empty() ? "" : " ") += ipr::code_name(code);
  return text;
}

/// Returns all that the table says of a code.
std::string explained(const ipr::GCode& code) {
  std::string text = row(code);
  const auto line = [&text](std::string_view what, std::string_view says) {
    if (!says.empty()) text += fmt::format("        {:<8}{}\n", what, says);
  };
  const auto order = static_cast<std::size_t>(code.order);
  line("fanuc", code.fanuc_words.empty() ? "" : "takes " + spaced(code.fanuc_words) + " too");
  line("haas", code.haas_words.empty() ? "" : "takes " + spaced(code.haas_words) + " too");
  line("group", fmt::format("{} ({})", ipr::group_name(code.group), codes_of(code.group)));
  line("order", fmt::format("{} of {}: {}", order + 1, ipr::order_names().size(),
                            ipr::order_names()[order]));
  return text;
}

std::string row(const CodeInfo& info) {
  return fmt::format("{}  {:<7}  {}\n", code_name(info.code), name(info.severity), info.title);
}

std::string explained(const CodeInfo& info) {
  return fmt::format("{}  {}: {}\n        {}\n", code_name(info.code), name(info.severity),
                     info.title, info.help);
}

/// Returns the row of that name, or all rows whose names begin so; empty where there is none.
std::string found(const std::string& word) {
  std::string text;
  for (const ipr::GCode& code : ipr::gcode_table()) {
    const std::string name = ipr::code_name(code);
    if (name == spelled_in_full(word)) return explained(code);
    if (name.starts_with(word)) text += row(code);
  }
  for (const CodeInfo& info : code_table()) {
    const std::string name = code_name(info.code);
    if (name == word) return explained(info);
    if (word.size() > 1 && name.starts_with(word)) text += row(info);
  }
  return text;
}

bool contains_all(std::string_view text, const std::vector<std::string>& words) {
  const std::string all = upper(text);
  return std::all_of(words.begin(), words.end(),
                     [&all](const std::string& word) { return all.find(upper(word)) != all.npos; });
}

/// Returns the rows of which the table says all words.
std::string rows_with(const std::vector<std::string>& words) {
  std::string text;
  for (const ipr::GCode& code : ipr::gcode_table())
    if (contains_all(code.says, words)) text += row(code);
  for (const CodeInfo& info : code_table())
    if (contains_all(fmt::format("{} {}", info.title, info.help), words)) text += row(info);
  return text;
}

}  // namespace

std::string list_of_codes() {
  std::string text;
  for (const ipr::GCode& code : ipr::gcode_table()) text += row(code);
  return text;
}

int codes(const Options& options) {
  StandardOutput out;
  if (options.files.empty()) out.write(list_of_codes());
  int status = 0;
  std::vector<std::string> others;  // words that begin no code
  for (const std::string& word : options.files) {
    const std::string text = found(upper(word));
    out.write(text);
    if (text.empty()) others.push_back(word);
  }
  const std::string rows = others.empty() ? std::string() : rows_with(others);
  out.write(rows);
  if (!others.empty() && rows.empty()) {
    write_to_stderr(fmt::format("softcnc: no code is called '{0}', and none is about '{0}'\n",
                                fmt::join(others, " ")));
    status = kWrongUsage;
  }
  const int written = out.finish();
  return written != 0 ? written : status;
}

}  // namespace softcnc::app
