// SPDX-License-Identifier: MIT
// Rounded paths beside the programmed ones: how far apart, how smooth, in which order.
#pragma once

#include <algorithm>
#include <vector>

#include "ipo/planner/trial_plan.hpp"
#include "ipo/smoothing/corner_stage.hpp"

namespace softcnc::test {

inline const Path& path_of(const Block& block) { return std::get<Move>(block.what).path; }

/// What the stage makes of the blocks.
inline std::vector<ipo::Piece> rounded(const Machine& machine, const std::vector<Block>& blocks) {
  ipo::CornerStage stage(machine, ipo::make_trial_plan(machine));
  std::vector<ipo::Piece> pieces;
  const auto take = [&] {
    while (auto piece = stage.pop()) pieces.push_back(std::move(*piece));
  };
  for (const Block& block : blocks) {
    stage.push(block);
    take();
  }
  stage.finish();
  take();
  return pieces;
}

/// Paths as many points, for brute force: the nearest of them, then golden sections around it.
class Cloud {
 public:
  void add(const Path& path) {
    const int steps = std::holds_alternative<Line>(path) ? 1 : 400;
    for (int i = 0; i <= steps; ++i) {
      const double s = i == steps ? length(path) : length(path) * i / steps;
      points_.push_back({&path, s, length(path) / steps, position(path, s)});
    }
  }

  double distance(const AxisVector& q) const {
    double best = 1e300;
    for (const Point& point : points_) best = std::min(best, (point.q - q).norm());
    for (const Point& point : points_)
      if ((point.q - q).norm() - point.step <= best) best = std::min(best, around(point, q));
    return best;
  }

  const auto& points() const { return points_; }

 private:
  struct Point {
    const Path* path;
    double s, step;
    AxisVector q;
  };

  static double around(const Point& point, const AxisVector& q) {
    constexpr double kGolden = 0.6180339887498949;
    double a = std::max(0.0, point.s - point.step);
    double b = std::min(length(*point.path), point.s + point.step);
    const auto off = [&](double s) { return (position(*point.path, s) - q).norm(); };
    while (b - a > 1e-10) {
      const double left = b - kGolden * (b - a), right = a + kGolden * (b - a);
      off(left) < off(right) ? b = right : a = left;
    }
    return std::min(
        {off(a), off(point.s),
         off(length(*point.path) - point.s < point.step ? length(*point.path) : point.s)});
  }

  std::vector<Point> points_;
};

/// The largest distance of one from the other, in both directions, mm.
inline double apart(const std::vector<Block>& blocks, const std::vector<ipo::Piece>& pieces) {
  Cloud programmed, run;
  for (const Block& block : blocks) programmed.add(path_of(block));
  for (const ipo::Piece& piece : pieces) run.add(path_of(piece.block));
  double largest = 0;
  for (const auto* side : {&programmed, &run}) {
    const Cloud& other = side == &run ? programmed : run;
    const std::size_t every = 1 + side->points().size() / 1500;
    for (std::size_t i = 0; i < side->points().size(); i += every)
      largest = std::max(largest, other.distance(side->points()[i].q));
  }
  return largest;
}

/// The largest distance of points from a polyline, mm.
inline double from_polyline(const std::vector<AxisVector>& points,
                            const std::vector<AxisVector>& corners) {
  double largest = 0;
  for (const AxisVector& point : points) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const AxisVector way = corners[i] - corners[i - 1], off = point - corners[i - 1];
      const double square = way.squaredNorm();
      const double part = square > 0 ? std::clamp(off.dot(way) / square, 0.0, 1.0) : 0;
      nearest = std::min(nearest, (off - part * way).squaredNorm());
    }
    largest = std::max(largest, std::sqrt(nearest));
  }
  return largest;
}

/// The largest jumps between and within pieces, except for turns of more than `most` (rad), at
/// which the machine rests.
struct Jumps {
  double gap = 0, turn = 0, curvature = 0;  // mm; rad; part of the curvature and 1/mm
  int rests = 0;
};
inline Jumps jumps(const std::vector<ipo::Piece>& pieces, double most = 1.9) {
  Jumps jumps;
  const auto joint = [&](const PathPoint& a, const PathPoint& b) {
    jumps.gap = std::max(jumps.gap, (a.q - b.q).norm());
    if ((a.dq - b.dq).norm() > most) {
      ++jumps.rests;
      return;
    }
    jumps.turn = std::max(jumps.turn, (a.dq - b.dq).norm());
    jumps.curvature = std::max(jumps.curvature, (a.ddq - b.ddq).norm() / (1 + a.ddq.norm()));
  };
  const Path* before = nullptr;
  for (const ipo::Piece& piece : pieces) {
    const Path& path = path_of(piece.block);
    if (before) joint(at(*before, length(*before), Side::before), at(path, 0));
    for (const double s : breaks(path)) joint(at(path, s, Side::before), at(path, s));
    before = &path;
  }
  return jumps;
}

/// Every block once, in order, with its line.
inline bool in_order(const std::vector<ipo::Piece>& pieces) {
  int number = 0;
  for (const ipo::Piece& piece : pieces) {
    if (piece.block.number < number || piece.block.number > number + 1) return false;
    number = piece.block.number;
    double s = 0;
    for (const ipo::Mark& mark : piece.marks) {
      const bool next = mark.number == number + 1 && mark.source.line == mark.number;
      if (!next || mark.s < s || mark.s > length(path_of(piece.block))) return false;
      number = mark.number;
      s = mark.s;
    }
  }
  return true;
}

}  // namespace softcnc::test
