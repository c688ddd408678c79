// SPDX-License-Identifier: MIT
#include "ipr/lines/integer_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

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

/// Dwells and switches: their letters are no lengths.
bool has_no_lengths(const ProgramLine& line) noexcept {
  constexpr double kCodes[] = {4, 5, 5.1, 8, 66, 66.1};
  return std::any_of(std::begin(kCodes), std::end(kCodes),
                     [&](double code) { return has_code(line, 'G', code); });
}

bool begins_cycle(const ProgramLine& line) noexcept {
  return std::any_of(line.words.begin(), line.words.end(), [](const Word& word) {
    return word.letter == 'G' && word.value >= 73 && word.value <= 89 && word.value != 80;
  });
}

/// Haas' G70 to G72, whose J and K are angles.
bool has_hole_pattern(const ProgramLine& line) noexcept {
  return has_code(line, 'G', 70) || has_code(line, 'G', 71) || has_code(line, 'G', 72);
}

/// K may be a number of repetitions, on Haas' controls a peck, or a knot, R a weight or an angle,
/// I J K factors.
LetterSet lengths_beside_angles(const ProgramLine& line, const LengthContext& context) noexcept {
  if (context.in_curve || has_code(line, 'G', 6.2)) return {"XYZ"};
  if (has_code(line, 'G', 68) || has_code(line, 'G', 51)) return {"XYZ"};
  if (context.of_haas && has_hole_pattern(line)) return {"XYZRQI"};
  const bool pecks = has_code(line, 'G', 73) || has_code(line, 'G', 83) || !begins_cycle(line);
  const LetterSet of_cycle{context.of_haas && pecks ? "XYZRQIJK" : "XYZRQIJ"};
  if (begins_cycle(line)) return of_cycle;
  if (has_code(line, 'G', 12) || has_code(line, 'G', 13)) return {"XYZIKQ"};
  const bool leaves_cycle = has_code(line, 'G', 80) || has_code(line, 'G', 0) ||
                            has_code(line, 'G', 1) || has_code(line, 'G', 2) ||
                            has_code(line, 'G', 3);
  return context.in_cycle && !leaves_cycle ? of_cycle : LetterSet("XYZIJKR");
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

bool is_whole(const ProgramLine& line, const Word& word) noexcept {
  return !has_point(line, word) && !is_computed(line, word);
}

/// The words after G65.
std::span<const Word> arguments_of(const ProgramLine& line) noexcept {
  const auto call = std::find_if(line.words.begin(), line.words.end(),
                                 [](const Word& word) { return is_code(word, 'G', 65); });
  return line.words.subspan(static_cast<std::size_t>(call - line.words.begin()));
}

void add(IntegerWords& words, const ProgramLine& line, const Word& word, double increment) {
  if (words.lines == 0) {
    words.first = word.pos;
    words.text = line.text;
    words.word = word.letter + number_text(word.value);
    words.value = word.value;
    words.increment = increment;
  }
  const std::pair<int, int> place{word.pos.file, word.pos.line};
  if (place == std::exchange(words.last, place)) return;
  ++words.lines;
}

void report_words(IntegerWords& words, std::string_view what, Diagnostics& diagnostics) {
  const std::int64_t more = words.lines - 1;
  std::string message = words.word + " without a decimal point is ";
  message += what;
  if (more > 0)
    message +=
        " (here and on " + std::to_string(more) + (more == 1 ? " more line)" : " more lines)");
  words.lines = 0;
  diagnostics.report(Code::SC1057, words.first, std::move(message), words.text);
}

constexpr LetterSet kArguments{"ABCIJKQRUVWXYZ"};  // that may count increments

}  // namespace

const ProgramLine& IntegerLengths::read(const ProgramLine& line, const LengthContext& context) {
  if (line.words.empty() || has_no_lengths(line)) return line;
  if (has_code(line, 'G', 65)) return with_arguments(line, context);
  if (unit_ != IntegerUnit::units && !line.broken && is_new(line)) see_lengths(line, context);
  if (unit_ != IntegerUnit::increments) return line;
  return scaled(line, lengths_of(line, context), increment_of(line, context));
}

/// The words before G65 stay as they are.
const ProgramLine& IntegerLengths::with_arguments(const ProgramLine& line,
                                                  const LengthContext& context) {
  if (unit_ == IntegerUnit::units) return line;
  const double increment = increment_of(line, context);
  const auto arguments = arguments_of(line);
  if (unit_ == IntegerUnit::unstated && !line.broken && is_new(line))
    for (const Word& word : arguments)
      if (kArguments.has(word.letter) && word.value != 0 && is_whole(line, word))
        add(arguments_, line, word, increment);
  words_.assign(line.words.begin(), line.words.end());
  for (std::size_t i = words_.size() - arguments.size(); i < words_.size(); ++i)
    if (kArguments.has(words_[i].letter) && is_whole(line, words_[i])) words_[i].value *= increment;
  line_ = line;
  line_.words = words_;
  return line_;
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

void IntegerLengths::see_lengths(const ProgramLine& line, const LengthContext& context) {
  const LetterSet lengths = lengths_of(line, context);
  for (const Word& word : line.words) {
    if (word.value == 0 || is_computed(line, word)) continue;
    if (word.letter == 'F' && context.of_haas && !has_point(line, word)) add(feeds_, line, word, 1);
    if (!lengths.has(word.letter)) continue;
    points_ = points_ || has_point(line, word);
    if (has_point(line, word)) continue;
    const double size = std::abs(word.value);
    smallest_ = lengths_.lines == 0 ? size : std::min(smallest_, size);
    add(lengths_, line, word, increment_of(line, context));
  }
}

const ProgramLine& IntegerLengths::scaled(const ProgramLine& line, LetterSet letters,
                                          double increment) {
  words_.assign(line.words.begin(), line.words.end());
  for (Word& word : words_)
    if (letters.has(word.letter) && is_whole(line, word)) word.value *= increment;
  line_ = line;
  line_.words = words_;
  if (line.corner != nullptr && is_whole(line, *line.corner)) {
    corner_ = *line.corner;
    corner_.value *= increment;
    line_.corner = &corner_;
  }
  return line_;
}

void IntegerLengths::report_lengths(Diagnostics& diagnostics) {
  const bool likely = points_ || smallest_ >= kLarge;
  if (unit_ != IntegerUnit::unstated || lengths_.lines == 0 || !likely) return;
  const std::string unit = lengths_.increment == kMetric ? " mm" : " inch";
  report_words(lengths_,
               number_text(lengths_.value) + unit + "; a control that counts increments goes " +
                   exact_text(lengths_.value * lengths_.increment) + unit,
               diagnostics);
}

void IntegerLengths::report(Diagnostics& diagnostics) {
  report_lengths(diagnostics);
  if (arguments_.lines > 0)
    report_words(arguments_,
                 "the argument " + exact_text(arguments_.value * arguments_.increment) +
                     ", in increments; a control that counts units passes " +
                     number_text(arguments_.value),
                 diagnostics);
  if (feeds_.lines > 0)
    report_words(
        feeds_,
        "a feed of " + number_text(feeds_.value) +
            "; setting 77 of a Haas control may make it a tenth to a ten-thousandth of that",
        diagnostics);
}

}  // namespace softcnc::ipr
