// SPDX-License-Identifier: MIT
// What is only read, and not run: subprograms that nothing has called, and branches never taken.
#include <algorithm>

#include "ipr/flow/flow.hpp"

namespace softcnc::ipr {
namespace {

/// Of variables nothing is known here.
bool has_unknown_label(const Line& line) {
  return line.statement != nullptr && line.statement->label_computed;
}

}  // namespace

void Flow::begin_unrun() {
  if (broke_off()) return;
  ended_ = false;
  leaves_.insert(passed_.last_read());
  order_lost_ = uncertain_ || target_lost_;
  diagnostics_.lines_repeat();
  while (in_subprogram()) {
    calls_.pop_back();
    diagnostics_.leave_call();
  }
  uncalled_ = library_.all_of_program();
  const int main_begin = calls_.front().sub.begin.place.line;
  std::erase_if(uncalled_, [&](const Subprogram& sub) {
    const int line = sub.begin.place.line;
    return line == main_begin || entered_.contains(line);
  });
  parser_.doubt_order();
  parser_.only_read();
}

std::optional<Line> Flow::next_unrun() {
  if (broke_off()) return std::nullopt;
  auto line = next_uncalled();
  return line ? line : next_passed();
}

std::optional<Line> Flow::next_uncalled() {
  while (!uncalled_.empty()) {
    if (!reading_uncalled_ && !go_to_uncalled(uncalled_.front())) return std::nullopt;
    reading_uncalled_ = true;
    const int errors = diagnostics_.errors();
    auto line = read_unrun();
    if (line) remember(*line);
    if (line && !ends_uncalled(*line)) {
      if (diagnostics_.errors() > errors || has_unknown_label(*line)) doubt(*line);
      if (line->statement == nullptr) return line;
      check_order(*line);
      continue;
    }
    tell_open_from(0);
    reading_uncalled_ = false;
    uncalled_.erase(uncalled_.begin());
  }
  return std::nullopt;
}

/// The next line, its condition too, as if nothing were known of variables.
std::optional<Line> Flow::read_unrun() {
  parser_.parameters().doubt_all(true);
  auto line = parser_.next();
  const bool condition = line && line->statement != nullptr;
  return condition && line->statement->kind == Kind::else_if ? parser_.evaluate() : line;
}

bool Flow::go_to_uncalled(const Subprogram& sub) {
  opens_.clear();
  landings_.clear();
  misfits_.clear();
  uncertain_ = opens_lost_ = false;
  return go(sub.begin);
}

bool Flow::ends_uncalled(const Line& line) const {
  const Subprogram& sub = uncalled_.front();
  if (line.statement == nullptr) return false;
  const Kind kind = line.statement->kind;
  if (kind == Kind::program || kind == Kind::sub) return true;
  if (sub.kind != SubKind::o_word) return false;
  return may_be_of(*line.statement, sub.label) ||
         (kind == Kind::end_sub && line.statement->label == sub.label);
}

/// Tells what begins without an end, and ends without a beginning.
void Flow::check_order(const Line& line) {
  take(line);
  switch (statement_.kind) {
    case Kind::while_begin:
      if (opened(Kind::do_begin) != nullptr) return close(Kind::do_begin);
      [[fallthrough]];
    case Kind::if_begin:
    case Kind::do_begin:
    case Kind::repeat_begin:
    case Kind::loop_begin:
      if (has_loop_number() && !is_too_deep() && !is_open_already()) open(statement_.kind, {});
      return;
    case Kind::else_if:
    case Kind::else_begin:
      if (opened(Kind::if_begin) == nullptr) tell_not_begun();
      return;
    case Kind::if_end:
      return close(Kind::if_begin);
    case Kind::while_end:
      return close(Kind::while_begin);
    case Kind::repeat_end:
      return close(Kind::repeat_begin);
    case Kind::loop_end:
      return close(Kind::loop_begin);
    default:
      return;
  }
}

void Flow::close(Kind begin) {
  const Open* open = opened(begin);
  if (open == nullptr) return tell_not_begun();
  close_within(*open, true);
  opens_.pop_back();
}

/// Of statements only what they say is read, not how they nest: a stretch may begin within a branch
/// and end within another.
std::optional<Line> Flow::next_passed() {
  if (unread_.empty()) unread_ = passed_.take(order_lost_);
  while (!unread_.empty()) {
    const PassedLines::Stretch& stretch = unread_.front();
    if (!reading_stretch_ && !go_to(stretch)) return std::nullopt;
    reading_stretch_ = true;
    const auto line = parser_.line() < stretch.last ? read_unrun() : std::nullopt;
    const bool within = line && line->number <= stretch.last;
    if (within && line->statement == nullptr) return line;
    if (within) continue;
    reading_stretch_ = false;
    unread_.pop_front();
  }
  return std::nullopt;
}

/// Behind the end of a program stands nothing of it up to the next one.
bool Flow::go_to(const PassedLines::Stretch& stretch) {
  if (!go({0, stretch.begin})) return false;
  bool outside = !order_lost_ && leaves_.contains(stretch.begin.line);
  while (outside && parser_.line() < stretch.last) {
    const auto line = parser_.next_statement();
    outside = line && !(line->statement != nullptr && line->statement->kind == Kind::program);
  }
  return true;
}

}  // namespace softcnc::ipr
