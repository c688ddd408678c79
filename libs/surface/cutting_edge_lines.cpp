// SPDX-License-Identifier: MIT
// Where lines that turn and feed pass the points of a row: between two instants a line passes all
// points between its two places on the row.
#include "surface/cutting_edge_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softcnc::surface {
namespace {

constexpr double kLargestTurn = std::numbers::pi / 32;  // rad, at most, from instant to instant
constexpr double kTravel = 0.01;                        // of the radius, at most
constexpr double kInstants = 4096;
constexpr double kFlat = 1e-12;  // a line along the row passes it far away
constexpr double kSeam = 1e-7;   // points: rounding where one pass goes over into the next

std::size_t instants_of(const EdgePass& pass, const Cutter& cutter) {
  const double turn = 2 * std::numbers::pi / cutter.teeth;
  const double travel = (pass.to - pass.from).norm() + 2 * pass.bulge;
  const double steps = std::max(turn / kLargestTurn, travel / (kTravel * cutter.radius));
  return static_cast<std::size_t>(std::clamp(std::ceil(steps - 1e-9), 2.0, kInstants)) + 1;
}

/// The first of `row` that does not lie before `place`.
int first_from(const PointRow& row, double place) noexcept {
  const double within =
      std::max(static_cast<double>(row.first), std::min(static_cast<double>(row.last), place));
  const int whole = static_cast<int>(within);
  return whole + (within > whole ? 1 : 0);
}

}  // namespace

EdgeLines::EdgeLines(const ToolTrack& track, const EdgePass& pass, const AxisVector& corner,
                     double step)
    : step_(step), instants_(instants_of(pass, track.cutter(pass))) {
  const Cutter& cutter = track.cutter(pass);
  radius_square_ = cutter.radius * cutter.radius;
  rays_ = cutter.teeth % 2 == 1;
  std::vector<AxisVector> tips(instants_);
  track.sample(pass, tips);
  for (const AxisVector& tip : tips)
    centres_.push_back({tip[0] - corner[0], tip[1] - corner[1], tip[2] + cutter.radius});
  const double gap = 2 * std::numbers::pi / cutter.teeth;
  const double turn = std::copysign(gap / static_cast<double>(instants_ - 1), cutter.spin);
  for (int edge = 0; edge < (rays_ ? cutter.teeth : cutter.teeth / 2); ++edge)
    for (std::size_t i = 0; i < instants_; ++i)
      add_line(ToolTrack::kFirstAngle + edge * gap + static_cast<double>(i) * turn, centres_[i]);
}

void EdgeLines::add_line(double angle, const Centre& centre) {
  const double cos = std::cos(angle);
  const double exact = std::sin(angle);
  const double sin = std::abs(exact) < kFlat ? std::copysign(kFlat, exact) : exact;
  lines_.push_back(
      {cos, sin, centre.y * cos - centre.x * sin, cos / sin / step_, centre.x / step_, centre.y});
}

/// 1 or -1 where all of the rectangle lies on one side of a line, otherwise 0.
int EdgeLines::side(const Line& line, const Rectangle& place) const noexcept {
  const double margin = 2 * kSeam * step_;
  const double y0 = place.y0 * line.cos, y1 = place.y1 * line.cos;
  const double x0 = place.x0 * line.sin, x1 = place.x1 * line.sin;
  const double least = std::min(y0, y1) - std::max(x0, x1) - line.offset;
  const double most = std::max(y0, y1) - std::min(x0, x1) - line.offset;
  return least > margin ? 1 : most < -margin ? -1 : 0;
}

void EdgeLines::passing(const Rectangle& place, std::vector<std::uint32_t>& steps) const {
  steps.clear();
  for (std::size_t first = 0; first < lines_.size(); first += instants_) {
    int before = side(lines_[first], place);
    for (std::size_t i = first; i + 1 < first + instants_; ++i) {
      const int after = side(lines_[i + 1], place);
      if (before == 0 || after != before) steps.push_back(static_cast<std::uint32_t>(i));
      before = after;
    }
  }
}

void EdgeLines::cut(const PointRow& row, std::span<const std::uint32_t> steps) const noexcept {
  const auto place = [&](std::size_t i) {
    return lines_[i].x + (row.y - lines_[i].y) * lines_[i].slope;
  };
  std::size_t known = lines_.size();  // whose `before` is there from the step before
  int before = 0;
  for (const std::size_t i : steps) {
    if (known != i) before = first_from(row, place(i));
    if (i % instants_ == 0) {
      const int early = first_from(row, place(i) - kSeam);
      cut(row, i, early, first_from(row, place(i) + kSeam));
    }
    const int after = first_from(row, place(i + 1));
    const int low = std::min(before, after), high = std::max(before, after);
    if ((lines_[i].sin > 0) == (lines_[i + 1].sin > 0)) {
      cut(row, i, low, high);
    } else {
      cut(row, i, row.first, low);
      cut(row, i, high, row.last);
    }
    before = after;
    known = i + 1;
  }
}

/// Points that the line passes between one instant and the next. Where the ball stands higher than
/// a point at that moment, there is nothing to cut.
void EdgeLines::cut(const PointRow& row, std::size_t step, int first, int last) const noexcept {
  if (first >= last) return;
  const Line a = lines_[step], b = lines_[step + 1];
  const Centre from = centres_[step % instants_], to = centres_[step % instants_ + 1];
  const double width = step_, radius_square = radius_square_;
  const double at_a = row.y * a.cos - a.offset, at_b = row.y * b.cos - b.offset;
  const double feed_x = to.x - from.x, feed_y = to.y - from.y, feed_z = to.z - from.z;
  double* const heights = row.heights;
  for (int i = first; i < last; ++i) {
    const double x = i * width;
    const double ga = at_a - x * a.sin;
    const double difference = ga - (at_b - x * b.sin);
    const double part = difference != 0 ? std::max(0.0, std::min(1.0, ga / difference)) : 0.5;
    const double dx = x - (from.x + part * feed_x);
    const double dy = row.y - (from.y + part * feed_y);
    const double z = from.z + part * feed_z;
    const double square = radius_square - dx * dx - dy * dy;
    const double above = z - heights[i];
    if (square <= 0 || (above >= 0 && square <= above * above)) continue;
    if (rays_ && dx * a.cos + dy * a.sin <= 0) continue;
    heights[i] = z - std::sqrt(square);
  }
}

}  // namespace softcnc::surface
