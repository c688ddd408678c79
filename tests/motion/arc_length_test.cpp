// SPDX-License-Identifier: MIT
// Arc length and its inverse for speeds whose integrals are known in closed form.
#include "motion/geometry/arc_length.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace softcnc {
namespace {

/// Both directions against a closed form s(t) on one span, and that they undo each other.
void check_map(const ArcLengthMap::Speed& speed, const std::function<double(double)>& s_of_t) {
  const auto map = ArcLengthMap::measure(speed, 1);
  REQUIRE(map);
  const double length = s_of_t(1);
  const double tolerance = 2 * ArcLengthMap::kTolerance * length;
  CHECK(std::abs(map->length() - length) <= tolerance);
  for (int i = 0; i <= 5000; ++i) {
    const double t = i / 5000.0;
    REQUIRE(std::abs(map->arc_length({0, 0, t}) - s_of_t(t)) <= tolerance);
    const SpanPlace place = map->place(length * t);
    REQUIRE(std::abs(s_of_t(place.from_first()) - length * t) <= tolerance);
    REQUIRE(std::abs(map->arc_length(place) - length * t) <= tolerance);
  }
}

}  // namespace

TEST_CASE("a constant speed is one cell", "[motion][arc_length]") {
  int calls = 0;
  const auto map = ArcLengthMap::measure([&](const SpanPlace&) { return ++calls, 3.0; }, 1);
  REQUIRE(map);
  CHECK(map->length() == Approx(3).epsilon(1e-15));
  CHECK(map->place(1.5).from_first() == Approx(0.5).epsilon(1e-15));
  CHECK(calls < 50);
}

TEST_CASE("speeds with a closed form are measured and undone", "[motion][arc_length]") {
  check_map([](const SpanPlace& p) { return std::exp(5 * p.from_first()); },
            [](double t) { return std::expm1(5 * t) / 5; });
  check_map([](const SpanPlace& p) { return 1 / (1e-3 + p.from_first()); },
            [](double t) { return std::log1p(t / 1e-3); });
  check_map([](const SpanPlace& p) { return 2 + std::cos(40 * p.from_first()); },
            [](double t) { return 2 * t + std::sin(40 * t) / 40; });
  // A near standstill: sqrt(t^2 + e^2) about the middle.
  const double e = 1e-5;
  const auto primitive = [=](double x) {
    return 0.5 * (x * std::hypot(x, e) + e * e * std::asinh(x / e));
  };
  check_map([=](const SpanPlace& p) { return std::hypot(p.from_first() - 0.5, e); },
            [=](double t) { return primitive(t - 0.5) - primitive(-0.5); });
}

TEST_CASE("a standstill at either end or inside is measured and undone", "[motion][arc_length]") {
  check_map([](const SpanPlace& p) { return 2 * p.from_first(); }, [](double t) { return t * t; });
  check_map([](const SpanPlace& p) { return 3 * std::pow(p.from_first(), 2); },
            [](double t) { return t * t * t; });
  check_map([](const SpanPlace& p) { return 3 * std::pow(p.from_last(), 2); },
            [](double t) { return 1 - std::pow(1 - t, 3); });
  const double a = 0.3;
  check_map([=](const SpanPlace& p) { return 2 * std::abs(p.from_first() - a); },
            [=](double t) { return a * a + (t - a) * std::abs(t - a); });
}

TEST_CASE("crowds of cells mark standstills inside a span only", "[motion][arc_length]") {
  const auto cusp =
      ArcLengthMap::measure([](const SpanPlace& p) { return std::abs(p.from_first() - 0.3); }, 1);
  REQUIRE(cusp);
  const auto crowds = cusp->crowds();
  REQUIRE(crowds.size() == 1);
  CHECK(crowds[0].first.from_first() <= 0.3);
  CHECK(moved(crowds[0].first, crowds[0].width).from_first() >= 0.3);
  const auto smooth = ArcLengthMap::measure([](const SpanPlace&) { return 1.0; }, 2);
  REQUIRE(smooth);
  CHECK(smooth->crowds().empty());
}

TEST_CASE("at the joint of two spans the side decides", "[motion][arc_length]") {
  const auto map = ArcLengthMap::measure([](const SpanPlace& p) { return p.span + 1.0; }, 3);
  REQUIRE(map);
  REQUIRE(map->span_starts().size() == 4);
  const double joint = map->span_starts()[1];
  CHECK(joint == Approx(1));
  CHECK(map->span_starts()[3] == map->length());
  CHECK(map->place(joint, Side::after).span == 1);
  CHECK(map->place(joint, Side::after).from_first() == 0.0);
  CHECK(map->place(joint, Side::before).span == 0);
  CHECK(map->place(joint, Side::before).from_last() == 0.0);
  CHECK(map->place(std::nextafter(joint, 0), Side::after).span == 0);
  CHECK(map->arc_length({1, 0, 0}) == joint);
  CHECK(map->arc_length({0, 1, 0}) == joint);
  CHECK(map->arc_length({2, 1, 0}) == map->length());
}

TEST_CASE("spans without length are stepped over", "[motion][arc_length]") {
  const auto map =
      ArcLengthMap::measure([](const SpanPlace& p) { return p.span == 1 ? 0.0 : 1.0; }, 3);
  REQUIRE(map);
  CHECK(map->length() == Approx(2));
  CHECK(map->place(map->span_starts()[1], Side::before).span == 0);
  CHECK(map->place(map->span_starts()[1], Side::after).span == 2);
  CHECK(map->arc_length({1, 0, 0.5}) == map->span_starts()[1]);
}

TEST_CASE("the arc length of thousands of spans does not drift", "[motion][arc_length]") {
  const auto map = ArcLengthMap::measure([](const SpanPlace&) { return 0.1; }, 30000);
  REQUIRE(map);
  CHECK(std::abs(map->length() - 3000.0) < 1e-15 * 3000);
}

TEST_CASE("what cannot be measured is given back as nothing", "[motion][arc_length]") {
  CHECK_FALSE(ArcLengthMap::measure([](const SpanPlace&) { return std::nan(""); }, 2));
  CHECK_FALSE(ArcLengthMap::measure([](const SpanPlace&) { return 0.0; }, 2));
  CHECK_FALSE(ArcLengthMap::measure([](const SpanPlace&) { return HUGE_VAL; }, 2));
  // Noise has no series, however small the cells.
  unsigned state = 1;
  const auto noise = [&](const SpanPlace&) {
    state = state * 1664525U + 1013904223U;
    return 1.0 + (state >> 8) / 16777216.0;
  };
  CHECK_FALSE(ArcLengthMap::measure(noise, 1));
}

}  // namespace softcnc
