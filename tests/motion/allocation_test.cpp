// SPDX-License-Identifier: MIT
// Evaluating a curve allocates nothing: counted at operator new itself.
#include <catch2/catch.hpp>
#include <new>
#include <vector>

#include "motion/geometry/path.hpp"
#include "support/allocations.hpp"
#include "support/curves.hpp"

namespace softcnc {

using test::allocations_during;

TEST_CASE("the counter counts", "[motion][allocation]") {
  CHECK(allocations_during([] { ::operator delete(::operator new(10)); }) == 1);
}

TEST_CASE("no curve allocates when it is evaluated", "[motion][allocation]") {
  std::vector<Path> paths;
  paths.emplace_back(Line({0, 0, 0}, {1, 2, 3}));
  paths.emplace_back(Arc::make({{1, 0, 0}, {0, 1, 3}, {0, 0, 0}}).value());
  paths.emplace_back(Arc::make({{1, 0, 0}, {0, 1.009, 3}, {0, 0, 0}}).value());
  paths.emplace_back(Nurbs::make(test::curve_spec("butterfly")).value());
  // Stands still at its start: the longest path through at().
  paths.emplace_back(
      Nurbs::make(
          {3, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 2, 3}}, {1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}})
          .value());
  AxisVector sum = AxisVector::Zero();
  const long counted = allocations_during([&] {
    for (const Path& path : paths)
      for (int i = 0; i <= 1000; ++i) {
        const double s = length(path) * i / 1000;
        sum += position(path, s) + at(path, s).ddq + at(path, s, Side::before).dq;
      }
  });
  CHECK(counted == 0);
  CHECK(sum.allFinite());
}

TEST_CASE("no NURBS allocates when it is evaluated by its parameter", "[motion][allocation]") {
  const Nurbs nurbs = Nurbs::make(test::curve_spec("butterfly")).value();
  AxisVector sum = AxisVector::Zero();
  const long counted = allocations_during([&] {
    for (int i = 0; i <= 1000; ++i) {
      const double u = i / 1000.0;
      sum += nurbs.point(u) + nurbs.derivatives(u)[3] + nurbs.derivatives(u, Side::before)[2];
      sum[0] += nurbs.speed(u) + nurbs.parameter(nurbs.arc_length(u));
    }
  });
  CHECK(counted == 0);
  CHECK(sum.allFinite());
}

}  // namespace softcnc
