// SPDX-License-Identifier: MIT
// What is only read, and not run: subprograms that nothing has called, and branches never taken.
#include <algorithm>

#include "ipr/flow/flow.hpp"

namespace softcnc::ipr {
void Flow::begin_unreachable() {
  if (broke_off()) return;
  ended_ = false;
  leaves_.insert(skipped_.last_read());
  rest_is_program_ = order_unknown_;
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
  parser_.lose_order();
  parser_.only_read();
}

std::optional<ProgramLine> Flow::next_unreachable() {
  if (broke_off()) return std::nullopt;
  auto line = next_uncalled();
  return line ? line : next_skipped();
}

std::optional<ProgramLine> Flow::next_uncalled() {
  while (!uncalled_.empty()) {
    if (!reading_uncalled_ && !go_to_uncalled(uncalled_.front())) return std::nullopt;
    reading_uncalled_ = true;
    const int errors = diagnostics_.errors();
    auto line = read_unreachable();
    if (line) remember(*line);
    if (line && !ends_uncalled(*line)) {
      const bool label_unknown = line->statement != nullptr && line->statement->label_computed;
      if (diagnostics_.errors() > errors || label_unknown) note_unread(*line);
      if (label_unknown) structure_unknown_ = true;
      if (line->statement == nullptr) return line;
      check_order(*line);
      continue;
    }
    report_open_from(0);
    reading_uncalled_ = false;
    uncalled_.erase(uncalled_.begin());
  }
  return std::nullopt;
}

/// The next line, its condition too, as if nothing were known of variables.
std::optional<ProgramLine> Flow::read_unreachable() {
  parser_.parameters().lose_all(true);
  errors_before_ = diagnostics_.errors();
  auto line = parser_.next();
  const bool condition = line && line->statement != nullptr;
  return condition && line->statement->kind == Kind::else_if ? parser_.evaluate() : line;
}

bool Flow::go_to_uncalled(const Subprogram& sub) {
  opens_.clear();
  landings_.clear();
  unknown_labels_.clear();
  order_unknown_ = structure_unknown_ = false;
  return go(sub.begin);
}

bool Flow::ends_uncalled(const ProgramLine& line) const {
  const Subprogram& sub = uncalled_.front();
  if (line.statement == nullptr) return false;
  const Kind kind = line.statement->kind;
  if (kind == Kind::program || kind == Kind::sub) return true;
  if (sub.kind != SubKind::o_word) return false;
  return kind == Kind::end_sub && line.statement->label == sub.label;
}

/// Reports what begins without an end, and ends without a beginning.
void Flow::check_order(const ProgramLine& line) {
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
      if (opened(Kind::if_begin) == nullptr) report_not_begun();
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
  if (open == nullptr) return report_not_begun();
  close_within(*open, true);
  opens_.pop_back();
}

/// Of statements only what they say is read, not how they nest: a stretch may begin within a branch
/// and end within another.
std::optional<ProgramLine> Flow::next_skipped() {
  if (unread_.empty()) unread_ = skipped_.take(rest_is_program_);
  while (!unread_.empty()) {
    const SkippedLines::Stretch& stretch = unread_.front();
    if (!reading_stretch_ && !go_to(stretch)) return std::nullopt;
    reading_stretch_ = true;
    const auto line = parser_.line() < stretch.last ? read_unreachable() : std::nullopt;
    const bool within = line && line->number <= stretch.last;
    if (within && line->statement == nullptr) return line;
    if (within) continue;
    reading_stretch_ = false;
    unread_.pop_front();
  }
  return std::nullopt;
}

/// After the end of a program stands nothing of it up to the next one.
bool Flow::go_to(const SkippedLines::Stretch& stretch) {
  if (!go({0, stretch.begin})) return false;
  bool outside = !rest_is_program_ && leaves_.contains(stretch.begin.line);
  while (outside && parser_.line() < stretch.last) {
    const auto line = parser_.next_statement();
    outside = line && !(line->statement != nullptr && line->statement->kind == Kind::program);
  }
  return true;
}

}  // namespace softcnc::ipr
