// SPDX-License-Identifier: MIT
#include "hal/signals/vcd_reader.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace softcnc::hal {
namespace {

constexpr std::string_view kVcdBlanks = " \t\r\n";
constexpr std::size_t kShown = 160;                 // bytes of a line
constexpr std::size_t kLongestVcdLine = 1U << 20U;  // bytes of a line: all of one is in memory
constexpr std::size_t kMostWords = 100;             // of a definition

struct Unit {
  std::string_view name;
  std::int64_t ns, per_ns;  // one of them is 1
};
constexpr Unit kUnits[] = {{"s", 1'000'000'000, 1}, {"ms", 1'000'000, 1},
                           {"us", 1000, 1},         {"ns", 1, 1},
                           {"ps", 1, 1000},         {"fs", 1, 1'000'000}};

/// Reads a whole number that is all of the text.
std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

/// The number of the line that has this name.
std::optional<unsigned> line_called(std::string_view name) {
  for (unsigned line = 0; line < kLineNumbers; line += 2) {
    const std::string known = line_name(line);
    if (name == known) return line;
    if ((line & 2U) != 0 && name == std::string_view(known).substr(0, 5)) return line;  // x_dir
  }
  return std::nullopt;
}

/// Of a long word the beginning.
std::string quoted_token(std::string_view token) {
  constexpr std::size_t kMost = 40;
  const bool is_long = token.size() > kMost;
  return "'" + std::string(token.substr(0, kMost)) + (is_long ? "...'" : "'");
}

}  // namespace

Status VcdReader::read(std::string_view bytes) {
  text_.erase(0, line_begin_);
  at_ -= std::exchange(line_begin_, 0);
  text_ += bytes;
  for (;;) {
    pass_blanks();
    const std::size_t end = text_.find_first_of(kVcdBlanks, at_);
    if (end == text_.npos) break;
    const Token token = std::string_view(text_).substr(at_, end - at_);
    if (auto taken = take(token); !taken) return taken;
    at_ = end;
  }
  return text_.size() - line_begin_ > kLongestVcdLine ? too_long() : Status();
}

Status VcdReader::too_long() const {
  return tl::make_unexpected(Diagnostic{.code = Code::SC6092,
                                        .pos = {line_number_, 1, 1},
                                        .message = "a line longer than 1 MiB",
                                        .source_line = std::string(line())});
}

void VcdReader::pass_blanks() {
  for (; at_ < text_.size() && kVcdBlanks.find(text_[at_]) != kVcdBlanks.npos; ++at_) {
    if (text_[at_] != '\n') continue;
    ++line_number_;
    line_begin_ = at_ + 1;
  }
}

Status VcdReader::finish() {
  const Token end = std::string_view(text_).substr(at_);
  if (!end.empty()) return failure(end, "not whole: it ends within a line");
  if (!defined_) return failure(end, "not whole: it ends within its definitions");
  if (!vector_.empty()) return failure(end, "not whole: it ends within a value");
  if (!within_.empty()) return failure(end, "not whole: it ends within " + within_);
  if (dumping_) return failure(end, "not whole: it ends within a dump of all values");
  return {};
}

std::string_view VcdReader::line() const {
  if (at_ - line_begin_ > kShown) return {};
  const std::string_view begin = std::string_view(text_).substr(line_begin_, kShown);
  return begin.substr(0, begin.find_first_of("\r\n"));
}

SourcePos VcdReader::place(Token token) const {
  return {line_number_, static_cast<int>(at_ - line_begin_) + 1,
          std::max(1, static_cast<int>(token.size()))};
}

Status VcdReader::failure(Token token, const std::string& why) const {
  return tl::make_unexpected(Diagnostic{.code = Code::SC6091,
                                        .pos = place(token),
                                        .message = why,
                                        .source_line = std::string(line())});
}

Status VcdReader::take(Token token) {
  if (!within_.empty()) return take_part(token);
  if (!vector_.empty()) return take_vector(token);
  if (token[0] == '$') return take_keyword(token);
  if (!defined_) return failure(token, quoted_token(token) + " among the definitions");
  return token[0] == '#' ? take_time(token) : take_level(token);
}

Status VcdReader::take_keyword(Token token) {
  constexpr std::string_view kDumps[] = {"$dumpvars", "$dumpall", "$dumpon", "$dumpoff"};
  if (std::find(std::begin(kDumps), std::end(kDumps), token) != std::end(kDumps)) {
    if (!defined_) return failure(token, quoted_token(token) + " among the definitions");
    dumping_ = true;
  } else if (token == "$end") {
    if (!std::exchange(dumping_, false)) return failure(token, "an $end without a beginning");
  } else {
    within_ = token;
    words_.clear();
  }
  return {};
}

/// A word of what a keyword began.
Status VcdReader::take_part(Token token) {
  if (token == "$end") return end_definition(token);
  const bool counts = within_ == "$var" || within_ == "$timescale";
  if (!counts) return {};
  if (words_.size() >= kMostWords) return failure(token, "too many words after " + within_);
  words_.emplace_back(token);
  return {};
}

Status VcdReader::end_definition(Token token) {
  const std::string keyword = std::exchange(within_, {});
  if (keyword == "$timescale") return end_timescale(token);
  if (keyword == "$var") return end_variable(token);
  if (keyword == "$enddefinitions") {
    if (unit_ == 0) return failure(token, "no $timescale");
    if (lines_.empty())
      return failure(token, "no variable is called x_step, x_direction, y_step, ...");
    defined_ = true;
  }
  return {};
}

/// "1 ns", "10us"
Status VcdReader::end_timescale(Token token) {
  std::string text;
  for (const std::string& word : words_) text += word;
  const auto digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto count = whole(std::string_view(text).substr(0, digits));
  const auto* unit = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit& known) {
    return known.name == std::string_view(text).substr(digits);
  });
  if (unit == std::end(kUnits) || !count || (*count != 1 && *count != 10 && *count != 100))
    return failure(
        token, "$timescale takes 1, 10 or 100 s, ms, us, ns, ps or fs, not " + quoted_token(text));
  unit_ = unit->ns * *count;
  per_ns_ = unit->per_ns;
  return {};
}

