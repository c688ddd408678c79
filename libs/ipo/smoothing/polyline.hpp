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
//
// Where many do, a hat for each would be more than the curve needs. There a mesh of knots is laid
// along the lines, no two neighbours further apart than half the width of any turn nearby, and the
// lines are replaced by those through their own points at the means of three knots in a row, with a
// hat over these three at each (the variation diminishing spline of Schoenberg, 1967). Each turn is
// so shared out to the hats on either side of it, about the same mean; what that is off anywhere is
// no more than with the hat of its own width.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "ipo/path/piece.hpp"
#include "ipo/smoothing/chord_knots.hpp"
#include "ipo/smoothing/chord_merge.hpp"
#include "ipo/smoothing/corner_choice.hpp"
#include "ipo/smoothing/line_vertex.hpp"
#include "ipo/smoothing/rounding.hpp"
#include "ipo/smoothing/smoothed_segments.hpp"

namespace softcnc::ipo {

class LineRun {
 public:
  /// Pieces are appended to `out`, which must outlive the run.
  LineRun(std::deque<Piece>& out, const Machine& machine) : choice_(machine), pieces_(out) {}

  bool empty() const noexcept { return vertices_.empty(); }

  /// Adds a line from where the last one ended; where it turns back, or a rest is sooner than a
  /// curve, the path goes through the corner.
  void add(const Chord& chord);
  /// The path ends where the last line ends.
  void end();

 private:
  struct Sum {
    double value, slope;  // mm, and by the width
    int turns;
  };
  /// Knots along dense lines, and how much of it is settled. What is laid but not fixed may be laid
  /// anew, nearer; from what is fixed there is a way on with knots near each other.
  struct Mesh {
    ChordMesh chords;
    AxisVector direction;             // of the line before the next bend
    double free_from;                 // mm: no other hat ends behind
    std::optional<std::size_t> stop;  // the last vertex of the mesh
    std::size_t looked = 2;           // spans that are known to be within the tolerance
    std::size_t fixed = 1, bent = 0;  // hats; those that the path has its bends for
    std::size_t tried = 0;            // hats, when they were last tried to be fixed
    int retreats = 0;                 // since the last hat was fixed
    std::size_t awaited = 0;          // as many lines may tell what was not known
    double most = 0, most_until = 0;  // mm: how wide knots may be before there
  };
  /// How far the next knot may be; nothing while lines that are still to come could change it.
  struct Spacing {
    double most = 0;
    std::optional<std::size_t> stop;  // the last vertex that is dense, if that is near
  };

  bool goes_through_corner(const Chord& next) const;
  void begin(const AxisVector& point);
  void append(const Chord& chord);
  void settle();
  bool find_reach(std::size_t i);
  bool find_width(std::size_t i);
  double longest_reach(std::size_t i) const;
  Sum sum_of_roundings(std::size_t i, double width) const;

  void bend();
  void find_density();
  bool is_dense(std::size_t i) const;
  double spacing_of_knots(std::size_t i) const;
  void bend_at_vertex();
  double uncrowded(double t, double width) const;
  bool crowds(double t, double width) const;
  bool is_close_to_knots(double t, double least) const;
  double uncrowded_spacing(double from, double spacing) const;

  bool begin_mesh();
  bool extend_mesh();
  bool await_lines();
  bool lay(Mesh& mesh, bool wide) const;
  std::optional<double> wide_spacing(const Mesh& mesh) const;
  double last_spacing(const Mesh& mesh, double most) const;
  bool is_complete(const Mesh& mesh) const;
  bool look(Mesh& mesh) const;
  static bool shapes_near(const Mesh& mesh, std::size_t hats);
  bool fix();
  std::optional<bool> goes_on_near(std::size_t hats) const;
  void retreat();
  void bend_along(std::size_t hats);
  void end_mesh();
  std::optional<Spacing> spacing(std::size_t near, double from, double back, double most) const;

  double settled_until() const;
  void forget();

  std::vector<LineVertex> vertices_;  // the last one ends the last line
  double look_again_ = 0;             // mm of lines behind the next vertex that has no reach yet
  std::size_t reaches_ = 0, widths_ = 0;  // vertices whose reach and width are settled
  std::size_t densities_ = 0;             // vertices known to be dense or not
  std::size_t bent_ = 0;                  // vertices that the path has its bends for
  std::optional<Mesh> mesh_;
  CornerChoice choice_;
  BendPieces pieces_;
  bool ended_ = false;
};

}  // namespace softcnc::ipo
