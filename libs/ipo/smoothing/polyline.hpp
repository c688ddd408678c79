// SPDX-License-Identifier: MIT
// Lines end to end with rounded corners: as they come in, pieces of path go out.
//
// The tolerance, together with all turns near it, determines how wide a turn is spread. The width
// limit W of a vertex is the half-width that would use up its tolerance if every turn within it had
// that width, too. A turn gets the largest half-width w at which it touches no vertex with a width
// limit below w:
//
//     w_i = min over all j of max(W_j, |t_j - t_i|).
//
// At a vertex, then, no turn that touches it is wider than its width limit, and the sum of
// deviations (rounding.hpp) is within its tolerance. Where a polyline begins and ends W is 0, and
// no turn extends beyond. So corners between long lines get what their tolerance allows, neighbours
// share the line between them, and along a chopped curve many turns overlap.
//
// Where many overlap, a basis function for each would be more than the curve needs. There a knot
// vector is laid along the lines, with no two neighbours further apart than half the width of any
// turn nearby. The lines are replaced by those through their own points at the means of three
// consecutive knots, with a basis function over these three at each (the variation diminishing
// spline of Schoenberg, 1967). Each turn is thus distributed to the basis functions on either side
// of it, about the same mean; the deviation is nowhere larger than with the basis function of its
// own width.
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

class Polyline {
 public:
  /// Pieces are appended to `out`; it and the choice must outlive the polyline.
  Polyline(std::deque<Piece>& out, const CornerChoice& choice) : choice_(choice), segments_(out) {}

  bool empty() const noexcept { return vertices_.empty(); }

  /// Adds a line from where the last one ended. Where it turns back, or a rest is sooner than a
  /// curve, the path goes through the corner.
  void add(const Chord& chord);
  /// Ends the path where the last line ends.
  void end();

 private:
  struct Sum {
    double value, slope;  // mm, and by the width
    int turns;
  };
  /// Knots along dense lines, and how much of that is settled. What is laid but not fixed may be
  /// laid again with a smaller spacing; what is fixed can be continued with knots near each other.
  struct KnotVector {
    ChordKnots chords;
    AxisVector direction;                 // of the line before the next vertex
    double free_from;                     // mm: no other basis function ends later
    std::optional<std::size_t> stop;      // the last vertex of the knot vector
    std::size_t looked = 2;               // spans that are known to be within the tolerance
    std::size_t fixed = 1, smoothed = 0;  // basis functions; those handed to the segments
    std::size_t tried = 0;                // basis functions at the last attempt to fix them
    int retreats = 0;                     // since the last basis function was fixed
    std::size_t awaited = 0;              // lines that may show what was not known
    double most = 0, most_until = 0;      // mm: largest spacing before that place
  };
  /// The largest distance of the next knot; nothing while lines that are still to come could change
  /// it.
  struct Spacing {
    double most = 0;
    std::optional<std::size_t> stop;  // the last vertex that is dense, if that is near
  };

  bool rests_in_corner(const Chord& next, double width) const;
  bool goes_through_corner(const Chord& next) const;
  void begin(const AxisVector& point);
  void append(const Chord& chord);
  void settle();
  bool find_width_limit(std::size_t i);
  bool find_width(std::size_t i);
  double longest_width_limit(std::size_t i) const;
  Sum sum_of_roundings(std::size_t i, double width) const;

  void smooth();
  void find_density();
  bool is_dense(std::size_t i) const;
  double spacing_of_knots(std::size_t i) const;
  void smooth_vertex();
  double uncrowded(double t, double width) const;
  bool crowds(double t, double width) const;
  bool is_close_to_knots(double t, double least) const;
  double uncrowded_spacing(double from, double spacing) const;

  bool begin_knots();
  bool extend_knots();
  bool await_lines();
  bool lay(KnotVector& knots, bool wide) const;
  std::optional<double> wide_spacing(const KnotVector& knots) const;
  double last_spacing(const KnotVector& knots, double most) const;
  bool is_complete(const KnotVector& knots) const;
  bool look(KnotVector& knots) const;
  static bool shapes_near(const KnotVector& knots, std::size_t bases);
  bool fix();
  std::optional<bool> goes_on_near(std::size_t bases) const;
  void retreat();
  void smooth_along(std::size_t bases);
  void end_knots();
  std::optional<Spacing> spacing(std::size_t near, double from, double back, double most) const;

  double settled_until() const;
  void forget();

  std::vector<LineVertex> vertices_;  // the last one ends the last line
  double look_again_ = 0;             // mm of lines after the next vertex without a width limit
  std::size_t width_limits_ = 0, widths_ = 0;  // vertices whose width limit and width are settled
  std::size_t densities_ = 0;                  // vertices known to be dense or not
  std::size_t smoothed_ = 0;                   // vertices handed to the segments
  std::optional<KnotVector> knots_;
  const CornerChoice& choice_;
  SmoothedSegments segments_;
  bool ended_ = false;
};

}  // namespace softcnc::ipo
