// SPDX-License-Identifier: MIT
// How far a spline is from the lines it stands for, and they from it, as bounds that hold
// everywhere: no point between samples is further off.
//
// The part of a line between two places and the part of the curve between the points nearest to
// these are compared at equal shares of their parameters. Their difference is a polynomial, nowhere
// longer than the longest of its Bezier points, and a bound both ways. Where it is not low enough,
// each way is looked at alone: a polynomial lies in the convex hull of its Bezier points, and the
// distance from a segment is convex, so that no point of the curve is further from a line than the
// furthest of them; parts of lines are compared as before; and both are halved while that helps.
#pragma once

#include <vector>

#include "ipo/rebuild/guide.hpp"
#include "ipo/rebuild/quintic.hpp"

namespace softcnc::ipo {

/// A place of the lines and the parameter at which the curve passes it.
struct Foot {
  double t, u;  // mm
};

class TubeCheck {
 public:
  /// Of what lies between t0 of the guide and the end of the spline. The spline begins at t0 or
  /// before it, and its parameter is that of the lines within Guide::slip(). Both must outlive the
  /// check.
  TubeCheck(const Guide& guide, const QuinticSpline& spline, double t0);

  /// Returns for every span of the spline how far the curve and the lines are apart there, by their
  /// tolerance; 0 for spans before t0.
  std::vector<double> shares();
  /// Returns the largest such distance, mm, with that of the lines from the programmed ones.
  double furthest() const noexcept { return furthest_; }
  /// Returns where the curve passes t0, the vertices, and t1.
  const std::vector<Foot>& feet() const noexcept { return feet_; }

 private:
  struct Part {  // of a line, and of the curve in one span
    std::size_t line, span;
    Foot begin, end;
  };

  void find_feet(double t0, double t1);
  double share(const Part& part);
  double curve_share(const QuinticBezier& curve, double t0, double t1, int halvings);
  double line_share(const Part& part, int halvings);
  double matched(const Part& part) const;
  double count(double distance, std::size_t line);
  double foot(double t, double guess) const;
  AxisVector on_line(std::size_t line, double t) const;
  double along_line(std::size_t line, const AxisVector& point) const;
  AxisVector on_curve(double u) const;
  QuinticBezier curve_of(const Part& part) const;

  const Guide& guide_;
  const QuinticSpline& spline_;
  std::vector<QuinticBezier> curves_;  // by span
  std::vector<Foot> feet_;
  std::size_t first_line_ = 0;
  double furthest_ = 0;
};

}  // namespace softcnc::ipo
