// SPDX-License-Identifier: MIT
// Random part programs of every kind of path, the same in every run.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "support/figures.hpp"
#include "support/run.hpp"

namespace softcnc::test {

/// A random chain of lines, arcs and cubic splines, tangent or not.
inline std::vector<Block> random_program(std::mt19937& random, int count) {
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  std::vector<std::variant<Move, Dwell, Action>> moves;
  AxisVector here(0, 0, 0);
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, uniform(-2, 1.5));
    const double feed = std::pow(10.0, uniform(0.5, 2.4));
    const PathMode join = random() % 8 == 0 ? PathMode::stop : PathMode::follow;
    const AxisVector to = here + size * AxisVector(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    const auto kind = random() % 4;
    if (kind == 0) {
      moves.emplace_back(Move{Line(here, to), random() % 3 == 0, feed, join});
      here = to;
    } else if (kind == 1) {
      const double start = uniform(0, 6.28), sweep = uniform(0.2, 6.0), radius = size;
      const AxisVector center = here - radius * AxisVector(std::cos(start), std::sin(start), 0);
      AxisVector end =
          center + radius * AxisVector(std::cos(start + sweep), std::sin(start + sweep), 0);
      end[2] += uniform(-0.5, 0.5) * size;
      const Arc arc = Arc::make({here, end, center, Plane::xy, true, 0}).value();
      moves.emplace_back(Move{arc, false, feed, join});
      here = end;
    } else if (kind == 2) {
      NurbsSpec spec;
      spec.degree = 3;
      AxisVector p = here;
      for (int k = 0; k < 8; ++k) {
        spec.control.push_back(p);
        spec.weights.push_back(std::pow(10.0, uniform(-0.5, 0.5)));
        p += size * AxisVector(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      }
      spec.knots = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5};
      here = spec.control.back();
      moves.emplace_back(Move{Nurbs::make(spec).value(), false, feed, join});
    } else {
      // Short chords with small turns, as CAM systems chop curves.
      double heading = uniform(0, 6.28);
      for (int k = 0; k < 20; ++k) {
        const AxisVector next =
            here + 0.02 * size * AxisVector(std::cos(heading), std::sin(heading), 0);
        moves.emplace_back(Move{Line(here, next), false, feed, PathMode::follow});
        here = next;
        heading += uniform(0, 0.012);
      }
    }
  }
  return number_blocks(std::move(moves));
}

/// Overrides from 0 to 200 % and holds, each a few samples after the one before; released at last.
inline Controls random_controls(std::mt19937& random, int count) {
  Controls controls;
  int row = 0;
  const auto later = [&] {
    const int most = std::array{3, 30, 300}[random() % 3];
    return row += 1 + static_cast<int>(random() % static_cast<unsigned>(most));
  };
  for (int i = 0; i < count; ++i) {
    ipo::FeedControl& control = controls[later()];
    control.feed_override = random() % 5 == 0 ? 0.0 : static_cast<double>(random() % 201) / 100;
    control.hold = random() % 4 == 0;
  }
  controls[later()] = {};
  return controls;
}

/// A machine with jerk limits: 300 to 6,000 mm/s^2, reached in 5 to 200 ms.
inline Machine random_machine(std::mt19937& random) {
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  Machine machine;
  machine.limits.feed = 0;
  machine.control.period = std::array{1e-3, 1e-3, 2e-3, 4e-3, 8e-3}[random() % 5];
  machine.control.chord_tolerance = std::array{1e-3, 1e-3, 5e-5, 5e-3}[random() % 4];
  const double acceleration = std::pow(10.0, uniform(2.5, 3.8));
  const double time = std::pow(10.0, uniform(-2.3, -0.7));
  for (Axis& axis : machine.axes) {
    axis.velocity = 250;
    axis.acceleration = acceleration;
    axis.jerk = acceleration / time;
  }
  if (random() % 3 == 0) {
    machine.axes[2].acceleration *= 0.3;
    machine.axes[1].velocity = 60;
  }
  if (random() % 3 == 0) machine.axes[1].jerk *= 0.3;
  if (random() % 6 == 0) machine.axes[0].jerk = 0;
  return machine;
}

