// SPDX-License-Identifier: MIT
#include "runtime/difference/path_distance.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/difference/polyline_search.hpp"

namespace softcnc::runtime {
namespace {

struct Farthest {
  double square = -1;  // mm^2; negative: no row has been seen
  std::size_t index = 0;
};

/// The segments of a path that a row may lie on, as the row advances.
class SlidingWindow {
 public:
  SlidingWindow(std::span<const StoredRow> path, std::size_t segments, double width)
      : path_(path), segments_(segments), width_(width) {}

  SegmentRange at(double s) {
    while (range_.first + 1 < segments_ && path_[range_.first + 1].s < s - width_) ++range_.first;
    range_.last = std::max(range_.last, range_.first + 1);
    while (range_.last < segments_ && path_[range_.last].s <= s + width_) ++range_.last;
    return range_;
  }

 private:
  std::span<const StoredRow> path_;
  std::size_t segments_;
  double width_;
  SegmentRange range_;
};

/// Goes on from segment to segment as long as they come nearer, forwards and then backwards.
std::size_t descend(const PolylineSearch& search, const AxisVector& point, SegmentRange range,
                    std::size_t segment) {
  double own = search.square(point, segment);
  for (; segment + 1 < range.last; ++segment) {
    const double next = search.square(point, segment + 1);
    if (next > own) break;
    own = next;
  }
  for (; segment > range.first; --segment) {
    const double next = search.square(point, segment - 1);
    if (next >= own) break;
    own = next;
  }
  return segment;
}

/// The row that is farthest from a path. Rows that are nearer than one before are not looked at any
/// further.
Farthest farthest(const RowStore& from, const RowStore& to, double width) {
  const std::span<const StoredRow> rows = from.rows(), path = to.rows();
  const PolylineSearch search(to);
  SlidingWindow window(path, search.segments(), width);
  Farthest result;
  std::size_t near = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % kRowsInMemory == 0) {
      from.release();
      to.release();
    }
    const SegmentRange range = window.at(rows[i].s);
    const AxisVector point = position_of(rows[i]);
    near = descend(search, point, range, std::clamp(near, range.first, range.last - 1));
    if (search.square(point, near) <= result.square) continue;
    const auto found = search.nearest(point, range, near, result.square);
    near = found.segment;
    if (found.square > result.square) result = {found.square, i};
  }
  return result;
}

}  // namespace

double path_window(const RowStore& a, const RowStore& b) noexcept {
  constexpr double kLeast = 1, kPart = 1e-4;  // mm; of the longer path
  const double of_a = a.rows().back().s, of_b = b.rows().back().s;
  return std::abs(of_a - of_b) + std::max(kLeast, kPart * std::max(of_a, of_b));
}

std::optional<PathDistance> largest_distance(const RowStore& a, const RowStore& b) {
  if (a.rows().empty() || b.rows().empty()) return std::nullopt;
  const double width = path_window(a, b);
  const Farthest of_a = farthest(a, b, width), of_b = farthest(b, a, width);
  const bool first = of_a.square >= of_b.square;
  const Farthest& larger = first ? of_a : of_b;
  return PathDistance{std::sqrt(larger.square), first, larger.index};
}

}  // namespace softcnc::runtime
