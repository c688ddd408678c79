// SPDX-License-Identifier: MIT
#include "ipo/rebuild/quintic.hpp"

#include <catch2/catch.hpp>

#include "motion/geometry/nurbs.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::ipo;
using test::integer;
using test::real;

namespace {

QuinticSpline random_spline() {
  QuinticSpline spline;
  const int spans = integer(1, 12);
  spline.knots.assign(kQuinticOrder, 0.0);
  for (int i = 0; i < spans; ++i) spline.knots.push_back(spline.knots.back() + real(0.05, 1));
  spline.knots.insert(spline.knots.end(), kQuinticDegree, spline.knots.back());
  for (int i = 0; i < spans + static_cast<int>(kQuinticDegree); ++i)
    spline.control.emplace_back(i + real(-1, 1), real(-1, 1), real(-1, 1));
  return spline;
}

/// The same curve, as it is computed elsewhere.
Nurbs nurbs_of(const QuinticSpline& spline) {
  return *Nurbs::make(
      {5, spline.control, std::vector<double>(spline.control.size(), 1.0), spline.knots});
}

double off(const AxisVector& a, const AxisVector& b) { return (a - b).norm() / (1 + b.norm()); }

}  // namespace

TEST_CASE("a quintic spline is the NURBS of degree 5 with its knots and points",
          "[rebuild][property]") {
  test::holds([] {
    const QuinticSpline spline = random_spline();
    const Nurbs nurbs = nurbs_of(spline);
    for (std::size_t span = 0; span < spline.spans(); ++span) {
      const double begin = spline.begin(span), width = spline.end(span) - begin;
      const QuinticBezier bezier = bezier_of(spline, span);
      for (const double x : {0.03, 0.4, 0.97}) {
        const double t = begin + x * width;
        RC_ASSERT(spline.span_at(t) == span);
        const auto exact = nurbs.derivatives(t);
        for (int order = 0; order <= 3; ++order) {
          const QuinticBasis basis = quintic_basis(spline.knots, span, t, order);
          AxisVector sum = AxisVector::Zero();
          for (std::size_t i = 0; i < basis.size(); ++i) sum += basis[i] * spline.control[span + i];
          RC_ASSERT(off(sum, exact[static_cast<std::size_t>(order)]) < 1e-8);
        }
        RC_ASSERT(off(bezier.at(x), exact[0]) < 1e-12);
        RC_ASSERT(off(bezier.with_slope(x).second / width, exact[1]) < 1e-10);
        RC_ASSERT(off(bezier.between(0.5 * x, x).points.back(), exact[0]) < 1e-12);
      }
    }
  });
}

TEST_CASE("a part of a quintic spline is the same curve", "[rebuild][property]") {
  test::holds([] {
    const QuinticSpline spline = random_spline();
    const Nurbs whole = nurbs_of(spline);
    const double end = spline.knots.back();
    double t0 = real(0, 0.6) * end, t1 = t0 + real(0.05, 0.4) * end;
    if (integer(0, 1)) t0 = spline.begin(spline.span_at(t0));  // at a knot
    if (integer(0, 1)) t1 = spline.end(spline.span_at(t1));
    const auto part = Nurbs::make(part_of(spline, t0, t1));
    RC_ASSERT(part.has_value());
    RC_ASSERT(part->u_last() == t1 - t0);
    for (const double x : {0.0, 0.2, 0.7, 1.0}) {
      const double u = x * (t1 - t0);
      RC_ASSERT(off(part->point(u), whole.point(std::min(t0 + u, end))) < 1e-10);
    }
  });
}

TEST_CASE("control points at their places on a line are that line", "[rebuild][property]") {
  test::holds([] {
    QuinticSpline spline = random_spline();
    const AxisVector direction = AxisVector(1, 2, 2) / 3;
    for (std::size_t i = 0; i < spline.control.size(); ++i)
      spline.control[i] = greville(spline.knots, i) * direction;
    for (std::size_t span = 0; span < spline.spans(); ++span) {
      const auto [point, slope] = bezier_of(spline, span).with_slope(0.3);
      const double width = spline.end(span) - spline.begin(span);
      RC_ASSERT((point - (spline.begin(span) + 0.3 * width) * direction).norm() < 1e-12);
      RC_ASSERT((slope / width - direction).norm() < 1e-10);
    }
  });
}
