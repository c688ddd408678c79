// SPDX-License-Identifier: MIT
// A knot vector along short lines: the cubic spline on it, and its distance from the lines.
//
// Every three consecutive knots carry a basis function (the triangle of the second derivative), and
// at their mean a control point. With control points on the lines this is the variation diminishing
// spline of Schoenberg (1967), which is off by h^2 / 6 of the second derivative, h being the
// spacing. Moved off the lines by as much, to the other side, they make a quasi-interpolant (C. de
// Boor and G. J. Fix, Spline approximation by quasiinterpolants, 1973), which reproduces cubics:
//
//     shift = -((a - b)^2 + (b - c)^2 + (c - a)^2) / 36 * p''   for knots a, b, c.
//
// With p'' from the second differences of the lines, it is off by h^4 / 36 of the fourth
// derivative, so its knots may lie many times further apart. Where the curvature jumps by 1, that
// of the spline overshoots by a sixth of that. With the mean of p'' over three basis functions,
// weighted by 1, 2 and 1, it overshoots by a twelfth and is off by h^4 / 14.4.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ipo/smoothing/line_vertex.hpp"
#include "ipo/smoothing/rounding.hpp"

namespace softcnc::ipo {

class ChordKnots {
 public:
  using Lines = std::span<const LineVertex>;

  /// The largest part of the tolerance that a span uses, and its distance from the programmed path,
  /// mm.
  struct Off {
    double share = 0, deviation = 0;
  };

  /// The knot vector begins in a vertex; its first basis function is symmetric.
  ChordKnots(Lines lines, std::size_t first, double spacing);

  /// Adds a knot and the basis function that it ends. Basis functions between knots that all are
  /// `near` have their control points on the lines.
  void lay(Lines lines, double spacing, bool near);
  /// Keeps the first `bases` basis functions and their knots, which what follows will not change.
  void cut_back(std::size_t bases);
  /// Drops `count` lines at the front, and basis functions that are not needed to shape those from
  /// `basis` on. Returns how many basis functions.
  std::size_t forget_bases(std::size_t basis);
  void forget_lines(std::size_t count);

  std::size_t bases() const noexcept { return bases_.size(); }
  double last() const noexcept { return knots_.back(); }
  double spacing() const noexcept { return knots_.back() - knots_[knots_.size() - 2]; }
  double mean() const noexcept { return bases_.back().mean; }
  double knot(std::size_t i) const noexcept { return knots_[i]; }
  std::size_t edge(std::size_t basis) const noexcept { return bases_[basis].edge; }
  bool is_near(std::size_t basis) const noexcept { return bases_[basis].near; }

  /// Spans are counted by the knot at which they begin; the basis functions of the first two do not
  /// all belong to this knot vector. Returns how many have all of their control points.
  std::size_t complete_spans() const noexcept;
  /// Whether all that shapes the span lies on the lines, with knots near each other.
  bool is_near_span(std::size_t span) const noexcept;
  /// Measures a span. Between knots and vertices the distance from the lines is a cubic polynomial,
  /// nowhere longer than the longest of its Bezier points.
  Off measure(Lines lines, std::size_t span);
  /// Returns what was measured, mm.
  const std::optional<double>& deviation(std::size_t span) const noexcept {
    return bases_[span].deviation;
  }

  /// Returns the turn of a basis function without its tangent jump.
  Turn turn(std::size_t basis) const;
  const AxisVector& point(std::size_t basis) const noexcept { return bases_[basis].point; }
  /// Returns the direction, by t, from the control point of a basis function to the next.
  AxisVector direction(std::size_t basis) const;

 private:
  struct Basis {
    double mean;
    std::size_t edge;          // the line on which the mean lies
    AxisVector middle, point;  // on that line; the control point
    bool near;
    std::optional<double> deviation{};  // mm: of the span that begins here
  };
  struct Place {
    AxisVector q, dq, ddq;
  };

  void add_basis(Lines lines, std::size_t edge, bool near);
  void shift(std::size_t basis);
  AxisVector curvature_of_lines(std::size_t basis) const;
  Place at_knot(std::size_t i) const;
  AxisVector curvature(std::size_t basis) const;

  std::vector<double> knots_;
  std::vector<Basis> bases_;
  std::size_t settled_ = 0;   // basis functions whose control points are known
  bool last_is_near_ = true;  // the last spacing
};

}  // namespace softcnc::ipo
