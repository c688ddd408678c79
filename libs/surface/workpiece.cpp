// SPDX-License-Identifier: MIT
// A tile is cut in blocks, by the passes that come close first, and by all where that was not
// enough. Each asks the passes that may reach deepest first, and stops where the
// next one cannot reach below what is already cut: a ball lies above a plane by at least the square
// of the distance from where it comes closest, over its diameter.
#include "surface/workpiece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "surface/ideal_surface.hpp"

namespace softcnc::surface {
namespace {

constexpr double kRounding = 1e-9;  // mm
constexpr double kClose = 0.02;  // of the radius: the height above a plane that close passes reach
constexpr std::size_t kAtOnce = 48;                       // passes put in order
constexpr std::size_t kMostLines = std::size_t{1} << 24;  // bytes of edges that are kept

/// z = slope_x x + slope_y y; heights are compared from there.
struct SlopedPlane {
  double slope_x = 0, slope_y = 0;
  double at(double x, double y) const noexcept { return slope_x * x + slope_y * y; }
};

/// How deep a pass may reach.
struct DepthBound {
  double base;       // mm above the plane: the lowest that any point is cut
  double diameter;   // mm
  Rectangle lowest;  // where that is; farther off it is higher
  double over(double square_distance) const noexcept { return base + square_distance / diameter; }
};

/// Places seen from the corner.
DepthBound depth_bound(const EdgePass& pass, double radius, const AxisVector& corner,
                       const SlopedPlane& plane) {
  const double length =
      std::sqrt(1 + plane.slope_x * plane.slope_x + plane.slope_y * plane.slope_y);
  const auto above = [&](const AxisVector& tip) {
    return tip[2] + radius - plane.at(tip[0] - corner[0], tip[1] - corner[1]);
  };
  Rectangle place = footprint(pass);
  const double dx = radius * plane.slope_x / length - corner[0];
  const double dy = radius * plane.slope_y / length - corner[1];
  place = {place.x0 + dx, place.y0 + dy, place.x1 + dx, place.y1 + dy};
  const double base = std::min(above(pass.from), above(pass.to)) - (radius + pass.bulge) * length;
  return {base - kRounding, 2 * radius, place};
}

/// The passes near a tile. Their lines are made when they are asked for, and kept for the next
/// block as long as memory allows.
class TilePasses {
 public:
  TilePasses(const ToolTrack& track, const StockGrid& grid, std::vector<std::uint32_t> members)
      : track_(track), grid_(grid), members_(std::move(members)), lines_(members_.size()) {
    for (const std::uint32_t member : members_) add_centre(track.passes()[member]);
  }

  std::size_t size() const noexcept { return members_.size(); }
  const EdgePass& operator[](std::size_t i) const noexcept { return track_.passes()[members_[i]]; }
  double radius(std::size_t i) const noexcept { return track_.cutter((*this)[i]).radius; }
  const EdgeLines& lines(std::size_t i) {
    if (!lines_[i]) {
      if (kept_ > kMostLines) forget();
      lines_[i] = std::make_unique<EdgeLines>(track_, (*this)[i], grid_.corner, grid_.step);
      kept_ += lines_[i]->memory();
    }
    return *lines_[i];
  }

  /// Centres of the ball on cutting moves, and its radius: of the last tool among them.
  std::span<const IdealSurface::Centre> centres() const noexcept { return centres_; }
  double ball() const noexcept { return ball_; }

 private:
  void forget() {
    for (auto& lines : lines_) lines.reset();
    kept_ = 0;
  }

  void add_centre(const EdgePass& pass) {
    if (!pass.cutting) return;
    const double radius = track_.cutter(pass).radius;
    if (radius != ball_) centres_.clear();
    ball_ = radius;
    AxisVector at = pass.commanded - grid_.corner;
    at[2] = pass.commanded[2] + radius;
    centres_.push_back({at, pass.to - pass.from, pass.target});
  }

