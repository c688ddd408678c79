// SPDX-License-Identifier: MIT
// Hands out lines, and does itself what they say about their order.
#include "ipr/flow/flow.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ipr/codes/lost_codes.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::size_t kMostLost = 10000;  // bytes

/// `GOT 15`: three letters in a row, behind no others; `G+TO 15`: TO.
bool begins_with_name(std::string_view line) {
  const std::string_view text = line.substr(0, line.find_first_of("(;"));
  const auto first = std::find_if(text.begin(), text.end(), is_letter);
  const bool name = text.end() - first >= 3 && is_letter(first[1]) && is_letter(first[2]);
  return name || names(text, "TO");
}

/// FANUC's IF, behind which nothing begins or ends: something stands behind its condition.
bool begins_with_if(std::string_view line) {
  const auto condition = line.substr(0, line.find_first_of("(;")).rfind(']');
  if (condition == std::string_view::npos ||
      std::none_of(line.begin() + static_cast<std::ptrdiff_t>(condition), line.end(), is_letter))
    return false;
  const auto first = std::find_if(line.begin(), line.end(),
                                  [](char c) { return is_letter(c) && c != 'N' && c != 'n'; });
  return line.end() - first >= 2 && upper_case(first[0]) == 'I' && upper_case(first[1]) == 'F';
}

/// A keyword of a loop, a branch or a subprogram stands somewhere.
bool names_order(std::string_view line) {
  constexpr std::array<std::string_view, 6> kWords{"end", "while", "if", "repeat", "sub", "else"};
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return names(line, word); });
}

/// The first letter but that of a line number is one with which statements begin.
bool looks_like_statement(std::string_view line) {
  const auto first = std::find_if(line.begin(), line.end(),
                                  [](char c) { return is_letter(c) && c != 'N' && c != 'n'; });
  return first != line.end() &&
         std::string_view("OoIiWwDdEe").find(*first) != std::string_view::npos;
}

}  // namespace

Flow::Flow(Parser& parser, Diagnostics& diagnostics, FlowOptions options)
    : parser_(parser),
      diagnostics_(diagnostics),
      options_(std::move(options)),
      library_(parser, diagnostics, options_.folder, options_.called) {
  if (options_.unrun_too) parser_.show_passed_over();
  Call main;
  main.sub.kind = SubKind::program;
  main.sub.begin = library_.here();
  calls_.push_back(std::move(main));
}

std::optional<Line> Flow::next() {
  if (jump_) perform_jump();
  while (!ended_) {
    auto line = parser_.next_if_there();
    if (!line && parser_.waiting()) return std::nullopt;
    if (!line) {
      if (!in_subprogram()) remember_end();
      if (!in_subprogram() || parser_.broke_off()) break;
      end_text();
      continue;
    }
    ++executed_;
    if (options_.unrun_too) remember(*line);
    if (options_.lines_run != nullptr && parser_.file() == 0) ++(*options_.lines_run)[line->number];
    if (line->broken) doubt(*line);
    if (line->passed_over && line->words.empty()) continue;
    const bool plain = line->statement == nullptr && !new_round_;
    if (plain || obey(*line)) return line;
  }
  return std::nullopt;
}

/// Behind a branch that has run an elseif is passed over: its condition is not read.
void Flow::remember(const Line& line) {
  const bool elseif = line.statement != nullptr && line.statement->kind == Kind::else_if;
  if (parser_.file() != 0 || elseif) return;
  moved_ = moved_ || line.passed_over;
  if (line.passed_over) return;
  passed_.read(line.number, parser_.reader().place(), std::exchange(moved_, false));
}

/// Lines may have been passed over up to here.
void Flow::remember_end() {
  if (!options_.unrun_too || !std::exchange(moved_, false)) return;
  passed_.read(parser_.line() + 1, parser_.reader().place(), true);
}

