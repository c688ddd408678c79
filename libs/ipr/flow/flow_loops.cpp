// SPDX-License-Identifier: MIT
// Loops and branches. Each is known by its label, and what is not run is passed over to that label.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ipr/flow/flow.hpp"
#include "ipr/flow/flow_search.hpp"

namespace softcnc::ipr {
namespace {

std::string_view keyword(StatementKind kind) {
  switch (kind) {
    case StatementKind::if_begin:
      return "if";
    case StatementKind::else_if:
      return "elseif";
    case StatementKind::else_begin:
      return "else";
    case StatementKind::if_end:
      return "endif";
    case StatementKind::while_begin:
      return "while";
    case StatementKind::while_end:
      return "endwhile";
    case StatementKind::do_begin:
      return "do";
    case StatementKind::repeat_begin:
      return "repeat";
    case StatementKind::repeat_end:
      return "endrepeat";
    case StatementKind::next_round:
      return "continue";
    case StatementKind::leave_loop:
      return "break";
    default:
      return {};
  }
}

bool is_fanuc(StatementKind kind) {
  return kind == StatementKind::loop_begin || kind == StatementKind::loop_end;
}

/// Whether it is another branch of what is open.
template <typename Open>
bool is_branch_of(const Open& open, const Statement& statement) {
  const bool branch =
      statement.kind == StatementKind::else_if || statement.kind == StatementKind::else_begin;
  return branch && open.kind == StatementKind::if_begin && statement.label == open.label;
}

/// As it is written, in quotes.
std::string spelled(StatementKind kind, const std::string& label) {
  if (!is_fanuc(kind)) return "'" + o_word(label, keyword(kind)) + "'";
  return (kind == StatementKind::loop_begin ? "'DO " : "'END ") + label + "'";
}

StatementKind end_of(StatementKind begin) {
  switch (begin) {
    case StatementKind::if_begin:
      return StatementKind::if_end;
    case StatementKind::while_begin:
      return StatementKind::while_end;
    case StatementKind::do_begin:
      return StatementKind::while_begin;
    case StatementKind::repeat_begin:
      return StatementKind::repeat_end;
    default:
      return StatementKind::loop_end;
  }
}

StatementKind begin_of(StatementKind end) {
  switch (end) {
    case StatementKind::while_end:
      return StatementKind::while_begin;
    case StatementKind::repeat_end:
      return StatementKind::repeat_begin;
    case StatementKind::loop_end:
      return StatementKind::loop_begin;
    default:
      return StatementKind::if_begin;
  }
}

constexpr double kMostRounds = 1e15;

}  // namespace

bool Flow::ends(const Statement& statement, const Open& open) {
  return statement.kind == end_of(open.kind) && statement.label == open.label;
}

void Flow::open(StatementKind kind, Spot round) {
  if (kind != StatementKind::if_begin) diagnostics_.lines_repeat();
  Open begun;
  begun.kind = kind;
  begun.label = statement_.label;
  begun.pos = statement_.pos;
  begun.text = text_;
  begun.round = round;
  begun.since = executed_;
  opens_.push_back(std::move(begun));
}

/// What has begun by this label; nullptr if nothing has, or what it stands in.
Flow::Open* Flow::opened(StatementKind begin) {
  for (std::size_t i = opens_.size(); i-- > calls_.back().opens;)
    if (opens_[i].kind == begin && opens_[i].label == statement_.label) return &opens_[i];
  return nullptr;
}

/// Makes it the innermost; others begun within it have no end, which is reported.
void Flow::close_within(const Open& open, bool reports) {
  const auto wanted = static_cast<std::size_t>(&open - opens_.data());
  const bool others = reports && opens_.size() > wanted + 1;
  if (others && is_fanuc(opens_.back().kind) && is_fanuc(statement_.kind))
    report_crossed(wanted + 1);
  else if (others)
    report_open_from(wanted + 1);
  opens_.resize(wanted + 1);
}

/// Nothing, where its beginning has reported an error.
void Flow::report_open(const Open& open) {
  if (erroneous_.contains({open.pos.file, open.pos.line})) unknown_labels_.insert(open.label);
  report_structure(
      open.label, Code::SC2302, open.pos,
      spelled(open.kind, open.label) + " has no " + spelled(end_of(open.kind), open.label),
      open.text);
}

void Flow::report_open_from(std::size_t first) {
  for (; first < opens_.size(); ++first) report_open(opens_[first]);
}

/// Loops of FANUC have three labels for all: only the first that cross are reported.
void Flow::report_crossed(std::size_t first) {
  const Open& top = opens_.back();
  if (!order_unknown_)
    diagnostics_.report(Code::SC2312, statement_.pos,
                        spelled(statement_.kind, statement_.label) + " before " +
                            spelled(end_of(top.kind), top.label) + ": the loops cross",
                        text_);
  lose_order();
  for (; first < opens_.size(); ++first) unknown_labels_.insert(opens_[first].label);
}

/// The last jump from outside to between the beginning and the end in work; nullptr if there was
/// none.
const Flow::Landing* Flow::jump_into(StatementKind begin) {
  const Spot here = library_.here();
  const auto found = std::find_if(landings_.rbegin(), landings_.rend(),
                                  [&](const Landing& one) { return leads_into(one, begin, here); });
  return found == landings_.rend() ? nullptr : &*found;
}

bool Flow::leads_into(const Landing& landing, StatementKind begin, const Spot& here) {
  if (landing.level != calls_.size() || landing.spot.file != here.file) return false;
  const int last = landing.spot.place.line;
  int begun = 0;  // the line of the beginning that has no end before the landing
  if (!go(calls_.back().sub.begin)) return false;
  pass_to([&](const ProgramLine& line) {
    const bool after = line.number > last;
    if (!after && line.statement && line.statement->label == statement_.label) {
      if (line.statement->kind == begin) begun = line.number;
      if (line.statement->kind == statement_.kind) begun = 0;
    }
    return after;
  });
  const int from = landing.pos.line;
  return go(here) && begun > 0 && (from < begun || from > here.place.line);
}

void Flow::report_not_begun() {
  const StatementKind begin = begin_of(statement_.kind);
  const Landing* jump = order_unknown_ ? nullptr : jump_into(begin);
  if (jump == nullptr)
    return report_structure(
        statement_.label, Code::SC2304, statement_.pos,
        spelled(statement_.kind, statement_.label) + " without " + spelled(begin, statement_.label),
        text_);
  report_structure(statement_.label, Code::SC2304, jump->pos,
                   "the jump leads past " + spelled(begin, statement_.label) + " to before " +
                       spelled(statement_.kind, statement_.label),
                   jump->text);
}

/// Reported if so: its end could not be distinguished from the other's.
bool Flow::is_open_already() {
  for (std::size_t i = opens_.size(); i-- > calls_.back().opens;) {
    const Open& open = opens_[i];
    if (open.label != statement_.label || is_fanuc(open.kind) != is_fanuc(statement_.kind))
      continue;
    report_structure(
        statement_.label, is_fanuc(open.kind) ? Code::SC2312 : Code::SC2313, statement_.pos,
        spelled(statement_.kind, statement_.label) + " within " + spelled(open.kind, open.label) +
            " of line " + std::to_string(open.pos.line),
        text_);
    return true;
  }
  return false;
}

/// Reported if so, and the program ends: what is open is kept in memory.
bool Flow::is_too_deep() {
  if (opens_.size() < kMostLevels) return false;
  break_off(Code::SC2316, statement_.pos,
            "more than " + std::to_string(kMostLevels) + " loops and branches within each other",
            text_);
  return true;
}

/// Passes on to after the end of the innermost, which is no longer open.
void Flow::pass_top() {
  const Spot here = library_.here();
  const Open top = std::move(opens_.back());
  opens_.pop_back();
  if (top.end) {
    go(*top.end);
  } else if (!pass_to_end(top)) {
    report_open(top);
    sought_in_vain(here, statement_.pos);
  }
}

bool Flow::pass_to_end(const Open& open) {
  bool had_else = open.had_else;
  return pass_to([&](const ProgramLine& line) {
    if (line.statement == nullptr) return false;
    if (is_branch_of(open, *line.statement)) {
      if (had_else) report_after_else(*line.statement, line.text);
      had_else = had_else || line.statement->kind == StatementKind::else_begin;
    }
    return ends(*line.statement, open);
  });
}

void Flow::begin_branch() {
  if (is_too_deep() || is_open_already()) return;
  open(StatementKind::if_begin, {});
  if (!statement_.unknown && statement_.value == 0) find_branch();
}

/// Passes on to the branch whose condition holds.
void Flow::find_branch() {
  const Spot here = library_.here();
  Kind found = StatementKind::none;
  const auto is_branch = [&](const ProgramLine& line) {
    const Statement* statement = line.statement;
    if (statement == nullptr) return false;
    found = statement->kind;
    const bool branch = found == StatementKind::else_if || found == StatementKind::else_begin ||
                        found == StatementKind::if_end;
    return branch && statement->label == opens_.back().label;
  };
  while (pass_to(is_branch)) {
    ++executed_;
    if (found == StatementKind::if_end) return opens_.pop_back();
    opens_.back().had_else = found == StatementKind::else_begin;
    if (found == StatementKind::else_begin) return;
    const ProgramLine line = parser_.evaluate();
    if (line.broken || line.statement == nullptr || line.statement->value != 0) return;
  }
  report_open(opens_.back());
  opens_.pop_back();
  sought_in_vain(here, statement_.pos);
}

void Flow::report_after_else(const Statement& branch, std::string_view text) {
  report_structure(branch.label, Code::SC2304, branch.pos,
                   spelled(branch.kind, branch.label) + " after " +
                       spelled(StatementKind::else_begin, branch.label),
                   text);
}

/// A branch has been run; the others are passed over.
void Flow::next_branch() {
  const Open* open = opened(StatementKind::if_begin);
  if (open == nullptr) return report_not_begun();
  close_within(*open, true);
  if (opens_.back().had_else) report_after_else(statement_, text_);
  opens_.back().had_else = opens_.back().had_else || statement_.kind == StatementKind::else_begin;
  pass_top();
}

void Flow::end_branch() {
  const Open* open = opened(StatementKind::if_begin);
  if (open == nullptr) return report_not_begun();
  close_within(*open, true);
  opens_.pop_back();
}

bool Flow::holds() const {
  if (statement_.unknown) return false;
  return statement_.kind == StatementKind::loop_begin ? statement_.condition
                                                      : statement_.value != 0;
}

/// WHILE: of a new loop, of the next round of one, or at the end of a do.
void Flow::begin_or_repeat() {
  if (std::exchange(new_round_, false)) {
    if (!holds()) pass_top();
    return;
  }
  const Open* loop =
      statement_.kind == StatementKind::while_begin ? opened(StatementKind::do_begin) : nullptr;
  if (loop != nullptr) {
    close_within(*loop, true);
    return holds() ? begin_round() : opens_.pop_back();
  }
  if (!has_loop_number() || is_too_deep() || is_open_already()) return;
  open(statement_.kind, head_);
  if (!holds() && !statement_.unknown) pass_top();
}

/// A loop of FANUC has one of three numbers.
bool Flow::has_loop_number() {
  const std::string& label = statement_.label;
  if (statement_.kind != StatementKind::loop_begin || label == "1" || label == "2" || label == "3")
    return true;
  if (label.empty()) return false;
  report_structure(label, Code::SC2312, statement_.pos,
                   "'DO " + label + "': a loop is numbered 1, 2 or 3", text_);
  return false;
}

void Flow::begin_loop() {
  if (is_too_deep() || is_open_already()) return;
  open(statement_.kind, library_.here());
  if (statement_.kind == StatementKind::do_begin) return;
  const double rounds = statement_.unknown ? 1 : std::round(statement_.value);
  opens_.back().rounds = static_cast<std::int64_t>(std::min(rounds, kMostRounds));
  if (rounds < 1) pass_top();
}

void Flow::end_loop() {
  const Open* loop = opened(begin_of(statement_.kind));
  if (loop == nullptr) return report_not_begun();
  close_within(*loop, true);
  Open& top = opens_.back();
  top.end = library_.here();
  if (top.kind == StatementKind::repeat_begin && --top.rounds <= 0) return opens_.pop_back();
  begin_round();
}

void Flow::begin_round() {
  const Open& top = opens_.back();
  if (order_unknown_) return opens_.pop_back();
  if (runs_too_long(executed_ - top.since, spelled(top.kind, top.label), top.pos, top.text)) return;
  new_round_ = top.kind == StatementKind::while_begin || top.kind == StatementKind::loop_begin;
  go(top.round);
}

void Flow::next_round_or_leave() {
  const Open* loop = nullptr;
  for (const Kind kind :
       {StatementKind::while_begin, StatementKind::do_begin, StatementKind::repeat_begin})
    if (loop == nullptr) loop = opened(kind);
  if (loop == nullptr)
    return report_structure(statement_.label, Code::SC2305, statement_.pos,
                            spelled(statement_.kind, statement_.label) + " outside of a loop " +
                                o_word(statement_.label),
                            text_);
  close_within(*loop, false);
  if (statement_.kind == StatementKind::leave_loop) return pass_top();
  const Spot here = library_.here();
  if (pass_to_end(opens_.back())) return static_cast<void>(go(before_));
  report_open(opens_.back());
  opens_.pop_back();
  sought_in_vain(here, statement_.pos);
}

}  // namespace softcnc::ipr
