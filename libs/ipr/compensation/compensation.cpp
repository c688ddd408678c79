// SPDX-License-Identifier: MIT
// Moves along the contour come in, moves of the tool beside it go out, one move late.
#include "ipr/compensation/compensation.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "ipr/compensation/corner.hpp"
#include "ipr/compensation/entry.hpp"
#include "ipr/compensation/gouge.hpp"
#include "ipr/state/nearness.hpp"
#include "ipr/text/number.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

bool stays_in_plane(const Path& path, const PlaneAxes& axes) {
  if (!std::holds_alternative<softcnc::Line>(path)) return false;
  return (in_plane(end(path), axes) - in_plane(start(path), axes)).norm() < kSamePoint;
}

const Path& path_of(const Block& block) { return std::get<Move>(block.what).path; }

/// The whole line, from its first word on.
SourcePos place_of(const Block& block, std::string_view text) {
  SourcePos place = block.source;
  const std::size_t last = text.find_last_not_of(" \t\r");
  const int end = last == std::string_view::npos ? 0 : static_cast<int>(last) + 1;
  place.length = std::max(1, end - place.column + 1);
  return place;
}

}  // namespace

void Compensation::start(const CutterSide& mode) {
  mode_ = mode;
  before_.reset();
  axes_ = plane_axes(mode.plane);
  entered_ = false;
}

std::optional<AxisVector> Compensation::stop() {
  if (held_) emit_whole();
  const bool beside = on() && entered_;
  mode_.reset();
  return beside ? std::optional(tool_) : std::nullopt;
}

void Compensation::follow(Block block, std::string_view text) {
  const bool move = std::holds_alternative<Move>(block.what);
  if (move && on() && mode_->radius > 0) return follow_move(std::move(block), text);
  if (held_)
    wait(std::move(block), text);
  else
    ready_.push_back(std::move(block));
}

std::optional<Block> Compensation::pop() {
  if (ready_.empty()) return std::nullopt;
  std::optional<Block> block(std::move(ready_.front()));
  ready_.pop_front();
  return block;
}

/// Until the next move of the contour shows where the one before ends.
void Compensation::wait(Block block, std::string_view text) {
  if (waiting_.size() < kMostWaiting) return waiting_.push_back(std::move(block));
  report(Code::SC2151, block, text,
         "more than " + std::to_string(kMostWaiting) +
             " blocks without a move in the plane of the contour");
  emit_whole();
  before_.reset();
}

void Compensation::follow_move(Block block, std::string_view text) {
  const AxisVector from = softcnc::start(path_of(block)), to = softcnc::end(path_of(block));
  const bool broken = (from - programmed_).norm() > kLeastRemainder;
  programmed_ = to;
  if (stays_in_plane(path_of(block), axes_)) {
    if (held_) return wait(std::move(block), text);
    if (!entered_) return ready_.push_back(std::move(block));
    return move_to(block, in_plane(tool_, axes_), to[axes_.across]);
  }
  const bool first = !std::exchange(entered_, true);
  if (held_ && broken) emit_whole();
  if (broken) before_.reset();
  if (first || !held_) tool_ = from;
  if (first) return enter(std::move(block), text);
  follow_contour(std::move(block), text);
}

/// The first move leads from wherever the tool is to the side of its end.
void Compensation::enter(Block block, std::string_view text) {
  const PlaneCurve contour = plane_curve(path_of(block), axes_);
  const double across = programmed_[axes_.across];
  const bool square = mode_->square_entry && !contour.is_arc();
  if (!square && (contour.to() - contour.from()).norm() <= mode_->radius) {
    return report(Code::SC2143, block, text,
                  "the first move of cutter compensation must be longer than the tool's radius, " +
                      number_text(mode_->radius) + " mm");
  }
  const auto parallel = entry_beside(contour, offset());
  if (!parallel)
    return report(Code::SC2144, block, text,
                  "no arc leads from here to the side of the end of this arc");
  held_.emplace(OffsetMove{std::move(block), std::string(text), contour, *parallel, across});
  held_->entry = true;
}

void Compensation::follow_contour(Block block, std::string_view text) {
  const PlaneCurve contour = plane_curve(path_of(block), axes_);
  const auto parallel = contour.parallel(offset());
  if (!parallel) {
    if (held_) emit_whole();
    const Gouge gouge = gouge_on_arc(contour, mode_->radius);
    return report(gouge.code, block, text, gouge.message);
  }
  const double across = programmed_[axes_.across];
  OffsetMove next{std::move(block), std::string(text), contour, *parallel, across};
  if (held_)
    pass_corner(next);
  else
    restart_at(*parallel);
  held_.emplace(std::move(next));
}

