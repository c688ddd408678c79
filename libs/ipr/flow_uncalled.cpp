// SPDX-License-Identifier: MIT
// Subprograms that nothing has called: their lines are read, and not run.
#include <algorithm>

#include "ipr/flow.hpp"

namespace softcnc::ipr {
namespace {

/// Of variables nothing is known here.
bool has_unknown_label(const Line& line) {
  return line.statement != nullptr && line.statement->label_computed;
}

}  // namespace

void Flow::begin_uncalled() {
  if (broke_off()) return;
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
}

std::optional<Line> Flow::next_uncalled() {
  while (!uncalled_.empty()) {
    if (!reading_uncalled_ && !go_to_uncalled(uncalled_.front())) return std::nullopt;
    reading_uncalled_ = true;
    parser_.parameters().doubt_all(true);
    const int errors = diagnostics_.errors();
    auto line = parser_.next();
    if (line && !ends_uncalled(*line)) {
      if (diagnostics_.errors() > errors || has_unknown_label(*line)) doubt(*line);
      if (line->statement == nullptr) return line;
      check_order(*line);
      continue;
    }
    if (!uncertain_ && !opens_.empty()) tell_open(opens_.back());
    reading_uncalled_ = false;
    uncalled_.erase(uncalled_.begin());
  }
  return std::nullopt;
}

bool Flow::go_to_uncalled(const Subprogram& sub) {
  opens_.clear();
  landings_.clear();
  uncertain_ = false;
  return go(sub.begin);
}

bool Flow::ends_uncalled(const Line& line) const {
  const Subprogram& sub = uncalled_.front();
  if (line.statement == nullptr) return false;
  const Kind kind = line.statement->kind;
  if (kind == Kind::program || kind == Kind::sub) return true;
  const bool of_sub = sub.kind == SubKind::o_word && line.statement->label == sub.label;
  return of_sub && (kind == Kind::end_sub || kind == Kind::misspelt);
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
      if (has_loop_number() && !is_open_already()) open(statement_.kind, {});
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

}  // namespace softcnc::ipr
