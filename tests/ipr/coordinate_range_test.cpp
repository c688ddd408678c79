// SPDX-License-Identifier: MIT
// What lies further off than any machine reaches is reported at its word, and nothing overflows.
#include <catch2/catch.hpp>
#include <cmath>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

Places reported_of_reach(const std::string& text, const InterpreterOptions& options = {}) {
  const Interpreted result = interpret(text, {}, options);
  for (const Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what)) CHECK(std::isfinite(length(move->path)));
  return places(result);
}

}  // namespace

TEST_CASE("a place further than a million mm is reported once, at its word", "[ipr][reach]") {
  CHECK(reported_of_reach("G20 G0 X[10**308]\nG91 G0 X-1\nM2\n") == Places{"SC3008 1:8"});
  CHECK(reported_of_reach("G91 G0 X[10**308]\nX[10**308]\nX[-10**308]\nM2\n") ==
        Places{"SC3008 1:8"});
  CHECK(reported_of_reach("G20 G0 X[10**308] Y1\nG1 Y2 F10\nM2\n") == Places{"SC3008 1:8"});
  CHECK(reported_of_reach("G0 X1000000 Y-1000000\nM2\n").empty());
  CHECK(reported_of_reach("G0 X1000000.1 Y-1000000.1\nX5 Y5\nM2\n") == Places{"SC3008 1:4"});
  CHECK(reported_of_reach("G0 X900000\nG91 X100001\nM2\n") == Places{"SC3008 2:5"});
  CHECK(reported_of_reach("G10 L2 P1 R45\nG0 X999999 Y999999\nM2\n") == Places{"SC3008 2:12"});
  CHECK(reported_of_reach("G10 L2 P1 X999999\nG0 X2 Z1\nM2\n") == Places{"SC3008 2:4"});
  CHECK(reported_of_reach("G20\nG6.2 P2 K0 X0 F100\nK0 X[10**308]\nK1\nK1\nM2\n") ==
        Places{"SC3008 3:4"});
  CHECK(reported_of_reach("G28 X[10**300]\nG91 G0 X1\nM2\n") == Places{"SC3008 1:5"});
}

TEST_CASE("ROUND of what has no digits to round is the number itself", "[ipr][reach]") {
  CHECK(reported_of_reach("G0 XROUND[10**307]\nM2\n", kFanuc) == Places{"SC3008 1:4"});
}

TEST_CASE("centres, radii and handles may be far away, but not for ever", "[ipr][reach]") {
  CHECK(reported_of_reach("F1 G2 X1 Y1 R[10**300]\nM2\n") == Places{"SC3008 1:13"});
  CHECK(reported_of_reach("F1 G2 X1 Y0 R100000000\nM2\n").empty());
  CHECK(reported_of_reach("F1 G2 X1 Y1 I1 J[10**308]\nG1 X5\nM2\n") == Places{"SC3008 1:16"});
  CHECK(reported_of_reach("F1 G2 X[10**308] Y1 R5\nG91 X1 R5\nM2\n") == Places{"SC3008 1:7"});
  CHECK(reported_of_reach("F1 G90.1 G3 X1 Y1 I[10**308] J1\nM2\n") == Places{"SC3008 1:19"});
  CHECK(reported_of_reach("F1 G5.1 X1 Y1 I1 J[10**308]\nM2\n") == Places{"SC3008 1:18"});
  CHECK(reported_of_reach("F1 G5 X1 Y1 I1 J1 P1 Q[10**308]\nM2\n") == Places{"SC3008 1:22"});
}

TEST_CASE("cycles reach no further than other moves", "[ipr][reach]") {
  CHECK(reported_of_reach("F1 G81 X1 Z-1 R[10**300]\nX2\nM2\n") == Places{"SC3008 1:15"});
  CHECK(reported_of_reach("F1 G81 X1 Z[-10**300] R1\nX2\nX3\nM2\n") == Places{"SC3008 1:11"});
  CHECK(reported_of_reach("F1 G81 X2000000 Z-1 R1\nM2\n") == Places{"SC3008 1:8"});
  CHECK(reported_of_reach("F1 G91 G81 X999 Z-1 R1 L9999\nM2\n") == Places{"SC3008 1:12"});
}

