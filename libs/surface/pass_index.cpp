// SPDX-License-Identifier: MIT
#include "surface/pass_index.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::surface {
namespace {

constexpr double kMostBins = 1024;  // along a side

AxisVector middle(const EdgePass& pass) { return (pass.from + pass.to) / 2; }

double gap(double a0, double a1, double b0, double b1) noexcept {
  return std::max({0.0, b0 - a1, a0 - b1});
}

}  // namespace

Rectangle footprint(const EdgePass& pass) noexcept {
  const double b = pass.bulge;
  return {std::min(pass.from[0], pass.to[0]) - b, std::min(pass.from[1], pass.to[1]) - b,
          std::max(pass.from[0], pass.to[0]) + b, std::max(pass.from[1], pass.to[1]) + b};
}

double square_distance(const Rectangle& a, const Rectangle& b) noexcept {
  const double dx = gap(a.x0, a.x1, b.x0, b.x1), dy = gap(a.y0, a.y1, b.y0, b.y1);
  return dx * dx + dy * dy;
}

PassIndex::PassIndex(const ToolTrack& track) : track_(track) {
  const auto passes = track.passes();
  if (passes.empty()) return;
  const AxisVector first = middle(passes.front());
  all_ = {first[0], first[1], first[0], first[1]};
  double radius = 0;
  for (const EdgePass& pass : passes) {
    const AxisVector at = middle(pass);
    all_ = {std::min(all_.x0, at[0]), std::min(all_.y0, at[1]), std::max(all_.x1, at[0]),
            std::max(all_.y1, at[1])};
    radius = std::max(radius, track.cutter(pass).radius);
    reach_ = std::max(reach_, (pass.to - pass.from).norm() / 2 + pass.bulge);
  }
  reach_ += radius;
  side_ = std::max({radius / 2, (all_.x1 - all_.x0) / kMostBins, (all_.y1 - all_.y0) / kMostBins});
  columns_ = column(all_.x1) + 1;
  rows_ = row(all_.y1) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto bin = [&](const EdgePass& pass) {
    const AxisVector at = middle(pass);
    return static_cast<std::size_t>(row(at[1])) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(at[0]));
  };
  for (const EdgePass& pass : passes) ++first_[bin(pass) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(passes.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < passes.size(); ++i) members_[next[bin(passes[i])]++] = i;
}

int PassIndex::column(double x) const noexcept {
  return static_cast<int>(std::max(0.0, (x - all_.x0) / side_));
}
int PassIndex::row(double y) const noexcept {
  return static_cast<int>(std::max(0.0, (y - all_.y0) / side_));
}

std::vector<std::uint32_t> PassIndex::near(const Rectangle& place) const {
  std::vector<std::uint32_t> found;
  const Rectangle wide{place.x0 - reach_, place.y0 - reach_, place.x1 + reach_, place.y1 + reach_};
  if (members_.empty() || wide.x1 < all_.x0 || wide.y1 < all_.y0) return found;
  const int last_column = std::min(column(wide.x1), columns_ - 1);
  const int last_row = std::min(row(wide.y1), rows_ - 1);
  for (int r = row(wide.y0); r <= last_row; ++r)
    for (int c = column(wide.x0); c <= last_column; ++c) {
      const auto bin = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(c);
      for (std::uint32_t k = first_[bin]; k < first_[bin + 1]; ++k) {
        const EdgePass& pass = track_.passes()[members_[k]];
        const double radius = track_.cutter(pass).radius;
        if (square_distance(footprint(pass), place) <= radius * radius)
          found.push_back(members_[k]);
      }
    }
  std::sort(found.begin(), found.end());
  return found;
}

std::size_t PassIndex::memory() const noexcept {
  return (first_.capacity() + members_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace softcnc::surface
