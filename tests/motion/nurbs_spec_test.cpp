// SPDX-License-Identifier: MIT
// Every reason why a specification is not a curve, and how it is reported.
#include "motion/geometry/nurbs_spec.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "motion/geometry/nurbs.hpp"

namespace softcnc {
namespace {

/// A cubic of six points that is in order.
NurbsSpec good() {
  return {3,
          {{0, 0, 0}, {1, 2, 0}, {3, 3, 0}, {4, 0, 0}, {6, 1, 0}, {7, 7, 0}},
          {1, 1, 2, 1, 1, 1},
          {0, 0, 0, 0, 0.5, 0.75, 1, 1, 1, 1}};
}

std::string nurbs_refusal(const NurbsSpec& spec) {
  const Status status = check(spec);
  if (status) return "good";
  const auto nurbs = Nurbs::make(spec);
  REQUIRE_FALSE(nurbs);
  CHECK(nurbs.error().code == status.error().code);
  CHECK(nurbs.error().message == status.error().message);
  CHECK(status.error().pos.line == 0);  // the place is the caller's to know
  CHECK(status.error().severity() == Severity::error);
  return render(status.error());
}

std::string nurbs_refusal(const std::function<void(NurbsSpec&)>& spoil) {
  NurbsSpec spec = good();
  spoil(spec);
  return nurbs_refusal(spec);
}

}  // namespace

TEST_CASE("a specification in order passes", "[motion][nurbs]") {
  CHECK(nurbs_refusal(good()) == "good");
  // A corner: an inner knot as often as the degree.
  CHECK(nurbs_refusal([](auto& s) { s.knots = {0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}; }) == "good");
  CHECK(nurbs_refusal({1, {{0, 0, 0}, {1, 0, 0}}, {1, 1}, {0, 0, 1, 1}}) == "good");
  CHECK(nurbs_refusal({2,
                       {{0, 0, 0}, {1, 0, 0}, {2, 2, 0}, {2, 4, 0}, {0, 9, 0}},
                       {1, 1, 1, 1, 1},
                       {0, 0, 0, 0.5, 0.5, 1, 1, 1}}) == "good");
}

TEST_CASE("orders below 2 and above 10 are refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.degree = 0; }) ==
        "softcnc: error: a NURBS of order 1; orders 2 to 10 are supported [SC3001]\n");
  CHECK(nurbs_refusal([](auto& s) { s.degree = 10; }) ==
        "softcnc: error: a NURBS of order 11; orders 2 to 10 are supported [SC3001]\n");
  CHECK(nurbs_refusal([](auto& s) { s.degree = -1; }) ==
        "softcnc: error: a NURBS of order 0; orders 2 to 10 are supported [SC3001]\n");
}

TEST_CASE("fewer points than the order are refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.control.resize(3); }) ==
        "softcnc: error: 3 control points are too few for a NURBS of order 4 [SC3002]\n");
}

TEST_CASE("knots too few or too many are refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.knots.pop_back(); }) ==
        "softcnc: error: 9 knots for 6 control points of order 4: there must be 10 [SC3003]\n");
  CHECK(nurbs_refusal([](auto& s) { s.knots.push_back(1); }) ==
        "softcnc: error: 11 knots for 6 control points of order 4: there must be 10 [SC3003]\n");
}

TEST_CASE("decreasing knots are refused by number", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.knots[5] = 0.25; }) ==
        "softcnc: error: knot 6 (0.25) is less than the knot before it (0.5) [SC3004]\n");
}

TEST_CASE("ends that are not clamped are refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.knots[0] = -1; }) ==
        "softcnc: error: the first 4 knots are not equal (-1 to 0) [SC3005]\n");
  CHECK(nurbs_refusal([](auto& s) { s.knots[9] = 1.5; }) ==
        "softcnc: error: the last 4 knots are not equal (1 to 1.5) [SC3005]\n");
}

TEST_CASE("knots that would tear the curve are refused", "[motion][nurbs][code]") {
  const std::vector<AxisVector> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0},
                                       {3, 3, 0}, {4, 0, 0}, {5, 0, 0}};
  const std::vector<double> weights(6, 1.0);
  CHECK(nurbs_refusal({2, points, weights, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}}) ==
        "softcnc: error: knot 4 (0.5) occurs 3 times: a curve of order 3 would be discontinuous "
        "[SC3006]\n");
  CHECK(nurbs_refusal({2, points, weights, {0, 0, 0, 0, 0.5, 0.7, 1, 1, 1}}) ==
        "softcnc: error: knot 2 (0) occurs 4 times: a curve of order 3 would be discontinuous "
        "[SC3006]\n");
  CHECK(nurbs_refusal({2, points, weights, {0, 0, 0, 0.5, 0.7, 1, 1, 1, 1}}) ==
        "softcnc: error: knot 6 (1) occurs 4 times: a curve of order 3 would be discontinuous "
        "[SC3006]\n");
  CHECK(nurbs_refusal({2, points, weights, {1, 1, 1, 1, 1, 1, 1, 1, 1}}) ==
        "softcnc: error: knot 2 (1) occurs 9 times: a curve of order 3 would be discontinuous "
        "[SC3006]\n");
}

TEST_CASE("weights that are not positive or not there are refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.weights[2] = 0; }) ==
        "softcnc: error: weight 0 of control point 3 is not positive [SC3007]\n");
  CHECK(nurbs_refusal([](auto& s) { s.weights[5] = -2.5; }) ==
        "softcnc: error: weight -2.5 of control point 6 is not positive [SC3007]\n");
  CHECK(nurbs_refusal([](auto& s) { s.weights[0] = std::nan(""); }) ==
        "softcnc: error: weight nan of control point 1 is not positive [SC3007]\n");
  CHECK(nurbs_refusal([](auto& s) { s.weights[0] = HUGE_VAL; }) ==
        "softcnc: error: weight inf of control point 1 is not positive [SC3007]\n");
  CHECK(nurbs_refusal([](auto& s) { s.weights.pop_back(); }) ==
        "softcnc: error: 5 weights for 6 control points [SC3007]\n");
}

TEST_CASE("numbers that are not finite are refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) { s.control[3].y() = HUGE_VAL; }) ==
        "softcnc: error: control point 4 is not finite [SC3008]\n");
  CHECK(nurbs_refusal([](auto& s) { s.knots[4] = std::nan(""); }) ==
        "softcnc: error: knot 5 is not finite [SC3008]\n");
}

TEST_CASE("a curve that goes nowhere is refused", "[motion][nurbs][code]") {
  CHECK(nurbs_refusal([](auto& s) {
          for (auto& p : s.control) p = {3, 4, 5};
        }) == "softcnc: error: all control points of the NURBS are the same [SC3009]\n");
}

TEST_CASE("a curve beyond working precision is refused, not computed wrongly",
          "[motion][nurbs][code]") {
  const auto refused = [](NurbsSpec spec) {
    const auto nurbs = Nurbs::make(std::move(spec));
    REQUIRE_FALSE(nurbs);
    CHECK(nurbs.error().code == Code::SC3010);
    CHECK(
        nurbs.error().message ==
        "the NURBS cannot be computed: its weights, knots or coordinates differ too much in size");
  };
  NurbsSpec spec = good();
  spec.weights = {1, 1e300, 1e-300, 1, 1, 1};
  refused(spec);
  spec.weights = {1, 1e60, 1, 1, 1, 1};
  refused(spec);
  spec = good();
  spec.control[2] = {1e300, 0, 0};
  refused(spec);
}

}  // namespace softcnc
