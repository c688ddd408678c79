// SPDX-License-Identifier: MIT
// A corner is made once both of its moves are known. FANUC: operator's manual, "Optional chamfering
// and corner R"; Haas: mill operator's manual, "Corner Rounding and Chamfering".
#include "ipr/corners/corners.hpp"

#include <cmath>
#include <utility>

#include "ipr/compensation/compensation.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kSameEnd = 1e-6;  // mm

const Move& move_of(const BlockOfLine& one) { return std::get<Move>(one.block.what); }

/// Whether a move goes along the plane, and not across it as well.
bool lies_in(const Path& path, Plane plane) {
  const PlaneAxes axes = plane_axes(plane);
  if (std::abs(end(path)[axes.across] - start(path)[axes.across]) > kSameEnd) return false;
  if (const auto* arc = std::get_if<Arc>(&path)) return arc->plane() == plane;
  return (in_plane(end(path), axes) - in_plane(start(path), axes)).norm() > kSameEnd;
}

bool is_line_or_arc(const Move& move) {
  return !move.rapid && (std::holds_alternative<softcnc::Line>(move.path) ||
                         std::holds_alternative<Arc>(move.path));
}

BlockOfLine like(const BlockOfLine& one, Path path) {
  BlockOfLine made = one;
  std::get<Move>(made.block.what).path = std::move(path);
  return made;
}

}  // namespace

void Corners::follow(BlockOfLine block, const AskedCorner* asked, std::vector<BlockOfLine>& ready) {
  if (!std::holds_alternative<Move>(block.block.what))
    return held_ ? wait(std::move(block), ready) : ready.push_back(std::move(block));
  const std::string text = block.text;
  std::optional<BlockOfLine> rest(std::move(block));
  if (held_) rest = make_corner(std::move(*rest), ready);
  if (rest && asked != nullptr) return hold(std::move(*rest), *asked, ready);
  if (rest) return ready.push_back(std::move(*rest));
  if (asked != nullptr)
    report(Code::SC2265, *asked, "the corner before it has left nothing of its move", text);
}

void Corners::hold(BlockOfLine move, const AskedCorner& asked, std::vector<BlockOfLine>& ready) {
  held_.emplace(Held{std::move(move), asked});
  if (!lies_in(move_of(held_->move).path, asked.plane))
    leave(Code::SC2264, "the move before it leads across the plane", ready);
}

/// What stands between the moves comes after the piece, which belongs to the first of them.
void Corners::wait(BlockOfLine block, std::vector<BlockOfLine>& ready) {
  if (after_.size() < kMostWaiting) return after_.push_back(std::move(block));
  leave(Code::SC2263, "more than 10000 blocks come before the next move", ready);
  ready.push_back(std::move(block));
}

void Corners::release_waiting(std::vector<BlockOfLine>& ready) {
  for (BlockOfLine& block : after_) ready.push_back(std::move(block));
  after_.clear();
}

void Corners::leave(std::vector<BlockOfLine>& ready) {
  if (!held_) return;
  ready.push_back(std::move(held_->move));
  held_.reset();
  release_waiting(ready);
}

void Corners::leave(Code code, const std::string& reason, std::vector<BlockOfLine>& ready) {
  if (!held_) return;
  report(code, held_->asked, reason, held_->move.text);
  leave(ready);
}

void Corners::report(Code code, const AskedCorner& asked, const std::string& reason,
                     const std::string& text) {
  diagnostics_.report(code, asked.pos, asked.name + ": " + reason, text);
}

bool Corners::may_follow(const Move& next, std::vector<BlockOfLine>& ready) {
  const Path& before = move_of(held_->move).path;
  if (!is_line_or_arc(next))
    leave(Code::SC2263, "no move by G01, G02 or G03 follows", ready);
  else if (!lies_in(next.path, held_->asked.plane))
    leave(Code::SC2264, "the move after it leads across the plane", ready);
  else if ((start(next.path) - end(before)).norm() > kSameEnd)
    leave(Code::SC2263, "the next move begins elsewhere", ready);
  return held_.has_value();
}

/// The rest of the second move, if there is one.
std::optional<BlockOfLine> Corners::make_corner(BlockOfLine next, std::vector<BlockOfLine>& ready) {
  if (!may_follow(move_of(next), ready)) return next;
  auto made = piece_corner(move_of(held_->move).path, move_of(next).path, held_->asked.plane,
                           held_->asked.piece);
  if (!made) {
    leave(made.error().code, made.error().message, ready);
    return next;
  }
  for (std::optional<Path>* path : {&made->before, &made->piece})
    if (*path) ready.push_back(like(held_->move, std::move(**path)));
  held_.reset();
  release_waiting(ready);
  if (!made->after) return std::nullopt;
  return like(next, std::move(*made->after));
}

}  // namespace softcnc::ipr
