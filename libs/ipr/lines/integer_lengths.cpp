// SPDX-License-Identifier: MIT
#include "ipr/lines/integer_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kMetric = 0.001, kInch = 0.0001;  // units of an increment
constexpr double kLarge = 100;                     // units: larger than most lengths of parts

bool is_code(const Word& word, char letter, double number) noexcept {
  return word.letter == letter && word.value == number;
}

bool has_code(const ProgramLine& line, char letter, double number) noexcept {
  return std::any_of(line.words.begin(), line.words.end(),
                     [&](const Word& word) { return is_code(word, letter, number); });
}

/// Dwells, arguments and switches: their letters are no lengths.
bool has_no_lengths(const ProgramLine& line) noexcept {
  constexpr double kCodes[] = {4, 5, 5.1, 8, 65, 66, 66.1};
  return std::any_of(std::begin(kCodes), std::end(kCodes),
                     [&](double code) { return has_code(line, 'G', code); });
}

bool begins_cycle(const ProgramLine& line) noexcept {
  return std::any_of(line.words.begin(), line.words.end(), [](const Word& word) {
    return word.letter == 'G' && word.value >= 73 && word.value <= 89 && word.value != 80;
  });
}

/// K may be a number of repetitions or a knot, R a weight or an angle, I J K factors.
LetterSet lengths_beside_angles(const ProgramLine& line, const LengthContext& context) noexcept {
  if (context.in_curve || has_code(line, 'G', 6.2)) return {"XYZ"};
  if (has_code(line, 'G', 68) || has_code(line, 'G', 51)) return {"XYZ"};
  if (begins_cycle(line)) return {"XYZRQIJ"};
  if (has_code(line, 'G', 12) || has_code(line, 'G', 13)) return {"XYZIKQ"};
  const bool leaves_cycle = has_code(line, 'G', 80) || has_code(line, 'G', 0) ||
                            has_code(line, 'G', 1) || has_code(line, 'G', 2) ||
                            has_code(line, 'G', 3);
  return context.in_cycle && !leaves_cycle ? LetterSet("XYZRQIJ") : LetterSet("XYZIJKR");
}

/// The letters of lengths on this line.
LetterSet lengths_of(const ProgramLine& line, const LengthContext& context) noexcept {
  const LetterSet letters = lengths_beside_angles(line, context);
  const bool polar = has_code(line, 'G', 16) || (context.polar && !has_code(line, 'G', 15));
  return polar ? letters.without(std::string_view(&context.angle, 1)) : letters;
}

double increment_of(const ProgramLine& line, const LengthContext& context) noexcept {
  if (has_code(line, 'G', 20)) return kInch;
  if (has_code(line, 'G', 21)) return kMetric;
  return context.mm_per_unit == 1 ? kMetric : kInch;
}

/// With all the digits of an increment.
std::string exact_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

std::string_view text_of(const ProgramLine& line, const Word& word) noexcept {
  return line.text.substr(static_cast<std::size_t>(word.pos.column) - 1,
                          static_cast<std::size_t>(word.pos.length));
}

bool has_point(const ProgramLine& line, const Word& word) noexcept {
  return text_of(line, word).find('.') != std::string_view::npos;
}

bool is_computed(const ProgramLine& line, const Word& word) noexcept {
  return text_of(line, word).find_first_of("#[") != std::string_view::npos;
}

}  // namespace

const ProgramLine& IntegerLengths::read(const ProgramLine& line, const LengthContext& context) {
  if (line.words.empty() || has_no_lengths(line)) return line;
  if (unit_ == IntegerUnit::increments) return scaled(line, context);
  if (line.broken) return line;
  if (!is_new(line)) return line;
  const LetterSet lengths = lengths_of(line, context);
  for (const Word& word : line.words)
    if (lengths.has(word.letter) && word.value != 0) see(line, word, context);
  return line;
}

/// Loops and calls read a line more than once.
bool IntegerLengths::is_new(const ProgramLine& line) {
  constexpr std::size_t kMostLines = 4'000'000;  // later ones are passed over
  const auto number = static_cast<std::size_t>(std::max(line.number, 0));
  if (number >= kMostLines) return false;
  std::vector<bool>& seen = seen_[line.words.front().pos.file];
  if (number >= seen.size()) seen.resize(std::max<std::size_t>(2 * number, 64));
  if (seen[number]) return false;
  seen[number] = true;
  return true;
}

void IntegerLengths::see(const ProgramLine& line, const Word& word, const LengthContext& context) {
  if (is_computed(line, word)) return;
  if (has_point(line, word)) {
    points_ = true;
    return;
  }
  const double size = std::abs(word.value);
  smallest_ = lines_ == 0 ? size : std::min(smallest_, size);
  if (lines_ == 0) {
    first_ = word.pos;
    text_ = line.text;
    word_ = word.letter + number_text(word.value);
    value_ = word.value;
    increment_ = increment_of(line, context);
    unit_name_ = increment_ == kMetric ? " mm" : " inch";
    last_counted_ = {};
  }
  const std::pair<int, int> place{word.pos.file, word.pos.line};
  if (place == last_counted_) return;
  last_counted_ = place;
  ++lines_;
}

const ProgramLine& IntegerLengths::scaled(const ProgramLine& line, const LengthContext& context) {
  const LetterSet lengths = lengths_of(line, context);
  const double increment = increment_of(line, context);
  words_.assign(line.words.begin(), line.words.end());
  for (Word& word : words_)
    if (lengths.has(word.letter) && !has_point(line, word) && !is_computed(line, word))
      word.value *= increment;
  line_ = line;
  line_.words = words_;
  if (line.corner != nullptr && !has_point(line, *line.corner) &&
      !is_computed(line, *line.corner)) {
    corner_ = *line.corner;
    corner_.value *= increment;
    line_.corner = &corner_;
  }
  return line_;
}

void IntegerLengths::report(Diagnostics& diagnostics) {
  if (lines_ == 0 || (!points_ && smallest_ < kLarge)) return;
  const std::int64_t more = lines_ - 1;
  std::string message = word_ + " without a decimal point is " + number_text(value_) + unit_name_;
  message +=
      "; a control that counts increments goes " + exact_text(value_ * increment_) + unit_name_;
  if (more > 0)
    message +=
        " (here and on " + std::to_string(more) + (more == 1 ? " more line)" : " more lines)");
  lines_ = 0;
  diagnostics.report(Code::SC1057, first_, std::move(message), text_);
}

}  // namespace softcnc::ipr
