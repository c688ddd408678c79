// SPDX-License-Identifier: MIT
// A mesh of knots along short lines: the cubic spline on it, and how far that is from the lines.
//
// Over every three knots in a row there is a hat, and where their mean is, a control point. On the
// lines the control points make the variation diminishing spline of Schoenberg (1967), which is
// h^2 / 6 of the second derivative off, h being the spacing. Moved off the lines by as much, to the
// other side, they make a quasi-interpolant (C. de Boor and G. J. Fix, Spline approximation by
// quasiinterpolants, 1973), which a cubic leaves as it is:
//
//     shift = -((a - b)^2 + (b - c)^2 + (c - a)^2) / 36 * p''   for knots a, b, c.
//
// With p'' as the second differences of the lines tell it, it is h^4 / 36 of the fourth derivative
// off, so its knots may lie many times further apart. Where the curvature jumps by 1, that of the
// spline swings over by a sixth of that. With the mean of p'' over three hats, weighted by 1, 2
// and 1, it is by a twelfth, and h^4 / 14.4 off.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ipo/smoothing/line_vertex.hpp"
#include "ipo/smoothing/rounding.hpp"

namespace softcnc::ipo {

class ChordMesh {
 public:
  using Lines = std::span<const LineVertex>;

  /// How much of the tolerance a span uses at most, and how far it is from the programmed path, mm.
  struct Off {
    double share = 0, deviation = 0;
  };

  /// The mesh begins in a vertex, its first hat symmetric.
  ChordMesh(Lines lines, std::size_t first, double spacing);

  /// One more knot and the hat that it ends. Hats between knots that all are `near` have their
  /// control points on the lines.
  void lay(Lines lines, double spacing, bool near);
  /// Leaves the first hats and their knots. What follows will not change them.
  void cut_back(std::size_t hats);
  /// Forgets so many lines in front, and hats that are not needed to shape those from `hat` on.
  /// Returns how many hats.
  std::size_t forget_hats(std::size_t hat);
  void forget_lines(std::size_t count);

  std::size_t hats() const noexcept { return hats_.size(); }
  double last() const noexcept { return knots_.back(); }
  double spacing() const noexcept { return knots_.back() - knots_[knots_.size() - 2]; }
  double mean() const noexcept { return hats_.back().mean; }
  double knot(std::size_t i) const noexcept { return knots_[i]; }
  std::size_t edge(std::size_t hat) const noexcept { return hats_[hat].edge; }
  bool is_near(std::size_t hat) const noexcept { return hats_[hat].near; }

  /// Spans are counted by the knot at which they begin; the hats of the first two are not all of
  /// this mesh. How many have all of their control points.
  std::size_t complete_spans() const noexcept;
  /// Whether all that shapes the span lies on the lines, knots near each other.
  bool is_near_span(std::size_t span) const noexcept;
  /// Between knots and vertices the distance from the lines is a cubic polynomial, and no longer
  /// anywhere than the longest of its Bezier points.
  Off measure(Lines lines, std::size_t span);
  /// What was measured, mm.
  const std::optional<double>& deviation(std::size_t span) const noexcept {
    return hats_[span].deviation;
  }

  /// A hat, its kink between the control points on either side; `before` is the direction in front
  /// of the first one.
  Turn turn(std::size_t hat) const;
  const AxisVector& point(std::size_t hat) const noexcept { return hats_[hat].point; }
  /// By t, from a hat's control point to the next.
  AxisVector direction(std::size_t hat) const;

 private:
  struct Hat {
    double mean;
    std::size_t edge;          // the line on which the mean lies
    AxisVector middle, point;  // on that line; the control point
    bool near;
    std::optional<double> deviation{};  // mm: of the span that begins here
  };
  struct Place {
    AxisVector q, dq, ddq;
  };

  void add_hat(Lines lines, std::size_t edge, bool near);
  void shift(std::size_t hat);
  AxisVector bend_of_lines(std::size_t hat) const;
  Place at_knot(std::size_t i) const;
  AxisVector bend(std::size_t hat) const;

  std::vector<double> knots_;
  std::vector<Hat> hats_;
  std::size_t settled_ = 0;   // hats whose control points are known
  bool last_is_near_ = true;  // the last spacing
};

}  // namespace softcnc::ipo
