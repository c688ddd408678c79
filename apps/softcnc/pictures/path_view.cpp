// SPDX-License-Identifier: MIT
#include "pictures/path_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace softcnc::app {
namespace {

using runtime::HistoryNode;
using runtime::MotionKind;

template <typename Take>
void each_move(PictureRuns runs, MotionKind motion, Take&& take) {
  for (const PictureRun& run : runs) {
    const auto& nodes = run.history->nodes();
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (nodes[i].motion == motion) take(nodes[i - 1].position, nodes[i].position);
  }
}

Box box_of(PictureRuns runs, MotionKind motion) {
  Box box;
  each_move(runs, motion, [&](const AxisVector& from, const AxisVector& to) {
    box.add(from);
    box.add(to);
  });
  return box;
}

}  // namespace

void Box::add(const AxisVector& point) noexcept {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

Box Box::wider(double margin) const noexcept {
  Box box = *this;
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

Box Box::all() noexcept {
  Box box;
  std::swap(box.low, box.high);
  return box;
}

Box path_box(PictureRuns runs) {
  const Box box = box_of(runs, MotionKind::cutting);
  return box.is_empty() ? box_of(runs, MotionKind::rapid) : box;
}

PathView path_view(PictureRuns runs) {
  constexpr double kLevel = 0.02;  // of a move: less is level, or straight up or down
  double all = 0, oblique = 0, upright = 0;
  each_move(runs, MotionKind::cutting, [&](const AxisVector& from, const AxisVector& to) {
    const AxisVector move = to - from;
    const double length = move.norm(), level = move.head<2>().norm();
    all += length;
    if (level <= kLevel * length)
      upright += length;
    else if (std::abs(move[2]) > kLevel * length)
      oblique += length;
  });
  return oblique > 0.02 * all || upright > 0.5 * all ? PathView::isometric : PathView::above;
}

Eigen::Vector2d seen(PathView view, const AxisVector& point) noexcept {
  if (view == PathView::above) return point.head<2>();
  return {(point[0] + point[1]) / std::numbers::sqrt2,
          (point[1] - point[0] + 2 * point[2]) / std::sqrt(6.0)};
}

bool clip_line(AxisVector& a, AxisVector& b, const Box& box) noexcept {
  const AxisVector along = b - a;
  double from = 0, to = 1;
  for (int axis = 0; axis < kAxes; ++axis) {
    if (along[axis] == 0) {
      if (a[axis] < box.low[axis] || a[axis] > box.high[axis]) return false;
      continue;
    }
    const double one = (box.low[axis] - a[axis]) / along[axis];
    const double other = (box.high[axis] - a[axis]) / along[axis];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  if (from > to) return false;
  const AxisVector start = a;
  a = start + from * along;
  b = start + to * along;
  return true;
}

Placing::Placing(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Rectangle& inner)
    : inner_(inner),
      scale_(std::min(inner.width / (high - low)[0], inner.height / (high - low)[1])),
      middle_((low + high) / 2) {}

Spot Placing::operator()(const Eigen::Vector2d& seen) const noexcept {
  return {inner_.x + inner_.width / 2 + scale_ * (seen[0] - middle_[0]),
          inner_.y + inner_.height / 2 - scale_ * (seen[1] - middle_[1])};
}

Eigen::Vector2d Placing::low() const noexcept {
  return middle_ - Eigen::Vector2d(inner_.width, inner_.height) / (2 * scale_);
}

Eigen::Vector2d Placing::high() const noexcept {
  return middle_ + Eigen::Vector2d(inner_.width, inner_.height) / (2 * scale_);
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> seen_extent(PathView view, const Box& box) noexcept {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    AxisVector point = box.low;
    for (int axis = 0; axis < kAxes; ++axis)
      if ((corner >> axis & 1) != 0) point[axis] = box.high[axis];
    const Eigen::Vector2d at = seen(view, point);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  return {low, high};
}

}  // namespace softcnc::app
