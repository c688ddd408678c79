// SPDX-License-Identifier: MIT
// The programmed lines that a curve stands for, by their own length.
#pragma once

#include <cstddef>
#include <deque>

#include "ipo/path/chord.hpp"

namespace softcnc::ipo {

/// A vertex of the lines, and the line after it.
struct GuideVertex {
  double t = 0;  // mm along the lines
  AxisVector point = AxisVector::Zero();
  AxisVector direction = AxisVector::Zero();  // of the line after it
  double turn = 0;                            // |jump of the direction|
  double tolerance = 0;                       // mm: of a curve from the line after it
  double span = 0;                            // mm: what its turn allows, once that is known
  double deviation = 0;                       // mm: of that line from the programmed ones
  MoveAttributes attributes;                  // of that line

  /// Returns the point of that line at `place`, also beyond its ends.
  AxisVector at(double place) const { return point + (place - t) * direction; }
};

struct GuideMark {
  double t;  // mm along the lines
  Mark mark;
};

class Guide {
 public:
  void begin(const AxisVector& point);
  void add(const Chord& chord);
  void end() noexcept { ended_ = true; }

  bool empty() const noexcept { return vertices_.size() < 2; }
  bool ended() const noexcept { return ended_; }
  double length() const noexcept { return vertices_.back().t; }

  /// The last vertex ends the last line.
  const std::deque<GuideVertex>& vertices() const noexcept { return vertices_; }
  const std::deque<GuideMark>& marks() const noexcept { return marks_; }

  /// Returns the line on which t lies; at a vertex, the one after it.
  std::size_t line_at(double t) const noexcept;
  AxisVector at(double t) const noexcept;
  double end_of(std::size_t line) const noexcept { return vertices_[line + 1].t; }

  /// Returns the longest knot span that the turns around t allow, at most `most` mm.
  double span_at(double t, double most) noexcept;

  /// Returns by how much, mm, a curve may run ahead of the lines or behind them around a line:
  /// where they turn sharply, little.
  double slip(std::size_t line) const noexcept;

  /// Drops lines that end before t, and marks that no longer count there.
  void forget(double t);

 private:
  double span_of(std::size_t vertex) noexcept;

  std::deque<GuideVertex> vertices_;
  std::deque<GuideMark> marks_;
  bool ended_ = false;
};

}  // namespace softcnc::ipo
