// SPDX-License-Identifier: MIT
// The table of codes and the rendering of a diagnostic with its caret.
#include "motion/core/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "motion/core/utf8.hpp"

namespace softcnc {
namespace {

constexpr CodeInfo kTable[] = {
#define SOFTCNC_DIAGNOSTIC(number, severity, title, help) \
  {Code::SC##number, Severity::severity, title, help},
#include "motion/core/diagnostic_table.inc"
#undef SOFTCNC_DIAGNOSTIC
};

constexpr bool ascending() {
  for (std::size_t i = 1; i < std::size(kTable); ++i)
    if (kTable[i - 1].code >= kTable[i].code) return false;
  return true;
}
static_assert(ascending(), "diagnostic_table.inc stands in ascending order, no code twice");

/// Characters (UTF-8 code points) in the first `bytes` bytes of a line.
int characters(std::string_view line, int bytes) {
  const auto head = line.substr(0, static_cast<std::size_t>(std::max(bytes, 0)));
  return static_cast<int>(head.size()) -
         static_cast<int>(std::count_if(head.begin(), head.end(), continues_character)) +
         std::max(0, bytes - static_cast<int>(line.size()));
}

/// Characters that turn the direction of what follows (Unicode's Bidi_Control), by which a text
/// shows what it does not say.
bool turns_direction(std::string_view character) {
  if (character == "\xD8\x9C") return true;  // U+061C
  if (character.size() != 3 || character[0] != '\xE2') return false;
  const auto second = static_cast<unsigned char>(character[1]);
  const auto third = static_cast<unsigned char>(character[2]);
  if (second == 0x80) return third == 0x8E || third == 0x8F || (third >= 0xAA && third <= 0xAE);
  return second == 0x81 && third >= 0xA6 && third <= 0xA9;
}

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return (first < 0x20 && first != '\t') || first == 0x7F;
  if (turns_direction(character)) return true;
  return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
}

/// Returns the text with U+FFFD for each control character except the tab and for each byte that is
/// not UTF-8: text of a program must not command a terminal.
std::string harmless(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const auto character = text.substr(0, std::max<std::size_t>(length, 1));
    clean += length == 0 || is_control(character) ? kReplacement : character;
    text.remove_prefix(character.size());
  }
  return clean;
}

/// Returns the size of the harmless text for the first `bytes` of a line.
int harmless_size(std::string_view line, int bytes) {
  const auto head = line.substr(0, static_cast<std::size_t>(std::max(bytes, 0)));
  return static_cast<int>(harmless(head).size()) +
         std::max(0, bytes - static_cast<int>(line.size()));
}

/// Returns the diagnostic with texts that may be shown, and its position within them.
Diagnostic harmless(const Diagnostic& d) {
  SourcePos pos = d.pos;
  if (pos.column > 0) {
    const int begin = harmless_size(d.source_line, pos.column - 1);
    pos.length = harmless_size(d.source_line, pos.column - 1 + pos.length) - begin;
    pos.column = begin + 1;
  }
  std::vector<CallPlace> calls = d.calls;
  for (CallPlace& call : calls) call.file = harmless(call.file);
  return {
      d.code,           pos,       harmless(d.message), harmless(d.file),  harmless(d.source_line),
      std::move(calls), d.subject, d.unreachable,       harmless(d.advice)};
}

/// Returns blanks as wide as the text is on a terminal; tabs stay tabs.
std::string blank(std::string_view text) {
  std::string blanks;
  while (!text.empty()) {
    const auto character = text.substr(0, std::max<std::size_t>(character_length(text), 1));
    if (character == "\t")
      blanks += '\t';
    else
      blanks.append(static_cast<std::size_t>(columns_of(character)), ' ');
    text.remove_prefix(character.size());
  }
  return blanks;
}

std::string caret_line(std::string_view line, const SourcePos& pos) {
  const auto begin = static_cast<std::size_t>(pos.column - 1);
  const auto length = static_cast<std::size_t>(std::max(pos.length, 0));
  const std::string_view before = line.substr(0, begin);
  const std::string after(begin - before.size(), ' ');
  const auto marked = begin < line.size() ? line.substr(begin, length) : std::string_view{};
  std::string tildes(std::max<std::size_t>(blank(marked).size(), 1), '~');
  tildes.front() = '^';
  return blank(before) + after + tildes;
}

/// Returns where a character begins, at a byte of the line or before it.
std::size_t character_at(std::string_view line, std::size_t byte) {
  while (byte > 0 && byte < line.size() && continues_character(line[byte])) --byte;
  return std::min(byte, line.size());
}

/// Returns the line and its caret; of a very long line, the part around the position.
std::string excerpt(std::string_view line, SourcePos pos) {
  constexpr std::size_t kLongest = 240, kBefore = 80, kShown = 160;  // bytes
  constexpr std::string_view kLeftOut = "...";
  const auto place = static_cast<std::size_t>(std::max(pos.column - 1, 0));
  std::string text(line);
  if (line.size() > kLongest) {
    const std::size_t last = line.size() - kShown;
    const std::size_t begin =
        place < kBefore ? 0 : character_at(line, std::min(place - kBefore, last));
    const std::size_t end = character_at(line, begin + kShown);
    text = line.substr(begin, end - begin);
    if (begin > 0) {
      text.insert(0, kLeftOut);
      pos.column -= static_cast<int>(begin) - static_cast<int>(kLeftOut.size());
    }
    pos.length = std::min(pos.length, static_cast<int>(text.size()) - pos.column + 1);
    if (end < line.size()) text += kLeftOut;
  }
  std::string shown = fmt::format("{:>5} | {}\n", pos.line, text);
  if (pos.column > 0) shown += fmt::format("      | {}\n", caret_line(text, pos));
  return shown;
}

/// Returns a number in which every bit depends on every input bit (the finalizer of SplitMix64).
constexpr std::uint64_t mixed(std::uint64_t x) noexcept {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

bool of_one_line(const SourcePos& a, const SourcePos& b) noexcept {
  return a.file == b.file && a.line == b.line;
}

}  // namespace

std::span<const CodeInfo> code_table() noexcept { return kTable; }

const CodeInfo& code_info(Code code) noexcept {
  const auto* row = std::lower_bound(std::begin(kTable), std::end(kTable), code,
                                     [](const CodeInfo& a, Code b) { return a.code < b; });
  assert(row != std::end(kTable) && row->code == code);
  return *row;
}

std::string_view name(Severity severity) noexcept {
  constexpr std::array<std::string_view, 3> names{"note", "warning", "error"};
  return names[static_cast<std::size_t>(severity)];
}

std::string code_name(Code code) { return fmt::format("SC{}", static_cast<int>(code)); }

Diagnostic shown(const Diagnostic& diagnostic) {
  Diagnostic d = harmless(diagnostic);
  if (d.pos.column <= 0) return d;
  const int begin = characters(d.source_line, d.pos.column - 1);
  const int end = characters(d.source_line, d.pos.column - 1 + d.pos.length);
  d.pos.column = begin + 1;
  d.pos.length = std::max(end - begin, 1);
  return d;
}

std::string render(const Diagnostic& diagnostic, Help help) {
  const Diagnostic d = harmless(diagnostic);
  std::string text = d.file.empty() ? "softcnc" : d.file;
  const int column = d.pos.column > 0 ? characters(d.source_line, d.pos.column - 1) + 1 : 0;
  if (d.pos.line > 0) text += fmt::format(":{}:{}", d.pos.line, std::max(column, 1));
  text += fmt::format(": {}: {} [{}]\n", name(d.severity()), d.message, code_name(d.code));
  if (d.pos.line > 0 && !d.source_line.empty()) text += excerpt(d.source_line, d.pos);
  const std::string_view advice = help == Help::always ? help_of(d) : std::string_view(d.advice);
  if (!advice.empty()) text += fmt::format("      = help: {}\n", advice);
  for (std::size_t i = 0, same = 0; i < d.calls.size(); i += same) {
    const CallPlace& call = d.calls[i];
    for (same = 1; i + same < d.calls.size() && d.calls[i + same] == call;) ++same;
    const std::string times = same > 1 ? fmt::format(", {} times", same) : "";
    text += fmt::format("{}:{}:{}: note: called from here{}\n", call.file, call.line, call.column,
                        times);
  }
  return text;
}

int exit_status(const Diagnostic& d) noexcept {
  if (d.severity() != Severity::error) return 0;
  const auto is_one_of = [&](auto... codes) { return ((d.code == codes) || ...); };
  if (d.code == Code::SC6023) return 1;
  if (is_one_of(Code::SC6014, Code::SC6050, Code::SC6060, Code::SC6062)) return 2;  // usage
  constexpr std::array<int, 10> by_family{70, 1, 1, 1, 3, 4, 5, 2, 70, 70};
  return by_family[static_cast<std::size_t>(static_cast<int>(d.code) / 1000) % 10];
}

int worse_status(int a, int b) noexcept {
  for (const int status : {70, 2, 5, 1, 3})
    if (a == status || b == status) return status;
  return std::max(a, b);
}

int Diagnostics::add_file(std::string file) {
  files_.push_back(std::move(file));
  return static_cast<int>(files_.size()) - 1;
}

void Diagnostics::enter_call(const SourcePos& place) {
  left_out_ += left_out_ > 0 || calls_.size() == kMostCalls ? 1 : 0;
  if (left_out_ > 0) return;
  const std::array<int, 4> key{call_, place.file, place.line, place.column};
  const auto [known, added] = call_index_.try_emplace(key, static_cast<int>(calls_.size()));
  if (added) calls_.push_back({call_, place});
  call_ = known->second;
}

void Diagnostics::leave_call() noexcept {
  if (left_out_ > 0)
    --left_out_;
  else
    call_ = calls_[static_cast<std::size_t>(call_)].within;
}

SourcePos Diagnostics::in_calls(SourcePos place) const noexcept {
  if (place.calls == 0) place.calls = call_;
  return place;
}

std::vector<CallPlace> Diagnostics::calls_to(const SourcePos& place) const {
  std::vector<CallPlace> calls;
  for (int call = place.calls; call != 0; call = calls_[static_cast<std::size_t>(call)].within) {
    const SourcePos& from = calls_[static_cast<std::size_t>(call)].place;
    calls.push_back({file(from.file), from.line, from.column});
  }
  return calls;
}

/// Remembers the position and returns whether it was known. For a line that makes many blocks, that
/// means that the same, or the same subject, was reported for the block before.
bool Diagnostics::is_repeated(const Diagnostic& d) {
  if (d.pos.line == 0) return false;
  std::uint64_t place = 0;
  for (const int part : {d.pos.file, d.pos.line, d.pos.column, static_cast<int>(d.code)})
    place = mixed(place ^ static_cast<std::uint32_t>(part));
  if (d.subject != 0) place = mixed(place ^ d.subject);
  const bool known = reported_.count(place) > 0;
  const bool as_before = known && place == last_place_ && d.message == last_message_;
  last_place_ = place;
  last_message_ = d.message;
  if (known) return lines_repeat_ || d.subject != 0 || as_before;
  if (reported_.size() < kRemembered) reported_.insert(place);
  return false;
}

void Diagnostics::report(Diagnostic diagnostic) {
  if (is_repeated(diagnostic)) return;
  if (holding_) diagnostic.pos = in_calls(diagnostic.pos);
  diagnostic.calls = calls_to(diagnostic.pos);
  if (diagnostic.file.empty())
    diagnostic.file = files_[static_cast<std::size_t>(diagnostic.pos.file)];
  count(diagnostic);
  if (!holding_) return deliver(std::move(diagnostic));
  if (!held_.empty() && !of_one_line(held_.front().pos, diagnostic.pos)) deliver_held();
  held_.push_back(std::move(diagnostic));
}

void Diagnostics::count(const Diagnostic& diagnostic) noexcept {
  if (diagnostic.severity() == Severity::error) ++errors_;
  status_ = worse_status(status_, exit_status(diagnostic));
}

void Diagnostics::pass_on(Diagnostic complete) {
  count(complete);
  deliver(std::move(complete));
}

void Diagnostics::deliver(Diagnostic diagnostic) {
  if (sink_)
    sink_(diagnostic);
  else
    kept_.push_back(std::move(diagnostic));
}

void Diagnostics::deliver_held() {
  const auto column = [](const Diagnostic& d) {
    return d.pos.column > 0 ? d.pos.column : std::numeric_limits<int>::max();
  };
  std::stable_sort(held_.begin(), held_.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return column(a) < column(b); });
  bool erroneous = false;
  for (Diagnostic& diagnostic : held_) {
    const bool error = diagnostic.severity() == Severity::error;
    if (error && std::exchange(erroneous, true)) continue;
    deliver(std::move(diagnostic));
  }
  held_.clear();
}

void Diagnostics::release() {
  holding_ = false;
  if (!held_.empty()) deliver_held();
}

void Diagnostics::report(Code code, SourcePos pos, std::string message,
                         std::string_view source_line) {
  report(Diagnostic{code, pos, std::move(message), {}, std::string(source_line)});
}

}  // namespace softcnc
