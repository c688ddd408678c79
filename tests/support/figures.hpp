// SPDX-License-Identifier: MIT
// Figures of all kinds of path, and the same figures described in other ways.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/run.hpp"

namespace softcnc::test {

/// A path of some moves; `corner` mm: how far its joints may be rounded.
struct Figure {
  std::string name;
  std::vector<Path> paths;
  double corner = 0;
};

/// `feed` in mm/s.
inline std::vector<Block> blocks_of(const Figure& figure, double feed) {
  std::vector<std::variant<Move, Dwell, Action>> moves;
  for (const Path& path : figure.paths)
    moves.emplace_back(Move{path, false, feed, PathMode::follow, figure.corner});
  return number_blocks(std::move(moves));
}

inline Figure polyline_figure(std::string name, const std::vector<AxisVector>& points,
                              double corner = 0) {
  Figure figure{std::move(name), {}, corner};
  for (std::size_t i = 1; i < points.size(); ++i)
    figure.paths.emplace_back(Line(points[i - 1], points[i]));
  return figure;
}

/// A part of a circle in chords, their ends rounded to micrometres where corners are rounded, too.
inline Figure chopped_circle(double radius, double chord, double angle, double corner) {
  const int count = static_cast<int>(radius * angle / chord);
  std::vector<AxisVector> points;
  for (int i = 0; i <= count; ++i) {
    const double at = angle * i / count;
    points.emplace_back(radius * std::sin(at), radius * (1 - std::cos(at)), 0);
    if (corner > 0) points.back() = (points.back() * 1e3).array().round() / 1e3;
  }
  return polyline_figure("chopped circle", points, corner);
}

/// Arcs with these radii, left and right in turn, each tangent to the one before.
inline Figure tangent_arcs(const std::vector<double>& radii) {
  Figure figure{"tangent arcs", {}};
  AxisVector here(0, 0, 0);
  double heading = 0, side = 1;
  for (const double radius : radii) {
    const auto arm = [&](double at) {
      return AxisVector(side * radius * AxisVector(std::sin(at), -std::cos(at), 0));
    };
    const AxisVector center = here - arm(heading);
    heading += side * (0.5 + 2 / radius);
    const AxisVector to = center + arm(heading);
    figure.paths.emplace_back(Arc::make({here, to, center, Plane::xy, side > 0}).value());
    here = to;
    side = -side;
  }
  return figure;
}

// The same in other ways --------------------------------------------------------------------------

template <typename Change>
Figure changed(Figure figure, Change&& change) {
  for (Path& path : figure.paths) path = std::visit(change, path);
  return figure;
}

/// Axis i becomes axis[i], in the direction sign[i].
struct Turning {
  std::array<int, kAxes> axis{0, 1, 2};
  std::array<double, kAxes> sign{1, 1, 1};

  AxisVector operator()(const AxisVector& point) const {
    AxisVector turned;
    for (std::size_t i = 0; i < axis.size(); ++i)
      turned[axis[i]] = sign[i] * point[static_cast<int>(i)];
    return turned;
  }

  Path operator()(const Line& line) const { return Line((*this)(line.from()), (*this)(line.to())); }

  Path operator()(const Arc& arc) const {
    const PlaneAxes axes = plane_axes(arc.plane());
    const int across = axis[static_cast<std::size_t>(axes.across)];
    const Plane plane = across == 2 ? Plane::xy : across == 1 ? Plane::zx : Plane::yz;
    const AxisVector first = (*this)(AxisVector::Unit(axes.first));
    const AxisVector second = (*this)(AxisVector::Unit(axes.second));
    const bool ccw = (first.cross(second)[across] > 0) == arc.ccw();
    return Arc::make({(*this)(arc.from()), (*this)(arc.to()), (*this)(arc.center()), plane, ccw,
                      arc.turns()})
        .value();
  }

