// SPDX-License-Identifier: MIT
// Programs that move for longer than a run may last.
#include "runtime/session/motion_limit.hpp"

#include <catch2/catch.hpp>

#include "apps/shell.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

Ended check_within(const std::string& text, const std::string& hours, const Folder& folder) {
  write(folder / "p.nc", text);
  return shell("cd " + (folder / "") + "; $softcnc check --set program.motion_limit_h=" + hours +
               " p.nc");
}

/// Seconds that a line along X to this place takes.
Block line(double x, double feed, bool rapid = false) {
  Move move{Line({0, 0, 0}, {x, 0, 0})};
  move.feed = feed;
  move.rapid = rapid;
  return {move, {3, 1, 2}, 1};
}

}  // namespace

TEST_CASE("the least time of a block is that at its feed", "[apps][limit]") {
  const Machine machine;
  CHECK(runtime::least_time(line(100, 20), machine, 1) == Approx(5));
  CHECK(runtime::least_time(line(100, 20), machine, 0.5) == Approx(10));
  CHECK(runtime::least_time(line(100, 0, true), machine, 0.5) ==
        Approx(100 / (250 * std::sqrt(3.0))));
  CHECK(runtime::least_time({Dwell{7}, {}, 1}, machine, 0.5) == 7);
  CHECK(runtime::least_time({Action{Action::Kind::stop}, {}, 1}, machine, 1) == 0);
}

TEST_CASE("a move of years is refused at once, at its line", "[apps][limit]") {
  const Folder folder;
  const Ended ended = check_within("G21 G90\nG01 X100 F0.000001\nX2000\nM30\n", "10000", folder);
  CHECK(ended.status == 3);
  CHECK(shows(ended.out,
              "p.nc:2:1: error: the program moves for more than 10000 h: 1.66667e+06 h up to the "
              "end of this line [SC4050]"));
  CHECK(shows(ended.out, "p.nc:3:1: error: X reaches 2000 mm... [SC4001]"));
  CHECK(ended.out.find("[SC4050]") == ended.out.rfind("[SC4050]"));
}

TEST_CASE("the line that passes the longest motion is refused", "[apps][limit]") {
  const Folder folder;
  const std::string lines = "G21 G90 F600\nG01 X10\nX20\nX30\nX40\nX50\nM30\n";  // 1 s each
  CHECK(check_within(lines, "0.001", folder)
            .out.find("p.nc:5:1: error: the program moves for more than "
                      "0.001 h: ") == 0);
  CHECK(check_within(lines, "0.0015", folder).status == 0);
  CHECK(check_within(lines, "0", folder).status == 0);
  CHECK(check_within("G04 P3\nG04 P2\nM30\n", "0.001", folder).out.find("p.nc:2:1: error: ") == 0);
  const std::string far = "G04 P30000000\nG04 P30000000\nM30\n";
  CHECK(shows(check_within(far, "10000", folder).out,
              "p.nc:2:1: error: the program moves ... [SC4050]"));
  CHECK(check_within(far, "0", folder).status == 0);
}

TEST_CASE("corners and ramps count for the longest motion", "[apps][limit]") {
  const Folder folder;
  std::string text = "G21 G90 G61.1 F6000\n";
  for (int i = 1; i <= 100; ++i) text += "G01 X" + std::to_string(0.1 * i) + "\n";  // 20 ms each
  const Ended ended = check_within(text + "M30\n", "0.0003", folder);
  CHECK(ended.status == 3);
  CHECK(ended.out.find("p.nc:5") == 0);  // 1.08 s
}

TEST_CASE("a dry run of a motion that is too long ends at rest before it", "[apps][limit]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90 F600\nG01 X10\nX20 F0.001\nM30\n");
  const Ended ended = call("run --dry-run -q --set program.motion_limit_h=1 " + (folder / "p.nc"));
  CHECK(ended.status == 3);
  const Trace trace = parse_trace(ended.out);
  const std::size_t last = trace.rows.size() - 1;
  CHECK(trace.number(last, "x_mm") == 10);
  CHECK(trace.number(last, "v_mm_s") == 0);
}
