// SPDX-License-Identifier: MIT
#include "ipo/planner.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/travel.hpp"

namespace softcnc::ipo {
namespace {

void add(Profile& profile, const SpeedPiece& piece) {
  profile.add_piece(piece.s0, piece.s1, std::sqrt(piece.q0), std::sqrt(piece.q1), piece.limit);
}

/// The largest acceleration the axes together can give, mm/s^2.
double acceleration_norm(const Constraints& constraints) {
  AxisVector a = constraints.acceleration_limits();
  for (int i = 0; i < kAxes; ++i)
    if (a[i] == kUnlimited) a[i] = 0;
  return a.norm();
}

}  // namespace

Planner::Planner(const Machine& machine, double feed_override, Diagnostics& diagnostics)
    : machine_(machine),
      diagnostics_(diagnostics),
      constraints_(machine, feed_override),
      window_(constraints_) {}

void Planner::push(Block block) {
  std::size_t intervals = 0;
  if (const Move* move = std::get_if<Move>(&block.what)) {
    const std::size_t before = window_.size();
    window_.append(*move, rest_);
    intervals = window_.size() - before;
    counts_.nodes += intervals;
    if (auto outside = check_travel(*move, window_.newest(intervals), machine_)) {
      outside->pos = block.source;
      diagnostics_.report(std::move(*outside));
    }
    rest_ = move->join == Join::stop;
  } else {
    rest_ = true;
  }
  pending_.push_back({{std::move(block), {}, 0, 0}, intervals});
}

std::optional<TimedBlock> Planner::pop() {
  if (pending_.empty()) return std::nullopt;
  Pending& next = pending_.front();
  if (const Dwell* dwell = std::get_if<Dwell>(&next.timed.block.what))
    next.timed.profile.add_rest(dwell->duration);
  while (!run(next))
    if (!settle()) return std::nullopt;
  return take();
}

/// Runs what is settled of a block; true when all of it is.
bool Planner::run(Pending& pending) {
  for (; pending.intervals > 0 && settled_ > 0; --pending.intervals, --settled_) {
    pieces_.clear();
    window_.run_front(pieces_);
    for (const SpeedPiece& piece : pieces_) add(pending.timed.profile, piece);
    if (window_.front_q() == 0) rest_at_turn(pending);
  }
  return pending.intervals == 0;
}

/// Passes over the window are worth their while only when it has grown.
bool Planner::settle() {
  if (!finished_ && window_.size() < std::max<std::size_t>(64, 2 * last_size_)) return false;
  settled_ = window_.settle(finished_);
  ++counts_.passes;
  last_size_ = window_.size() - settled_;
  return settled_ > 0;
}

/// Where the direction turns at a stop between two rows, the polyline through the rows would cut
/// the corner; if by too much, the machine waits for the next row.
void Planner::rest_at_turn(Pending& pending) {
  if (window_.size() == 0 || !window_.turns_at_front()) return;
  const double period = constraints_.period();
  const double t = t_ + pending.timed.profile.duration();
  const double after_row = t - std::floor(t / period) * period;
  const double nearest = std::min(after_row, period - after_row);
  if (0.5 * acceleration_norm(constraints_) * nearest * nearest >
      0.5 * constraints_.chord_tolerance())
    pending.timed.profile.add_rest(period - after_row);
}

TimedBlock Planner::take() {
  TimedBlock timed = std::move(pending_.front().timed);
  pending_.pop_front();
  timed.t_start = t_;
  timed.s_start = s_;
  t_ = timed.t_end();
  if (const Move* move = timed.move()) s_ += length(move->path);
  return timed;
}

}  // namespace softcnc::ipo
