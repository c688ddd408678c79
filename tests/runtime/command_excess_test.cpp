// SPDX-License-Identifier: MIT
// Commands that are faster than their axis are reported.
#include <catch2/catch.hpp>

#include "runtime/session/verification.hpp"
#include "support/shown.hpp"

namespace softcnc::runtime {

TEST_CASE("commands faster than their axis are reported", "[runtime][verification]") {
  Machine machine;
  Diagnostics diagnostics;
  report_command_excess({250, 0, 250.2}, machine, diagnostics);
  CHECK(diagnostics.all().empty());
  report_command_excess({100, 275, 0}, machine, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(shows(render(diagnostics.all()[0]),
              "the velocity of the commands of Y reaches 275 mm/s, 10 % above its limit of 250 "
              "mm/s [SC4002]"));
}

}  // namespace softcnc::runtime
