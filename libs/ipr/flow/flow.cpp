// SPDX-License-Identifier: MIT
// Hands out lines, and does itself what they say about their order.
#include "ipr/flow/flow.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::ipr {
namespace {

/// The first letter but that of a line number is one with which statements begin.
bool looks_like_statement(std::string_view line) {
  const auto first = std::find_if(line.begin(), line.end(),
                                  [](char c) { return is_letter(c) && c != 'N' && c != 'n'; });
  return first != line.end() &&
         std::string_view("OoIiWwDdEeGg").find(*first) != std::string_view::npos &&
         ((*first == 'O' || *first == 'o') || (line.end() - first > 1 && is_letter(first[1])));
}

/// Whether values say where it leads.
bool depends_on_values(const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::none:
    case StatementKind::program:
    case StatementKind::sub:
    case StatementKind::end_sub:
    case StatementKind::leave_sub:
    case StatementKind::call:
    case StatementKind::do_begin:
      return statement.label_computed;
    default:
      return true;
  }
}

}  // namespace

Flow::Flow(Parser& parser, Diagnostics& diagnostics, FlowOptions options)
    : parser_(parser),
      diagnostics_(diagnostics),
      options_(std::move(options)),
      library_(parser, diagnostics, options_.folders, options_.called) {
  if (options_.unreachable_too) parser_.show_skipped();
  Call main;
  main.sub.kind = SubKind::program;
  main.sub.begin = library_.here();
  calls_.push_back(std::move(main));
}

std::optional<ProgramLine> Flow::next() {
  if (jump_) jump_now();
  while (!ended_) {
    errors_before_ = diagnostics_.errors();
    auto line = parser_.next_if_there();
    if (!line && parser_.waiting()) return std::nullopt;
    if (!line) {
      if (!in_subprogram()) remember_end();
      if (!in_subprogram() || parser_.broke_off()) break;
      end_text();
      continue;
    }
    const bool only_stock = !line->stock.empty() && line->words.empty();
    if (!only_stock) ++executed_;
    if (options_.unreachable_too) remember(*line);
    if (line->broken) note_unread(*line);
    decided_ = decided_ || line->decided;
    if (line->skipped && line->words.empty()) continue;
    const bool plain = line->statement == nullptr && !new_round_;
    if (plain || obey(*line)) return line;
  }
  return std::nullopt;
}

/// After a branch that has run an elseif is passed over: its condition is not read.
void Flow::remember(const ProgramLine& line) {
  const bool elseif = line.statement != nullptr && line.statement->kind == Kind::else_if;
  if (parser_.file() != 0 || elseif) return;
  moved_ = moved_ || line.skipped;
  if (line.skipped) return;
  skipped_.read(line.number, parser_.reader().place(), std::exchange(moved_, false));
}

/// Lines may have been passed over up to here.
void Flow::remember_end() {
  if (!options_.unreachable_too || !std::exchange(moved_, false)) return;
  skipped_.read(parser_.line() + 1, parser_.reader().place(), true);
}

/// What cannot be read may have begun or ended something.
void Flow::note_unread(const ProgramLine& line) {
  if (line.unread.has('N')) line_numbers_unknown_ = true;
  const bool names_label = line.unread.has('O') && line.unread != kAllLetters;
  if (line.statement == nullptr && !looks_like_statement(line.text) && !names_label) return;
  lose_order();
  if (line.statement == nullptr) structure_unknown_ = true;
}

void Flow::lose_order() noexcept {
  order_unknown_ = true;
  parser_.lose_order();
}

/// True if the line has words as well.
bool Flow::obey(const ProgramLine& line) {
  if (line.statement == nullptr) {  // the head of a loop cannot be read any more
    new_round_ = false;
    go(*opens_.back().end);
    opens_.pop_back();
    return false;
  }
  take(line);
  const bool has_words = statement_.kind == Kind::program;
  obey();
  return has_words && !ended_;
}

void Flow::take(const ProgramLine& line) {
  statement_ = *line.statement;
  statement_.unknown = statement_.unknown || line.broken;
  text_ = line.text;
  if (diagnostics_.errors() > errors_before_) erroneous_.emplace(parser_.file(), line.number);
  head_ = {parser_.file(), parser_.reader().place_before(line.text)};
}

void Flow::obey() {
  decided_ = decided_ || depends_on_values(statement_);
  switch (statement_.kind) {
    case Kind::none:
      return;
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
      if (statement_.condition && !statement_.unknown)
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
  decided_ = decided_ || text.find('#') != std::string_view::npos;
}

/// The text has ended within a subprogram.
void Flow::end_text() {
  const auto& [kind, label, begin] = calls_.back().sub;
  const SourcePos pos{parser_.line(), 0, 1, parser_.file()};
  if (!order_unknown_)
    report_structure(
        label, Code::SC2303, pos,
        kind == SubKind::o_word
            ? "'" + o_word(label, "sub") + "' has no '" + o_word(label, "endsub") + "'"
            : (kind == SubKind::lines ? label : program_name(label)) + " ends without M99",
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
    if (top.end || pass_to_end(top)) continue;
    without_end.push_back(std::move(top));
    if (!go(here)) return;
  }
  std::for_each(without_end.rbegin(), without_end.rend(),
                [&](const Open& open) { report_open(open); });
}

/// Then what is missing need not be: reading has not come so far.
bool Flow::is_stopped() const noexcept { return parser_.reader().stop().stop_requested(); }

void Flow::report(Code code, SourcePos pos, std::string message) {
  if (!is_stopped()) diagnostics_.report(code, pos, std::move(message), text_);
}

/// Of a label once: where something of its is missing, what belongs to that fits nowhere.
void Flow::report_structure(const std::string& label, Code code, SourcePos pos, std::string message,
                            std::string_view text) {
  const bool is_new = unknown_labels_.insert(label).second && !structure_unknown_;
  if (is_new && !is_stopped()) diagnostics_.report(code, pos, std::move(message), text);
  lose_order();
}

void Flow::break_off(Code code, SourcePos pos, std::string message, std::string_view text) {
  if (!is_stopped()) diagnostics_.report(code, pos, std::move(message), text);
  ended_ = broken_ = true;
}

/// What is missing has been reported, and looked for as far as the parser stands: if there is no
/// end of such, the program has one.
void Flow::sought_in_vain(const Spot& from, const SourcePos& pos) {
  vain_ += parser_.line() - from.place.line;
  if (runs_too_long(vain_, "the search for what is missing", pos, text_)) return;
  go(from);
}

/// True, after a report that ends the program, if more blocks have run since then than may be.
bool Flow::runs_too_long(std::int64_t lines, const std::string& what, SourcePos pos,
                         std::string_view text) {
  if (lines <= options_.block_limit) return false;
  break_off(Code::SC2310, pos,
            what + " has run more than " + std::to_string(options_.block_limit) + " blocks", text);
  return true;
}

}  // namespace softcnc::ipr
