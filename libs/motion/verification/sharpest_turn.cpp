// SPDX-License-Identifier: MIT
#include "motion/verification/sharpest_turn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softcnc {
namespace {

constexpr double kWidth = std::numbers::e / 2;  // of a window, as a part of its lag

}  // namespace

SharpestTurn::SharpestTurn() {
  for (std::size_t i = 0; i < kWindows; ++i)
    windows_[i].lag =
        kShortest *
        std::pow(kLongest / kShortest, static_cast<double>(i) / static_cast<double>(kWindows - 1));
}

void SharpestTurn::add(const std::vector<CubicPiece>& pieces, double s) {
  for (const CubicPiece& piece : pieces) {
    if (piece.s0 >= s) return;
    add(piece.s1 > s ? piece.until(s) : piece);
  }
}

void SharpestTurn::add(const CubicPiece& piece) {
  const AxisVector begin = piece.start_direction(), end = piece.end_direction();
  if (!started_) push({piece.s0, 0, 0});
  const bool counts = started_ && !(was_rapid_ && piece.origin.rapid);
  nodes_.back().after += counts ? joint(angle_between(direction_, begin)) : 0;
  for (Window& window : windows_) measure(window);
  const double turn = nodes_.back().after + angle_between(begin, end);
  push({piece.s1, turn, turn});
  direction_ = end;
  started_ = true;
  was_rapid_ = piece.origin.rapid;
}

/// Returns how much of a joint counts as a curve.
double SharpestTurn::joint(double angle) noexcept {
  if (angle < kCorner) return angle;
  corner_ = std::max(corner_, std::sin(angle));
  return 0;
}

void SharpestTurn::push(const Node& node) {
  nodes_.push_back(node);
  for (Window& window : windows_) measure(window);
  forget();
}

/// The turn within the window that ends at the last node.
void SharpestTurn::measure(Window& window) const noexcept {
  const auto node = [this](std::size_t i) -> const Node& { return nodes_[i - forgotten_]; };
  const Node& end = nodes_.back();
  const double begin = end.s - kWidth * window.lag;
  const std::size_t last = forgotten_ + nodes_.size() - 1;
  while (window.from < last && node(window.from + 1).s < begin) ++window.from;
  double before = node(window.from).before;
  if (window.from < last && node(window.from).s < begin) {
    const Node &a = node(window.from), &b = node(window.from + 1);
    before = a.after + (b.before - a.after) * (begin - a.s) / (b.s - a.s);
  }
  window.turn = std::max(window.turn, end.after - before);
}

void SharpestTurn::forget() {
  std::size_t needed = forgotten_ + nodes_.size();
  for (const Window& window : windows_) needed = std::min(needed, window.from);
  for (; forgotten_ < needed; ++forgotten_) nodes_.pop_front();
}

/// The errors of the windows grow with their lags; between two of them as a power of the lag.
double SharpestTurn::curve_lag(double error) const noexcept {
  const auto left = [](const Window& window) { return window.lag * window.turn / std::numbers::e; };
  const auto above = std::find_if(windows_.begin(), windows_.end(),
                                  [&](const Window& window) { return left(window) >= error; });
  if (above == windows_.end()) return 0;
  if (above == windows_.begin()) return above->lag * error / left(*above);
  const Window& below = above[-1];
  const double low = std::max(left(below), 1e-3 * error);
  const double power = std::log(error / low) / std::log(left(*above) / low);
  return below.lag * std::pow(above->lag / below.lag, power);
}

double SharpestTurn::corner_lag(double error) const noexcept {
  return corner_ > 0 ? std::numbers::e * error / corner_ : 0;
}

}  // namespace softcnc
