// SPDX-License-Identifier: MIT
// Subprograms: their definitions are passed over, calls enter them, M99 and endsub leave them.
#include <algorithm>
#include <limits>
#include <utility>

#include "ipr/flow/flow.hpp"
#include "ipr/flow/flow_search.hpp"

namespace softcnc::ipr {
namespace {

std::string name_of(const Subprogram& sub) {
  if (sub.kind == SubKind::lines) return sub.label;
  return sub.kind == SubKind::program ? program_name(sub.label)
                                      : "'" + o_word(sub.label, "sub") + "'";
}

}  // namespace

void Flow::report_sub_again(const std::string& label, SourcePos pos, std::string_view text) {
  diagnostics_.report(Code::SC2314, pos, o_word(label, "sub") + " is already defined in this file",
                      text);
}

/// A definition is passed over where it stands. Without its end nobody knows which of the lines
/// after it are the program's.
void Flow::pass_definition() {
  const Subprogram& within = calls_.back().sub;
  const bool twice =
      in_subprogram() && within.kind == SubKind::o_word && within.label == statement_.label;
  if (twice) return report_sub_again(statement_.label, statement_.pos, text_);
  const Spot from = library_.here();
  SourcePos nested;
  std::string nested_text, nested_label;
  std::optional<Spot> next;  // where something else begins for certain
  moved_ = true;
  while (const auto line = parser_.next_statement()) {
    const Statement* inner = line->statement;
    if (line->broken && inner == nullptr && options_.unreachable_too) structure_unknown_ = true;
    if (inner == nullptr) continue;
    if (inner->kind == Kind::program && inner->label == statement_.label && nested.line == 0 &&
        !next) {
      const std::string& label = statement_.label;
      return report_structure(label, Code::SC2303, inner->pos,
                              "'" + o_word(label) + "' within its 'sub' lacks a keyword; is '" +
                                  o_word(label, "endsub") + "' meant?",
                              line->text);
    }
    if (inner->kind == Kind::program) break;
    if (inner->kind == Kind::end_sub && inner->label == statement_.label) {
      if (nested.line > 0 && nested_label == statement_.label)
        report_sub_again(nested_label, nested, nested_text);
      else if (nested.line > 0)
        report_structure(nested_label, Code::SC2307, nested,
                         "'" + o_word(nested_label, "sub") + "' within '" +
                             o_word(statement_.label, "sub") + "'",
                         nested_text);
      return;
    }
    if (inner->kind == Kind::end_sub && !next) next = library_.here();
    if (inner->kind != Kind::sub || nested.line > 0) continue;
    if (!next) next = Spot{parser_.file(), parser_.reader().place_before(line->text)};
    nested = inner->pos;
    nested_label = inner->label;
    nested_text = line->text;
  }
  const std::string& label = statement_.label;
  if (erroneous_.contains({statement_.pos.file, statement_.pos.line}))
    unknown_labels_.insert(label);
  report_structure(label, Code::SC2303, statement_.pos,
                   "'" + o_word(label, "sub") + "' has no '" + o_word(label, "endsub") + "'",
                   text_);
  end_definition(from, next);
}

/// Of one without its end: it has ended before the next one began, or at an end of another label.
/// Without either nobody knows which of the lines are the program's: they are only read.
void Flow::end_definition(const Spot& from, const std::optional<Spot>& next) {
  if (!next || in_subprogram()) {
    ended_ = true;
    return;
  }
  miss_call(false);
  sought_in_vain(from, statement_.pos);
  if (!ended_) go(*next);
}

/// The O of the main program, or of the one after it.
void Flow::begin_program() {
  if (in_subprogram()) {
    const std::string name = name_of(calls_.back().sub);
    if (calls_.back().sub.label ==
        statement_.label)  // its own, twice: the library has reported that
      return report(Code::SC2314, statement_.pos, name + " is already defined in this file");
    if (!order_unknown_)
      report_structure(calls_.back().sub.label, Code::SC2303, statement_.pos,
                       name + " has no end before " + program_name(statement_.label), text_);
    calls_.back().times = 1;
    return leave(std::nullopt, statement_.pos);
  }
  if (program_line_ == 0) {
    program_line_ = statement_.pos.line;
    calls_.back().sub.begin = library_.here();
  }
  if (statement_.pos.line != program_line_) ended_ = true;
}

void Flow::call() {
  if (statement_.label.empty()) return;  // reported already
  Jump jump;
  jump.arguments = std::move(statement_.arguments);
  if (statement_.unknown)
    jump.arguments.resize(static_cast<std::size_t>(parameters().locals()), kUnknown);
  jump.pos = statement_.pos;
  if (const auto sub = find(statement_.label, false, jump.pos))
    enter(*sub, std::move(jump), true);
  else
    miss_call(true);
}

/// Nothing, after a report: there is none.
std::optional<Subprogram> Flow::find(const std::string& label, bool program,
                                     const SourcePos& call) {
  const int errors = diagnostics_.errors();
  auto sub = library_.find(label, program, call, text_);
  if (library_.is_lost()) ended_ = broken_ = true;
  if (sub || diagnostics_.errors() > errors || structure_unknown_) return sub;
  if (options_.unreachable_too && library_.has_unread_label()) {  // reported where it is read
    lose_order();
    return sub;
  }
  if (!missing_.insert(label).second) return sub;
  const std::string nearest = library_.nearest(label);
  report(Code::SC2301, call,
         "no subprogram " + (program ? program_name(label) : o_word(label)) + " " +
             library_.places() + (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  return sub;
}

void Flow::miss_call(bool has_level) {
  parser_.parameters().lose_all(!has_level);
  if (options_.observer != nullptr) options_.observer->miss_call();
}

void Flow::jump_now() {
  Jump jump = std::move(*jump_);
  jump_.reset();
  if (jump.kind == Jump::Kind::leave) return leave_by_code(jump);
  if (jump.kind == Jump::Kind::call_lines) return enter_lines(std::move(jump));
  const bool macro = jump.kind == Jump::Kind::call_macro;
  if (jump.times <= 0) return;
  const std::string label = jump.name.empty() ? std::to_string(jump.number) : jump.name;
  if (auto sub = find(label, true, jump.pos))
    enter(std::move(*sub), std::move(jump), macro);
  else
    miss_call(macro);
}

/// M97: the lines are those of the program or subprogram of the call.
void Flow::enter_lines(Jump jump) {
  if (jump.times <= 0) return;
  const int number = jump.number;
  const Spot begin = calls_.back().sub.begin;
  const std::size_t level = calls_.size();
  const SourcePos pos = jump.pos;
  enter({SubKind::lines, "N" + std::to_string(number), begin}, std::move(jump), false);
  if (calls_.size() == level) return;
  const std::tuple key{begin.file, begin.place.line, number};
  if (const auto known = called_lines_.find(key); known != called_lines_.end()) {
    calls_.back().entry = known->second;
    go(known->second);
  } else if (begin_at(number, pos) && called_lines_.size() < kMostTargets) {
    called_lines_.emplace(key, *calls_.back().entry);
  }
}

void Flow::enter(Subprogram sub, Jump jump, bool has_level) {
  const auto by_itself = std::count_if(calls_.begin() + 1, calls_.end(), [&](const Call& call) {
    return call.sub.label == sub.label && call.sub.begin.file == sub.begin.file;
  });
  if (order_unknown_ && by_itself > 0)
    return miss_call(has_level);  // what ends it may be what is lost
  if (calls_.size() > kMaxDepth)
    return break_off(Code::SC2309, jump.pos,
                     "more than " + std::to_string(kMaxDepth) + " calls within each other; " +
                         name_of(sub) + " is among them " + std::to_string(by_itself) + " times",
                     text_);
  if (in_subprogram()) {
    const Call& first = calls_[1];
    if (runs_too_long(executed_ - first.since, "the call of " + name_of(first.sub), first.pos,
                      first.text))
      return;
  }
  diagnostics_.lines_repeat();
  if (sub.begin.file == 0) entered_.insert(sub.begin.place.line);
  Call call;
  call.sub = std::move(sub);
  call.back = library_.here();
  call.pos = jump.pos;
  call.text = text_;
  call.opens = opens_.size();
  call.times = jump.times;
  call.has_level = has_level;
  call.arguments = std::move(jump.arguments);
  call.since = executed_;
  diagnostics_.enter_call(call.pos);
  calls_.push_back(std::move(call));
  start();
  if (jump.line_number) begin_at(*jump.line_number, jump.pos);
}

/// The innermost call goes on at a line, each time that it runs. Without that line the called lines
/// are missing: false.
bool Flow::begin_at(int number, const SourcePos& pos) {
  const bool found = go_to_line(number, pos);
  if (found) calls_.back().entry = library_.here();
  if (found || calls_.back().sub.kind != SubKind::lines || ended_) return found;
  calls_.back().times = 1;
  leave(std::nullopt, pos);
  miss_call(false);
  return false;
}

/// Begins the innermost call, once or again, with variables of its own or those of the time before.
void Flow::start(bool keeps_variables) {
  const Call& call = calls_.back();
  if (call.has_level && !keeps_variables) parser_.parameters().push(call.arguments);
  if (options_.observer != nullptr) options_.observer->begin_call();
  go(call.entry.value_or(call.sub.begin));
}

/// A return leaves the subprogram in which it stands, whatever its label, as in LinuxCNC.
void Flow::leave_by_statement() {
  const Call& call = calls_.back();
  const bool end = statement_.kind == Kind::end_sub;
  const std::string& label = statement_.label;
  const bool of_call = in_subprogram() && call.sub.kind == SubKind::o_word;
  if (!of_call || (end && call.sub.label != label))
    return report_structure(label, end ? Code::SC2304 : Code::SC2306, statement_.pos,
                            "'" + o_word(label, end ? "endsub" : "return") +
                                (end ? "' without '" : "' outside of '") + o_word(label, "sub") +
                                "'",
                            text_);
  if (end) report_open_from(call.opens);
  std::optional<double> value;
  if (statement_.unknown) value = kUnknown;
  if (statement_.has_value) value = statement_.value;
  leave(value, statement_.pos);
}

/// Whether each further pass of the program would run the lines of this one: nothing has decided
/// which lines those are, or only values that a pass does not change.
bool Flow::repeats_endlessly() const noexcept {
  return !decided_ || !parser_.parameters().may_differ();
}

/// M99. Its P is a line of the caller, on Haas' controls of the program in which it stands.
void Flow::leave_by_code(const Jump& jump) {
  const bool stays = jump.line_number && parser_.parameters().dialect() == Dialect::haas;
  if (options_.unreachable_too && jump.pos.file == 0 && !stays) leaves_.insert(jump.pos.line);
  if (in_subprogram() && !stays) {
    if (jump.line_number) calls_.back().times = 1;
    leave(std::nullopt, jump.pos);
  } else if (!jump.line_number) {
    if (order_unknown_) return static_cast<void>(ended_ = true);  // it may never come here
    if (repeats_endlessly()) {
      report(Code::SC2172, jump.pos,
             "M99 starts the program again, and nothing in the program would end that; it is run "
             "once");
      ended_ = ended_by_repeat_ = true;
      return;
    }
    decided_ = false;
    parser_.parameters().begin_pass();
    if (runs_too_long(executed_, "the program, which M99 starts again,", jump.pos, text_)) return;
    diagnostics_.lines_repeat();
    opens_.clear();
    go(calls_.front().sub.begin);
  }
  if (jump.line_number && !ended_) go_to_line(*jump.line_number, jump.pos);
}

/// Ends the innermost call, or runs it once more. Haas' controls set the arguments the first time
/// only: what a time has left in the local variables is what the next one finds.
void Flow::leave(std::optional<double> value, const SourcePos& pos) {
  Call& call = calls_.back();
  opens_.resize(call.opens);
  const bool keeps = call.times > 1 && parser_.parameters().dialect() == Dialect::haas;
  if (call.has_level && !keeps) parser_.parameters().pop();
  if (options_.observer != nullptr) options_.observer->end_call(pos);
  if (call.sub.kind == SubKind::o_word) parser_.parameters().give_back(value);
  if (--call.times > 0) {
    const bool too_long = runs_too_long(executed_ - call.since, "the call of " + name_of(call.sub),
                                        call.pos, call.text);
    return too_long ? void() : start(keeps);
  }
  const Spot back = call.back;
  calls_.pop_back();
  diagnostics_.leave_call();
  go(back);
}

/// The name of the called program whose lines are executed; empty in the main program.
std::string Flow::program_in_work() const {
  const auto of_lines = [](const Call& call) { return call.sub.kind == SubKind::lines; };
  const auto call = std::find_if_not(calls_.rbegin(), calls_.rend() - 1, of_lines);
  return call == calls_.rend() - 1 ? std::string() : name_of(call->sub);
}

/// Looks from here to the end of the program, then from its beginning to here.
bool Flow::go_to_line(int number, const SourcePos& pos) {
  const Spot here = library_.here();
  const std::tuple key{here.file, here.place.line, number};
  if (const auto known = backward_.find(key); known != backward_.end()) {
    go_back(here, known->second, pos);
    return true;
  }
  if (find_line(number, std::numeric_limits<int>::max())) {
    if (go(before_)) land(pos);
    return !ended_;
  }
  const int end = parser_.line();
  if (!go(calls_.back().sub.begin)) return false;
  if (find_line(number, here.place.line)) {
    if (backward_.size() < kMostTargets) backward_.emplace(key, before_);
    go_back(here, before_, pos);
    return true;
  }
  lose_order();
  const std::string name = program_in_work();
  if (!line_numbers_unknown_)
    report(Code::SC2308, pos,
           "no line N" + std::to_string(number) + " in " + (name.empty() ? "the program" : name));
  vain_ += end;
  sought_in_vain(here, pos);
  return false;
}

/// Passes to the line of this number; loops whose end is passed are no longer open.
bool Flow::find_line(int number, int last) {
  std::size_t open = opens_.size();
  bool found = false;
  pass_to([&](const ProgramLine& line) {
    const bool begins = line.statement && line.statement->kind == Kind::program;
    const bool numbered = !begins && !line.words.empty() && line.words.front().letter == 'N';
    found = numbered && line.words.front().value == number && line.number <= last;
    if (!found && line.statement && open > calls_.back().opens &&
        ends(*line.statement, opens_[open - 1]))
      --open;
    return found || line.number >= last;
  });
  if (found) opens_.resize(open);
  return found;
}

void Flow::go_back(const Spot& from, const Spot& to, const SourcePos& pos) {
  const int line = to.place.line;
  const std::int64_t made = std::exchange(made_since_jump_, 0);
  const bool again = landing_of(pos) != landings_.end();
  if (again && order_unknown_) return static_cast<void>(go(from));
  jumped_back_ += from.place.line - line + (again ? made : 0);
  if (runs_too_long(jumped_back_, "jumping back to line " + std::to_string(line + 1), pos, text_))
    return;
  diagnostics_.lines_repeat();
  while (opens_.size() > calls_.back().opens && opens_.back().pos.line > line) opens_.pop_back();
  if (go(to)) land(pos);
}

std::vector<Flow::Landing>::iterator Flow::landing_of(const SourcePos& pos) {
  return std::find_if(landings_.begin(), landings_.end(), [&](const Landing& one) {
    return one.pos.line == pos.line && one.pos.file == pos.file && one.level == calls_.size();
  });
}

/// Remembered once for each jump, with where it has led to last.
void Flow::land(const SourcePos& pos) {
  if (const auto before = landing_of(pos); before != landings_.end()) landings_.erase(before);
  if (landings_.size() == kMostLandings) landings_.erase(landings_.begin());
  landings_.push_back({pos, text_, library_.here(), calls_.size()});
}

}  // namespace softcnc::ipr
