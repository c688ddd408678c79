// SPDX-License-Identifier: MIT
#include "pictures/path_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "pictures/chart.hpp"
#include "pictures/isometric_axes.hpp"
#include "pictures/line_thinning.hpp"
#include "pictures/path_pieces.hpp"

namespace softcnc::app {
namespace {

constexpr double kAroundPath = 0.05;                     // of the path's extent, around it
constexpr double kMostColoured = 50;                     // px
constexpr std::size_t kMostPieces = 15'000;              // of a run
constexpr double kLowestPlot = 200, kHighestPlot = 560;  // px, of the rectangle
constexpr double kBetweenRuns = 18;                      // px, between the rectangles of two runs
const Pen kRapidPen{.colour = kRapidColour, .width = 0.8, .dashed = true};
constexpr double kThinnest = 0.12;  // of the longest side of a box, the others at least
constexpr double kCutLine = 1.7;    // px

/// What is shown: a box with some extent in what is seen of it.
struct ShownPaths {
  PathView view = PathView::above;
  Box box;

  explicit ShownPaths(PictureRuns runs) : view(path_view(runs)), box(path_box(runs)) {
    if (box.is_empty()) return;
    const double size = std::max(box.size(), 1e-3);
    for (int axis = 0; axis < kAxes; ++axis) {
      const double least = view == PathView::above ? 0.0 : kThinnest * size;
      const double missing = (least - (box.high - box.low)[axis]) / 2;
      if (missing <= 0) continue;
      box.low[axis] -= missing;
      box.high[axis] += missing;
    }
  }

  /// As seen, with a margin.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> extent() const {
    auto [low, high] = seen_extent(view, box);
    const double margin = kAroundPath * std::max((high - low).maxCoeff(), 1e-3);
    low.array() -= margin;
    high.array() += margin;
    return {low, high};
  }
};

double inner_width(double width, std::size_t runs, Colouring by) {
  const double bare = width - kAxisLeft - (is_category(by) ? kRight : kBarRight);
  return runs < 2 ? bare : (bare - kBetweenRuns - kAxisLeft) / 2;
}

/// Colours change as often as a picture can show, or a file should hold.
PathPieces bounded_pieces(const runtime::RunHistory& history, const PathColours& colours,
                          const std::function<Spot(const AxisVector&)>& place, const Box& box) {
  for (Fineness fineness;; fineness.coloured *= 2) {
    PathPieces pieces = path_pieces(history, colours, place, box, fineness);
    if (pieces.cuts.size() <= kMostPieces || fineness.coloured > kMostColoured) return pieces;
  }
}

void draw_pieces(Canvas& canvas, const PathPieces& pieces) {
  for (const auto& rapid : pieces.rapids) canvas.line(rapid, kRapidPen);
  for (const PathPiece& piece : pieces.cuts)
    canvas.line(straightened(piece.spots, kStraight), {.colour = piece.colour, .width = kCutLine});
}

void draw_run(Canvas& canvas, const Rectangle& inner, const PictureRun& run,
              const ShownPaths& shown, const PathColours& colours) {
  const auto [low, high] = shown.extent();
  const Placing placing(low, high, inner);
  const auto place = [&](const AxisVector& point) { return placing(seen(shown.view, point)); };
  if (shown.view == PathView::isometric) {
    draw_isometric_axes(canvas, shown.box, placing);
    draw_pieces(canvas, bounded_pieces(*run.history, colours, place, shown.box));
    return;
  }
  const Chart chart(inner, {"X, mm", placing.low()[0], placing.high()[0]},
                    {"Y, mm", placing.low()[1], placing.high()[1]});
  chart.draw_grid(canvas);
  canvas.clip(inner);
  draw_pieces(canvas, bounded_pieces(*run.history, colours, place, Box::all()));
  canvas.unclip();
  chart.draw_axes(canvas);
}

std::vector<LegendEntry> legend_entries(PictureRuns runs, const PathColours& colours) {
  const Colouring by = colours.by();
  std::vector<LegendEntry> entries = colours.entries();
  if (!is_category(by) && colours.scale().has_unknown)
    entries.push_back({"unknown", kUnknownColour});
  const auto has_rapids = [](const PictureRun& run) {
    return std::ranges::any_of(run.history->nodes(), [](const runtime::HistoryNode& node) {
      return node.motion == runtime::MotionKind::rapid;
    });
  };
  if (std::ranges::any_of(runs, has_rapids)) entries.push_back({"rapid", kRapidColour, true});
  return entries;
}

}  // namespace

double path_plot_height(PictureRuns runs, Colouring by, double width) {
  const ShownPaths shown(runs);
  if (shown.box.is_empty()) return kHeadingLine + 60;
  const auto [low, high] = shown.extent();
  const double inner = inner_width(width, runs.size(), by);
  const double below = shown.view == PathView::above ? kAxisBelow : 12;
  const double sides = runs.size() > 1 ? kHeadingLine : 0;
  return kHeadingLine + 4 + sides + below +
         std::clamp(inner * (high - low)[1] / (high - low)[0], kLowestPlot, kHighestPlot);
}

void draw_path_plot(Canvas& canvas, const Rectangle& area, PictureRuns runs, Colouring by) {
  const PathColours colours(runs, by);
  const std::vector<LegendEntry> entries = legend_entries(runs, colours);
  const int lines = heading_lines(canvas, colours.heading(), entries, area.width);
  draw_heading(canvas, {area.x, area.y}, colours.heading(), entries, area.width);
  const ShownPaths shown(runs);
  if (shown.box.is_empty()) {
    canvas.text({area.x + kAxisLeft, area.y + kHeadingLine + 30}, "no motion", kLabelLook);
    return;
  }
  const bool above = shown.view == PathView::above;
  const double sides = runs.size() > 1 ? kHeadingLine : 0;
  const double top = area.y + lines * kHeadingLine + 4 + sides;
  Rectangle inner{area.x + kAxisLeft, top, inner_width(area.width, runs.size(), by),
                  area.bottom() - top - (above ? kAxisBelow : 12)};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0) inner.x = inner.right() + kBetweenRuns + kAxisLeft;
    if (runs.size() > 1) canvas.text({inner.x, inner.y - 6}, i == 0 ? "A" : "B", kHeadingLook);
    draw_run(canvas, inner, runs[i], shown, colours);
  }
  if (!is_category(by)) draw_colour_bar(canvas, inner, colours.scale());
}

}  // namespace softcnc::app
