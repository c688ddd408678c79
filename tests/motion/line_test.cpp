// SPDX-License-Identifier: MIT
// Straight lines against their closed form.
#include "motion/geometry/line.hpp"

#include <catch2/catch.hpp>

#include "support/curve_checks.hpp"
#include "support/property.hpp"

namespace softcnc {

using test::real;

TEST_CASE("a line is measured along itself", "[motion][line]") {
  const Line line({1, 2, 3}, {4, 6, 15});
  CHECK(line.length() == 13.0);
  CHECK((line.position(6.5) - AxisVector(2.5, 4, 9)).norm() < 1e-15);
  const PathPoint p = line.at(4);
  CHECK((p.dq - AxisVector(3, 4, 12) / 13.0).norm() < 1e-15);
  CHECK(p.ddq == AxisVector::Zero());
  CHECK(p.dddq == AxisVector::Zero());
  CHECK(p.q == line.position(4));
}

TEST_CASE("a line meets both ends exactly and keeps to the chord", "[motion][line][property]") {
  test::holds([] {
    const AxisVector from(real(-900, 900), real(-900, 900), real(-900, 900));
    const AxisVector to(real(-900, 900), real(-900, 900), 901);
    const Line line(from, to);
    RC_ASSERT(line.position(0) == from);
    RC_ASSERT(line.position(line.length()) == to);
    const double s = line.length() * real(0, 1);
    RC_ASSERT(std::abs((line.position(s) - from).norm() - s) < 1e-12);
    RC_ASSERT(std::abs((line.position(s) - to).norm() - (line.length() - s)) < 1e-12);
    RC_ASSERT(std::abs(line.at(s).dq.norm() - 1.0) < 1e-15);
  });
}

TEST_CASE("a very short line and a very long one have a direction", "[motion][line]") {
  CHECK(Line({0, 0, 0}, {3e-300, 4e-300, 0}).at(0).dq.isApprox(AxisVector(0.6, 0.8, 0), 1e-14));
  CHECK(Line({0, 0, 0}, {3e200, 4e200, 0}).length() == Approx(5e200).epsilon(1e-14));
}

}  // namespace softcnc
