// SPDX-License-Identifier: MIT
#include "ipo/rebuild/quintic.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

constexpr int kDegree = static_cast<int>(kQuinticDegree);

/// The basis functions of a degree that are not zero at t, by the recursion of Cox and de Boor, in
/// the last places.
void put_values(std::span<const double> knots, std::size_t index, double t, int degree,
                QuinticBasis& out) {
  out.fill(0);
  double* value = out.data() + kDegree;  // of the function that ends last
  value[0] = 1;
  for (int p = 1; p <= degree; ++p)
    for (int i = -p; i <= 0; ++i) {
      const double* knot = knots.data() + index + i;
      const double rise = i == -p ? 0.0 : (t - knot[0]) / (knot[p] - knot[0]) * value[i];
      const double fall = i == 0 ? 0.0 : (knot[p + 1] - t) / (knot[p + 1] - knot[1]) * value[i + 1];
      value[i] = rise + fall;
    }
}

AxisVector mix(const AxisVector& a, const AxisVector& b, double x) { return a + x * (b - a); }

/// Inserts a knot where there are fewer than five of it (W. Boehm, 1980).
void insert(QuinticSpline& spline, double t) {
  const auto& u = spline.knots;
  const auto after = static_cast<std::size_t>(std::upper_bound(u.begin(), u.end(), t) - u.begin());
  const std::size_t k = after - 1;  // u[k] <= t < u[k + 1]
  const auto there = static_cast<std::size_t>(std::count(u.begin(), u.end(), t));
  std::vector<AxisVector> fresh;
  for (std::size_t i = k - kQuinticDegree + 1; i <= k - there; ++i) {
    const double x = (t - u[i]) / (u[i + kQuinticDegree] - u[i]);
    fresh.push_back(mix(spline.control[i - 1], spline.control[i], std::clamp(x, 0.0, 1.0)));
  }
  const auto first = static_cast<std::ptrdiff_t>(k - kQuinticDegree + 1);
  spline.control.insert(spline.control.begin() + first, AxisVector::Zero());
  std::copy(fresh.begin(), fresh.end(), spline.control.begin() + first);
  spline.knots.insert(spline.knots.begin() + static_cast<std::ptrdiff_t>(after), t);
}

void saturate(QuinticSpline& spline, double t) {
  const auto count = std::count(spline.knots.begin(), spline.knots.end(), t);
  for (auto i = count; i < kDegree; ++i) insert(spline, t);
}

}  // namespace

std::size_t QuinticSpline::span_at(double t) const noexcept {
  const auto first = knots.begin() + kDegree + 1;
  const auto last = knots.end() - kDegree - 1;
  return static_cast<std::size_t>(std::upper_bound(first, last, t) - first);
}

double greville(std::span<const double> knots, std::size_t i) noexcept {
  double sum = 0;
  for (std::size_t k = 1; k <= kQuinticDegree; ++k) sum += knots[i + k];
  return sum / static_cast<double>(kQuinticDegree);
}

QuinticBasis quintic_basis(std::span<const double> knots, std::size_t span, double t, int order) {
  QuinticBasis basis{};
  const std::size_t index = span + kQuinticDegree;
  put_values(knots, index, t, kDegree - order, basis);
  for (int q = kDegree - order; q < kDegree; ++q) {
    QuinticBasis raised{};
    for (int i = -q; i <= 0; ++i) {
      const double* knot = knots.data() + index + i;
      const double share =
          (q + 1) / (knot[q + 1] - knot[0]) * basis[static_cast<std::size_t>(kDegree + i)];
      raised[static_cast<std::size_t>(kDegree + i)] += share;
      raised[static_cast<std::size_t>(kDegree + i - 1)] -= share;
    }
    basis = raised;
  }
  return basis;
}

AxisVector QuinticBezier::at(double x) const noexcept {
  auto p = points;
  for (std::size_t n = kQuinticDegree; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) p[i] = mix(p[i], p[i + 1], x);
  return p[0];
}

std::pair<AxisVector, AxisVector> QuinticBezier::with_slope(double x) const noexcept {
  auto p = points;
  for (std::size_t n = kQuinticDegree; n > 1; --n)
    for (std::size_t i = 0; i < n; ++i) p[i] = mix(p[i], p[i + 1], x);
  return {mix(p[0], p[1], x), kDegree * (p[1] - p[0])};
}

QuinticBezier QuinticBezier::cut_front(double x) noexcept {
  QuinticBezier front;
  for (std::size_t n = 0; n <= kQuinticDegree; ++n) {
    front.points[n] = points[0];
    for (std::size_t i = 0; i + n < kQuinticDegree; ++i)
      points[i] = mix(points[i], points[i + 1], x);
  }
  return front;
}

QuinticBezier QuinticBezier::between(double x0, double x1) const noexcept {
  QuinticBezier part = *this;
  if (x0 > 0) part.cut_front(x0);
  if (x1 < 1) part = part.cut_front((x1 - x0) / (1 - x0));
  return part;
}

QuinticBezier bezier_of(const QuinticSpline& spline, std::size_t span) {
  const double a = spline.begin(span), b = spline.end(span);
  const double* knot = spline.knots.data() + span + kQuinticDegree;  // a
  QuinticBezier out;
  std::array<AxisVector, kQuinticOrder> late;
  for (std::size_t i = 0; i <= kQuinticDegree; ++i) late[i] = spline.control[span + i];
  // Values of the blossom: with more and more arguments b, the others a.
  const auto insert_at = [&](std::array<AxisVector, kQuinticOrder>& d, int round, double t) {
    for (int i = 0; i <= kDegree - round; ++i) {
      const double first = knot[round + i - kDegree], last = knot[i + 1];
      d[static_cast<std::size_t>(i)] =
          mix(d[static_cast<std::size_t>(i)], d[static_cast<std::size_t>(i + 1)],
              (t - first) / (last - first));
    }
  };
  for (int n = 0; n <= kDegree; ++n) {
    auto d = late;
    for (int round = n + 1; round <= kDegree; ++round) insert_at(d, round, a);
    out.points[static_cast<std::size_t>(n)] = d[0];
    if (n < kDegree) insert_at(late, n + 1, b);
  }
  return out;
}

NurbsSpec part_of(const QuinticSpline& spline, double t0, double t1) {
  const std::size_t first = spline.span_at(t0);
  std::size_t last = spline.span_at(t1);
  if (last > first && t1 <= spline.begin(last)) --last;
  const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  QuinticSpline local;
  local.knots.assign(spline.knots.begin() + at(first),
                     spline.knots.begin() + at(last + 2 * kQuinticDegree + 2));
  local.control.assign(spline.control.begin() + at(first),
                       spline.control.begin() + at(last + kQuinticDegree + 1));
  saturate(local, t0);
  saturate(local, t1);
  const auto& u = local.knots;
  const auto begin = static_cast<std::size_t>(std::upper_bound(u.begin(), u.end(), t0) - u.begin());
  const auto end = static_cast<std::size_t>(std::lower_bound(u.begin(), u.end(), t1) - u.begin());
  NurbsSpec part;
  part.degree = kDegree;
  part.knots.assign(kQuinticOrder, 0.0);
  for (std::size_t i = begin; i < end; ++i) part.knots.push_back(u[i] - t0);
  part.knots.insert(part.knots.end(), kQuinticOrder, t1 - t0);
  const std::size_t count = part.knots.size() - kQuinticOrder;
  const std::size_t from = begin - kQuinticOrder;
  part.control.assign(local.control.begin() + at(from), local.control.begin() + at(from + count));
  part.weights.assign(count, 1.0);
  return part;
}

}  // namespace softcnc::ipo
