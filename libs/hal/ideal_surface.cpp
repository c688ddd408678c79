// SPDX-License-Identifier: MIT
// Least squares through the centres of a few passes, then offset by the radius.
#include "hal/ideal_surface.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace softcnc::hal {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;

constexpr double kSide = 0.1;      // of its distance: a centre further aside is of another pass
constexpr double kSides = 1.3;     // pick-feeds, and
constexpr double kEdges = 1.6;     // feeds per tooth around a place, that count
constexpr double kDiagonal = 1.5;  // of half a side: out to the corners
constexpr double kSmooth = 0.002;  // mm: centres that stray further are on no smooth surface
constexpr double kRidge = 1e-9;    // keeps what too few passes leave open small
constexpr int kSteps = 6;

Six terms(double a, double b) { return (Six() << 1, a, b, a * a, a * b, b * b).finished(); }

/// The centre whose ball reaches deepest at a place.
const IdealSurface::Centre* lowest(std::span<const IdealSurface::Centre> centres, double radius,
                                   double x, double y) {
  const IdealSurface::Centre* found = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& centre : centres) {
    const double dx = x - centre.at[0], dy = y - centre.at[1];
    const double below = radius * radius - dx * dx - dy * dy;
    const double least_below = centre.at[2] - least;  // that reaches no deeper
    if (below <= 0 || (least_below >= 0 && below <= least_below * least_below)) continue;
    found = &centre;
    least = centre.at[2] - std::sqrt(below);
  }
  return found;
}

/// Distance to the nearest pass beside `from`, mm; infinite if there is none.
double pick_feed(std::span<const IdealSurface::Centre> centres, const IdealSurface::Centre& from,
                 double along_x, double along_y, double edge) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& centre : centres) {
    const double dx = centre.at[0] - from.at[0], dy = centre.at[1] - from.at[1];
    const double a = std::abs(dx * along_x + dy * along_y);
    const double b = std::abs(dy * along_x - dx * along_y);
    if (a <= kEdges * edge && b > kSide * kEdges * edge) least = std::min(least, b);
  }
  return least;
}

}  // namespace

std::optional<IdealSurface> IdealSurface::near(std::span<const Centre> centres, double radius,
                                               double x, double y, double reach) {
  const Centre* from = lowest(centres, radius, x, y);
  if (from == nullptr) return std::nullopt;
  const double edge = std::hypot(from->along[0], from->along[1]);
  if (!(edge > 0)) return std::nullopt;
  IdealSurface surface;
  surface.radius_ = radius;
  surface.x_ = from->at[0];
  surface.y_ = from->at[1];
  surface.along_x_ = from->along[0] / edge;
  surface.along_y_ = from->along[1] / edge;
  const double pick = pick_feed(centres, *from, surface.along_x_, surface.along_y_, edge);
  const double wide =
      std::max({kSides * pick, kEdges * edge, kDiagonal * reach + std::max(pick, edge)});
  if (!(wide < radius)) return std::nullopt;
  surface.unit_ = wide;

  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Six right = Six::Zero();
  std::vector<std::array<double, 3>> used;
  for (const Centre& centre : centres) {
    const double dx = centre.at[0] - surface.x_, dy = centre.at[1] - surface.y_;
    const double a = (dx * surface.along_x_ + dy * surface.along_y_) / wide;
    const double b = (dy * surface.along_x_ - dx * surface.along_y_) / wide;
    if (std::abs(a) > 1 || std::abs(b) > 1) continue;
    const double z = centre.at[2] - from->at[2];
    const Six t = terms(a, b);
    normal += t * t.transpose();
    right += z * t;
    used.push_back({a, b, z});
    surface.a0_ = std::min(surface.a0_, a);
    surface.a1_ = std::max(surface.a1_, a);
    surface.b0_ = std::min(surface.b0_, b);
    surface.b1_ = std::max(surface.b1_, b);
  }
  for (int i = 3; i < 6; ++i) normal(i, i) += kRidge * static_cast<double>(used.size());
  const Six c = normal.ldlt().solve(right);
  if (!c.allFinite()) return std::nullopt;
  for (const auto& [a, b, z] : used)
    if (std::abs(terms(a, b).dot(c) - z) > kSmooth) return std::nullopt;
  std::copy_n(c.data(), 6, surface.c_.begin());
  surface.c_[0] += from->at[2];
  return surface;
}

double IdealSurface::value(double a, double b) const noexcept {
  return c_[0] + a * (c_[1] + a * c_[3] + b * c_[4]) + b * (c_[2] + b * c_[5]);
}

/// By mm along a and b.
std::array<double, 2> IdealSurface::slope(double a, double b) const noexcept {
  return {(c_[1] + 2 * a * c_[3] + b * c_[4]) / unit_, (c_[2] + a * c_[4] + 2 * b * c_[5]) / unit_};
}

IdealSurface::Point IdealSurface::at(double x, double y) const noexcept {
  const double dx = x - x_, dy = y - y_;
  const double pa = (dx * along_x_ + dy * along_y_) / unit_;
  const double pb = (dy * along_x_ - dx * along_y_) / unit_;
  double a = pa, b = pb, long_ = 1;
  std::array<double, 2> g{};
  for (int i = 0; i < kSteps; ++i) {
    g = slope(a, b);
    long_ = std::sqrt(1 + g[0] * g[0] + g[1] * g[1]);
    a = pa - radius_ * g[0] / long_ / unit_;
    b = pb - radius_ * g[1] / long_ / unit_;
  }
  return {value(a, b) - radius_ / long_, g[0] * along_x_ - g[1] * along_y_,
          g[0] * along_y_ + g[1] * along_x_, a, b};
}

}  // namespace softcnc::hal
