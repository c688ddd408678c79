// SPDX-License-Identifier: MIT
#include "hal/import/machine_draft.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "hal/files/folder_bounds.hpp"
#include "hal/files/number.hpp"
#include "hal/files/text_file.hpp"
#include "hal/import/setting_value.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/machine/toml_text.hpp"

namespace softcnc::hal {
namespace {

constexpr std::string_view kSettingBlanks = " \t\r\v\f";

std::string table_of(const std::string& key) {
  const auto dot = key.rfind('.');
  return dot == key.npos ? std::string() : key.substr(0, dot);
}

std::string source_of(const GivenAt& from) {
  const std::string file = std::filesystem::path(from.file).filename().string();
  return comment_text(trimmed_setting(from.line)) + " (" + comment_text(file) + ":" +
         std::to_string(from.pos.line) + ")";
}

bool stands_before(const Diagnostic& a, const Diagnostic& b) {
  return std::tie(a.file, a.pos.line, a.pos.column) < std::tie(b.file, b.pos.line, b.pos.column);
}

}  // namespace

Diagnostic MachineDraft::diagnostic(Code code, const GivenAt& at, std::string message) const {
  return {.code = code,
          .pos = at.pos,
          .message = std::move(message),
          .file = at.file,
          .source_line = unquoted_.contains(at.file) ? std::string() : at.line};
}

Result<std::string> MachineDraft::read_named_file(const std::string& file) {
  const auto refused = [&](std::string why) {
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC7037, .message = std::move(why), .file = file});
  };
  const auto lies_in = [real = real_path(file)](const std::string& folder) {
    return is_in_folder(real, real_path(folder));
  };
  const bool is_own = lies_in(folder_);
  if (!is_own && std::none_of(allowed_.begin(), allowed_.end(), lies_in))
    return refused("lies outside the folder of the settings; --allow-include DIR reads it");
  if (!is_own) unquoted_.insert(file);
  std::error_code unreadable;
  const auto type = std::filesystem::status(file, unreadable).type();
  if (type != std::filesystem::file_type::regular && type != std::filesystem::file_type::not_found)
    return refused("cannot be read: not a regular file");
  return read_text(file, Code::SC7037);
}

void MachineDraft::add(Value value) {
  if (known_.insert(value.key).second) values_.push_back(std::move(value));
}

void MachineDraft::set(const std::string& key, std::string value, const GivenAt& from) {
  add({key, std::move(value), source_of(from), from});
}

void MachineDraft::set(const std::string& key, double value, const GivenAt& from) {
  set(key, number_text(without_rounding(value)), from);
}

void MachineDraft::choose(const std::string& key, std::string value, std::string why) {
  add({key, std::move(value), std::move(why), std::nullopt});
}

void MachineDraft::leave(const GivenAt& from, std::string_view why) {
  left_.push_back(source_of(from) + (why.empty() ? "" : ": " + std::string(why)));
}

void MachineDraft::fail(Code code, const GivenAt& at, std::string message) {
  if (errors_.size() < kMostErrors) errors_.push_back(diagnostic(code, at, std::move(message)));
}

void MachineDraft::warn(Code code, const GivenAt& at, std::string message) {
  if (notes_.size() < kMostErrors) notes_.push_back(diagnostic(code, at, std::move(message)));
}

/// A default that nobody has chosen is said to be one.
void MachineDraft::add_missing_limits() {
  for (const char axis : {'x', 'y', 'z'}) {
    const std::string table = std::string("axis.") + axis;
    const auto is_of_axis = [&](const Value& value) { return table_of(value.key) == table; };
    if (std::none_of(values_.begin(), values_.end(), is_of_axis)) continue;
    Machine defaults;
    for (const char* key :
         {".velocity_mm_min", ".acceleration_mm_s2", ".min_mm", ".max_mm", ".blu_um"})
      if (const auto ref = find_key(table + key); ref && !has(table + key))
        choose(table + key, value_text(*ref, defaults), "no setting gives it: the default");
  }
}

/// Keys without a table come first, then each table in one piece, in the order of its first value.
std::string MachineDraft::text(const std::string& made_from) {
  std::vector<std::pair<std::string, std::vector<const Value*>>> tables{{"", {}}};
  std::map<std::string, std::size_t> places{{"", 0}};
  for (const Value& value : values_) {
    const auto [place, added] = places.try_emplace(table_of(value.key), tables.size());
    if (added) tables.emplace_back(place->first, std::vector<const Value*>());
    tables[place->second].second.push_back(&value);
  }
  std::string text = "# " + comment_text(made_from) + "\n";
  int line = 1;
  for (const auto& [table, values] : tables) {
    if (!table.empty()) {
      text += "\n[" + table + "]\n";
      line += 2;
    }
    for (const Value* value : values) {
      const auto begin = table.empty() ? 0 : table.size() + 1;
      text += value->key.substr(begin) + " = " + value->value + "  # " + value->comment + "\n";
      if (++line; value->from) places_.insert_or_assign(line, *value->from);
    }
  }
  if (!left_.empty()) text += "\n# Settings without a key in machine files:\n";
  for (const std::string& left : left_) text += "#   " + left + "\n";
  return text;
}

tl::expected<ImportedMachine, std::vector<Diagnostic>> MachineDraft::finish(
    const std::string& file, const std::string& made_from) {
  add_missing_limits();
  std::string made = text(made_from);
  if (errors_.empty())
    if (const auto machine = parse_machine(made, file, {}); !machine)
      for (Diagnostic error : machine.error()) {
        const auto place = places_.find(error.pos.line);
        if (place == places_.end())
          errors_.push_back(std::move(error));
        else
          fail(error.code, place->second, std::move(error.message));
      }
  if (!errors_.empty()) {
    std::stable_sort(errors_.begin(), errors_.end(), stands_before);
    return tl::make_unexpected(std::move(errors_));
  }
  if (!left_.empty())
    notes_.push_back({.code = Code::SC7031,
                      .message = std::to_string(left_.size()) +
                                 (left_.size() == 1 ? " setting has" : " settings have") +
                                 " no key in a machine file; the end of the file lists " +
                                 (left_.size() == 1 ? "it" : "them"),
                      .file = file});
  return ImportedMachine{std::move(made), std::move(state_), std::move(notes_)};
}

GivenAt place_of(const std::string& file, int number, const std::string& line,
                 std::string_view part) {
  const bool within = part.data() >= line.data() && part.data() <= line.data() + line.size();
  const int column = within ? static_cast<int>(part.data() - line.data()) + 1 : 1;
  return {file, {number, column, std::max(1, static_cast<int>(part.size()))}, line};
}

std::optional<double> setting_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (text.empty() || read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
    return std::nullopt;
  return value + 0.0;
}

std::string_view trimmed_setting(std::string_view text) {
  const auto first = text.find_first_not_of(kSettingBlanks);
  if (first == text.npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(kSettingBlanks) + 1 - first);
}

std::vector<std::string> setting_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace softcnc::hal