/// type size short name [range]
Status VcdReader::end_variable(Token token) {
  if (words_.size() < 4) return failure(token, "$var takes a type, a size and two names");
  const auto line = line_called(words_[3]);
  if (!line) return {};
  if (words_[1] != "1") return failure(token, words_[3] + " is not one bit");
  const auto [known, is_new] = lines_.try_emplace(words_[2], *line);
  const bool twice = std::count_if(lines_.begin(), lines_.end(),
                                   [&](const auto& other) { return other.second == *line; }) > 1;
  if (twice || known->second != *line) return failure(token, words_[3] + " is there twice");
  return {};
}

Status VcdReader::take_time(Token token) {
  const auto units = whole(token.substr(1));
  std::int64_t ns = 0;
  if (!units || __builtin_mul_overflow(*units, unit_, &ns))
    return failure(token, quoted_token(token) + " is not a time");
  time_ = per_ns_ == 1 ? ns : ns / per_ns_ + (ns % per_ns_ >= per_ns_ / 2 ? 1 : 0);
  return {};
}

Status VcdReader::take_level(Token token) {
  constexpr std::string_view kLevels = "01xXzZ", kVectors = "bBrRsS";
  const bool is_vector = kVectors.find(token[0]) != kVectors.npos;
  if (token.size() == 1 || (!is_vector && kLevels.find(token[0]) == kLevels.npos))
    return failure(token, quoted_token(token) + " is not a value of a variable");
  if (is_vector) vector_ = token;
  return is_vector ? Status() : set(token.substr(1), token[0], token);
}

/// The variable of a value that stands ahead of it: b1, of one bit.
Status VcdReader::take_vector(Token token) {
  const std::string value = std::exchange(vector_, {});
  return set(token, value.size() == 2 ? value[1] : 'x', token);
}

/// The variable has this value from now on. Its first one may be unknown.
Status VcdReader::set(std::string_view variable, char value, Token token) {
  const auto line = lines_.find(variable);
  if (line == lines_.end()) return {};
  if (value == '0' || value == '1')
    set(line->second, value == '1', token);
  else if (level_[line->second])
    return failure(token, line_name(line->second) + " is neither high nor low");
  return {};
}

/// A dump repeats levels, and the first one shows how lines begin.
void VcdReader::set(unsigned line, bool high, Token token) {
  const auto before = std::exchange(level_[line], high);
  if (dumping_ && before == high) return;
  const bool begins = !before && (dumping_ || !high);
  visit_({edge_of(line, time_, high), place(token), this->line(), begins});
}

}  // namespace softcnc::hal
