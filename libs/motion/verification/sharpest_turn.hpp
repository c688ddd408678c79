// SPDX-License-Identifier: MIT
// How sharply a path turns, and how far a tool may lag behind on it.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include "motion/verification/path_pieces.hpp"

namespace softcnc {

/// A loop of gain Kv follows a command at speed v with a lag L = v / Kv, and smooths the path by
/// it: the tool is where the command was, weighted by exp(-x / L) / L over the path x before. To
/// first order in the turn, the smoothed path lies L times the integral of curvature times W(x / L)
/// beside the path, with W(x) = exp(-x) - 1 + x up to x = 1, where the tool is, and exp(-x) beyond.
/// On a circle of radius R that is L^2 / (2 R), and where the path turns by A at once L A / e. So a
/// turn by A within e / 2 of L leaves L A / e, be it a curve or many short chords. A corner of the
/// angle A leaves exactly L sin(A) / e.
class SharpestTurn {
 public:
  SharpestTurn();

  /// Adds the next pieces of the path, up to s, mm along the program. Joints of two rapids do not
  /// count.
  void add(const std::vector<CubicPiece>& pieces, double s);

  /// Returns the lag, mm, at which the tightest curve leaves this contour error, mm; 0: there is no
  /// curve, or none tight enough for lags up to kLongest.
  double curve_lag(double error) const noexcept;
  /// Returns the same for the sharpest corner; 0: there is none.
  double corner_lag(double error) const noexcept;

  static constexpr double kCorner = 0.2;  // rad: a larger turn at a point is a corner
  static constexpr double kShortest = 0.005, kLongest = 25;  // mm

 private:
  /// The turn of the path so far without its corners, rad, before and after a place: more after a
  /// joint.
  struct Node {
    double s, before, after;
  };
  struct Window {
    double lag = 0;        // mm
    double turn = 0;       // rad: the largest within e / 2 of it
    std::size_t from = 0;  // the node at or before its begin, counted from the first of all
  };

  void add(const CubicPiece& piece);
  double joint(double angle) noexcept;
  void push(const Node& node);
  void measure(Window& window) const noexcept;
  void forget();

  static constexpr std::size_t kWindows = 20;
  std::array<Window, kWindows> windows_;
  std::deque<Node> nodes_;
  std::size_t forgotten_ = 0;  // nodes
  double corner_ = 0;          // sin of the angle of the sharpest one
  bool started_ = false, was_rapid_ = false;
  AxisVector direction_ = AxisVector::Zero();  // at the end so far
};

}  // namespace softcnc
