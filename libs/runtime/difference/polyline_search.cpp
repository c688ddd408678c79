// SPDX-License-Identifier: MIT
#include "runtime/difference/polyline_search.hpp"

#include <algorithm>
#include <cassert>

namespace softcnc::runtime {
namespace {

constexpr std::size_t kInBox = 32;    // segments
constexpr std::size_t kChildren = 8;  // boxes within one of the next level

/// The squared distance of a point from a box, mm^2.
double square_from(const AxisVector& point, const AxisVector& low, const AxisVector& high) {
  return (point - point.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

}  // namespace

PolylineSearch::PolylineSearch(const RowStore& rows)
    : rows_(rows.rows()), segments_(std::max(rows_.size(), std::size_t{2}) - 1) {
  assert(!rows_.empty());
  auto& boxes = levels_.emplace_back();
  sizes_.push_back(kInBox);
  for (std::size_t first = 0; first < segments_; first += kInBox) {
    if (first % kRowsInMemory == 0) rows.release();
    Box box = box_of(first);
    for (std::size_t i = first + 1; i < std::min(first + kInBox, segments_); ++i) {
      const Box own = box_of(i);
      box = {box.low.cwiseMin(own.low), box.high.cwiseMax(own.high)};
    }
    boxes.push_back(box);
  }
  while (levels_.back().size() > 1) add_level();
}

void PolylineSearch::add_level() {
  const std::vector<Box>& finer = levels_.back();
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < finer.size(); ++i) {
    if (i % kChildren == 0)
      boxes.push_back(finer[i]);
    else
      boxes.back() = {boxes.back().low.cwiseMin(finer[i].low),
                      boxes.back().high.cwiseMax(finer[i].high)};
  }
  sizes_.push_back(sizes_.back() * kChildren);
  levels_.push_back(std::move(boxes));
}

PolylineSearch::Box PolylineSearch::box_of(std::size_t segment) const noexcept {
  const AxisVector begin = position_of(rows_[segment]);
  const AxisVector end = position_of(rows_[std::min(segment + 1, rows_.size() - 1)]);
  return {begin.cwiseMin(end), begin.cwiseMax(end)};
}

double PolylineSearch::square(const AxisVector& point, std::size_t segment) const noexcept {
  const AxisVector begin = position_of(rows_[segment]);
  const AxisVector along = position_of(rows_[std::min(segment + 1, rows_.size() - 1)]) - begin;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - begin).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - begin - part * along).squaredNorm();
}

PolylineSearch::Nearest PolylineSearch::nearest(const AxisVector& point, SegmentRange range,
                                                std::size_t guess, double enough) const {
  assert(range.first <= guess && guess < range.last && range.last <= segments_);
  Query query{point, range, enough, {square(point, guess), guess}};
  visit(levels_.size() - 1, 0, query);
  return query.found;
}

void PolylineSearch::visit(std::size_t level, std::size_t index, Query& query) const {
  const SegmentRange own{index * sizes_[level], (index + 1) * sizes_[level]};
  if (query.found.square <= query.enough) return;
  if (own.last <= query.range.first || own.first >= query.range.last) return;
  const Box& box = levels_[level][index];
  if (square_from(query.point, box.low, box.high) >= query.found.square) return;
  if (level == 0) return visit_segments(own, query);
  const std::size_t end = std::min((index + 1) * kChildren, levels_[level - 1].size());
  for (std::size_t child = index * kChildren; child < end; ++child) visit(level - 1, child, query);
}

void PolylineSearch::visit_segments(SegmentRange segments, Query& query) const {
  const std::size_t first = std::max(segments.first, query.range.first);
  const std::size_t last = std::min(segments.last, query.range.last);
  for (std::size_t i = first; i < last; ++i)
    if (const double own = square(query.point, i); own < query.found.square) query.found = {own, i};
}

}  // namespace softcnc::runtime
