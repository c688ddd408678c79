// SPDX-License-Identifier: MIT
// Which vertices are corners of the part, and which lines are a curve cut into pieces.
//
// A vertex is a corner where both of its lines are half as long again as what the curve that would
// round it alone within the tolerance takes of them, or longer: 9 P / |k|, k being the jump of the
// direction. The chords of a curve are shorter than that where they are within 9/8 P of it,
// whatever their length and however much they turn. Lines between corners are rounded where they
// meet (polyline.hpp). A run of others is one curve (rebuild/curve_run.hpp), which begins and ends
// on a line.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "ipo/rebuild/curve_run.hpp"
#include "ipo/smoothing/polyline.hpp"

namespace softcnc::ipo {

/// An end of a line or of another path.
struct PathEnd {
  AxisVector direction = AxisVector::Zero();  // of the path
  double length = 0;                          // mm
  double tolerance = 0;                       // mm
};

/// Returns how much of the lines beside a vertex the curve takes that rounds it alone, mm.
double rounding_width(const PathEnd& before, const PathEnd& after) noexcept;

/// Whether a vertex is no corner.
bool is_part_of_curve(const PathEnd& before, const PathEnd& after) noexcept;

class LineRuns {
 public:
  /// Pieces are appended to `out`; all must outlive this object. Without `rebuilds` all lines are
  /// one polyline.
  LineRuns(const Machine& machine, std::deque<Piece>& out, const CornerChoice& choice,
           bool rebuilds, const RebuildOptions& options)
      : rebuilds_(rebuilds), polyline_(out, choice), run_(machine, out, options) {}

  bool empty() const noexcept { return !next_ && polyline_.empty(); }
  const RebuildCounts& counts() const noexcept { return run_.counts(); }

  /// Adds a line from where the last one ended. One that stays straight is in no run.
  void add(Chord chord, bool stays_straight = false);
  /// Ends the path where the last line ends.
  void end();

 private:
  enum class Joint : std::uint8_t {
    end_of_path,
    smooth,
    corner,
    inside  // a line
  };
  struct Meeting {
    Joint joint = Joint::end_of_path;
    double needed = 0;  // mm of either line, for the corner
  };
  struct Held {
    Chord chord;
    bool stays_straight = false;
    Meeting before{};
  };

  static Meeting meeting(const Held& before, const Held& after);
  static double kept_straight(const Chord& chord, const Meeting& end);
  void settle(Held line, const Meeting& after);
  void begin_run();
  void feed_run(Chord chord, const Meeting& after);
  void leave_run_given_up();
  void give_to_polyline();

  bool rebuilds_;
  Polyline polyline_;
  CurveRun run_;
  std::optional<Held> next_;   // what follows it is not known
  std::deque<Held> held_;      // lines that meet smoothly, too few for a run so far
  bool in_run_ = false;        // then none is held
  std::deque<Chord> of_run_;   // lines that the run may leave
  double of_run_from_ = 0;     // mm of the run where the first of them begins
  bool was_given_up_ = false;  // behind the last line
};

}  // namespace softcnc::ipo
