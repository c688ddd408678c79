// SPDX-License-Identifier: MIT
// Least squares through the centres of a few passes, then offset by the radius.
#include "surface/ideal_surface.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace softcnc::surface {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;

constexpr double kSide = 0.1;      // of its distance: a centre further aside is of another pass
constexpr double kSides = 1.3;     // pick-feeds, and
constexpr double kEdges = 1.6;     // feeds per tooth around a place, that count
constexpr double kDiagonal = 1.5;  // of half a side: out to the corners
constexpr double kSmooth = 0.002;  // mm: centres that stray further are on no smooth surface
constexpr double kRidge = 1e-9;    // keeps what too few passes leave open small
constexpr int kSteps = 12;         // of Newton's method
constexpr double kFound = 1e-10;   // of half a side
constexpr int kAcross = 48, kAround = 6;  // steps of lattices to each side

Six terms(double a, double b) { return (Six() << 1, a, b, a * a, a * b, b * b).finished(); }

/// Distance to the nearest pass beside, mm: of those further off than `aside`; infinite if there is
/// none.
double pick_feed(std::span<const Ball> balls, double aside) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls)
    if (std::abs(ball.b) > aside) least = std::min(least, std::abs(ball.b));
  return least;
}

/// Half of a side of the square whose centres count, mm.
double half_side(double pick, double edge, double reach) {
  return std::max({kSides * pick, kEdges * edge, kDiagonal * reach + std::max(pick, edge)});
}

}  // namespace

/// First through all passes; where that is not smooth, through those that cut deepest, and others
/// on the same surface.
std::optional<IdealSurface> IdealSurface::near(std::span<const Centre> centres, double radius,
                                               double x, double y, double reach) {
  const Centre* from = lowest_ball(centres, radius, [&](const Centre& centre) {
    return Ball{centre.at[0] - x, centre.at[1] - y, centre.at[2]};
  });
  if (from == nullptr) return std::nullopt;
  const double edge = std::hypot(from->along[0], from->along[1]);
  if (!(edge > 0)) return std::nullopt;
  IdealSurface surface;
  surface.radius_ = radius;
  surface.target_ = from->target;
  surface.x_ = from->at[0];
  surface.y_ = from->at[1];
  surface.z_ = from->at[2];
  surface.along_x_ = from->along[0] / edge;
  surface.along_y_ = from->along[1] / edge;
  const double strip = kEdges * edge;
  const auto beside = surface.place(centres, strip, std::numeric_limits<double>::infinity());
  const double wide = half_side(pick_feed(beside, kSide * strip), edge, reach);
  if (surface.lay(surface.place(centres, wide, wide), wide)) return surface;

  return surface.lay_lower_envelope(centres, beside, {x, y, 0}, edge, reach)
             ? std::optional(surface)
             : std::nullopt;
}

bool IdealSurface::lay_lower_envelope(std::span<const Centre> centres, std::span<const Ball> beside,
                                      const AxisVector& at, double edge, double reach) {
  const Ball middle = place(at);
  const Lattice across{middle.a, middle.b, 0, radius_ / 2, 0, kAcross};
  const double pick = pick_feed(lower_envelope(beside, radius_, across), kSide * kEdges * edge);
  const double wide = half_side(pick, edge, reach);
  if (!(wide < radius_)) return false;
  const double wider = wide + std::max(pick, edge);  // so that all balls are there up to the side
  const Lattice around{middle.a, middle.b, wide, wide, kAround, kAround};
  auto deep = lower_envelope(place(centres, wider, wider), radius_, around);
  std::erase_if(deep, [wide](const Ball& ball) {
    return std::abs(ball.a) > wide || std::abs(ball.b) > wide;
  });
  if (!lay(deep, wide)) return false;
  auto balls = place(centres, wide, wide);
  std::erase_if(balls, [&](const Ball& ball) { return std::abs(height(ball) - ball.z) > kSmooth; });
  return lay(balls, wide) && lies_below(centres, at, reach);
}

/// No ball of a pass reaches below an ideal surface: where one does, it is not that of these
/// passes.
bool IdealSurface::lies_below(std::span<const Centre> centres, const AxisVector& at,
                              double reach) const {
  for (const double dx : {-reach, 0.0, reach})
    for (const double dy : {-reach, 0.0, reach}) {
      const double x = at[0] + dx, y = at[1] + dy;
      const auto seen = [&](const Centre& centre) {
        return Ball{centre.at[0] - x, centre.at[1] - y, centre.at[2]};
      };
      const Centre* found = lowest_ball(centres, radius_, seen);
      if (found == nullptr) return false;
      const Ball ball = seen(*found);
      const double bottom =
          ball.z - std::sqrt(radius_ * radius_ - ball.a * ball.a - ball.b * ball.b);
      const auto point = this->at(x, y);
      if (!point || point->z > bottom + kSmooth) return false;
    }
  return true;
}