  Path operator()(const Nurbs& nurbs) const {
    NurbsSpec spec = nurbs.spec();
    for (AxisVector& point : spec.control) point = (*this)(point);
    return Nurbs::make(spec).value();
  }
};

inline Figure turned(const Figure& figure, const Turning& turning) {
  return changed(figure, turning);
}

/// Each axis takes its limits along.
inline Machine turned(const Machine& machine, const Turning& turning) {
  Machine other = machine;
  for (std::size_t i = 0; i < machine.axes.size(); ++i)
    other.axes[static_cast<std::size_t>(turning.axis[i])] = machine.axes[i];
  return other;
}

/// From its end to its beginning.
inline Figure reversed(const Figure& figure) {
  struct Reverse {
    Path operator()(const Line& line) const { return Line(line.to(), line.from()); }
    Path operator()(const Arc& arc) const {
      return Arc::make({arc.to(), arc.from(), arc.center(), arc.plane(), !arc.ccw(), arc.turns()})
          .value();
    }
    Path operator()(const Nurbs& nurbs) const {
      NurbsSpec spec = nurbs.spec();
      std::reverse(spec.control.begin(), spec.control.end());
      std::reverse(spec.weights.begin(), spec.weights.end());
      std::reverse(spec.knots.begin(), spec.knots.end());
      const double last = spec.knots.front();
      for (double& knot : spec.knots) knot = last - knot;
      return Nurbs::make(spec).value();
    }
  };
  Figure other = changed(figure, Reverse());
  std::reverse(other.paths.begin(), other.paths.end());
  return other;
}

/// Every line as two, one twice as long as the other.
inline Figure split_lines(const Figure& figure) {
  Figure other{figure.name, {}, figure.corner};
  for (const Path& path : figure.paths) {
    const Line* line = std::get_if<Line>(&path);
    if (line == nullptr) {
      other.paths.push_back(path);
      continue;
    }
    const AxisVector between = line->from() + (line->to() - line->from()) / 3;
    other.paths.emplace_back(Line(line->from(), between));
    other.paths.emplace_back(Line(between, line->to()));
  }
  return other;
}

/// W. Boehm, Inserting new knots into B-spline curves, Computer-Aided Design 12, 1980.
inline NurbsSpec with_knot(const NurbsSpec& spec, double knot) {
  const auto p = static_cast<std::size_t>(spec.degree);
  const auto k = static_cast<std::size_t>(
      std::upper_bound(spec.knots.begin(), spec.knots.end(), knot) - spec.knots.begin() - 1);
  NurbsSpec other{spec.degree, {}, {}, spec.knots};
  other.knots.insert(other.knots.begin() + static_cast<std::ptrdiff_t>(k) + 1, knot);
  for (std::size_t i = 0; i <= spec.control.size(); ++i) {
    const double a = i + p <= k ? 1
                     : i > k    ? 0
                                : (knot - spec.knots[i]) / (spec.knots[i + p] - spec.knots[i]);
    const auto weighted = [&](std::size_t j) {
      return AxisVector(spec.weights[j] * spec.control[j]);
    };
    const double own = a > 0 ? a * spec.weights[i] : 0;
    const double before = a < 1 ? (1 - a) * spec.weights[i - 1] : 0;
    AxisVector point = AxisVector::Zero();
    if (a > 0) point += a * weighted(i);
    if (a < 1) point += (1 - a) * weighted(i - 1);
    other.weights.push_back(own + before);
    other.control.emplace_back(point / (own + before));
  }
  return other;
}

/// One in the middle of every span of every NURBS.
inline Figure with_knots(const Figure& figure) {
  struct Insert {
    Path operator()(const Line& line) const { return line; }
    Path operator()(const Arc& arc) const { return arc; }
    Path operator()(const Nurbs& nurbs) const {
      const std::vector<double>& knots = nurbs.spec().knots;
      NurbsSpec spec = nurbs.spec();
      for (std::size_t i = 1; i < knots.size(); ++i)
        if (knots[i] > knots[i - 1]) spec = with_knot(spec, 0.5 * (knots[i] + knots[i - 1]));
      return Nurbs::make(spec).value();
    }
  };
  return changed(figure, Insert());
}

/// Every arc, of less than half a circle, as a NURBS of degree 2.
inline Figure arcs_as_nurbs(const Figure& figure) {
  struct Convert {
    Path operator()(const Line& line) const { return line; }
    Path operator()(const Nurbs& nurbs) const { return nurbs; }
    Path operator()(const Arc& arc) const {
      const double half = std::cos(0.5 * arc.sweep());
      const AxisVector middle = 0.5 * (arc.from() + arc.to());
      const AxisVector corner = arc.center() + (middle - arc.center()) / (half * half);
      return Nurbs::make({2, {arc.from(), corner, arc.to()}, {1, half, 1}, {0, 0, 0, 1, 1, 1}})
          .value();
    }
  };
  return changed(figure, Convert());
}

/// With the rounding of numbers that were inches.
inline Figure through_inches(const Figure& figure) {
  struct Convert {
    static AxisVector round(const AxisVector& point) { return 25.4 * (point / 25.4); }
    Path operator()(const Line& line) const { return Line(round(line.from()), round(line.to())); }
    Path operator()(const Arc& arc) const {
      return Arc::make({round(arc.from()), round(arc.to()), round(arc.center()), arc.plane(),
                        arc.ccw(), arc.turns()})
          .value();
    }
    Path operator()(const Nurbs& nurbs) const {
      NurbsSpec spec = nurbs.spec();
      for (AxisVector& point : spec.control) point = round(point);
      return Nurbs::make(spec).value();
    }
  };
  return changed(figure, Convert());
}

}  // namespace softcnc::test