  const ToolTrack& track_;
  const StockGrid& grid_;
  std::vector<std::uint32_t> members_;
  std::vector<std::unique_ptr<EdgeLines>> lines_;
  std::size_t kept_ = 0;  // bytes of lines_
  std::vector<IdealSurface::Centre> centres_;
  double ball_ = 0;
};

/// Passes of a tile, in their order, among which are all that cut anything as low as `height`
/// above the plane.
struct ClosePasses {
  std::vector<std::size_t> passes;
  SlopedPlane plane;
  double height = -std::numeric_limits<double>::infinity();
};

/// `tile` seen from the corner.
ClosePasses close_passes(const TilePasses& passes, const StockGrid& grid, const Rectangle& tile) {
  ClosePasses close;
  const double x = (tile.x0 + tile.x1) / 2, y = (tile.y0 + tile.y1) / 2;
  const auto ideal = IdealSurface::near(passes.centres(), passes.ball(), x, y, grid.step);
  const auto point = ideal ? ideal->at(x, y) : std::nullopt;
  if (!point) return close;
  close.plane = {point->slope_x, point->slope_y};
  close.height = point->z - close.plane.at(x, y) + kClose * passes.ball();
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const DepthBound bound = depth_bound(passes[i], passes.radius(i), grid.corner, close.plane);
    if (bound.over(square_distance(bound.lowest, tile)) <= close.height) close.passes.push_back(i);
  }
  return close;
}

class BlockCutter {
 public:
  BlockCutter(const StockGrid& grid, Tile& tile, TilePasses& passes, const ClosePasses& close,
              int column, int row)
      : step_(grid.step),
        top_(grid.top),
        corner_(grid.corner),
        tile_(tile),
        passes_(passes),
        close_(close),
        column0_(column),
        row0_(row),
        column1_(std::min(column + Workpiece::kBlock, tile.first_column + tile.columns)),
        row1_(std::min(row + Workpiece::kBlock, tile.first_row + tile.rows)) {}

  void run() {
    ideal_ =
        IdealSurface::near(passes_.centres(), passes_.ball(), middle_x(), middle_y(), half_width());
    const auto point = ideal_ ? ideal_->at(middle_x(), middle_y()) : std::nullopt;
    if (point) plane_ = {point->slope_x, point->slope_y};
    for (int i = 0; i < Workpiece::kBlock; ++i) rise_[i] = plane_.slope_x * (i * step_);
    for (int row = row0_; row < row1_; ++row) highest_.push_back(highest_of(row));
    cut(close_.passes);
    if (reaches_above(close_)) cut(all_passes());
    if (ideal_) measure();
    tile_.targets.push_back(ideal_ ? ideal_->target() : 0);
  }

 private:
  double middle_x() const noexcept { return step_ * (column0_ + column1_ - 1) / 2; }
  double middle_y() const noexcept { return step_ * (row0_ + row1_ - 1) / 2; }
  double half_width() const noexcept { return step_ * Workpiece::kBlock / 2; }
  Rectangle place() const noexcept {
    return {column0_ * step_, row0_ * step_, (column1_ - 1) * step_, (row1_ - 1) * step_};
  }
  double* heights(int row) const noexcept {
    return tile_.heights.data() + tile_.index(column0_, row);
  }
  double highest() const noexcept { return *std::max_element(highest_.begin(), highest_.end()); }

  double highest_of(int row) const noexcept;
  bool reaches_above(const ClosePasses& close) const noexcept;
  std::vector<std::size_t> all_passes() const;
  void cut(std::span<const std::size_t> passes);
  void cut(std::size_t pass, const DepthBound& bound);
  void measure() const;

