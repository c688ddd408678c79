// SPDX-License-Identifier: MIT
#include "runtime/circle/circle_pass.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kFewest = 8;             // rows of an arc
constexpr double kLargestRadius = 1e4;         // mm: a larger radius is a line
constexpr double kShortOfTurn = 1e-3 * kTurn;  // what a full circle may lack
constexpr double kMoved = 1e-9;                // mm: less is rest

double angle_between(const Vector2d& from, const Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// The circle with the least squares of x^2 + y^2 - 2 a x - 2 b y - c (Kasa 1976), about the mean.
template <typename Points>
std::optional<std::pair<Vector2d, double>> circle_through(const Points& points) {
  Vector2d mean = Vector2d::Zero();
  for (const auto& point : points) mean += point.commanded;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& point : points) {
    const Vector2d p = point.commanded - mean;
    const Eigen::Vector3d line(2 * p.x(), 2 * p.y(), 1);
    normal += line * line.transpose();
    right += line * p.squaredNorm();
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return std::nullopt;
  const Eigen::Vector3d solution = solver.solve(right);
  const Vector2d centre = solution.head<2>();
  const double square = solution[2] + centre.squaredNorm();
  if (!(square > 0) || square > kLargestRadius * kLargestRadius) return std::nullopt;
  return std::pair(Vector2d(centre + mean), std::sqrt(square));
}

}  // namespace

void CircleFinder::take(const Row& row) {
  if (!block_.empty() && row.block != block_.back().block) {
    const Row last = block_.back();
    end_block();
    block_.assign(1, last);
    block_.front().block = row.block;
  }
  block_.push_back(row);
}

std::optional<CircleFinder::Arc> CircleFinder::arc_of_block() const {
  if (block_.size() < kFewest) return std::nullopt;
  const auto circle = circle_through(block_);
  if (!circle) return std::nullopt;
  Arc arc{circle->first, circle->second, 0};
  for (std::size_t i = 0; i < block_.size(); ++i) {
    const Row& row = block_[i];
    if (std::abs((row.commanded - arc.centre).norm() - arc.radius) > kOnCircle ||
        std::abs(row.across - block_[0].across) > kOnCircle)
      return std::nullopt;
    if (i > 0)
      arc.sweep += angle_between(block_[i - 1].commanded - arc.centre, row.commanded - arc.centre);
  }
  return arc;
}

bool CircleFinder::continues(const Arc& arc) const {
  return arc_ && (arc.centre - arc_->centre).norm() <= 5 * kOnCircle &&
         std::abs(arc.radius - arc_->radius) <= 5 * kOnCircle && arc.sweep * arc_->sweep > 0;
}

/// The rows of a block that does not move belong to the circle before it: the machine comes to
/// rest.
void CircleFinder::end_block() {
  const auto moved = [](const Row& a, const Row& b) {
    return (a.commanded - b.commanded).norm() > kMoved || std::abs(a.across - b.across) > kMoved;
  };
  const bool moves = std::adjacent_find(block_.begin(), block_.end(), moved) != block_.end();
  const auto arc = moves ? arc_of_block() : std::nullopt;
  if (moves && !(arc && continues(*arc))) end_pass();
  if (arc && !arc_) {
    arc_ = arc;
    pass_ = {block_[1].line, arc->sweep < 0, arc->centre, arc->radius, 0, {}};
    pass_.actual.push_back(block_[0].actual);
  } else if (arc) {
    arc_->sweep += arc->sweep;
  }
  for (std::size_t i = 1; arc_ && i < block_.size(); ++i) {
    pass_.actual.push_back(block_[i].actual);
    const double time = block_[i].t - block_[i - 1].t;
    if (time > 0)
      pass_.speed =
          std::max(pass_.speed, (block_[i].commanded - block_[i - 1].commanded).norm() / time);
  }
  block_.clear();
}

void CircleFinder::end_pass() {
  if (arc_ && std::abs(arc_->sweep) > kTurn - kShortOfTurn) passes_.push_back(std::move(pass_));
  arc_.reset();
  pass_ = {};
}

std::vector<CirclePass> CircleFinder::finish() {
  if (block_.size() > 1) end_block();
  end_pass();
  return std::move(passes_);
}

Result<std::vector<CirclePass>> read_circles(hal::TraceReader& trace, CirclePlane plane) {
  const auto axes = plane_axes(plane);
  const char third = static_cast<char>('x' + 'y' + 'z' - axes[0] - axes[1]);
  const auto name = [](char axis, const char* what) { return std::string(1, axis) + what; };
  std::vector<std::string> names{"t_s", "line", "block"};
  for (const char* what : {"_mm", "_act_mm"})
    for (const char axis : axes) names.push_back(name(axis, what));
  const auto& columns = trace.columns();
  if (std::ranges::find(columns, name(third, "_mm")) != columns.end())
    names.push_back(name(third, "_mm"));
  std::vector<std::size_t> selected;
  for (const std::string& wanted : names) {
    const auto found = std::ranges::find(columns, wanted);
    if (found == columns.end())
      return tl::make_unexpected(
          Diagnostic{.code = wanted.ends_with("_act_mm") ? Code::SC6085 : Code::SC6082,
                     .message = "the trace has no column '" + wanted + "'"});
    selected.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  if (Status status = trace.select(selected); !status) return tl::make_unexpected(status.error());
  CircleFinder finder;
  for (;;) {
    const auto more = trace.next();
    if (!more) return tl::make_unexpected(more.error());
    if (!*more) return finder.finish();
    const auto v = trace.values();
    finder.take({static_cast<int>(v[2]),
                 static_cast<int>(v[1]),
                 v[0],
                 {v[3], v[4]},
                 {v[5], v[6]},
                 v.size() > 7 ? v[7] : 0});
  }
}

}  // namespace softcnc::runtime
