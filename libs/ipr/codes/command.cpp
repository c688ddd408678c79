// SPDX-License-Identifier: MIT
// Sorts the words of a line and finds what contradicts itself.
#include "ipr/codes/command.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ipr/codes/handlers.hpp"
#include "ipr/codes/lost_codes.hpp"
#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

constexpr Letters kAfterUnknownCode{"GXYZ"};  // what it would have done is not known
constexpr double kLargeMCode = 100;  // likewise, but for the user's own: `M100` may be an F
constexpr double kLargeCode = 200;   // from here on no control has codes: `G400` may be an F
constexpr Groups kMoving{Group::motion, Group::cycle, Group::non_modal};
constexpr Groups kWithWords{Group::cutter_compensation, Group::tool_length, Group::path_control,
                            Group::surface};

/// Of a word that is not going to act.
void check_value(const Word& word, Output& out) {
  if (word.letter == 'F' || word.letter == 'S') is_not_negative(out, word);
  if (word.letter == 'T') whole_number(out, word);
}

void report_twice(const Word& word, Output& out) {
  out.report(Code::SC2003, word.pos, std::string(1, word.letter) + " is given twice");
}

/// G38.2 to G38.9; G31 of FANUC.
bool probes(const Word& word, Dialect dialect) noexcept {
  const double code = dialect == Dialect::fanuc ? 31 : 38;
  return word.letter == 'G' && std::floor(word.value) == code;
}

/// M70 to M73, whatever the letter.
bool saves_or_restores(double number) noexcept {
  constexpr double kM70 = 70, kM73 = 73;
  return number >= kM70 && number <= kM73;
}

/// 32, 530, 3, 999: of M codes that are unknown; M99 ends a program, too.
bool resembles_end(double number) noexcept {
  const std::string written = number_text(number);
  const auto differs_in_one = [&](std::string_view end) {
    if (written.size() == end.size()) return (written[0] != end[0]) + (written[1] != end[1]) == 1;
    if (written.size() != end.size() + 1) return false;
    for (std::size_t extra = 0; extra < written.size(); ++extra)
      if (std::string(written).erase(extra, 1) == end) return true;
    return false;
  };
  return differs_in_one("30") || differs_in_one("99") ||
         (written.size() == 2 && written[1] == '2') || (written.size() == 2 && written[0] == '2');
}

}  // namespace

void Command::read(const Line& line, Dialect dialect, Output& out) {
  values_.letters_ = {};
  count_ = 0;
  groups_ = {};
  uncertain_ = line.lost;
  missing_ = {};
  doubted_ = contradicted_ = {};
  doubled_ = unknown_code_ = false;
  lost_touch_ = may_be_end_ = false;
  lost_all_ = stands_for_value_ = false;
  calls_macro_ = false;
  below_cycle_ = nullptr;
  called_ = line.called;
  for (const Word& word : line.words) {
    is_code_letter(word.letter) ? read_code(word, dialect, out) : read_value(word, out);
    if (!calls_macro_) continue;
    read_arguments(line.words.subspan(static_cast<std::size_t>(&word - line.words.data()) + 1),
                   out);
    break;
  }
  if (line.lone_number && line.words.empty() && line.doubtful.empty())
    may_be_end_ = is_end(std::abs(*line.lone_number)) || resembles_end(std::abs(*line.lone_number));
  if (has(Group::program_number)) check_program_number(line, out);
  if (!line.doubtful.empty() && !calls_macro_) look_at(line.doubtful, dialect, out);
  if (line.broken) doubt_lost_codes(line);
  if (stands_for_value_ || doubled_) doubt_missing();
}

/// What codes would have done that are told is not known: of a code that moves, where it leads.
[[gnu::cold]] void Command::doubt(Groups groups) noexcept {
  doubted_ |= groups;
  if (groups.has_any(kMoving)) uncertain_ |= kAfterUnknownCode;
}

[[gnu::cold]] void Command::doubt_motion() noexcept {
  contradicted_.add(Group::motion);
  doubt({Group::motion});
}

/// A code that takes no words leaves the others to the motion in force.
[[gnu::cold]] void Command::doubt_lost_codes(const Line& line) noexcept {
  const Groups lost = lost_groups(line);
  const bool takes_words = lost.has_any(kMoving) || lost.has_any(kWithWords);
  lost_all_ = line.lost == kAllLetters;
  if (!lost_all_ && !lost.empty() && !takes_words) uncertain_.remove('G');
  doubt(lost);
}

/// A feed, a speed and a tool may stand anywhere, but seldom do beside codes that need none: as
/// `R600` beside modes.
Letters Command::words_meant() const noexcept {
  constexpr int kG00 = 0;
  constexpr double kFeed = 10;
  const GCode* motion = find(Group::motion);
  const bool words_alone = count_ == (has(Group::line_number) ? 1 : 0);
  bool may_be_feed = words_alone || (motion != nullptr && motion->number != kG00);
  for (char letter = 'A'; letter <= 'Z' && motion == nullptr; ++letter)
    may_be_feed = may_be_feed || (values_.has(letter) && values_[letter] >= kFeed);
  Letters meant{"XYZ"};
  if (may_be_feed) meant.add('F');
  if (words_alone || has(Group::spindle)) meant.add('S');
  if (words_alone || has(Group::tool_change)) meant.add('T');
  return meant;
}