/// What is less usual, each once in a while: limits along the path, axes far apart, rounded corners
/// and joined chords, and what happens at rest between moves.
inline void vary(std::mt19937& random, Machine& machine, std::vector<Block>& blocks) {
  const auto power = [&](double a, double b) {
    return std::pow(10.0, a + (b - a) * static_cast<double>(random()) /
                                  static_cast<double>(std::mt19937::max()));
  };
  const double acceleration = machine.axes[0].acceleration;
  if (random() % 4 == 0) machine.limits.tangential = acceleration * power(-1, 0.2);
  if (random() % 4 == 0) machine.limits.normal = acceleration * power(-1, 0.2);
  if (random() % 6 == 0) {
    const double part = power(-1.3, 0);
    Axis& axis = machine.axes[random() % kAxes];
    axis.velocity *= part;
    axis.acceleration *= part;
    axis.jerk *= part;
  }
  if (random() % 3 == 0) {
    const double deviation = power(-3, -0.3), merged = random() % 2 == 0 ? deviation : 0;
    for (Block& block : blocks)
      if (Move* move = std::get_if<Move>(&block.what)) {
        move->corner_tolerance = deviation;
        move->chord_tolerance = merged;
      }
  }
  if (random() % 4 != 0) return;
  std::vector<std::variant<Move, Dwell, Action>> whats;
  for (Block& block : blocks) {
    if (random() % 8 == 0) whats.emplace_back(Dwell{power(-4, -1)});
    if (random() % 8 == 0) whats.emplace_back(Action{Action::Kind::coolant, 8});
    whats.push_back(std::move(block.what));
  }
  blocks = number_blocks(std::move(whats));
}

/// A program in X and Y, or along X alone, where lines lead from end to end of its moves.
inline std::vector<Block> in_axes(const std::vector<Block>& blocks, int count) {
  const auto left = [count](AxisVector point) {
    point.tail(kAxes - count).setZero();
    return point;
  };
  const auto level = [&](const Path& path) -> Path {
    if (count == 1 || std::holds_alternative<Line>(path))
      return Line(left(position(path, 0)), left(end(path)));
    if (const Arc* arc = std::get_if<Arc>(&path))
      return Arc::make({left(arc->from()), left(arc->to()), left(arc->center()), Plane::xy,
                        arc->ccw(), arc->turns()})
          .value();
    NurbsSpec spec = std::get<Nurbs>(path).spec();
    for (AxisVector& point : spec.control) point = left(point);
    return Nurbs::make(spec).value();
  };
  std::vector<std::variant<Move, Dwell, Action>> whats;
  for (const Block& block : blocks) {
    whats.push_back(block.what);
    Move* move = std::get_if<Move>(&whats.back());
    if (move == nullptr) continue;
    move->path = level(move->path);
    if (!(length(move->path) > 0)) whats.pop_back();
  }
  return number_blocks(std::move(whats));
}

/// Once in a while the machine has two axes or one, whichever, and the program moves those.
inline void leave_out_axes(std::mt19937& random, Machine& machine, std::vector<Block>& blocks) {
  const int count = std::array{3, 3, 3, 3, 3, 2, 2, 1}[random() % 8];
  if (count == kAxes) return;
  const Turning turning =
      std::array<Turning, 3>{{{{0, 1, 2}}, {{1, 2, 0}}, {{2, 0, 1}}}}[random() % 3];
  blocks = in_axes(blocks, count);
  for (Block& block : blocks)
    if (Move* move = std::get_if<Move>(&block.what)) move->path = std::visit(turning, move->path);
  for (std::size_t i = static_cast<std::size_t>(count); i < machine.axes.size(); ++i)
    machine.axes[static_cast<std::size_t>(turning.axis[i])].present = false;
}

}  // namespace softcnc::test
