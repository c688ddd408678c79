// SPDX-License-Identifier: MIT
// A run of lines as one curve: lines in, pieces of the curve out, as soon as what follows no longer
// changes them.
//
// The curve is solved for in windows (tube_window.hpp), each of which looks ahead as far as the
// machine needs to brake, and settles a part of that. A window ends on a line, in its direction and
// without curvature, so that what was solved for can always be run to its end, and followed by the
// line: where a later window has no solution, that is what is done.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "ipo/rebuild/guide.hpp"
#include "ipo/rebuild/speed_estimate.hpp"
#include "ipo/rebuild/tube_window.hpp"

namespace softcnc::ipo {

/// How a run begins or ends: where the path does, or in the middle of a line.
enum class RunEnd : std::uint8_t { of_path, on_line };

/// What became of lines, in all.
struct RebuildCounts {
  std::size_t lines = 0;      // that are part of curves
  std::size_t curves = 0;     // which they became
  std::size_t fallbacks = 0;  // windows without a solution
  double deviation = 0;       // mm: the largest distance between both, at most
};

struct RebuildOptions {
  double coarsest = 1;          // times the usual length of spans, where that stays in the tube
  std::size_t least_spans = 1;  // of a piece of the curve
};

class CurveRun {
 public:
  /// Pieces are appended to `out`, which must outlive the run.
  CurveRun(const Machine& machine, std::deque<Piece>& out, const RebuildOptions& options = {});

  void begin(const AxisVector& point, RunEnd kind);
  /// Adds a line from where the last one ended.
  void add(const Chord& chord);
  void end(RunEnd kind);

  /// Returns the place, mm of the lines, at which the curve ended early because there was none
  /// further on. It lies on a line.
  std::optional<double> gave_up() const noexcept { return gave_up_; }
  /// Returns up to where pieces have left, mm of the lines.
  double reached() const noexcept { return knots_.empty() ? 0 : knots_[done_]; }
  /// Whether the axes are much alike for which lines in these directions ask most.
  bool suits(const AxisVector& shares) const noexcept { return are_alike(limits_, shares); }
  const AxisVector& last_point() const noexcept { return point_; }
  const RebuildCounts& counts() const noexcept { return counts_; }

 private:
  struct Extent {
    double step, ahead;  // mm
  };

  void settle();
  Extent window_extent() const;
  double span_beside_line(double t, double away);
  double span_at(double t, double end, bool on_line);
  void lay_knots(double end, bool on_line);
  bool is_settled() const noexcept { return done_ > 0 || begun_; }
  bool settles_some(std::size_t last) const;
  std::size_t window_end(double until);
  TubeWindow window_to(std::size_t last);
  std::optional<AxisVector> last_control(const std::vector<double>& knots, std::size_t i,
                                         std::size_t first) const;
  bool stays_in_travel(const TubeWindow& window) const;
  void take(std::size_t until);
  void emit_settled(bool all);
  QuinticSpline settled_spline(bool is_end) const;
  void emit(const QuinticSpline& spline, double t0, double t1);
  void emit_piece(const QuinticSpline& spline, double t0, double t1,
                  const MoveAttributes& attributes);
  void emit_straight(const AxisVector& from, const MoveAttributes& attributes);
  double place_of(double t) const;
  std::vector<Mark> marks_until(double t0, double t1, const Nurbs& curve);
  std::size_t step_end(double step, std::size_t last) const;
  void fall_back(double step);
  void forget();

  ShapeLimits limits_;
  std::deque<Piece>& out_;
  RebuildOptions options_;
  Guide guide_;
  RunEnd begin_ = RunEnd::of_path, end_ = RunEnd::of_path;
  std::vector<double> knots_;        // of the run; the first counts six times
  std::vector<AxisVector> control_;  // settled ones
  std::vector<double> tightened_;    // by span between two knots
  std::size_t done_ = 0;             // knot up to which the curve is settled
  std::size_t emitted_ = 0;          // knot up to which pieces have left
  bool ends_ = false;                // what leaves now ends the curve
  bool begun_ = false;               // the first knots and control points have been dropped
  std::optional<TubeWindow> last_;   // the last solution,
  std::size_t last_first_ = 0, last_end_ = 0;  // and its first and last knot
  AxisVector point_ = AxisVector::Zero();      // where the last piece ended
  Mark last_mark_;                             // of the block that has begun last
  std::optional<double> gave_up_;
  double furthest_ = 0;       // mm: what is settled and has not left, from the lines
  double laid_fineness_ = 1;  // of the spans laid last
  double fineness_ = 1;       // of spans
  RebuildCounts counts_;
};

}  // namespace softcnc::ipo
