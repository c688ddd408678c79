// SPDX-License-Identifier: MIT
// From turns and their hats to pieces of path: straight where no hat is, curves where hats are.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "ipo/path/piece.hpp"
#include "ipo/smoothing/rounding.hpp"

namespace softcnc::ipo {

/// A place where the path turns, its hat if it has one, and the line behind it.
struct Bend {
  Turn turn;  // no hat where it begins and ends at once
  AxisVector point = AxisVector::Zero();
  AxisVector direction = AxisVector::Zero();  // by t, of the line behind
  double deviation = 0;                       // mm: of that line from the programmed ones
  Manner manner;
  /// mm: how far the path is from the programmed one before the peak of the hat, if it was
  /// measured.
  std::optional<double> measured{};
  double furthest = 0;  // where the last of this hat and all before it ends: BendPieces::add()
};

class BendPieces {
 public:
  /// Pieces are appended to `out`, which must outlive this.
  explicit BendPieces(std::deque<Piece>& out) : out_(out) {}

  void begin(const AxisVector& point);
  /// The next line that was programmed begins here, `deviation` mm from what it stands for.
  void add_vertex(double t, const AxisVector& point, double deviation);
  void add_mark(double t, const Mark& mark) { marks_.push_back({t, mark}); }
  /// In the order of their places; the first and the last one are the ends of the path.
  void add(const Bend& bend);
  /// No hat that is still to be added begins before `until`.
  void emit(double until);
  /// There are no more bends.
  void end();

  /// Pieces are out up to here, mm.
  double reached() const noexcept { return t_; }
  /// The last bends, for knots that lie close to theirs.
  const std::vector<Bend>& bends() const noexcept { return bends_; }

 private:
  struct PlacedMark {
    double t;
    Mark mark;
  };
  struct PlacedPoint {
    double t;
    AxisVector point;
    double behind;     // mm: what the line behind stands for is off, at most
    double deviation;  // and the lines on either side
  };

  void pass();
  double next_hat() const;
  double end_of_curve() const;
  void emit_line(double t1);
  void emit_curve(double t1);
  void emit_corners(const AxisVector& to, double t1, double deviation);
  void emit_piece(Path path, double t1, double deviation);
  double deviation(const Nurbs& curve, double t1) const;
  void forget();
  bool is_last(std::size_t i) const { return ended_ && i + 1 == bends_.size(); }

  std::size_t edge_at(double t) const;
  const Bend* bend_at(double t) const;

  std::deque<Piece>& out_;
  std::vector<Bend> bends_;
  std::deque<PlacedMark> marks_;
  std::deque<PlacedPoint> vertices_;
  double t_ = 0;
  std::size_t edge_ = 0,
              passed_ = 0;  // line at t_; all bends before this end their hats before t_
  AxisVector point_ = AxisVector::Zero();
  bool ended_ = false;
  std::vector<Edge> edges_;  // of the piece being made
  std::vector<Turn> turns_;
  bool is_measured_ = false;  // all of it
  double measured_ = 0;       // mm
};

}  // namespace softcnc::ipo
