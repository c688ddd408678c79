// SPDX-License-Identifier: MIT
#include "ipo/window.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// Largest part of an axis acceleration that jumps of velocity may use within one period.
constexpr double kKinkShare = 0.25;
/// Tangents closer than this (rad) count as one: rounding of the geometry.
constexpr double kSameTangent = 1e-9;

Cap joint_cap(double turn, double period, double chord_tolerance) {
  if (turn > kTangentTolerance) return {0, Limit::corner};
  // The polyline through the samples cuts a kink by at most v T turn / 4.
  const double v = 4 * chord_tolerance / (turn * period);
  return {v * v, Limit::corner};
}

}  // namespace

void Window::append(const Move& move, bool rest, double from) {
  std::vector<Interval> grid = make_grid(move, constraints_, from);
  if (nodes_.empty()) nodes_.emplace_back();
  for (const Interval& next : grid) {
    Node& joint = nodes_.back();
    joint.own.lower_to(next.left_cap);
    if (!intervals_.empty()) {
      const double turn = (next.left.dq - intervals_.back().right.dq).norm();
      if (turn > kSameTangent) {
        joint.own.lower_to(joint_cap(turn, constraints_.period(), constraints_.chord_tolerance()));
        joint.kink = (next.left.dq - intervals_.back().right.dq).cwiseAbs();
      }
    }
    if (rest) joint.own.lower_to({0, Limit::corner});
    rest = false;
    intervals_.push_back(next);
    Node end;
    end.own = next.right_cap;
    end.s = joint.s + next.length();
    nodes_.push_back(end);
  }
}

std::size_t Window::settle(bool ended) {
  if (size() == 0) return 0;
  derive_caps();
  const std::size_t last = nodes_.size() - 1;
  back_from(last, 0);
  if (ended) return size();
  std::vector<double> from_rest(nodes_.size());
  for (std::size_t i = front_; i <= last; ++i) from_rest[i] = nodes_[i].k;
  // From the highest speed, until both agree.
  nodes_[last].k = nodes_[last].cap.q;
  std::size_t settled = last;
  while (settled > front_ && nodes_[settled].k != from_rest[settled]) {
    --settled;
    nodes_[settled].k = reach_back(intervals_[settled], constraints_, reach(settled));
  }
  for (std::size_t i = settled; i <= last; ++i) nodes_[i].k = from_rest[i];
  while (settled > front_ && nodes_[last].s - nodes_[settled].s < 2 * step_reach()) --settled;
  return settled - front_;
}

double Window::reachable_from_rest(std::size_t end) {
  back_from(front_ + end, 0);
  return nodes_[front_].k;
}

void Window::run_front(std::vector<SpeedPiece>& out) {
  q_ = run_forward(intervals_[front_], constraints_, reach(front_), q_, out);
  ++front_;
  if (front_ > 1024 && 2 * front_ > intervals_.size()) forget();
}

/// K from rest or speed at node `last` back to the front.
void Window::back_from(std::size_t last, double k) {
  nodes_[last].k = std::min(k, nodes_[last].cap.q);
  for (std::size_t i = last; i > front_; --i)
    nodes_[i - 1].k = reach_back(intervals_[i - 1], constraints_, reach(i - 1));
}

Reach Window::reach(std::size_t i) const noexcept {
  return {nodes_[i].cap, nodes_[i + 1].cap, inside_[i], share_[i], nodes_[i].k, nodes_[i + 1].k};
}

void Window::derive_caps() {
  top_ = 0;
  inside_.resize(intervals_.size());
  share_.assign(intervals_.size(), 1.0);
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    inside_[i] = intervals_[i].left_cap;
    top_ = std::max(top_, inside_[i].q);
  }
  for (Node& node : nodes_) node.cap = node.own;
  spread_step_caps();
  pass_kinks();
}

/// The longest step any speed in the window can make.
double Window::step_reach() const noexcept { return std::sqrt(top_) * constraints_.period(); }

void Window::spread_step_caps() {
  for (std::size_t i = 0; i < intervals_.size(); ++i)
    if (intervals_[i].step_cap.q < top_) spread_step_cap(i);
}

/// A step that touches interval i may be as long as g; it is, if the speed is at most g / T within
/// g of the interval on either side: a step that reached further would have to cross that stretch,
/// which alone takes a period.
void Window::spread_step_cap(std::size_t i) {
  const Cap& cap = intervals_[i].step_cap;
  const double g = std::sqrt(cap.q) * constraints_.period();
  inside_[i].lower_to(cap);
  for (std::size_t n = i + 1; n-- > 0;) {
    nodes_[n].cap.lower_to(cap);
    if (n == 0 || nodes_[i].s - nodes_[n].s >= g) break;
    inside_[n - 1].lower_to(cap);
  }
  for (std::size_t n = i + 1; n < nodes_.size(); ++n) {
    nodes_[n].cap.lower_to(cap);
    if (n + 1 == nodes_.size() || nodes_[n].s - nodes_[i + 1].s >= g) break;
    inside_[n].lower_to(cap);
  }
}

void Window::pass_kinks() {
  for (std::size_t n = 1; n + 1 < nodes_.size(); ++n)
    if (nodes_[n].cap.q > 0 && !nodes_[n].kink.isZero(0)) pass_kink(n);
}

/// A jump of velocity adds |dx'| v / T to the second difference of one period; together with its
/// neighbours within a period it may use kKinkShare of the acceleration, and the curve the rest.
void Window::pass_kink(std::size_t n) {
  Node& node = nodes_[n];
  double v = std::sqrt(node.cap.q);
  double load = kink_load(n, v);
  if (load > kKinkShare) node.cap.limit = Limit::corner;
  for (int i = 0; i < 60 && load > kKinkShare; ++i) {
    v *= std::max(0.5, kKinkShare / load * (1 - 1e-6));
    load = kink_load(n, v);
  }
  node.cap.q = std::min(node.cap.q, v * v);
  const double near = step_reach();
  for (std::size_t i = n; i-- > 0 && nodes_[n].s - nodes_[i + 1].s < near;)
    share_[i] = std::min(share_[i], 1 - load);
  for (std::size_t i = n; i < intervals_.size() && nodes_[i].s - nodes_[n].s < near; ++i)
    share_[i] = std::min(share_[i], 1 - load);
}

/// The part of the axis accelerations that the kinks within one step of node n use at speed v.
double Window::kink_load(std::size_t n, double v) const {
  AxisVector sum = nodes_[n].kink;
  const double near = v * constraints_.period();
  for (std::size_t i = n; i-- > 0 && nodes_[n].s - nodes_[i].s < near;) sum += nodes_[i].kink;
  for (std::size_t i = n + 1; i < nodes_.size() && nodes_[i].s - nodes_[n].s < near; ++i)
    sum += nodes_[i].kink;
  return (sum * v / constraints_.period())
      .cwiseQuotient(constraints_.acceleration_limits())
      .maxCoeff();
}

/// Drops what lies so far behind the front that nothing ahead can feel it.
void Window::forget() {
  const double behind = nodes_[front_].s - 8 * step_reach();
  std::size_t keep = 0;
  while (keep < front_ && nodes_[keep + 1].s < behind) ++keep;
  const auto drop = [keep](auto& v) {
    v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(keep));
  };
  drop(intervals_);
  drop(inside_);
  drop(share_);
  drop(nodes_);
  front_ -= keep;
}

}  // namespace softcnc::ipo
