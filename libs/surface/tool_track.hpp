// SPDX-License-Identifier: MIT
// Where a turning tool has been: the rows of a run as passes of its edges.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "motion/core/axes.hpp"
#include "motion/core/disk_backed_vector.hpp"

namespace softcnc::surface {

/// A ball-end mill with edges as half circles from the tip, all alike, and how fast it turns.
struct Cutter {
  double radius = 0;  // mm
  int teeth = 0;
  double spin = 0;  // rad/s, positive as X turns to Y; 0: it cuts nothing

  bool operator==(const Cutter&) const = default;
};

/// Where the tool is in one period.
struct ToolRow {
  double t = 0;          // s
  AxisVector tip;        // mm, where it is
  AxisVector commanded;  // mm, where it should be
  bool cutting = false;  // no rapid
  double target = 0;     // mm: the Rmax that is asked for; 0: none is
};

/// The time from one edge to the next: all edges together sweep the whole circle once.
struct EdgePass {
  std::size_t stretch;   // of the track
  double begin, end;     // s
  AxisVector from, to;   // tip, mm
  AxisVector commanded;  // tip at the end, mm
  double bulge;          // mm: how far the tip strays from the line between
  bool cutting;          // all of it
  float target;          // mm: the Rmax that is asked for at its end; 0: none is
};

/// A time over which the spindle turns evenly; it always begins in the same position.
struct Stretch {
  Cutter cutter;
  double begin;       // s
  std::size_t first;  // of its places
};

/// A long track stands in a temporary file for the most part.
class ToolTrack {
 public:
  /// From the last row on this cutter, as it always begins; or from `at` on, s, if that lies
  /// between the last row and the next.
  void begin(const Cutter& cutter, double at = -1);
  /// Rows in the order of time; between them the tool moves evenly.
  void add(const ToolRow& row);
  /// Call once after the last row, before anything is read. Errors: SC6003.
  Status finish();
  /// False: the temporary file is full, and finish() will say so.
  bool kept() const noexcept { return passes_.kept() && places_.kept(); }

  std::span<const EdgePass> passes() const noexcept { return passes_.values(); }
  const Cutter& cutter(const EdgePass& pass) const noexcept {
    return stretches_[pass.stretch].cutter;
  }
  /// rad from X towards Y: where an edge stands as a pass begins. Along no row of points, so that
  /// an edge passes a row within a pass and never just where one pass goes over into the next.
  static constexpr double kFirstAngle = 0.7;

  /// Tips at equal steps of time over the period of a pass, out.size() of them.
  void sample(const EdgePass& pass, std::span<AxisVector> out) const;

  /// s from edge to edge.
  static double tooth_period(const Cutter& cutter) noexcept;

  /// Bytes that it takes, without what stands in the file.
  std::size_t memory() const noexcept;
  /// Gives memory back that has been read from the file.
  void release() const noexcept;

 private:
  struct Place {
    double t;
    AxisVector tip;
  };
  void start_stretch(const ToolRow& row);
  void close_stretch();
  void add_place(const Place& place);
  void end_places();
  void close_passes(const ToolRow& row);
  void close_pass(double end, const AxisVector& to, const AxisVector& commanded);
  double bulge_of(const AxisVector& from, const AxisVector& to) const noexcept;
  std::size_t end_of(std::size_t stretch) const noexcept;

  Cutter cutter_;
  bool begins_ = false, any_ = false;
  double begins_at_ = -1;  // s
  ToolRow last_;
  std::vector<Stretch> stretches_;
  DiskBackedVector<Place> places_;
  DiskBackedVector<EdgePass> passes_;
  std::optional<Place> place_;  // the last one, not yet among places_
  bool place_rests_ = false;    // where the one before is

  // of the pass that is not yet closed
  double pass_begin_ = 0;
  AxisVector pass_from_ = AxisVector::Zero();
  std::vector<AxisVector> pass_tips_;  // behind its begin
  std::size_t pass_number_ = 0;        // in the stretch
  bool pass_cutting_ = true, rests_ = false;
  double target_ = 0;
};

}  // namespace softcnc::surface