[[gnu::cold]] void Command::doubt_missing() noexcept {
  constexpr Groups kKept{Group::cutter_compensation, Group::tool_length, Group::non_modal};
  Letters missing = stands_for_value_ ? Letters("FSTXYZ") : words_meant();
  Letters given = values_.letters();
  for (const CodeWord& code : codes()) {
    missing |= Letters(code.code->words);
    given.add(code.code->letter);
    if (kKept.has(code.code->group)) doubted_ |= {code.code->group};
  }
  missing_ = missing.without(given);
}

Letters Command::lastingly_uncertain() const noexcept {
  Letters uncertain = uncertain_;
  uncertain |= missing_;
  if (!lost_all_ && !doubted_.has_any(kMoving)) uncertain.remove('G');
  return uncertain;
}

/// Tells what is wrong with words that are not going to act.
[[gnu::cold]] void Command::look_at(std::span<const Word> words, Dialect dialect, Output& out) {
  const Command before = *this;
  for (const Word& word : words) {
    const std::size_t codes = count_;
    is_code_letter(word.letter) ? read_code(word, dialect, out) : read_value(word, out);
    if (count_ > codes) check_value(word, out);
    if (calls_macro_) break;
  }
  *this = before;
}

[[gnu::always_inline]] inline void Command::read_code(const Word& word, Dialect dialect,
                                                      Output& out) {
  const GCode* code = find_gcode(word.letter, word.value);
  if (code == nullptr) {
    out.report(Code::SC2001, word.pos, code_name(word.letter, word.value) + " is not supported");
    unknown_code_ = true;
    uncertain_ |= word.letter == 'G' ? kAfterUnknownCode : Letters("M");
    if (word.letter == 'G') doubt(groups_of_code(word.value));
    if (saves_or_restores(word.value)) uncertain_.add('M');
    stands_for_value_ = stands_for_value_ || (word.letter == 'G' && word.value >= kLargeCode);
    if (word.letter == 'M' && word.value >= kLargeMCode) missing_ |= Letters("FS");
    lost_touch_ = lost_touch_ || probes(word, dialect);
    may_be_end_ = may_be_end_ || (word.letter == 'M' && resembles_end(word.value));
    return;
  }
  if (code->act == refuse_signal) may_be_end_ = may_be_end_ || resembles_end(word.value);
  calls_macro_ = calls_macro(*code);
  if (!has(code->group)) return add(*code, word);
  if (dialect == Dialect::fanuc && put_above(*code, word)) return;
  if (code->number == kAnyNumber) {
    uncertain_.add(word.letter);
    report_twice(word, out);
    return check_value(word, out);
  }
  contradicted_.add(code->group);
  if (word.letter == 'G')
    doubt({code->group});
  else
    uncertain_.add(word.letter);
  out.report(Code::SC2002, word.pos, code_name(*code) + " beside another code of the same group");
}

/// Behind G65 and its like only P and L are words of the line's own.
void Command::read_arguments(std::span<const Word> words, Output& out) {
  arguments_ = words;
  for (const Word& word : words)
    if (word.letter == 'P' || word.letter == 'L') read_value(word, out);
}

[[gnu::hot]] void Command::read_value(const Word& word, Output& out) {
  if (values_.has(word.letter)) {
    doubled_ = true;
    uncertain_.add(word.letter);
    return report_twice(word, out);
  }
  values_.letters_.add(word.letter);
  values_.words_[Values::index(word.letter)] = &word;
}

/// O names the program; only a line number may stand beside it. Behind other words it is told
/// itself, and what it was meant for is not known; before them it may be another letter's code.
void Command::check_program_number(const Line& line, Output& out) {
  const auto& words = line.words;
  const auto number =
      std::find_if(words.begin(), words.end(), [](const Word& word) { return word.letter == 'O'; });
  const auto other = std::find_if(words.begin(), words.end(), [](const Word& word) {
    return word.letter != 'O' && word.letter != 'N';
  });
  if (other == words.end()) return;
  const bool behind = other < number;
  if (behind) missing_ |= Letters("FST").without(values_.letters());  // `O500`, for F500
  if (behind || find_gcode('G', number->value) != nullptr) uncertain_ |= kAfterUnknownCode;
  if (!behind && find_gcode('G', number->value) != nullptr) doubt(groups_of_code(number->value));
  if (!behind && find_gcode('M', number->value) != nullptr) uncertain_.add('M');
  out.report(Code::SC2006, behind ? number->pos : other->pos,
             std::string("O stands alone on its line") + (behind ? kLetterForDigit : ""));
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
  if (dialect != Dialect::fanuc || !values_.letters().has_any(kLoneLetters)) return;
  const Letters lone = unused(dialect);
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

[[gnu::hot]] Letters Command::unused(Dialect dialect) const noexcept {
  Letters used;
  for (const CodeWord& code : codes()) {
    used |= Letters(code.code->words);
    if (dialect == Dialect::fanuc) used |= Letters(code.code->fanuc_words);
  }
  return values_.letters().without(used);
}

}  // namespace softcnc::ipr
