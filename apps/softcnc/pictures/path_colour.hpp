// SPDX-License-Identifier: MIT
// The colours of a path: by a number with a scale, or by a category with a legend.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "pictures/legend.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// Returns whether the colours stand for names, not for numbers.
constexpr bool is_category(Colouring by) noexcept {
  return by == Colouring::limit || by == Colouring::tool;
}

/// What colours the moves of one or two runs.
class PathColours {
 public:
  PathColours(PictureRuns runs, Colouring by);

  Colouring by() const noexcept { return by_; }
  /// The scale of the numbers; without meaning for categories.
  const ColourScale& scale() const noexcept { return scale_; }
  /// The categories that cutting moves have, those of limits with the longest one first.
  const std::vector<LegendEntry>& entries() const noexcept { return entries_; }
  /// What colours the path, for a heading: "coloured by ...".
  std::string heading() const;
  /// Returns whether any cutting move has a colour.
  bool known() const noexcept { return known_; }

  /// Returns the number of the motion between two nodes, in the unit of the scale; NaN where there
  /// is none.
  double value(const runtime::HistoryNode& before, const runtime::HistoryNode& node) const noexcept;
  /// Returns the colour of a category: a limit, or the place of a tool among those of the runs.
  Colour category(const runtime::HistoryNode& node) const noexcept;
  /// Returns the colour of a number, one of kShades.
  Colour shade_of(double value) const noexcept;

  static constexpr int kShades = 32;

 private:
  void measure(PictureRuns runs);
  void list_limits(PictureRuns runs);
  void list_tools(PictureRuns runs);

  Colouring by_;
  ColourScale scale_;
  std::vector<LegendEntry> entries_;
  std::vector<int> tools_;  // ascending
  bool known_ = false;
};

/// The colour of motion that is too short to be shown by itself: of feeds their mean over the time,
/// of other numbers the largest, of categories the one that lasts longest.
class ColourMean {
 public:
  explicit ColourMean(const PathColours& colours) noexcept : colours_(&colours) {}

  void add(const runtime::HistoryNode& before, const runtime::HistoryNode& node);
  /// Returns the colour of what has been added, and begins again.
  Colour take();

 private:
  const PathColours* colours_;
  double sum_ = 0, time_ = 0, largest_ = -1;
  std::vector<std::pair<Colour, double>> categories_;  // with their time
};

}  // namespace softcnc::app
