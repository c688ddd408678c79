// SPDX-License-Identifier: MIT
// Finds subprograms: in the texts that are open, then in files.
#include "ipr/parser/library.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace softcnc::ipr {
namespace {

constexpr std::size_t kMostMissing = 1000, kMostFoldersShown = 4;

std::string shown_folder(const std::string& folder) {
  std::error_code unreadable;
  return std::filesystem::is_directory(folder, unreadable) ? folder : folder + " (no such folder)";
}

bool is_number(std::string_view label) { return !label.empty() && is_digit(label.front()); }

/// How many letters must be changed, added or removed to make one word of the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::vector<std::string> usual_file_names(const std::string& label, bool program) {
  if (!program) return {label + ".ngc", label + ".nc"};
  if (!is_number(label)) return {label + ".nc", label + ".ngc", label};
  const std::string padded = std::string(label.size() < 4 ? 4 - label.size() : 0, '0') + label;
  std::vector<std::string> names;
  for (const std::string& stem : {"O" + padded, "o" + padded, "O" + label, "o" + label, label})
    for (const char* suffix : {".nc", ".ngc", ""}) names.push_back(stem + suffix);
  return names;
}

/// Names that the file of a subprogram may have. Some systems write all of a name in capitals.
std::vector<std::string> file_names(const std::string& label, bool program) {
  std::vector<std::string> names = usual_file_names(label, program);
  for (std::size_t i = 0, usual = names.size(); i < usual; ++i) {
    std::string capitals = names[i];
    for (char& c : capitals) c = upper_case(c);
    if (std::find(names.begin(), names.end(), capitals) == names.end())
      names.push_back(std::move(capitals));
  }
  return names;
}

bool begins_subprogram(const Statement* statement) {
  return statement != nullptr &&
         (statement->kind == StatementKind::program || statement->kind == StatementKind::sub);
}

}  // namespace

std::string o_word(std::string_view label, std::string_view keyword) {
  std::string text = is_number(label) ? "o" : "o<";
  text += label;
  if (!is_number(label)) text += '>';
  if (!keyword.empty()) (text += ' ') += keyword;
  return text;
}

std::string program_name(std::string_view label) {
  const std::string name(label);
  return is_number(label) ? "O" + name : "O<" + name + ">";
}

Library::Library(Parser& parser, Diagnostics& diagnostics, Folders folders, CalledTexts* called)
    : parser_(parser),
      diagnostics_(diagnostics),
      folders_(std::move(folders)),
      called_(called != nullptr ? called : &own_) {
  Text main;
  main.reader = &parser.reader();
  main.searched = here();
  texts_.emplace(0, std::move(main));
}

Spot Library::here() const { return {parser_.file(), parser_.reader().place()}; }

bool Library::go(const Spot& spot) {
  Reader& reader = *text(spot.file).reader;
  if (!reader.seek(spot.place)) {
    diagnostics_.report(reader.seek_failure());
    lost_ = true;
    return false;
  }
  parser_.read_on(reader, spot.file, spot.place.line == 0);
  return true;
}

std::optional<Subprogram> Library::find(const std::string& label, bool program,
                                        const SourcePos& call, std::string_view line) {
  const Spot before = here();
  std::optional<Subprogram> found;
  for (const int file : {call.file, 0})
    if (const auto* sub = found ? nullptr : find_in(file, label, program)) found = *sub;
  if (!found) found = find_file(label, program, call, line);
  if (!go(before)) return std::nullopt;
  return found;
}

const Subprogram* Library::find_in(int file, const std::string& label, bool program) {
  if (known(text(file), label, program) == nullptr) search_on(file, label, program);
  return known(text(file), label, program);
}

const Subprogram* Library::known(const Text& text, const std::string& label, bool program) const {
  if (program)
    if (const auto at = text.programs.find(label); at != text.programs.end()) return &at->second;
  const auto at = text.subs.find(label);
  return at == text.subs.end() ? nullptr : &at->second;
}

/// Reads on from where the last search has ended.
void Library::search_on(int file, const std::string& label, bool program) {
  if (text(file).searched_all || !go(text(file).searched)) return;
  while (const auto line = parser_.next_statement()) {
    learn(text(file), *line);
    if (known(text(file), label, program) == nullptr) continue;
    text(file).searched = here();
    return;
  }
  text(file).searched_all = true;
}