void Compensation::pass_corner(OffsetMove& next) {
  const Corner corner = corner_between(held_->contour, next.contour, mode_->side, mode_->radius);
  if (held_->entry && !held_->contour.is_arc() && corner != Corner::none) {
    differences_.note(DialectDifference::entry, held_->block.source, held_->text);
    if (mode_->square_entry) return emit(next.parallel.from(), 0);
  }
  switch (corner) {
    case Corner::none:
      return emit_whole();
    case Corner::outside:
      emit_whole();
      return go_round_corner(next);
    case Corner::inside:
      return cut_corner(next);
  }
}

void Compensation::cut_corner(OffsetMove& next) {
  const auto corner = meeting(held_->parallel, next.parallel);
  if (!corner) {
    reject(gouge_in_corner(mode_->radius), next);
    emit_whole();
    return restart_at(next.parallel);
  }
  if (const auto gouge = gouge_between_corners(*held_, *corner, mode_->radius)) {
    reject(*gouge, *held_);
    emit_whole();
    return restart_at(next.parallel);
  }
  next.cut = corner->cut_after;
  emit(corner->at, corner->cut_before);
}

/// After an error: what comes next is judged by itself.
void Compensation::restart_at(const PlaneCurve& parallel) {
  before_.reset();
  tool_[axes_.first] = parallel.from().x();
  tool_[axes_.second] = parallel.from().y();
}

void Compensation::go_round_corner(const OffsetMove& next) {
  turn_to(next.block, next.parallel.from(), tool_[axes_.across], next.contour.from(),
          -mode_->side * std::numbers::pi);
}

void Compensation::emit_whole() { emit(held_->parallel.to(), 0); }

void Compensation::check_gouge() {
  if (!before_) return;
  if (const auto gouge = gouge_of_neighbours(*before_, *held_, *mode_)) reject(*gouge, *held_);
}

/// The held move as far as this point, and what has waited after it.
void Compensation::emit(const PlaneVector& to, double cut) {
  held_->cut_end = cut;
  check_gouge();
  const PlaneCurve& beside = held_->parallel;
  const double left = 1 - (held_->cut + cut) / beside.length();
  if (beside.is_arc())
    turn_to(held_->block, to, held_->across, beside.center(), left * beside.sweep());
  else
    move_to(held_->block, to, held_->across);
  for (Block& block : waiting_) {
    if (std::holds_alternative<Move>(block.what))
      move_to(block, in_plane(tool_, axes_), softcnc::end(path_of(block))[axes_.across]);
    else
      ready_.push_back(std::move(block));
  }
  waiting_.clear();
  before_ = std::exchange(held_, std::nullopt);
}

void Compensation::move_to(const Block& like, const PlaneVector& to, double across) {
  AxisVector end = tool_;
  end[axes_.first] = to.x();
  end[axes_.second] = to.y();
  end[axes_.across] = across;
  if ((end - tool_).norm() < kLeastRemainder) return;
  ready_.push_back(like);
  std::get<Move>(ready_.back().what).path = softcnc::Line(tool_, end);
  tool_ = end;
}

/// On an arc about the centre; `sweep` gives its direction and how often it goes round, rad.
void Compensation::turn_to(const Block& like, const PlaneVector& to, double across,
                           const PlaneVector& center, double sweep) {
  const bool closed = (to - in_plane(tool_, axes_)).norm() < kLeastRemainder;
  if (closed && std::abs(sweep) < std::numbers::pi) return move_to(like, to, across);
  ArcSpec spec{tool_, tool_, tool_, mode_->plane, sweep > 0, 0};
  spec.center[axes_.first] = center.x();
  spec.center[axes_.second] = center.y();
  spec.to[axes_.across] = across;
  spec.radius_tolerance = std::numeric_limits<double>::infinity();  // the contour is accepted
  const double turns = std::abs(sweep) / kTurn;
  spec.turns = static_cast<int>(closed ? std::round(turns) : std::ceil(turns)) - 1;
  if (!closed) {
    spec.to[axes_.first] = to.x();
    spec.to[axes_.second] = to.y();
  }
  Result<Arc> arc = Arc::make(spec);
  if (!arc)
    return report(Code::SC9001, like, {}, "an arc beside the contour: " + arc.error().message);
  ready_.push_back(like);
  std::get<Move>(ready_.back().what).path = std::move(*arc);
  tool_ = spec.to;
}

void Compensation::reject(const Gouge& gouge, const OffsetMove& move) {
  report(gouge.code, move.block, move.text, gouge.message);
}

void Compensation::report(Code code, const Block& block, std::string_view text,
                          std::string message) {
  diagnostics_.report(code, place_of(block, text), std::move(message), text);
}

}  // namespace softcnc::ipr
