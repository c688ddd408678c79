// SPDX-License-Identifier: MIT
// blocks: one JSON object per line, numbers as short as they can be.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

TEST_CASE("blocks shows each kind of block as the contract spells it", "[apps][blocks]") {
  const Ended ended = call("blocks -",
                           "T2 M06\nS1000 M04\nM08\nG00 X10 Y-0\nG01 X20.5 F600\n"
                           "G02 X20.5 Y0 I-5 J0\nG18 G03 X10.5 Z0 I-5 K0\nG04 P0.25\nM00\nM02\n");
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(ended.out ==
        "{\"line\":1,\"block\":1,\"kind\":\"tool\",\"code\":6,\"tool\":2}\n"
        "{\"line\":2,\"block\":2,\"kind\":\"spindle\",\"code\":4,\"rpm\":-1000}\n"
        "{\"line\":3,\"block\":3,\"kind\":\"coolant\",\"code\":8}\n"
        "{\"line\":4,\"block\":4,\"kind\":\"rapid\",\"from\":[0,0,0],\"to\":[10,0,0]}\n"
        "{\"line\":5,\"block\":5,\"kind\":\"feed\",\"from\":[10,0,0],\"to\":[20.5,0,0],"
        "\"feed_mm_s\":10}\n"
        "{\"line\":6,\"block\":6,\"kind\":\"arc\",\"from\":[20.5,0,0],\"to\":[20.5,0,0],"
        "\"feed_mm_s\":10,\"plane\":\"XY\",\"center\":[15.5,0,0],\"ccw\":false,\"turns\":0,"
        "\"radius\":5}\n"
        "{\"line\":7,\"block\":7,\"kind\":\"arc\",\"from\":[20.5,0,0],\"to\":[10.5,0,0],"
        "\"feed_mm_s\":10,\"plane\":\"ZX\",\"center\":[15.5,0,0],\"ccw\":true,\"turns\":0,"
        "\"radius\":5}\n"
        "{\"line\":8,\"block\":8,\"kind\":\"dwell\",\"duration_s\":0.25}\n"
        "{\"line\":9,\"block\":9,\"kind\":\"stop\"}\n"
        "{\"line\":10,\"block\":10,\"kind\":\"end\",\"code\":2}\n");
}

TEST_CASE("blocks shows a NURBS with all that makes it", "[apps][blocks]") {
  const Ended ended =
      call("blocks -", "G90 G06.2 P3 K0 X0 Y0 F60\nK0 X1 Y1 R2\nK0 X2 Y0\nK1\nK1\nK1\nM30\n");
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  std::istringstream lines(ended.out);
  std::string line;
  std::getline(lines, line);
  CHECK(json::parse(line) == json::parse(R"({"line":1,"block":1,"kind":"nurbs","from":[0,0,0],
    "to":[2,0,0],"feed_mm_s":1,"degree":2,"control":[[0,0,0],[1,1,0],[2,0,0]],"weights":[1,2,1],
    "knots":[0,0,0,1,1,1]})"));
}

TEST_CASE("blocks shows the roughness asked for", "[apps][blocks]") {
  const Ended good =
      call("blocks -", "S6000 M03\nF60 G06.4 D5 J.5 H10.7 L2\nG01 X1\nG06.1 X2 Y1\nX3 Y0\nM30\n");
  REQUIRE(good.status == 0);
  CHECK(good.err.empty());
  std::istringstream lines(good.out);
  for (std::string line; std::getline(lines, line);) {
    const json block = json::parse(line);
    if (block["kind"] == "end" || block["kind"] == "spindle") continue;
    CHECK(block["surface"] ==
          json::parse(R"({"tool_radius_mm":5,"pick_feed_mm":0.5,"rmax_um":10.7,"teeth":2})"));
  }
}

TEST_CASE("blocks shows by what radius a surface bends across the feed", "[apps][blocks]") {
  const Ended good = call("blocks -", "S6000 M03\nF60 G06.4 D5 J.5 H10.7 L2 R-20\nG01 X1\nM30\n");
  REQUIRE(good.status == 0);
  CHECK(good.out.find("\"teeth\":2,\"radius_across_mm\":-20}") != std::string::npos);
}

TEST_CASE("blocks shows how much a surface slopes across the feed", "[apps][blocks]") {
  const Ended good = call("blocks -", "S6000 M03\nF60 G06.4 D5 J.5 H10.7 L2 Q20\nG01 X1\nM30\n");
  REQUIRE(good.status == 0);
  CHECK(good.out.find("\"teeth\":2,\"slope_across_deg\":20}") != std::string::npos);
}

TEST_CASE("blocks shows what it has while its input pipe is open", "[apps][blocks]") {
  const Folder folder;
  const std::string out = folder / "out";
  const Ended ended = shell(
      "{ printf 'G00 X1\nX2\nX3\n'; for i in $(seq 100); do sleep 0.05; "
      "[ $(wc -l <" +
      out + ") -ge 2 ] && break; done; wc -l <" + out +
      " >&2; echo M30; } | $softcnc blocks -q - >" + out);
  CHECK(std::stoi(ended.err) >= 2);
  CHECK(read(out).find("\"kind\":\"end\"") != std::string::npos);
}

TEST_CASE("a block of a called file names its file", "[apps][blocks]") {
  const Folder folder;
  write(folder / "part.nc", "G0 X1\nM98 P7\nG0 X3\nM30\n");
  write(folder / "O0007.nc", "O7\nG0 X2\nM99\n");
  const std::string called = "\"file\":\"" + (folder / "O0007.nc") + "\",";
  CHECK(call("blocks " + (folder / "part.nc")).out ==
        "{\"line\":1,\"block\":1,\"kind\":\"rapid\",\"from\":[0,0,0],\"to\":[1,0,0]}\n"
        "{\"line\":2," +
            called +
            "\"block\":2,\"kind\":\"rapid\",\"from\":[1,0,0],\"to\":[2,0,0]}\n"
            "{\"line\":3,\"block\":3,\"kind\":\"rapid\",\"from\":[2,0,0],\"to\":[3,0,0]}\n"
            "{\"line\":4,\"block\":4,\"kind\":\"end\",\"code\":30}\n");
}

TEST_CASE("blocks reports errors on stderr and goes on", "[apps][blocks]") {
  const Ended ended = call("blocks $data/two_errors.nc");
  CHECK(ended.status == 1);
  CHECK(shows(ended.err, ":5:5: error: ... [SC2001]"));
  CHECK(ended.out.find("\"line\":2,") != std::string::npos);
  CHECK(ended.out.find("\"kind\":\"end\"") != std::string::npos);
  CHECK(ended.out.find("\"line\":3,") == std::string::npos);
}

TEST_CASE("the rows of a trace name lines and blocks as blocks does", "[apps][blocks]") {
  std::vector<int> line_of{0};
  std::istringstream lines(call("blocks $data/square.nc").out);
  for (std::string line; std::getline(lines, line);) line_of.push_back(json::parse(line)["line"]);
  const Trace trace = parse_trace(call("run -q --dry-run $data/square.nc").out);
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    if (std::stoi(trace.word(i, "line")) !=
        line_of.at(static_cast<std::size_t>(std::stoi(trace.word(i, "block")))))
      FAIL_CHECK("row " << i);
  CHECK(std::stoul(trace.word(trace.rows.size() - 1, "block")) == line_of.size() - 1);
}