void Library::learn(Text& text, const ProgramLine& line) {
  const Statement* statement = line.statement;
  if (statement == nullptr && line.broken) unread_label_ = true;
  if (!begins_subprogram(statement)) return;
  const bool program = statement->kind == StatementKind::program;
  auto& known = program ? text.programs : text.subs;
  const bool added = known.try_emplace(statement->label, begun_by(*statement)).second;
  if (added) return;
  const std::string name =
      program ? program_name(statement->label) : o_word(statement->label, "sub");
  diagnostics_.report(Code::SC2314, statement->pos, name + " is already defined in this file",
                      line.text);
}

/// Expects that the parser stands after its line.
Subprogram Library::begun_by(const Statement& statement) const {
  const SubKind kind =
      statement.kind == StatementKind::program ? SubKind::program : SubKind::o_word;
  return {kind, statement.label, here()};
}

std::optional<Subprogram> Library::find_file(const std::string& label, bool program,
                                             const SourcePos& call, std::string_view line) {
  if (label.find('/') != std::string::npos || label.starts_with('.')) return std::nullopt;
  const std::vector<std::string> names = file_names(label, program);
  for (std::size_t folder = 0; folder < folders_.size(); ++folder) {
    if (folders_[folder].empty()) continue;
    for (const std::string& name : names) {
      const auto file = open(folder, name, call, line);
      if (!file) continue;
      if (const auto* sub = find_in(*file, label, program)) return *sub;
      if (program) return Subprogram{SubKind::program, label, {*file, {}}};
    }
  }
  return std::nullopt;
}

/// The file of this name in a folder; nothing if there is none, or none that can be read.
std::optional<int> Library::open(std::size_t folder, const std::string& name, const SourcePos& call,
                                 std::string_view line) {
  const std::string path =
      (std::filesystem::path(folders_[folder]) / name).lexically_normal().string();
  if (const auto at = file_of_.find(path); at != file_of_.end())
    return at->second < 0 ? std::nullopt : std::optional(at->second);
  const auto& found = called_->find(path, folder == 0 ? std::string() : folders_[folder]);
  if (!found) {
    diagnostics_.report(found.error().code, call, found.error().message, line);
    file_of_[path] = -1;
    return std::nullopt;
  }
  if (!*found) {
    if (missing_.size() < kMostMissing) missing_.insert(path);
    return std::nullopt;
  }
  Text text;
  text.own = std::make_unique<Reader>(Reader::of_file((*found)->descriptor(), 0));
  text.own->set_stop(parser_.reader().stop());
  text.reader = text.own.get();
  text.found = {folder == 0 ? name : std::to_string(folder) + '/' + name, path};
  const int file = diagnostics_.add_file(path);
  text.searched.file = file;
  texts_.emplace(file, std::move(text));
  file_of_[path] = file;
  return file;
}

std::vector<Subprogram> Library::all_of_program() {
  std::vector<Subprogram> all;
  if (!go({})) return all;
  while (const auto line = parser_.next_statement())
    if (begins_subprogram(line->statement)) all.push_back(begun_by(*line->statement));
  return all;
}

std::string Library::nearest(const std::string& label) const {
  std::string best;
  std::size_t least = label.size() / 3 + 1;  // more is another word
  for (const auto& [file, text] : texts_)
    for (const auto* known : {&text.subs, &text.programs})
      for (const auto& [name, sub] : *known)
        if (const std::size_t d = distance(label, name); d < least) {
          least = d;
          best = sub.kind == SubKind::program ? program_name(name) : o_word(name);
        }
  return best;
}

std::vector<FoundFile> Library::files() const {
  std::vector<FoundFile> found;
  for (const auto& [file, text] : texts_)
    if (text.own) found.push_back(text.found);
  return found;
}

std::string Library::places() const {
  std::vector<std::string> places{"in this program"};
  if (!folders_.empty() && !folders_.front().empty()) places.emplace_back("beside it");
  const std::size_t shown = std::min(folders_.size(), kMostFoldersShown + 1);
  for (std::size_t i = 1; i < shown; ++i) places.push_back("in " + shown_folder(folders_[i]));
  if (folders_.size() > shown)
    places.push_back("in " + std::to_string(folders_.size() - shown) + " more folders");
  std::string text = places.front();
  for (std::size_t i = 1; i < places.size(); ++i)
    text += (i + 1 == places.size() ? " or " : ", ") + places[i];
  return text;
}

}  // namespace softcnc::ipr