  double step_, top_;
  AxisVector corner_;
  Tile& tile_;
  TilePasses& passes_;
  const ClosePasses& close_;
  int column0_, row0_, column1_, row1_;
  SlopedPlane plane_;
  Eigen::Array<double, Workpiece::kBlock, 1> rise_;  // of the plane along a row
  std::vector<double> highest_;                      // above the plane, by row
  std::vector<std::uint32_t> steps_;                 // of the pass that cuts
  std::optional<IdealSurface> ideal_;
};

double BlockCutter::highest_of(int row) const noexcept {
  const Eigen::Map<const Eigen::ArrayXd> z(heights(row), column1_ - column0_);
  return (z - rise_.head(column1_ - column0_)).maxCoeff() -
         plane_.at(column0_ * step_, row * step_);
}

/// Whether passes that are not close may still cut something.
bool BlockCutter::reaches_above(const ClosePasses& close) const noexcept {
  for (int row = row0_; row < row1_; ++row)
    for (int column = column0_; column < column1_; ++column)
      if (tile_.heights[tile_.index(column, row)] - close.plane.at(column * step_, row * step_) >=
          close.height)
        return true;
  return false;
}

std::vector<std::size_t> BlockCutter::all_passes() const {
  std::vector<std::size_t> all(passes_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void BlockCutter::cut(std::span<const std::size_t> passes) {
  struct Candidate {
    double least;
    std::size_t pass;
    DepthBound bound;
    bool operator<(const Candidate& other) const noexcept {
      return least != other.least ? least < other.least : pass < other.pass;
    }
  };
  std::vector<Candidate> candidates;
  for (const std::size_t i : passes) {
    const DepthBound bound = depth_bound(passes_[i], passes_.radius(i), corner_, plane_);
    candidates.push_back({bound.over(square_distance(bound.lowest, place())), i, bound});
  }
  for (auto next = candidates.begin(); next != candidates.end();) {
    const auto left = static_cast<std::size_t>(candidates.end() - next);
    const auto end = next + static_cast<std::ptrdiff_t>(std::min(left, kAtOnce));
    std::partial_sort(next, end, candidates.end());
    for (; next != end; ++next) {
      if (next->least >= highest()) return;
      cut(next->pass, next->bound);
    }
  }
}

/// Points of a row farther off than `wide` from where the pass reaches lowest stay as they are.
void BlockCutter::cut(std::size_t pass, const DepthBound& bound) {
  const EdgeLines& lines = passes_.lines(pass);
  lines.passing(place(), steps_);
  for (int row = row0_; row < row1_; ++row) {
    double& highest = highest_[static_cast<std::size_t>(row - row0_)];
    const double y = row * step_;
    const double dy = std::max({0.0, bound.lowest.y0 - y, y - bound.lowest.y1});
    const double square = (highest - bound.base) * bound.diameter - dy * dy;
    if (square <= 0) continue;
    const double wide = std::sqrt(square);
    const double low = std::ceil((bound.lowest.x0 - wide) / step_);
    const double high = std::floor((bound.lowest.x1 + wide) / step_) + 1;
    const int first = static_cast<int>(std::clamp<double>(low, column0_, column1_));
    const int last = static_cast<int>(std::clamp<double>(high, column0_, column1_));
    if (first >= last) continue;
    tile_.updates += last - first;
    lines.cut({y, first, last, heights(row) - column0_}, steps_);
    highest = highest_of(row);
  }
}

/// A polynomial of second degree through three places.
struct Parabola {
  double c0, c1, c2;
  Parabola(double f0, double f1, double f2, double width) noexcept
      : c0(f0),
        c1(width > 0 ? (4 * f1 - 3 * f0 - f2) / width : 0),
        c2(width > 0 ? 2 * (f0 - 2 * f1 + f2) / (width * width) : 0) {}
  double operator()(double x) const noexcept { return c0 + x * (c1 + x * c2); }
};

/// The ideal surface is smooth: within a block nine of its points determine it. Where it lies above
/// the stock there is nothing to cut, and nothing to report.
void BlockCutter::measure() const {
  const double wide = step_ * (column1_ - 1 - column0_), high = step_ * (row1_ - 1 - row0_);
  IdealSurface::Point at[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto point = ideal_->at(column0_ * step_ + wide * i / 2, row0_ * step_ + high * j / 2);
      if (!point) return;
      at[i][j] = *point;
    }
  const auto over_row = [&](double IdealSurface::Point::*value, double y) {
    const auto column = [&](int i) {
      return Parabola(at[i][0].*value, at[i][1].*value, at[i][2].*value, high)(y);
    };
    return Parabola(column(0), column(1), column(2), wide);
  };
  const double steep =
      1 / std::sqrt(1 + plane_.slope_x * plane_.slope_x + plane_.slope_y * plane_.slope_y);
  for (int row = row0_; row < row1_; ++row) {
    const double y = step_ * (row - row0_);
    const Parabola z = over_row(&IdealSurface::Point::z, y);
    const Parabola a = over_row(&IdealSurface::Point::a, y);
    const Parabola b = over_row(&IdealSurface::Point::b, y);
    const double* cut = heights(row);
    float* to = tile_.deviations.data() + tile_.index(column0_, row);
    for (int i = 0; i < column1_ - column0_; ++i) {
      const double x = step_ * i;
      const double above = cut[i] - z(x);
      if (!ideal_->inside(a(x), b(x)) || (above < 0 && cut[i] == top_)) continue;
      to[i] = static_cast<float>(above * steep);
    }
  }
}

}  // namespace

Tile Workpiece::cut(int first_column, int first_row, int columns, int rows,
                    const std::function<bool()>& wants_stop) const {
  Tile tile{first_column,
            first_row,
            std::min(columns, grid_.columns - first_column),
            std::min(rows, grid_.rows - first_row),
            {},
            {},
            0,
            {}};
  const auto points = static_cast<std::size_t>(tile.columns) * static_cast<std::size_t>(tile.rows);
  tile.heights.assign(points, grid_.top);
  tile.deviations.assign(points, kUnknown);
  const double x = grid_.corner[0] + first_column * grid_.step;
  const double y = grid_.corner[1] + first_row * grid_.step;
  TilePasses passes(track_, grid_,
                    index_.near({x, y, x + tile.columns * grid_.step, y + tile.rows * grid_.step}));
  const ClosePasses close = close_passes(
      passes, grid_,
      {first_column * grid_.step, first_row * grid_.step,
       (first_column + tile.columns) * grid_.step, (first_row + tile.rows) * grid_.step});
  for (int row = first_row; row < first_row + tile.rows; row += kBlock)
    for (int column = first_column; column < first_column + tile.columns; column += kBlock) {
      if (wants_stop && wants_stop()) return tile;
      BlockCutter(grid_, tile, passes, close, column, row).run();
    }
  track_.release();
  return tile;
}

}  // namespace softcnc::surface
