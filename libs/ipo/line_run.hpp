// SPDX-License-Identifier: MIT
// Lines end to end, their corners rounded: as they come in, pieces of path go out.
//
// How far a turn is spread is settled by the tolerance, together with all turns near it. The reach
// W of a vertex is the half-width that would use up its tolerance if every turn within it had that
// width too. A turn gets the largest half-width w at which it touches no vertex of a smaller reach
// than w:
//
//     w_i = min over all j of max(W_j, |t_j - t_i|).
//
// At a vertex, then, no turn that touches it is wider than its reach, and the sum of deviations
// (rounding.hpp) is within its tolerance. Where a run begins and ends W is 0, and no turn reaches
// beyond. So corners between long lines have what their tolerance gives them, neighbours share the
// line between them, and along a chopped curve many turns run into each other.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "ipo/chord_merge.hpp"
#include "ipo/piece.hpp"
#include "ipo/rounding.hpp"

namespace softcnc::ipo {

class LineRun {
 public:
  /// Pieces are appended to `out`, which must outlive the run.
  explicit LineRun(std::deque<Piece>& out) : out_(out) {}

  bool empty() const noexcept { return vertices_.empty(); }

  /// Adds a line from where the last one ended; where it turns back the path goes through the
  /// corner.
  void add(const Chord& chord);
  /// The path ends where the last line ends.
  void end();

 private:
  /// A place between two lines, and the line behind it.
  struct Vertex {
    AxisVector point = AxisVector::Zero();
    double t = 0;  // mm along the lines
    AxisVector direction = AxisVector::Zero();
    AxisVector kink = AxisVector::Zero();
    double turn = 0;       // |kink|
    double tolerance = 0;  // mm, of the curve from the lines here
    double deviation = 0;  // mm, of the line behind from the programmed ones
    double reach = 0;      // W
    double width = 0;      // w
    Manner manner;
  };
  struct PlacedMark {
    double t;
    Mark mark;
  };

  void begin(const AxisVector& point);
  void append(const Chord& chord);
  void settle();
  bool find_reach(std::size_t i);
  bool find_width(std::size_t i);
  double longest_reach(std::size_t i) const;
  double sum_of_roundings(std::size_t i, double width, double& slope) const;
  bool crowds(std::size_t i, double width) const;

  double settled_until() const;
  void emit();
  void pass();
  double next_hat() const;
  double end_of_curve() const;
  void emit_line(double t1);
  void emit_curve(double t1);
  void emit_corners(const AxisVector& to, double t1, double deviation);
  void emit_piece(Path path, double t1, double deviation);
  double deviation(std::size_t i) const;
  void forget();

  std::size_t edge_at(double t) const;
  const Vertex* vertex_at(double t) const;

  std::deque<Piece>& out_;
  std::deque<Vertex> vertices_;  // the last one ends the last line
  std::deque<PlacedMark> marks_;
  std::size_t reaches_ = 0, widths_ = 0;  // vertices whose reach and width are settled
  double t_ = 0;                          // pieces are out up to here
  std::size_t edge_ = 0,
              passed_ = 0;  // line at t_; all vertices before this end their hats before t_
  AxisVector point_ = AxisVector::Zero();
  bool ended_ = false;
  std::vector<Edge> edges_;  // of the piece being made
  std::vector<Turn> turns_;
};

}  // namespace softcnc::ipo
