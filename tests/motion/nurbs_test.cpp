// SPDX-License-Identifier: MIT
// NURBS curves against an evaluator in quadruple precision, closed forms, and themselves.
#include "motion/geometry/nurbs.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "support/curve_checks.hpp"
#include "support/curves.hpp"
#include "support/quad_nurbs.hpp"
#include "support/random_nurbs.hpp"
#include "support/sanitized.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;
using test::quad;
using test::QuadDerivatives;
using test::QuadSpan;
using test::QuadVector;
using test::Random;

constexpr int kPoints = test::kSanitized ? 40'000 : 1'000'000;
constexpr int kPointsPerCurve = 1000;

Nurbs make(NurbsSpec spec) {
  auto nurbs = Nurbs::make(std::move(spec));
  INFO((nurbs ? std::string() : nurbs.error().message));
  REQUIRE(nurbs);
  return *std::move(nurbs);
}

quad distance(const AxisVector& a, const QuadVector& b) {
  return test::norm({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

/// Largest errors and largest magnitudes over a curve, by order of the derivative.
struct Errors {
  std::array<quad, 4> error{}, magnitude{};

  void add(const NurbsDerivatives& found, const QuadDerivatives& exact) {
    for (std::size_t k = 0; k < 4; ++k) {
      error[k] = std::max(error[k], distance(found[k], exact[k]));
      magnitude[k] = std::max(magnitude[k], test::norm(exact[k]));
    }
  }
  double relative(std::size_t k) const {
    return magnitude[k] > 0 ? static_cast<double>(error[k] / magnitude[k])
                            : static_cast<double>(error[k]);
  }
};

/// At both sides of every knot and at random places, so many of them together.
Errors compare(const Nurbs& nurbs, Random& random, int points) {
  Errors errors;
  const auto spans = test::spans(nurbs.spec());
  const int each = points / static_cast<int>(spans.size()) + 1;
  for (const std::size_t span : spans) {
    const QuadSpan exact(nurbs.spec(), span);
    const double first = nurbs.spec().knots[span];
    const double last = nurbs.spec().knots[span + 1];
    errors.add(nurbs.derivatives(first, Side::after), exact.derivatives(first));
    errors.add(nurbs.derivatives(last, Side::before), exact.derivatives(last));
    for (int i = 2; i < each; ++i) {
      const double u = std::min(random(first, last), std::nextafter(last, first));
      errors.add(nurbs.derivatives(u), exact.derivatives(u));
    }
  }
  return errors;
}

/// The length between two parameters of one span, by Gauss-Legendre quadrature in quadruple
/// precision, halved until it stands.
class QuadLength {
 public:
  QuadLength(const NurbsSpec& spec, std::size_t span, double tolerance)
      : span_(spec, span), tolerance_(tolerance) {}

  quad operator()(double a, double b, int depth = 0) const {
    const double middle = 0.5 * (a + b);
    const quad whole = rule(a, b);
    const quad halves = rule(a, middle) + rule(middle, b);
    quad miss = whole - halves;
    if (miss < 0) miss = -miss;
    if (miss <= tolerance_ || depth > 30) return halves;
    return (*this)(a, middle, depth + 1) + (*this)(middle, b, depth + 1);
  }

 private:
  quad rule(double a, double b) const {
    // Abramowitz and Stegun, table 25.4, n = 10.
    constexpr double x[] = {0.148874338981631211, 0.433395394129247191, 0.679409568299024406,
                            0.865063366688984511, 0.973906528517171720};
    constexpr double w[] = {0.295524224714752870, 0.269266719309996355, 0.219086362515982044,
                            0.149451349150580593, 0.066671344308688138};
    const double half = 0.5 * (b - a);
    quad sum = 0;
    for (std::size_t i = 0; i < 5; ++i)
      for (const double side : {-1.0, 1.0})
        sum += w[i] * test::norm(span_.derivatives(0.5 * (a + b) + side * x[i] * half)[1]);
    return sum * half;
  }

  QuadSpan span_;
  double tolerance_;
};

}  // namespace

TEST_CASE("points and three derivatives agree with quadruple precision over random curves",
          "[motion][nurbs]") {
  Random random(20261121);
  std::array<double, 4> worst{};
  for (int i = 0; i < kPoints / kPointsPerCurve; ++i) {
    const Nurbs nurbs = make(test::random_nurbs(random, 1 + i % 9));
    const Errors errors = compare(nurbs, random, kPointsPerCurve);
    for (std::size_t k = 0; k < 4; ++k) worst[k] = std::max(worst[k], errors.relative(k));
  }
  CAPTURE(worst[0], worst[1], worst[2], worst[3]);
  for (const double error : worst) CHECK(error < 1e-11);
}

TEST_CASE("polynomial curves have no rational residue in their derivatives", "[motion][nurbs]") {
  Random random(5);
  for (int degree = 1; degree <= 3; ++degree) {
    NurbsSpec spec = test::random_nurbs(random, degree);
    std::fill(spec.weights.begin(), spec.weights.end(), 0.7);
    const Nurbs nurbs = make(spec);
    const auto c = nurbs.derivatives(0.37);
    if (degree < 2) CHECK(c[2] == AxisVector::Zero());
    if (degree < 3) CHECK(c[3] == AxisVector::Zero());
    CHECK(compare(nurbs, random, 200).relative(3) < 1e-13);
  }
}

TEST_CASE("very narrow knot spans lose no digits", "[motion][nurbs]") {
  Random random(9);
  for (const double gap : {1e-3, 1e-6, 1e-9}) {
    for (const int degree : {3, 5, 9}) {
      NurbsSpec spec = test::random_nurbs(random, degree);
      while (std::ssize(spec.control) != degree + 5) spec = test::random_nurbs(random, degree);
      const auto inner = spec.knots.begin() + degree + 1;
      const std::array<double, 4> knots{0.2, 0.5, 0.5 + gap, 0.8};
      std::copy(knots.begin(), knots.end(), inner);
      const Errors errors = compare(make(spec), random, 500);
      for (std::size_t k = 0; k < 4; ++k) CHECK(errors.relative(k) < 1e-11);
    }
  }
}

TEST_CASE("the butterfly is as long and as tight as published", "[motion][nurbs]") {
  const Nurbs nurbs = make(test::curve_spec("butterfly"));
  CHECK(std::abs(nurbs.length() - 382.859558) < 5e-7);
  double curvature = 0;
  for (int i = 0; i <= 400000; ++i)
    curvature = std::max(curvature, nurbs.at(nurbs.length() * i / 400000).ddq.norm());
  CHECK(1 / curvature == Approx(0.02312).margin(5e-6));
  CHECK(nurbs.breaks().size() == 47);
}

TEST_CASE("a circle as a NURBS is a circle", "[motion][nurbs]") {
  const Nurbs nurbs = make(test::curve_spec("circle_deg2"));
  CHECK(std::abs(nurbs.length() - 20 * pi) < 1e-13 * 20 * pi);
  REQUIRE(nurbs.breaks().size() == 3);
  for (int i = 0; i < 3; ++i)
    CHECK(nurbs.breaks()[size_t(i)] == Approx(5 * pi * (i + 1)).epsilon(1e-14));
  for (int i = 0; i <= 1000; ++i) {
    const double s = nurbs.length() * i / 1000;
    const PathPoint p = nurbs.at(s);
    const AxisVector radial(std::cos(s / 10), std::sin(s / 10), 0);
    const AxisVector tangent(-std::sin(s / 10), std::cos(s / 10), 0);
    REQUIRE((p.q - 10 * radial).norm() < 2e-13);
    REQUIRE((p.dq - tangent).norm() < 1e-13);
    REQUIRE((p.ddq + radial / 10).norm() < 1e-13);
    REQUIRE((p.dddq + tangent / 100).norm() < 1e-12);
  }
}

TEST_CASE("arc lengths agree with quadrature in quadruple precision", "[motion][nurbs]") {
  Random random(77);
  std::vector<NurbsSpec> specs{test::curve_spec("butterfly"), test::curve_spec("infinity8"),
                               test::curve_spec("circle_deg2")};
  for (int degree = 1; degree <= 9; ++degree) specs.push_back(test::random_nurbs(random, degree));
  for (const NurbsSpec& spec : specs) {
    const Nurbs nurbs = make(spec);
    quad length = 0;
    for (const std::size_t span : test::spans(spec)) {
      const QuadLength exact(spec, span, 1e-15 * nurbs.length());
      const double first = spec.knots[span];
      const double middle = random(first, spec.knots[span + 1]);
      const quad inside = length + exact(first, middle);
      CHECK(std::abs(static_cast<double>(inside - nurbs.arc_length(middle))) <
            1e-12 * nurbs.length());
      length = inside + exact(middle, spec.knots[span + 1]);
    }
    CHECK(std::abs(static_cast<double>(length - nurbs.length())) < 2e-13 * nurbs.length());
  }
}

TEST_CASE("the inverse of the arc length undoes it", "[motion][nurbs]") {
  Random random(78);
  for (int i = 0; i < 36; ++i) {
    const Nurbs nurbs = make(test::random_nurbs(random, 1 + i % 9));
    CHECK(nurbs.parameter(0) == nurbs.u_first());
    CHECK(nurbs.parameter(nurbs.length()) == nurbs.u_last());
    CHECK(nurbs.arc_length(nurbs.u_first()) == 0.0);
    CHECK(nurbs.arc_length(nurbs.u_last()) == nurbs.length());
    for (int k = 0; k < 500; ++k) {
      const double s = random(0, nurbs.length());
      const double u = nurbs.parameter(s);
      // A parameter is a double: its last digit is worth so much length.
      const double digit = 2e-16 * u * std::max(nurbs.speed(u), nurbs.speed(u, Side::before));
      REQUIRE(std::abs(nurbs.arc_length(u) - s) < 2e-13 * nurbs.length() + digit);
      REQUIRE((nurbs.point(u) - nurbs.position(s)).norm() < 2e-13 * nurbs.length() + digit);
    }
  }
}

TEST_CASE("derivatives by arc length are those of the positions", "[motion][nurbs]") {
  Random random(79);
  std::vector<NurbsSpec> specs{test::curve_spec("butterfly"), test::curve_spec("infinity8")};
  for (int i = 0; i < 18; ++i) {
    specs.push_back(test::random_nurbs(random, 1 + i % 9));
    for (double& weight : specs.back().weights) weight = std::sqrt(std::sqrt(weight));
  }
  for (const NurbsSpec& spec : specs) {
    const Nurbs nurbs = make(spec);
    for (int k = 0; k < 300; ++k) {
      const double s = random(0, nurbs.length());
      const PathPoint p = nurbs.at(s);
      REQUIRE(p.q == nurbs.position(s));
      test::check_unit_speed(p);
      const double sharp = p.ddq.norm() + std::sqrt(p.dddq.norm()) + 1 / nurbs.length();
      const double h = 3e-4 / sharp;
      const auto crosses = [&](double b) { return std::abs(b - s) < 300 * h; };
      const bool near_break = std::any_of(nurbs.breaks().begin(), nurbs.breaks().end(), crosses);
      if (near_break || s < 300 * h || s > nurbs.length() - 300 * h) continue;
      test::check_differences(nurbs, s, h, sharp);
    }
  }
}

TEST_CASE("both ends are met to the last bit", "[motion][nurbs]") {
  Random random(80);
  for (int i = 0; i < 90; ++i) {
    const Nurbs nurbs = make(test::random_nurbs(random, 1 + i % 9));
    CHECK(nurbs.position(0) == nurbs.spec().control.front());
    CHECK(nurbs.position(nurbs.length()) == nurbs.spec().control.back());
    CHECK(nurbs.at(0).q == nurbs.spec().control.front());
    CHECK(nurbs.at(nurbs.length(), Side::before).q == nurbs.spec().control.back());
    const double step = 1e-9 * nurbs.length();
    CHECK((nurbs.position(step) - nurbs.position(0)).norm() == Approx(step).epsilon(1e-3));
  }
}

TEST_CASE("at a break the side decides, exactly", "[motion][nurbs]") {
  // Degree 1: every knot is a corner, every derivative known.
  const Nurbs nurbs =
      make({1, {{0, 0, 0}, {3, 4, 0}, {3, 10, 0}, {0, 10, 0}}, {1, 2, 3, 4}, {0, 0, 1, 5, 6, 6}});
  REQUIRE(nurbs.breaks().size() == 2);
  CHECK(nurbs.breaks()[0] == Approx(5).epsilon(1e-14));
  CHECK(nurbs.breaks()[1] == Approx(11).epsilon(1e-14));
  const double corner = nurbs.breaks()[0];
  CHECK((nurbs.at(corner, Side::before).dq - AxisVector(0.6, 0.8, 0)).norm() < 1e-15);
  CHECK((nurbs.at(corner, Side::after).dq - AxisVector(0, 1, 0)).norm() < 1e-15);
  CHECK(nurbs.derivatives(1, Side::before)[1].x() > 0);
  CHECK(nurbs.derivatives(1, Side::after)[1].x() == Approx(0).margin(1e-15));
  CHECK(nurbs.speed(1, Side::before) == Approx(nurbs.derivatives(1, Side::before)[1].norm()));
  CHECK((nurbs.position(corner) - AxisVector(3, 4, 0)).norm() < 1e-14);
}

TEST_CASE("inner knots are breaks, each once, whatever their multiplicity", "[motion][nurbs]") {
  Random random(81);
  for (int i = 0; i < 90; ++i) {
    const Nurbs nurbs = make(test::random_nurbs(random, 1 + i % 9));
    const auto breaks = nurbs.breaks();
    REQUIRE(breaks.size() == test::spans(nurbs.spec()).size() - 1);
    for (std::size_t k = 0; k < breaks.size(); ++k) {
      CHECK(breaks[k] > (k > 0 ? breaks[k - 1] : 0.0));
      CHECK(breaks[k] < nurbs.length());
      CHECK(nurbs.arc_length(nurbs.spec().knots[test::spans(nurbs.spec())[k + 1]]) == breaks[k]);
    }
  }
}

TEST_CASE("a cusp inside a span is a break where the tangent turns back", "[motion][nurbs]") {
  // x' = 3 (1 - 2t)^2, y' = 3 (1 - 2t): stands still at t = 1/2, reached upwards, left downwards.
  const Nurbs nurbs = make(
      {3, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}, {1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}});
  // |C'| = 3 r sqrt(1 + r^2) with r = |1 - 2t|: the length is 2^(3/2) - 1.
  CHECK(nurbs.length() == Approx(2 * std::sqrt(2.0) - 1).epsilon(1e-14));
  REQUIRE(nurbs.breaks().size() == 1);
  const double cusp = nurbs.breaks()[0];
  CHECK(cusp == Approx(nurbs.length() / 2).epsilon(1e-12));
  const PathPoint before = nurbs.at(cusp, Side::before);
  const PathPoint after = nurbs.at(cusp, Side::after);
  CHECK((before.dq - AxisVector(0, 1, 0)).norm() < 1e-4);
  CHECK((after.dq + AxisVector(0, 1, 0)).norm() < 1e-4);
  for (const PathPoint& p : {before, after}) {
    CHECK(p.dq.norm() == Approx(1).epsilon(1e-15));
    CHECK(p.ddq.allFinite());
    CHECK(p.dddq.allFinite());
  }
}

TEST_CASE("a straight curve that runs back is broken where it turns", "[motion][nurbs]") {
  const Nurbs nurbs = make({2, {{0, 0, 0}, {10, 0, 0}, {2, 0, 0}}, {1, 1, 1}, {0, 0, 0, 1, 1, 1}});
  // x = 20 t - 18 t^2 turns at t = 5/9, x = 50/9.
  CHECK(nurbs.length() == Approx(100.0 / 9 - 2).epsilon(1e-13));
  REQUIRE(nurbs.breaks().size() == 1);
  CHECK(nurbs.breaks()[0] == Approx(50.0 / 9).epsilon(1e-12));
  CHECK(nurbs.at(nurbs.breaks()[0], Side::before).dq == AxisVector(1, 0, 0));
  CHECK(nurbs.at(nurbs.breaks()[0], Side::after).dq == AxisVector(-1, 0, 0));
}

TEST_CASE("a sharp bend that does not stand still is no break", "[motion][nurbs]") {
  const Nurbs nurbs = make({3,
                            {{0, 0, 0}, {1, 1, 0}, {0.001, 1, 0}, {1, 0, 0}},
                            {1, 1, 1, 1},
                            {0, 0, 0, 0, 1, 1, 1, 1}});
  CHECK(nurbs.breaks().empty());
}

TEST_CASE("a triple control point is a corner where the curve stands still", "[motion][nurbs]") {
  const Nurbs nurbs =
      make({3,
            {{0, 0, 0}, {1, 0, 0}, {10, 0, 0}, {10, 0, 0}, {10, 0, 0}, {10, 5, 0}, {10, 9, 0}},
            {1, 1, 1, 1, 1, 1, 1},
            {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}});
  CHECK(nurbs.length() == Approx(19).epsilon(1e-14));
  REQUIRE(nurbs.breaks().size() == 3);
  const double corner = nurbs.breaks()[1];
  CHECK(corner == Approx(10).epsilon(1e-14));
  CHECK(nurbs.at(corner, Side::before).dq == AxisVector(1, 0, 0));
  CHECK(nurbs.at(corner, Side::after).dq == AxisVector(0, 1, 0));
  for (int i = 0; i <= 1000; ++i) {
    const double s = 19.0 * i / 1000;
    const AxisVector q = s <= 10 ? AxisVector(s, 0, 0) : AxisVector(10, s - 10, 0);
    REQUIRE((nurbs.position(s) - q).norm() < 1e-12);
  }
}

TEST_CASE("four equal control points make a span without length", "[motion][nurbs]") {
  NurbsSpec spec{3, {}, std::vector<double>(8, 1.0), {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5}};
  spec.control = {{0, 0, 0},  {1, 0, 0},  {10, 0, 0}, {10, 0, 0},
                  {10, 0, 0}, {10, 0, 0}, {10, 5, 0}, {10, 9, 0}};
  const Nurbs nurbs = make(spec);
  CHECK(nurbs.length() == Approx(19).epsilon(1e-14));
  CHECK(nurbs.breaks().size() == 3);  // two knots stand at the corner
  CHECK(nurbs.at(nurbs.breaks()[1], Side::before).dq == AxisVector(1, 0, 0));
  CHECK(nurbs.at(nurbs.breaks()[1], Side::after).dq == AxisVector(0, 1, 0));
}

TEST_CASE("doubled ends keep the tangent of their leg", "[motion][nurbs]") {
  const Nurbs nurbs = make({3,
                            {{0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {10, 10, 0}},
                            {1, 1, 3, 1, 1},
                            {0, 0, 0, 0, 1, 2, 2, 2, 2}});
  CHECK((nurbs.at(0).dq - AxisVector(1, 0, 0)).norm() < 1e-15);
  CHECK((nurbs.at(nurbs.length(), Side::before).dq - AxisVector(0, 1, 0)).norm() < 1e-15);
  for (int i = 0; i <= 1000; ++i) {
    const PathPoint p = nurbs.at(nurbs.length() * i / 1000);
    REQUIRE(std::abs(p.dq.norm() - 1) < 1e-14);
    REQUIRE(p.ddq.allFinite());
    REQUIRE(p.dddq.allFinite());
  }
}

TEST_CASE("a straight NURBS with uneven weights and knots is a line", "[motion][nurbs]") {
  const AxisVector leg(1, 2, -2);
  const Nurbs nurbs = make({3,
                            {0 * leg, 1 * leg, 2 * leg, 7 * leg, 9 * leg},
                            {1, 30, 0.2, 1, 8},
                            {0, 0, 0, 0, 0.9, 1, 1, 1, 1}});
  CHECK(nurbs.length() == Approx(27).epsilon(1e-13));
  for (int i = 0; i <= 1000; ++i) {
    const PathPoint p = nurbs.at(27.0 * i / 1000);
    REQUIRE((p.q - 27.0 * i / 1000 * leg / 3).norm() < 1e-11);
    REQUIRE((p.dq - leg / 3).norm() < 1e-13);
  }
}

TEST_CASE("a NURBS of two points is a line", "[motion][nurbs]") {
  const Nurbs nurbs = make({1, {{1, 1, 1}, {4, 5, 1}}, {1, 100}, {2, 2, 7, 7}});
  CHECK(nurbs.length() == Approx(5).epsilon(1e-14));
  CHECK(nurbs.breaks().empty());
  CHECK((nurbs.position(2.5) - AxisVector(2.5, 3, 1)).norm() < 1e-13);
  CHECK(nurbs.at(1).ddq.norm() < 1e-12);
}

TEST_CASE("coincident ends are allowed", "[motion][nurbs]") {
  const Nurbs nurbs = make(test::curve_spec("infinity8"));
  CHECK(nurbs.position(0) == nurbs.position(nurbs.length()));
  CHECK(nurbs.length() > 1000);
}

TEST_CASE("knots and weights may be scaled without changing the curve", "[motion][nurbs]") {
  const Nurbs plain = make(test::curve_spec("butterfly"));
  NurbsSpec spec = test::curve_spec("butterfly");
  for (double& knot : spec.knots) knot = 4096 * knot;
  for (double& weight : spec.weights) weight = weight / 1024;
  const Nurbs scaled = make(spec);
  CHECK(scaled.length() == Approx(plain.length()).epsilon(1e-14));
  for (double s = 0; s < plain.length(); s += 0.37)
    REQUIRE((scaled.position(s) - plain.position(s)).norm() < 1e-10);
}

TEST_CASE("a thousand control points are measured as exactly as six", "[motion][nurbs]") {
  Random random(82);
  NurbsSpec spec{3, {}, std::vector<double>(1000, 1.0), {0, 0, 0}};
  for (int i = 0; i < 1000; ++i)
    spec.control.emplace_back(random(0, 100), random(0, 100), random(0, 9));
  for (int i = 0; i <= 997; ++i) spec.knots.push_back(i);
  spec.knots.insert(spec.knots.end(), 3, 997);
  const Nurbs nurbs = make(spec);
  CHECK(nurbs.breaks().size() == 996);
  quad length = 0;
  for (const std::size_t span : test::spans(spec))
    length +=
        QuadLength(spec, span, 1e-16 * nurbs.length())(spec.knots[span], spec.knots[span + 1]);
  CHECK(std::abs(static_cast<double>(length - nurbs.length())) < 1e-13 * nurbs.length());
  for (int i = 0; i < 20000; ++i) {
    const double s = random(0, nurbs.length());
    REQUIRE(std::abs(nurbs.arc_length(nurbs.parameter(s)) - s) < 1e-12 * nurbs.length());
  }
}

}  // namespace softcnc
