// SPDX-License-Identifier: MIT
// Sorts the words of a line and finds what contradicts itself.
#include "ipr/lines/command.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/lines/operands.hpp"
#include "ipr/text/number.hpp"
#include "ipr/text/text_errors.hpp"
#include "motion/model/machine_code.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kTwoDigits = 10;  // a code below is one digit, whatever zeros stand before it

void report_twice(const Word& word, Output& out) {
  out.report(Code::SC2003, word.pos, std::string(1, word.letter) + " is given twice");
}

/// G38.2 to G38.9; G31 of FANUC.
bool is_probing(const Word& word, Dialect dialect) noexcept {
  const double code = is_fanuc_like(dialect) ? 31 : 38;
  return word.letter == 'G' && std::floor(word.value) == code;
}

bool may_be_of_machine(const Word& word) noexcept {
  return word.letter == 'M' && word.value > 0 && word.value <= kLastMachineCode &&
         word.value == std::floor(word.value);
}

bool is_of_other(const GCode& code, Dialect dialect) noexcept {
  if (dialect == Dialect::haas) return false;
  return is_of_haas(code) || (!is_fanuc_like(dialect) && is_of_fanuc(code));
}

/// The three lines of a machine file that define this M code. Words of its line that seldom belong
/// to another code are taken for its own.
std::string lines_of_machine(const Word& code, std::span<const Word> words) {
  std::string letters;
  for (const Word& word : words)
    if (LetterSet("PQELRH").has(word.letter) && letters.find(word.letter) == letters.npos)
      letters += word.letter;
  return "; if the machine has it, its machine file says so in three lines: [mcode." +
         number_text(code.value) + "] | do = \"ignore\" | words = \"" + letters + "\"";
}

/// The '#' of an assignment outside comments; column 0: there is none.
SourcePos assignment_in(const ProgramLine& line) noexcept {
  bool comment = false;
  SourcePos sign = line.words.front().pos;
  sign.column = 0;
  sign.length = 1;
  for (std::size_t i = 0; i < line.text.size() && line.text[i] != ';'; ++i) {
    const char c = line.text[i];
    comment = c == '(' || (comment && c != ')');
    if (comment) continue;
    if (c == '#') sign.column = static_cast<int>(i) + 1;
    if (c == '=') return sign;
  }
  sign.column = 0;
  return sign;
}

/// G70 and G71 are the units of Mach3, PlanetCNC and DIN 66025.
constexpr double kInches = 70, kMillimetres = 71;
bool is_unit_of_others(const Word& word) {
  return word.letter == 'G' && (word.value == kInches || word.value == kMillimetres);
}

/// Blanks within a number count nothing; but after the digits of a code a letter may be missing.
[[gnu::cold]] void warn_of_blank(const Word& word, Output& out) {
  const std::string written(out.text().substr(static_cast<std::size_t>(word.pos.column - 1),
                                              static_cast<std::size_t>(word.pos.length)));
  const std::size_t blank = written.find_first_of(kBlanks);
  if (blank == std::string::npos || !is_digit(written[1])) return;
  out.report(Code::SC1061, word.pos,
             "'" + written + "' is read as " + code_name(word.letter, word.value) +
                 "; is a letter missing before " +
                 std::string(without_blanks_around(std::string_view(written).substr(blank))) + "?");
}

}  // namespace

void Command::read(const ProgramLine& line, Dialect dialect, Output& out) {
  values_.letters_ = {};
  count_ = 0;
  groups_ = {};
  unread_ = line.unread;
  unknown_ = {};
  probes_ = calls_macro_ = polar_ = false;
  below_cycle_ = nullptr;
  called_ = line.called;
  words_ = line.words;
  corner_ = line.corner;
  for (const Word& word : line.words) {
    is_code_letter(word.letter) ? read_code(word, dialect, out) : read_value(word, out);
    if (!calls_macro_) continue;
    read_arguments(line.words.subspan(static_cast<std::size_t>(&word - line.words.data()) + 1),
                   out);
    break;
  }
  if (has(Group::program_number)) check_program_number(line, out);
  if (values_.letters_.has_any(kPolarWords)) take_polar_words();
  if (unread_.has_any(kPolarWords)) lose_polar_words();
  if (!unread_.empty()) unknown_ |= set_by(unread_);
  if (unknown_.has(Part::motion)) unknown_ |= set_by(values_.letters_);
}

[[gnu::always_inline]] inline void Command::read_code(const Word& word, Dialect dialect,
                                                      Output& out) {
  const GCode* code = find_gcode(word.letter, word.value);
  if (word.letter == 'M' && (code == nullptr || is_of_haas(*code)))
    if (const GCode* own = find_machine_code(machine_codes_, word.value)) code = own;
  const bool of_other = code != nullptr && is_of_other(*code, dialect);
  const bool of_machine = word.letter == 'M' && of_other && is_of_haas(*code);  // it may be
  if (code == nullptr || of_other) {
    report_unknown(word, of_other && !of_machine ? name(dialect) : std::string_view{}, out);
    unknown_ |= word.letter == 'G' ? Unknown{Part::motion} : set_by("M");
    probes_ = probes_ || is_probing(word, dialect);
    return;
  }
  const bool is_code = word.letter == 'G' || word.letter == 'M';
  if (is_code && word.value >= kTwoDigits) warn_of_blank(word, out);
  if (is_probing_move(*code)) probes_ = probes_ || is_probing(word, dialect);
  calls_macro_ = calls_macro(*code);
  if (!has(code->group)) return add(*code, word);
  if (is_fanuc_like(dialect) && put_above(*code, word)) return;
  unknown_ |= settled(*code);
  if (code->number == kAnyNumber) return report_twice(word, out);
  out.report(Code::SC2002, word.pos,
             code_name(*code) + " conflicts with another code of its group on this line");
}

