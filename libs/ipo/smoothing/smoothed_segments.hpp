// SPDX-License-Identifier: MIT
// From turns and their basis functions to pieces of path: straight where there is no basis
// function, curves elsewhere.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "ipo/path/piece.hpp"
#include "ipo/smoothing/rounding.hpp"

namespace softcnc::ipo {

/// A vertex of the path, its basis function if it has one, and the line after it.
struct SmoothedVertex {
  Turn turn;  // no basis function if begin == end
  AxisVector point = AxisVector::Zero();
  AxisVector direction = AxisVector::Zero();  // by t, of the line after it
  double deviation = 0;                       // mm: of that line from the programmed ones
  MoveAttributes attributes;
  /// mm: the distance of the path from the programmed one before the peak of the basis function, if
  /// it was measured.
  std::optional<double> measured{};
  double furthest = 0;  // the largest end of this basis function and all before it
};

class SmoothedSegments {
 public:
  /// Pieces are appended to `out`, which must outlive this object.
  explicit SmoothedSegments(std::deque<Piece>& out) : out_(out) {}

  void begin(const AxisVector& point);
  /// Begins the next programmed line here, `deviation` mm from what it stands for.
  void add_programmed(double t, const AxisVector& point, double deviation);
  /// Where a line was cut in two, both parts have its mark.
  void add_mark(double t, const Mark& mark) {
    if (marks_.empty() || marks_.back().mark.number != mark.number) marks_.push_back({t, mark});
  }
  /// Adds a vertex, in the order of their positions; the first and the last one are the ends of the
  /// path.
  void add(const SmoothedVertex& vertex);
  /// Emits pieces up to `until`; no basis function that is still to be added begins before it.
  void emit(double until);
  /// Ends the path: there are no more vertices.
  void end();

  /// Returns the place, mm, up to which pieces have been emitted.
  double reached() const noexcept { return t_; }
  /// Returns the last vertices, for knots that lie close to theirs.
  const std::vector<SmoothedVertex>& vertices() const noexcept { return vertices_; }

 private:
  struct PlacedMark {
    double t;
    Mark mark;
  };
  struct PlacedPoint {
    double t;
    AxisVector point;
    double after;      // mm: largest deviation of the line after it
    double deviation;  // and of the lines on either side
  };

  void pass();
  double next_basis() const;
  double end_of_curve() const;
  void emit_line(double t1);
  void emit_curve(double t1);
  void emit_corners(const AxisVector& to, double t1, double deviation);
  void emit_piece(Path path, double t1, double deviation);
  double deviation(const Nurbs& curve, double t1) const;
  void forget();
  bool is_last(std::size_t i) const { return ended_ && i + 1 == vertices_.size(); }

  std::size_t edge_at(double t) const;
  const SmoothedVertex* vertex_at(double t) const;

  std::deque<Piece>& out_;
  std::vector<SmoothedVertex> vertices_;
  std::deque<PlacedMark> marks_;
  std::deque<PlacedPoint> programmed_;
  double t_ = 0;
  std::size_t edge_ = 0,
              passed_ = 0;  // line at t_; basis functions before this end before t_
  AxisVector point_ = AxisVector::Zero();
  bool ended_ = false;
  std::vector<PolylineEdge> edges_;  // of the piece being made
  std::vector<Turn> turns_;
  bool is_measured_ = false;  // all of it
  double measured_ = 0;       // mm
};

}  // namespace softcnc::ipo