Ball IdealSurface::place(const AxisVector& centre) const noexcept {
  const double dx = centre[0] - x_, dy = centre[1] - y_;
  return {dx * along_x_ + dy * along_y_, dy * along_x_ - dx * along_y_, centre[2] - z_};
}

std::vector<Ball> IdealSurface::place(std::span<const Centre> centres, double far_a,
                                      double far_b) const {
  std::vector<Ball> placed;
  for (const Centre& centre : centres) {
    const Ball ball = place(centre.at);
    if (std::abs(ball.a) <= far_a && std::abs(ball.b) <= far_b) placed.push_back(ball);
  }
  return placed;
}

/// Whether a smooth surface goes through the balls, none of which is further off than `wide`.
bool IdealSurface::lay(std::span<const Ball> balls, double wide) {
  if (!(wide < radius_)) return false;
  unit_ = wide;
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Six right = Six::Zero();
  for (const Ball& ball : balls) {
    const Six t = terms(ball.a / unit_, ball.b / unit_);
    normal += t * t.transpose();
    right += ball.z * t;
  }
  for (int i = 3; i < 6; ++i) normal(i, i) += kRidge * static_cast<double>(balls.size());
  const Six c = normal.ldlt().solve(right);
  if (!c.allFinite()) return false;
  std::copy_n(c.data(), 6, c_.begin());
  c_[0] += z_;
  bound(balls);
  return std::ranges::all_of(
      balls, [&](const Ball& ball) { return std::abs(height(ball) - ball.z) <= kSmooth; });
}

/// Where centres are.
void IdealSurface::bound(std::span<const Ball> balls) noexcept {
  a0_ = a1_ = b0_ = b1_ = 0;
  for (const Ball& ball : balls) {
    a0_ = std::min(a0_, ball.a / unit_);
    a1_ = std::max(a1_, ball.a / unit_);
    b0_ = std::min(b0_, ball.b / unit_);
    b1_ = std::max(b1_, ball.b / unit_);
  }
}

double IdealSurface::value(double a, double b) const noexcept {
  return c_[0] + a * (c_[1] + a * c_[3] + b * c_[4]) + b * (c_[2] + b * c_[5]);
}

/// By mm along a and b.
std::array<double, 2> IdealSurface::slope(double a, double b) const noexcept {
  return {(c_[1] + 2 * a * c_[3] + b * c_[4]) / unit_, (c_[2] + a * c_[4] + 2 * b * c_[5]) / unit_};
}

/// The centre whose ball touches the surface here, by Newton's method: steeply bent hollows too.
std::optional<IdealSurface::Point> IdealSurface::at(double x, double y) const noexcept {
  const double dx = x - x_, dy = y - y_;
  const double pa = (dx * along_x_ + dy * along_y_) / unit_;
  const double pb = (dy * along_x_ - dx * along_y_) / unit_;
  const Eigen::Vector2d wanted(pa, pb);
  const Eigen::Matrix2d curvature{{2 * c_[3] / unit_, c_[4] / unit_},
                                  {c_[4] / unit_, 2 * c_[5] / unit_}};
  const double part = radius_ / unit_;
  Eigen::Vector2d ab = wanted, g;
  double step = std::numeric_limits<double>::infinity(), long_ = 1;
  for (int i = 0; i < kSteps && step > kFound; ++i) {
    const auto [ga, gb] = slope(ab[0], ab[1]);
    g = {ga, gb};
    long_ = std::sqrt(1 + g.squaredNorm());
    const Eigen::Vector2d miss = ab - wanted + part / long_ * g;
    const Eigen::Matrix2d turned = curvature - g * (g.transpose() * curvature) / (long_ * long_);
    const Eigen::Matrix2d slopes = Eigen::Matrix2d::Identity() + part / long_ * turned;
    if (!(slopes.determinant() > 0)) break;  // the ball would cut what it has left
    const Eigen::Vector2d newton = slopes.inverse() * miss;
    ab -= newton;
    step = newton.norm();
  }
  if (!(step <= kFound)) return std::nullopt;
  return Point{value(ab[0], ab[1]) - radius_ / long_, g[0] * along_x_ - g[1] * along_y_,
               g[0] * along_y_ + g[1] * along_x_, ab[0], ab[1]};
}

}  // namespace softcnc::surface
