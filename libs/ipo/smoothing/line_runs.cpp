// SPDX-License-Identifier: MIT
#include "ipo/smoothing/line_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

double length_of(const Chord& chord) { return (chord.to - chord.from).norm(); }

PathEnd path_end(const Chord& chord) {
  return {(chord.to - chord.from).normalized(), length_of(chord),
          corner_tolerance(chord.attributes, chord.deviation)};
}

/// Takes the first `length` mm off a line.
Chord take_front(Chord& chord, double length) {
  Chord front{chord.from, chord.to, chord.attributes, chord.deviation, {}};
  front.marks = cut_front(chord, length);
  front.to = chord.from;
  return front;
}

}  // namespace

void LineRuns::add(Chord chord, bool stays_straight) {
  if (!rebuilds_) return polyline_.add(chord);
  Held line{std::move(chord), stays_straight};
  if (next_) {
    line.before = meeting(*next_, line);
    settle(*std::exchange(next_, std::nullopt), line.before);
    if (was_given_up_ && line.before.joint == Joint::smooth) line.before.joint = Joint::corner;
    was_given_up_ = false;
  }
  next_ = std::move(line);
}

void LineRuns::end() {
  if (next_) settle(*std::exchange(next_, std::nullopt), {});
  was_given_up_ = false;
  polyline_.end();
}

double rounding_width(const PathEnd& before, const PathEnd& after) noexcept {
  const double turn =
      std::max((after.direction - before.direction).norm(), tuning::polyline::kStraight);
  return 6 * std::min(before.tolerance, after.tolerance) / turn;
}

bool is_part_of_curve(const PathEnd& before, const PathEnd& after) noexcept {
  return tuning::rebuild::kBesideCorner * rounding_width(before, after) >
             std::min(before.length, after.length) &&
         before.direction.dot(after.direction) >= tuning::blend::kTurnsBack;
}

LineRuns::Meeting LineRuns::meeting(const Held& before, const Held& after) {
  const PathEnd a = path_end(before.chord), b = path_end(after.chord);
  const bool is_apart = before.stays_straight || after.stays_straight;
  return {is_apart || !is_part_of_curve(a, b) ? Joint::corner : Joint::smooth,
          std::min(rounding_width(a, b), 0.5 * std::min(a.length, b.length))};
}

/// Returns how much of a line next to the end of a run is left to the polyline, mm.
double LineRuns::kept_straight(const Chord& chord, const Meeting& end) {
  const double length = length_of(chord);
  const double beyond = length - tuning::rebuild::kLine;
  if (end.joint != Joint::corner) return beyond > 0.5 * tuning::rebuild::kLine ? beyond : 0;
  return std::max(beyond, std::clamp(1.01 * end.needed, 0.5 * length, 0.9 * length));
}

/// Both ends of the line are known.
void LineRuns::settle(Held line, const Meeting& after) {
  if (in_run_) return feed_run(std::move(line.chord), after);
  if (line.before.joint != Joint::smooth) give_to_polyline();
  held_.push_back(std::move(line));
  if (after.joint != Joint::smooth) return give_to_polyline();
  if (held_.size() < tuning::rebuild::kFewestLines) return;
  AxisVector shares = AxisVector::Zero();
  for (const Held& held : held_)
    shares = shares.cwiseMax(path_end(held.chord).direction.cwiseAbs());
  run_.suits(shares) ? begin_run() : give_to_polyline();
}

void LineRuns::give_to_polyline() {
  for (const Held& line : held_) polyline_.add(line.chord);
  held_.clear();
}

void LineRuns::begin_run() {
  auto lines = std::exchange(held_, {});
  Chord& first = lines.front().chord;
  const Meeting& before = lines.front().before;
  const double straight = kept_straight(first, before);
  if (straight > 0) polyline_.add(take_front(first, straight));
  const bool on_line = straight > 0 || before.joint == Joint::inside;
  polyline_.end();
  run_.begin(first.from, on_line ? RunEnd::on_line : RunEnd::of_path);
  in_run_ = true;
  of_run_.clear();
  of_run_from_ = 0;
  for (Held& line : lines) {
    if (std::exchange(was_given_up_, false)) line.before.joint = Joint::corner;
    settle(std::move(line), {Joint::smooth, 0});
  }
}

void LineRuns::feed_run(Chord chord, const Meeting& after) {
  const double length = length_of(chord);
  const bool is_long = length > 3 * tuning::rebuild::kLine;
  if (after.joint == Joint::smooth && !is_long) {
    run_.add(chord);
    of_run_.push_back(std::move(chord));
    leave_run_given_up();
    while (of_run_.size() > 1 && of_run_from_ + length_of(of_run_.front()) < run_.reached()) {
      of_run_from_ += length_of(of_run_.front());
      of_run_.pop_front();
    }
    return;
  }
  const double straight =
      after.joint == Joint::smooth ? length - tuning::rebuild::kLine : kept_straight(chord, after);
  if (straight < length) {
    Chord front = straight > 0 ? take_front(chord, length - straight) : chord;
    run_.add(front);
    of_run_.push_back(std::move(front));
  }
  run_.end(straight > 0 ? RunEnd::on_line : RunEnd::of_path);
  in_run_ = false;
  leave_run_given_up();
  if (straight <= 0) return;
  if (after.joint != Joint::smooth) return polyline_.add(chord);
  polyline_.add(take_front(chord, straight - tuning::rebuild::kLine));
  held_.push_back({std::move(chord), false, {Joint::inside, 0}});
}

/// Where the run has given up, what it did not make a curve of is a polyline.
void LineRuns::leave_run_given_up() {
  if (!run_.gave_up()) return;
  double begin = of_run_from_;
  for (Chord& chord : of_run_) {
    const double end = begin + length_of(chord), from = *run_.gave_up();
    if (end > from + tuning::knots::kSamePlace) {
      if (from > begin + tuning::knots::kSamePlace) take_front(chord, from - begin);
      if (from > begin) chord.from = run_.last_point();
      polyline_.add(chord);
    }
    begin = end;
  }
  in_run_ = false;
  was_given_up_ = true;
  of_run_.clear();
}

}  // namespace softcnc::ipo