[[gnu::cold]] void Command::report_unknown(const Word& word, std::string_view dialect,
                                           Output& out) {
  std::string message = code_name(word.letter, word.value) + " is not supported";
  if (!dialect.empty()) message += " in the " + std::string(dialect) + " dialect";
  if (dialect.empty() && may_be_of_machine(word)) message += lines_of_machine(word, words_);
  if (is_unit_of_others(word)) message += word.value == kInches ? "; G20 is inch" : "; G21 is mm";
  out.report(Code::SC2001, word.pos, std::move(message));
}

/// After G65 and its like only P and L are words of the line's own.
void Command::read_arguments(std::span<const Word> words, Output& out) {
  arguments_ = words;
  for (const Word& word : words)
    if (word.letter == 'P' || word.letter == 'L') read_value(word, out);
}

[[gnu::hot]] void Command::read_value(const Word& word, Output& out) {
  if (values_.has(word.letter)) {
    unread_.add(word.letter);
    return report_twice(word, out);
  }
  values_.letters_.add(word.letter);
  values_.words_[Values::index(word.letter)] = &word;
}

[[gnu::cold]] void Command::take_polar_words() {
  polar_ = true;
  for (const char letter : {'@', '^'})
    polar_words_[letter == '@' ? 0 : 1] = values_.has(letter) ? &values_.word(letter) : nullptr;
  values_.letters_ = values_.letters_.without(kPolarWords);
}

[[gnu::cold]] void Command::replace_polar_words(const PlaneAxes& axes) {
  const Word* const radius = polar_words_[0];
  const Word* const angle = polar_words_[1];
  set_axis(axes.first, 0, radius != nullptr ? *radius : *angle);
  set_axis(axes.second, 0, angle != nullptr ? *angle : *radius);
}

[[gnu::cold]] void Command::lose_polar_words() {
  unread_ |= kAxisWords;
  unknown_ |= set_by(kAxisWords);
}

void Command::set_axis(int axis, double value, const Word& like) {
  const char letter = axis_letter(axis);
  Word& own = axis_words_[static_cast<std::size_t>(axis)];
  if (values_.has(letter)) {
    own = values_.word(letter);
  } else {
    own = like;
    values_.letters_.add(letter);
  }
  own.value = value;
  values_.words_[Values::index(letter)] = &own;
}

/// O names the program; only a line number may stand beside it.
void Command::check_program_number(const ProgramLine& line, Output& out) {
  const auto& words = line.words;
  const auto number =
      std::find_if(words.begin(), words.end(), [](const Word& word) { return word.letter == 'O'; });
  const auto other = std::find_if(words.begin(), words.end(), [](const Word& word) {
    return word.letter != 'O' && word.letter != 'N';
  });
  const SourcePos assigned = assignment_in(line);
  if (other == words.end() && assigned.column == 0) return;
  const SourcePos first = other == words.end() ? assigned : other->pos;
  const bool after = first.column < number->pos.column;
  unknown_.add(Part::motion);
  out.report(Code::SC2006, after ? number->pos : first,
             std::string("O stands alone on its line") + (after ? kLetterForDigit : ""));
}

[[gnu::hot]] void Command::add(const GCode& code, const Word& word) {
  std::size_t at = count_++;
  for (; at > 0 && codes_[at - 1].code->order > code.order; --at) codes_[at] = codes_[at - 1];
  codes_[at] = {&code, &word};
  groups_.add(code.group);
}

/// FANUC: a cycle counts rather than the G00 to G03 before it.
bool Command::put_above(const GCode& cycle, const Word& word) {
  const auto motion = std::find_if(codes_.begin(), codes_.begin() + count_, [](const auto& code) {
    return code.code->group == Group::motion;
  });
  if (!is_canned_cycle(cycle) || !is_line_or_arc(*motion->code)) return false;
  below_cycle_ = motion->code;
  *motion = {&cycle, &word};
  return true;
}

void Command::add_lone_letters(Dialect dialect) {
  if (!is_fanuc_like(dialect) || !values_.letters().has_any(kLoneLetters)) return;
  const LetterSet lone = unused(dialect);
  for (const char letter : {'D', 'H'})
    if (lone.has(letter)) add(*find_gcode(letter, 0), values_.word(letter));
}

const GCode* Command::find(Group group) const noexcept {
  if (!has(group)) return nullptr;
  for (const CodeWord& code : codes())
    if (code.code->group == group) return code.code;
  return nullptr;
}

const Word& Command::find_word(Group group) const noexcept {
  const auto all = codes();
  return *std::find_if(all.begin(), all.end(), [&](const CodeWord& code) {
            return code.code->group == group;
          })->word;
}

[[gnu::hot]] LetterSet Command::unused(Dialect dialect) const noexcept {
  LetterSet used;
  for (const CodeWord& code : codes()) {
    used |= LetterSet(code.code->words);
    if (is_fanuc_like(dialect)) used |= LetterSet(code.code->fanuc_words);
    if (dialect == Dialect::haas) used |= LetterSet(code.code->haas_words);
  }
  return values_.letters().without(used);
}

}  // namespace softcnc::ipr