/// What cannot be read may have begun or ended something, an M code the program.
void Flow::doubt(const Line& line) {
  const std::string_view before_comment = line.text.substr(0, line.text.find('('));
  const bool names_m = before_comment.find_first_of("Mm") != std::string_view::npos;
  const bool loses_m = line.lost.has('M') && !means_end(line);
  if (loses_m && names_m) expect_end();
  if (loses_m && line.lone_number) doubt_end();
  if (line.may_count) return;
  if (line.statement == nullptr && begins_with_if(line.text)) return doubt_order();
  if (line.statement == nullptr && begins_with_name(line.text)) doubt_order();
  if (line.statement == nullptr && names(line.text, "call")) miss_call(true);
  if (line.statement == nullptr && !looks_like_statement(line.text) && !names_order(line.text))
    return;
  doubt_order();
  const bool misspelt = line.statement != nullptr && line.statement->kind == Kind::misspelt;
  const bool labelled = line.statement != nullptr &&
                        (!line.statement->label.empty() || line.statement->kind == Kind::go_to);
  if (!labelled) opens_lost_ = true;
  if (labelled && misspelt) {
    const std::string &label = line.statement->label, &meant = line.statement->label_meant;
    is_new({Misfit::Role::between, Kind::misspelt, label});
    if (!meant.empty() && meant != label) is_new({Misfit::Role::between, Kind::misspelt, meant});
  }
  if ((line.statement != nullptr && !misspelt) || lost_o_words_.size() > kMostLost) return;
  for (const char c : line.text)
    if (!is_blank(c)) lost_o_words_ += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

void Flow::doubt_end() noexcept {
  end_lost_ = true;
  parser_.doubt_order();
}

void Flow::expect_end() noexcept {
  doubt_end();
  parser_.expect_prose();
}

void Flow::doubt_order() noexcept {
  uncertain_ = true;
  parser_.doubt_order();
}

/// True if the line has words as well.
bool Flow::obey(const Line& line) {
  if (line.statement == nullptr) {  // the head of a loop cannot be read any more
    new_round_ = false;
    go(*opens_.back().end);
    opens_.pop_back();
    return false;
  }
  take(line);
  const bool has_words = statement_.kind == Kind::program || statement_.kind == Kind::misspelt;
  obey();
  return has_words && !ended_;
}

void Flow::take(const Line& line) {
  statement_ = *line.statement;
  statement_.uncertain = statement_.uncertain || line.broken;
  opens_lost_ = opens_lost_ || (uncertain_ && statement_.label_computed);
  text_ = line.text;
  head_ = {parser_.file(), parser_.reader().place_before(line.text)};
}

void Flow::obey() {
  switch (statement_.kind) {
    case Kind::none:
    case Kind::misspelt_end:
      return;
    case Kind::misspelt:
      return miss_misspelt();
    case Kind::program:
      return begin_program();
    case Kind::sub:
      return pass_definition();
    case Kind::end_sub:
    case Kind::leave_sub:
      return leave_by_statement();
    case Kind::call:
      return call();
    case Kind::if_begin:
      return begin_branch();
    case Kind::else_if:
    case Kind::else_begin:
      return next_branch();
    case Kind::if_end:
      return end_branch();
    case Kind::while_begin:
    case Kind::loop_begin:
      return begin_or_repeat();
    case Kind::do_begin:
    case Kind::repeat_begin:
      return begin_loop();
    case Kind::while_end:
    case Kind::repeat_end:
    case Kind::loop_end:
      return end_loop();
    case Kind::next_round:
    case Kind::leave_loop:
      return next_round_or_leave();
    case Kind::go_to:
      if (statement_.condition && !statement_.uncertain)
        go_to_line(static_cast<int>(statement_.value), statement_.pos);
  }
}

bool Flow::go(const Spot& spot) {
  moved_ = true;
  if (!library_.go(spot)) ended_ = broken_ = true;
  return !ended_;
}

void Flow::jump(Jump jump, std::string_view text) {
  jump_ = std::move(jump);
  text_ = text;
}

/// The text has ended within a subprogram.
void Flow::end_text() {
  const auto& [kind, label, begin] = calls_.back().sub;
  const SourcePos pos{parser_.line(), 0, 1, parser_.file()};
  if (end_lost_) {
    doubt_order();
    opens_lost_ = true;
  }
  report({Misfit::Role::beginning, Kind::sub, label}, Code::SC2303, pos,
         kind == SubKind::o_word
             ? "'" + o_word(label, "sub") + "' has no '" + o_word(label, "endsub") + "'"
             : program_name(label) + " ends without M99",
         {});
  calls_.back().times = 1;
  leave(std::nullopt, pos);
}

void Flow::finish() {
  if (broke_off()) return;
  std::vector<Open> without_end;
  while (opens_.size() > calls_.back().opens) {
    Open top = std::move(opens_.back());
    opens_.pop_back();
    const Spot here = library_.here();
    const Passed passed = top.end ? Passed::to_end : pass_to_end(top);
    if (passed == Passed::nowhere) without_end.push_back(std::move(top));
    if (passed == Passed::nowhere && !go(here)) return;
    if (passed == Passed::to_misspelt) parser_.next();  // which tells it
  }
  std::for_each(without_end.rbegin(), without_end.rend(),
                [&](const Open& open) { tell_open(open); });
}

/// Then what is missing need not be: reading has not come so far.
bool Flow::is_stopped() const noexcept { return parser_.reader().stop().stop_requested(); }

void Flow::report(Code code, SourcePos pos, std::string message) {
  if (!is_stopped()) diagnostics_.report(code, pos, std::move(message), text_);
}

/// For what may follow from an earlier error of its kind.
void Flow::report(Misfit misfit, Code code, SourcePos pos, std::string message,
                  std::string_view text) {
  if (is_new(std::move(misfit)) && !is_stopped())
    diagnostics_.report(code, pos, std::move(message), text);
}

/// A wrong label makes two of one error: the other one's is looked for and not found. The `while`
/// that ends a do has none of its own, and looks like a beginning.
bool Flow::follows(Misfit& one) {
  using Role = Misfit::Role;
  const auto is_do_or_while = [](const Misfit& misfit, Kind kind) {
    return misfit.role == Role::beginning && misfit.begin == kind;
  };
  const auto may_belong = [](const Misfit& misfit, Kind begin) {
    const bool of_loop = begin != Kind::if_begin && begin != Kind::loop_begin;
    return misfit.begin == begin ||
           (misfit.role == Role::between && misfit.begin == Kind::while_begin && of_loop);
  };
  for (Misfit& told : misfits_) {
    const Spot &here = one.within, &there = told.within;
    const bool together = here.file == there.file && here.place.line == there.place.line;
    if (!together && one.begin != Kind::sub) continue;
    if (may_mean(told.label, one.label)) return true;
    const bool both_ends = one.begin == told.begin && one.role != told.role &&
                           one.role != Role::between && told.role != Role::between;
    const bool branch = one.begin == Kind::if_begin && told.begin == Kind::if_begin &&
                        one.role == Role::between && told.role == Role::beginning;
    const bool of_do =
        (is_do_or_while(one, Kind::do_begin) && is_do_or_while(told, Kind::while_begin)) ||
        (is_do_or_while(told, Kind::do_begin) && is_do_or_while(one, Kind::while_begin));
    const bool of_twice = told.role == Role::twice && one.role != Role::twice &&
                          (may_belong(one, told.begin) || may_belong(one, told.outer));
    if ((both_ends || branch || of_do || of_twice) && !told.paired && !one.paired)
      return told.paired = one.paired = true;
  }
  return false;
}

/// True if it follows from nothing. What follows from it from here on is not told.
bool Flow::is_new(Misfit misfit) {
  misfit.within = calls_.back().sub.begin;
  const bool follows = opens_lost_ || this->follows(misfit);
  if (misfits_.size() < kMostMisfits)
    misfits_.push_back(std::move(misfit));
  else
    opens_lost_ = true;
  doubt_order();
  return !follows;
}

void Flow::break_off(Code code, SourcePos pos, std::string message, std::string_view text) {
  if (!is_stopped()) diagnostics_.report(code, pos, std::move(message), text);
  ended_ = broken_ = true;
}

/// What is missing has been told, and looked for as far as the parser stands: if there is no end of
/// such, the program has one.
void Flow::sought_in_vain(const Spot& from, const SourcePos& pos) {
  vain_ += parser_.line() - from.place.line;
  if (runs_too_long(vain_, "the search for what is missing", pos, text_)) return;
  go(from);
}

/// Tells, and ends the program, if more blocks have run since then than may be.
bool Flow::runs_too_long(std::int64_t lines, const std::string& what, SourcePos pos,
                         std::string_view text) {
  if (lines <= options_.block_limit) return false;
  break_off(Code::SC2310, pos,
            what + " has run more than " + std::to_string(options_.block_limit) + " blocks", text);
  return true;
}

}  // namespace softcnc::ipr
