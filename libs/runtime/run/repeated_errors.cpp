// SPDX-License-Identifier: MIT
#include "runtime/run/repeated_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ipr/dialects/dialect_guess.hpp"
#include "runtime/run/foreign_language.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::size_t kMostCauses = 1000;  // those after them are shown line by line
constexpr int kLinesOfHead = 300;          // in which a language is looked for
constexpr std::size_t kShownOfText = 10;   // errors with the same text
constexpr std::int64_t kShownOfCode = 100;

/// Codes of which errors with the same text have the same cause.
bool has_one_cause(Code code) {
  constexpr std::array kCodes{Code::SC1020, Code::SC1050, Code::SC2001,
                              Code::SC2008, Code::SC2240, Code::SC2241};
  return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

/// What errors with numbers of their own have in common; empty where nothing is known.
std::string_view common_cause(const Diagnostic& diagnostic) {
  if (diagnostic.code != Code::SC2103) return {};
  const std::string_view message = diagnostic.message;
  const std::size_t at = message.find("; its centre fits with ");
  return at == std::string_view::npos ? std::string_view() : message.substr(at + 2);
}

std::string said_of(const Diagnostic& first) {
  const std::string_view common = common_cause(first);
  return common.empty() ? first.message : fmt::format("an arc ends off its circle, and {}", common);
}

/// Puts an error about the whole program in place of the first one within it.
void replace(Diagnostic& error, Diagnostic of_program) {
  of_program.file = std::move(error.file);
  error = std::move(of_program);
}

/// E of an extruder, on every line of a program for a 3-D printer.
bool is_unused_word(const Diagnostic& diagnostic) {
  return diagnostic.code == Code::SC2004 && diagnostic.message.starts_with("E ");
}

}  // namespace

bool RepeatedErrors::takes(Diagnostic& diagnostic) {
  if (foreign_) return true;
  if (diagnostic.severity() != Severity::error && !diagnostic.unreachable) return false;
  if (is_foreign(diagnostic)) return false;
  return is_of_known_cause(diagnostic) || is_of_frequent_code(diagnostic);
}

bool RepeatedErrors::is_of_known_cause(const Diagnostic& error) {
  const std::string_view common = common_cause(error);
  const auto same = [&](const Cause& cause) {
    return cause.first.code == error.code && cause.first.file == error.file &&
           (common.empty() ? cause.first.message == error.message
                           : common_cause(cause.first) == common);
  };
  const auto known = std::find_if(causes_.begin(), causes_.end(), same);
  if (known == causes_.end()) {
    const bool once = has_one_cause(error.code) || is_unused_word(error) || !common.empty();
    if (causes_.size() < kMostCauses)
      causes_.push_back({error, once ? 1 : kShownOfText, 0, error.pos.line});
    return false;
  }
  if (std::exchange(known->last_line, error.pos.line) != error.pos.line) ++known->lines;
  return known->is_hidden();
}

/// Errors whose texts differ, each with a number of its own.
bool RepeatedErrors::is_of_frequent_code(const Diagnostic& error) {
  Kind& kind = kinds_[error.code];
  if (kind.shown == 0) kind.first = error;
  if (kind.shown < kShownOfCode) {
    ++kind.shown;
    return false;
  }
  ++kind.hidden;
  kind.last_line = error.pos.line;
  return true;
}

/// Looks once, at the first error of the program itself.
bool RepeatedErrors::is_foreign(Diagnostic& error) {
  const bool may_be = !looked_ && program_ != nullptr && error.pos.file == 0 &&
                      error.pos.line > 0 && exit_status(error) == 1;
  if (!may_be) return false;
  looked_ = true;
  if (program_->streamed()) return error.pos.line == 1 && is_no_text(error, error.source_line);
  if (is_no_text(error, program_->line(1))) return true;
  guess_dialect(error);
  ForeignLanguage language;
  std::string line = program_->line(1);
  for (int number = 1; number <= kLinesOfHead; line = program_->line(++number))
    language.see(line, number);
  if (!language.found()) return false;
  foreign_ = true;
  replace(error, {.code = Code::SC2383,
                  .pos = {language.line(), 1,
                          static_cast<int>(std::max(language.text().size(), std::size_t{1}))},
                  .message = fmt::format("the program is made for {}; softcnc reads G-code as "
                                         "LinuxCNC and FANUC's controls do",
                                         language.control()),
                  .source_line = language.text()});
  return true;
}

/// A picture, an archive or the like, which would be an error on every line.
bool RepeatedErrors::is_no_text(Diagnostic& error, const std::string& first) {
  const std::string_view kind = kind_of_binary(first);
  if (kind.empty()) return false;
  foreign_ = true;
  replace(error, {.code = Code::SC1060,
                  .pos = {1, 0, 1},
                  .message = fmt::format("the file is {}, not a part program", kind)});
  return true;
}

/// By the first lines of the program, as `--dialect auto` does. FANUC's marks are Haas' too.
void RepeatedErrors::guess_dialect(const Diagnostic& error) {
  if (guessed_) return;
  ipr::DialectGuess guess;
  for (int number = 1; number <= ipr::DialectGuess::kLines; ++number)
    guess.see(program_->line(number), number);
  const auto dialect = guess.dialect();
  if (!dialect || *dialect == dialect_) return;
  if (*dialect == ipr::Dialect::fanuc && dialect_ == ipr::Dialect::haas) return;
  Diagnostic note = error;
  note.code = Code::SC1059;
  note.pos = {guess.line(), 0, 1};
  note.source_line = guess.text();
  note.message = fmt::format("the program looks like one for {} ({}): --dialect {}", name(*dialect),
                             guess.mark(), name(*dialect));
  note.calls.clear();
  other_dialect_ = std::move(note);
}

std::vector<Diagnostic> RepeatedErrors::notes() const {
  std::vector<Diagnostic> all;
  if (foreign_) return all;
  for (const Cause& cause : causes_) {
    if (!cause.is_hidden()) continue;
    Diagnostic note = cause.first;
    note.code = Code::SC6005;
    note.message = fmt::format("{}, here and on {} more line{} (last: {})", said_of(cause.first),
                               cause.lines, cause.lines == 1 ? "" : "s", cause.last_line);
    all.push_back(std::move(note));
  }
  for (const auto& [code, kind] : kinds_) {
    if (kind.hidden == 0) continue;
    Diagnostic note = kind.first;
    note.code = Code::SC6005;
    note.message = fmt::format(
        "{} more error{} {} like this one and the {} shown, the last on line {}", kind.hidden,
        kind.hidden == 1 ? "" : "s", code_name(code), kind.shown - 1, kind.last_line);
    all.push_back(std::move(note));
  }
  if (other_dialect_) all.push_back(*other_dialect_);
  return all;
}

Diagnostics::Sink ShownOnce::sink() {
  return [this](const Diagnostic& diagnostic) {
    Diagnostic own = diagnostic;
    if (!errors_.takes(own)) show_(own);
  };
}

void ShownOnce::finish() {
  for (const Diagnostic& note : errors_.notes()) show_(note);
}

}  // namespace softcnc::runtime