TEST_CASE("an offset beyond what a machine keeps is reported, and the one before stays",
          "[ipr][reach][offsets]") {
  CHECK(reported_of_reach("G20 G92 X[10**308]\nG92 X5\nG0 X5\nM2\n") == Places{"SC3008 1:9"});
  CHECK(reported_of_reach("G20 G43.1 Z[10**308]\nG92 Z[10**308]\nG0 Z1\nM2\n") ==
        Places{"SC3008 1:11"});
  CHECK(reported_of_reach("G10 L1 P1 Z600000\nG43 H1\nG43.2 H1\nM2\n") == Places{"SC3008 3:1"});
  CHECK(reported_of_reach("G52 X600000\nG91 G10 L2 P1 X600000\nG10 L2 P1 X600000\nM2\n", kFanuc) ==
        Places{"SC3008 3:11", "SC1057 1:5"});
  CHECK(reported_of_reach("G10 L11 P1 R1000001\nM2\n", kFanuc) ==
        Places{"SC3008 1:12", "SC1057 1:12"});
  CHECK(reported_of_reach("G10 L10 P1 Z-1000001\nM2\n") == Places{"SC3008 1:12"});
  const Interpreted result =
      interpret("G10 L2 P2 X7\nG10 L2 P2 X2000000 R9\nG10 L2 P1 R36001\n#5241=1000001\nM2\n");
  CHECK(places(result) == Places{"SC3008 2:11", "SC3008 3:11", "SC3008 4:1"});
  CHECK(result.state.work[1].origin.x() == 7);
  CHECK(result.state.work[0].rotation == 0);
}

TEST_CASE("a variable of an offset takes what a machine keeps", "[ipr][reach][offsets]") {
  CHECK(reported_of_reach("#5221=1000000 #5230=-36000\nM2\n").empty());
  CHECK(reported_of_reach("#5161=1000001\nG28 X0\nM2\n") == Places{"SC3008 1:1"});
  CHECK(reported_of_reach("#5230=36001\nG0 X1\nM2\n") == Places{"SC3008 1:1"});
  CHECK(reported_of_reach("#2001=-1000001\n#500=[10**300]\nM2\n", kFanuc) == Places{"SC3008 1:1"});
}

TEST_CASE("a feed that no machine keeps is reported", "[ipr][reach]") {
  Machine fast;
  fast.limits.feed = 0;
  CHECK(reported_of_reach("G1 X1 F[10**-300]\nX2\nM2\n") == Places{"SC2007 1:7"});
  CHECK(places(interpret("G20 G1 X1 F[10**308]\nM2\n", fast)) == Places{"SC2007 1:11"});
  CHECK(places(interpret("G1 X1 F900000000\nM2\n", fast)).empty());
  CHECK(reported_of_reach("G93 G1 X1 F[10**-300]\nM2\n") == Places{"SC2007 1:11"});
  CHECK(reported_of_reach("G95 S1 M3 F[10**-300]\nG1 X1\nM2\n") == Places{"SC2007 2:1"});
}

TEST_CASE("a dwell that lasts for ever is reported", "[ipr][reach]") {
  CHECK(reported_of_reach("G4 P[10**308]\nM2\n") == Places{"SC2007 1:4"});
  CHECK(reported_of_reach("F1 G82 X1 Z-1 R1 P[10**300]\nX2\nM2\n") == Places{"SC2007 1:18"});
}

TEST_CASE("what is too far, in words", "[ipr][reach]") {
  const auto text = [](const std::string& program) {
    const Interpreted result = interpret(program);
    return result.diagnostics.empty() ? std::string() : result.diagnostics.front().message;
  };
  CHECK(text("G0 X2000000\nM2\n") == "X leads to a place beyond 1000000 mm");
  CHECK(text("G92 X2000000\nM2\n") == "X gives an offset beyond 1000000 mm");
  CHECK(text("F1 G2 X1 R[10**10]\nM2\n") == "R is beyond 1000000000 mm");
  CHECK(text("G10 L2 P1 R36001\nM2\n") == "R turns the work system by more than 36000 degrees");
  CHECK(text("#5221=1000001\nM2\n") == "#5221 takes from -1000000 to 1000000");
  CHECK(text("F[10**-9]\nM2\n") == "a feed below 0.000001 mm/min");
  CHECK(text("G4 P[10**10]\nM2\n") == "P, the time of G04, must be 1000000000 s at most");
  CHECK(text("F1 G82 X1 Z-1 R1 P[10**10]\nM2\n") ==
        "P, the time at the bottom, must be 1000000000 s at most");
  CHECK(text("G64 P1000001\nM2\n") == "P, a tolerance of G64, must be 1000000 mm at most");
  CHECK(text("G6.4 D1000001 J1 H1 L2\nM2\n") == "D, the tool radius, must be 1000000 mm at most");
  CHECK(text("F1 G81 X1 Z-1 R1 L99999\nM2\n") ==
        "G81 on this line would take more than 10000 holes");
}

}  // namespace softcnc::ipr
