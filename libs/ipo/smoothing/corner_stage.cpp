// SPDX-License-Identifier: MIT
#include "ipo/smoothing/corner_stage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/limits/planner_limits.hpp"
#include "ipo/tuning.hpp"
#include "motion/geometry/section.hpp"

namespace softcnc::ipo {
namespace {

bool is_rounded(const Move& move) {
  return move.path_mode == PathMode::follow &&
         (move.corner_tolerance > 0 || move.chord_tolerance > 0);
}

/// A path that begins at a corner, or ends there.
CornerSide side_of(const Path& path, const MoveAttributes& attributes) {
  return {path, 0, length(path), attributes};
}

PathEnd beginning_of(const Move& move) {
  return {at(move.path, 0).dq, length(move.path), corner_tolerance(attributes_of(move), 0)};
}

PathEnd end_of(const Move& move) {
  const double s = length(move.path);
  return {at(move.path, s, Side::before).dq, s, corner_tolerance(attributes_of(move), 0)};
}

bool has_tangent_jump(const PathEnd& before, const PathEnd& after) {
  return (after.direction - before.direction).norm() > tuning::corners::kRests;
}

Mark mark_of(const Block& block) { return {0, block.source, block.number}; }

/// Returns the inner positions where the tangent of a path jumps.
std::vector<double> inner_corners(const Path& path) {
  std::vector<double> corners;
  for (const double s : breaks(path))
    if ((at(path, s, Side::after).dq - at(path, s, Side::before).dq).norm() >
        tuning::corners::kInnerCorner)
      corners.push_back(s);
  return corners;
}

}  // namespace

CornerStage::CornerStage(const Machine& machine, std::unique_ptr<const TrialPlan> trial,
                         const RebuildOptions& options)
    : machine_(machine),
      choice_(machine, std::move(trial)),
      has_jerk_limit_(limits_jerk(machine)),
      rebuilds_(has_jerk_limit_ && machine.control.rebuild == Rebuild::on),
      lines_(machine, out_, choice_, rebuilds_, options) {}

bool CornerStage::passes(const Block& block) const noexcept {
  if (!chord_.empty() || !lines_.empty() || held_ || arc_ || !out_.empty()) return false;
  const Move* move = std::get_if<Move>(&block.what);
  return !move || !is_rounded(*move);
}

void CornerStage::push(Block&& block) {
  const Move* move = std::get_if<Move>(&block.what);
  const bool rounded = move && is_rounded(*move);
  const bool joined = rounded && joins(*move);
  if (arc_) settle_arc(joined ? move : nullptr);
  if (!joined) flush();
  if (!rounded) {
    out_.push_back({std::move(block), {}, 0});
    return;
  }
  last_ = attributes_of(*move);
  const PathEnd before = end_;
  if (rebuilds_) end_ = end_of(*move);
  if (std::holds_alternative<Line>(move->path)) return push_line(block);
  const bool is_short_arc = rebuilds_ && std::holds_alternative<Arc>(move->path) &&
                            length(move->path) <= tuning::rebuild::kLongestArc;
  if (!is_short_arc || !joined) return push_curve(std::move(block));
  const PathEnd beginning = beginning_of(*move);
  if (!is_part_of_curve(before, beginning)) return push_curve(std::move(block));
  jumps_ = has_tangent_jump(before, beginning);
  arc_ = std::move(block);
}

/// A short arc between others is a part of a curve, as short lines are, where it meets one of them
/// in a corner that a curve can smooth. Tangent ones stay what they are.
void CornerStage::settle_arc(const Move* next) {
  Block arc = *std::exchange(arc_, std::nullopt);
  const PathEnd end = end_of(std::get<Move>(arc.what));
  const bool goes_on = next && is_part_of_curve(end, beginning_of(*next)) &&
                       (jumps_ || has_tangent_jump(end, beginning_of(*next)));
  goes_on ? push_arc(arc) : push_curve(std::move(arc));
}

void CornerStage::finish() { flush(); }

std::optional<Piece> CornerStage::pop() {
  if (out_.empty()) return std::nullopt;
  std::optional<Piece> piece = std::move(out_.front());
  out_.pop_front();
  return piece;
}

bool CornerStage::joins(const Move& move) const { return last_ && last_->rapid == move.rapid; }

void CornerStage::push_line(const Block& block) {
  const Move& move = std::get<Move>(block.what);
  const Line& line = std::get<Line>(move.path);
  if (chord_.add(line, attributes_of(move), mark_of(block))) return;
  close_chord();
  chord_.add(line, attributes_of(move), mark_of(block));
}

/// As chords that are nearer to it than matters to the curve which they become.
void CornerStage::push_arc(const Block& block) {
  const Move& move = std::get<Move>(block.what);
  const double length = softcnc::length(move.path);
  const double deviation = tuning::rebuild::kArcShare * move.corner_tolerance;
  const double bend = at(move.path, 0.5 * length).ddq.norm();
  const double parts = std::ceil(length * std::sqrt(bend / (8 * deviation)));
  AxisVector from = start(move.path);
  for (double i = 1; i <= parts; ++i) {
    const AxisVector to = i < parts ? position(move.path, i / parts * length) : end(move.path);
    close_chord();
    chord_.add(Line(from, to), attributes_of(move), mark_of(block), deviation);
    from = to;
  }
}

/// A NURBS with corners inside is several curves.
void CornerStage::push_curve(Block block) {
  const std::vector<double> corners = inner_corners(std::get<Move>(block.what).path);
  double s = 0;
  for (const double corner : corners) {
    Block part = block;
    Path& path = std::get<Move>(part.what).path;
    path = section(path, s, corner);
    hold(std::move(part));
    s = corner;
  }
  Path& path = std::get<Move>(block.what).path;
  if (s > 0) path = section(path, s, length(path));
  hold(std::move(block));
}

/// Makes the transition from what came before into a curve, whose own end waits for what comes
/// next.
void CornerStage::hold(Block block) {
  const Move& move = std::get<Move>(block.what);
  const Side next{attributes_of(move), {mark_of(block)}};
  double begin = 0;
  if (!chord_.empty()) {
    begin = leave_chord(move.path, next);
  } else if (held_) {
    if (const auto blend =
            leave_held(side_of(move.path, next.attributes), corner_tolerance(next.attributes, 0))) {
      emit_blend(*blend, held_side(), next);
      begin = blend->after;
    }
  }
  held_ = Held{std::move(block), begin};
}

/// Makes the transition from the chord into a curve; returns how much of the curve that takes, mm.
double CornerStage::leave_chord(const Path& after, const Side& next) {
  Chord chord = chord_.take();
  if (held_) begin_with_held(chord);
  const Path line = Line(chord.from, chord.to);
  const double left =
      (lines_.empty() ? 1 - tuning::corners::kRest : tuning::corners::kHalf) * length(line);
  const double tolerance = std::min(corner_tolerance(chord.attributes, chord.deviation),
                                    corner_tolerance(next.attributes, 0));
  const auto blend =
      blend_into(side_of(line, chord.attributes), left, tolerance, side_of(after, next.attributes));
  Side last{chord.attributes, {}, chord.deviation};
  if (blend) last.marks = cut_back(chord, blend->before);
  lines_.add(std::move(chord), true);
  lines_.end();
  if (blend) emit_blend(*blend, std::move(last), next);
  return blend ? blend->after : 0;
}

/// Makes the transition from the held curve into a chord.
void CornerStage::begin_with_held(Chord& chord) {
  const Path line = Line(chord.from, chord.to);
  if (const auto blend = leave_held(side_of(line, chord.attributes),
                                    corner_tolerance(chord.attributes, chord.deviation)))
    emit_blend(*blend, held_side(),
               {chord.attributes, cut_front(chord, blend->after), chord.deviation});
  held_.reset();
}

/// Emits the curve up to where a blend into `after` begins, if there is one.
std::optional<Blend> CornerStage::leave_held(const CornerSide& after, double tolerance) {
  const double length = softcnc::length(held_->path());
  const CornerSide before{held_->path(), held_->begin, length, attributes_of(held_->move())};
  auto blend = blend_into(before, (1 - tuning::corners::kRest) * (length - held_->begin),
                          std::min(corner_tolerance(before.attributes, 0), tolerance), after);
  emit_held(length - (blend ? blend->before : 0));
  return blend;
}

void CornerStage::close_chord() {
  if (chord_.empty()) return;
  Chord chord = chord_.take();
  const bool follows_curve = held_.has_value();
  if (follows_curve) begin_with_held(chord);
  lines_.add(std::move(chord), follows_curve);
}

void CornerStage::flush() {
  if (arc_) settle_arc(nullptr);
  close_chord();
  lines_.end();
  if (held_) emit_held(length(held_->path()));
  held_.reset();
  last_.reset();
}

/// Without jerk limits a jump of curvature costs nothing, and the exact curve is better.
std::optional<Blend> CornerStage::blend_into(const CornerSide& before, double left,
                                             double tolerance, const CornerSide& after) const {
  const JointJump jump = ipo::joint_jump(before.path, after.path);
  const bool needed = has_jerk_limit_ ? jump.tangent > tuning::corners::kTurn ||
                                            jump.curvature > tuning::corners::kCurvatureJump
                                      : jump.tangent > tuning::corners::kSmallTurn;
  if (!needed) return std::nullopt;
  auto blend = make_blend(
      {before.path, after.path, left, tuning::corners::kHalf * length(after.path), tolerance});
  if (!blend || !within_travel(blend->curve)) return std::nullopt;
  if (jump.tangent > tuning::corners::kRests &&
      !choice_.is_sooner({before, after, blend->curve, blend->before, blend->after}))
    return std::nullopt;
  return blend;
}

bool CornerStage::within_travel(const Nurbs& curve) const {
  for (const AxisVector& point : curve.spec().control)
    for (int i = 0; i < kAxes; ++i) {
      const Axis& axis = machine_.axes[static_cast<std::size_t>(i)];
      if (axis.present && (point[i] < axis.min || point[i] > axis.max)) return false;
    }
  return true;
}

void CornerStage::emit_held(double end) {
  Block block = held_->block;
  Move& move = std::get<Move>(block.what);
  move.path = section(move.path, held_->begin, end);
  out_.push_back({std::move(block), {}, 0});
}

CornerStage::Side CornerStage::held_side() const {
  return {attributes_of(held_->move()), {mark_of(held_->block)}};
}

/// The first half belongs to what is before, the second to what is after.
void CornerStage::emit_blend(const Blend& blend, Side before, Side after) {
  const Path path = blend.curve;
  const double length = blend.curve.length();
  const double middle = 0.5 * length;
  const double deviation = blend.deviation + std::max(before.deviation, after.deviation);
  for (Mark& mark : before.marks) mark.s *= middle / blend.before;
  for (Mark& mark : after.marks) mark.s *= middle / blend.after;
  const auto add = [&](Path part, const Side& side) {
    const Mark& first = side.marks.front();
    out_.push_back({{make_move(std::move(part), side.attributes), first.source, first.number},
                    {side.marks.begin() + 1, side.marks.end()},
                    deviation});
  };
  if (before.attributes == after.attributes) {
    for (Mark& mark : after.marks) mark.s += middle;
    before.marks.insert(before.marks.end(), after.marks.begin(), after.marks.end());
    add(path, before);
    return;
  }
  add(section(path, 0, middle), before);
  add(section(path, middle, length), after);
}

}  // namespace softcnc::ipo
