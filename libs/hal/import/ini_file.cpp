// SPDX-License-Identifier: MIT
#include "hal/import/ini_file.hpp"

#include <algorithm>
#include <filesystem>

namespace softcnc::hal {
namespace {

constexpr std::string_view kInclude = "#INCLUDE";

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with(';'); }

}  // namespace

std::string beside_file(const std::string& file, const std::string& name) {
  return (std::filesystem::path(file).parent_path() / name).lexically_normal().string();
}

IniFile::IniFile(std::string_view text, const std::string& file, MachineDraft& draft)
    : draft_(draft) {
  read(text, file, false);
}

void IniFile::read(std::string_view text, const std::string& file, bool included) {
  const std::vector<std::string> lines = setting_lines(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    std::string line = lines[i];
    const std::string_view begin = trimmed_setting(line);
    if (begin.starts_with(kInclude) && !included) {
      const std::string_view name = trimmed_setting(begin.substr(kInclude.size()));
      include(name, place_of(file, number, line, begin), file);
      continue;
    }
    if (begin.empty() || is_comment(begin)) continue;
    while (line.ends_with('\\') && i + 1 < lines.size()) {
      line.pop_back();
      line += lines[++i];
    }
    take(line, number, file);
  }
}

void IniFile::include(std::string_view name, const GivenAt& at, const std::string& from) {
  const std::string file = beside_file(from, std::string(name));
  const auto text = draft_.read_named_file(file);
  if (text)
    read(*text, file, true);
  else
    draft_.warn(Code::SC7037, at, "the file " + file + " " + text.error().message);
}

void IniFile::take(const std::string& line, int number, const std::string& file) {
  const std::string_view text = trimmed_setting(line);
  const auto fail = [&](std::string message) {
    draft_.fail(Code::SC7034, place_of(file, number, line, text), std::move(message));
  };
  if (text.starts_with('[')) {
    const auto end = text.find(']');
    if (end == text.npos) return fail("a section needs its ']'");
    section_ = text.substr(1, end - 1);
    return;
  }
  const auto equals = text.find('=');
  if (equals == text.npos || equals == 0)
    return draft_.warn(Code::SC7039, place_of(file, number, line, text),
                       "this is neither [SECTION] nor NAME = VALUE, and is passed over");
  if (section_.empty()) return fail("a variable before any [SECTION]");
  const std::string_view value = trimmed_setting(text.substr(equals + 1));
  const std::string_view name = trimmed_setting(text.substr(0, equals));
  variables_.push_back({section_, std::string(name), std::string(value),
                        place_of(file, number, line, value.empty() ? text : value)});
}

const IniVariable* IniFile::find(std::string_view section, std::string_view name) {
  IniVariable* first = nullptr;
  for (IniVariable& variable : variables_) {
    if (variable.used || variable.section != section || variable.name != name) continue;
    variable.used = true;
    if (!first)
      first = &variable;
    else
      draft_.warn(
          Code::SC7036, variable.at,
          "[" + variable.section + "]" + variable.name + " is given twice; the first line counts");
  }
  return first;
}

std::optional<IniFile::Number> IniFile::number(std::string_view section, std::string_view name) {
  const IniVariable* found = find(section, name);
  if (!found) return std::nullopt;
  const std::string_view value = found->value;
  const auto comment = std::min(value.find_first_of("#;"), value.size());
  const auto read = setting_number(trimmed_setting(value.substr(0, comment)));
  if (read) return Number{*read, found->at};
  draft_.fail(
      Code::SC7035, found->at,
      "[" + found->section + "]" + found->name + " needs a number, not '" + found->value + "'");
  return std::nullopt;
}

bool IniFile::has_section(std::string_view section) const {
  return std::any_of(variables_.begin(), variables_.end(),
                     [&](const IniVariable& one) { return one.section == section; });
}

}  // namespace softcnc::hal
