// SPDX-License-Identifier: MIT
// softcnc pulses: lists of edges judged, own ones and those of others.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;

namespace {

/// The built-in drivers ask for 10 us between steps, 2.5 us high and low, 5 us set-up and hold.
const std::string kHead =
    "$timescale 1 us $end\n$var wire 1 s x_step $end\n$var wire 1 d x_direction $end\n"
    "$var wire 1 z z_step $end\n$enddefinitions $end\n";

Ended judged(const std::string& changes) { return call("pulses -", kHead + changes); }

std::string told(const std::string& changes) {
  const Ended ended = judged(changes);
  CHECK(ended.status == 3);
  return ended.err;
}

}  // namespace

TEST_CASE("pulses counts and measures what keeps the rules", "[apps][pulse]") {
  const Folder folder;
  const Ended ended = call("pulses - --report " + (folder / "r.json"),
                           kHead + "#10 1s #13 0s #20 1s 1z #26 0s #27 0z\n#31 1d #36 1s #39 0s\n");
  CHECK(ended.err == "report written to " + (folder / "r.json") + "\n");
  CHECK(ended.status == 0);
  CHECK(
      ended.out ==
      "<stdin>: 9 edges, 4 steps in 3.9e-05 s; no rule is broken. Shortest times in ns:\n\n"
      "  axis         steps      counts   interval     length      space     set-up       hold   "
      "broken\n"
      "  x                3           1      10000       3000       7000       5000       5000   "
      "     0\n"
      "  z                1           1          -       7000          -          -          -   "
      "     0\n"
      "  required                            10000       2500       2500       5000       5000\n");
  const auto report = nlohmann::json::parse(read(folder / "r.json"));
  CHECK(report["edges"] == 9);
  CHECK(report["steps"] == 4);
  CHECK(report["broken"] == 0);
  CHECK(report["asked"]["hold_ns"] == 5000);
  CHECK(report["axes"]["x"]["interval_ns"] == 10000);
  CHECK(report["axes"]["x"]["counts"] == 1);
  CHECK(report["axes"]["z"]["interval_ns"].is_null());
  CHECK(report["axes"]["y"]["steps"] == 0);
}

TEST_CASE("pulses finds a broken rule of each kind", "[apps][pulse][code]") {
  CHECK(told("#10 1s #12 0s\n") ==
        "<stdin>:6:12: error: x at 12000 ns: step length 2000 ns, at least 2500 ns is "
        "required [SC4090]\n"
        "    6 | #10 1s #12 0s\n"
        "      |            ^~\n");
  CHECK(begins_showing(
      told("#10 1s #18 0s\n#20 1s #23 0s\n"),
      "<stdin>:7:5: error: x at 20000 ns: step space 2000 ns, at least 2500 ns ... [SC4090]"));
  CHECK(begins_showing(told("#10 1s #13 0s\n#19 1s #23 0s\n"),
                       "<stdin>:7:5: error: x at 19000 ns: step interval 9000 ns, at "
                       "least 10000 ns ... [SC4090]"));
  CHECK(begins_showing(told("#10 1d #14 1s #17 0s\n"),
                       "<stdin>:6:12: error: x at 14000 ns: direction set-up 4000 ns, at "
                       "least 5000 ns ... [SC4090]"));
  CHECK(begins_showing(told("#10 1s #13 0s #17 1d\n"),
                       "<stdin>:6:19: error: x at 17000 ns: direction hold 4000 ns, at "
                       "least 5000 ns ... [SC4090]"));
  CHECK(told("#10 1z 1s #12 1d #13 0s 0z\n")
            .starts_with("<stdin>:6:15: error: x at 12000 ns: the direction changes during a step "
                         "[SC4090]\n"));
  CHECK(told("#10 1z #13 0z 0z\n")
            .starts_with("<stdin>:6:15: error: z at 13000 ns: the line is low already [SC4090]\n"));
  CHECK(told("#10 1z #13 0z #9 1d\n")
            .starts_with("<stdin>:6:18: error: x at 9000 ns: comes before the previous edge, "
                         "at 13000 ns [SC4090]\n"));
  CHECK(told("#10 1s\n") ==
        "<stdin>: error: x at 10000 ns: the step that begins here has no end [SC4090]\n");
}

TEST_CASE("pulses reports every broken rule, in order, and how many there are", "[apps][pulse]") {
  const Ended ended = judged("#10 1s #12 0s #13 1s #15 0s\n");
  CHECK(ended.status == 3);
  CHECK(
      ended.out.starts_with("<stdin>: 4 edges, 2 steps in 1.5e-05 s; rules are broken 4 times. "));
  std::size_t at = 0;
  for (const char* text : {"12000 ns: step length", "13000 ns: step space",
                           "13000 ns: step interval", "15000 ns: step length"}) {
    at = ended.err.find(text, at);
    CHECK(at != std::string::npos);
  }
  const auto document =
      nlohmann::json::parse(call("pulses --diagnostics json -", kHead + "#10 1s #12 0s\n").err);
  REQUIRE(document.size() == 1);
  CHECK(document[0]["code"] == "SC4090");
  CHECK(document[0]["line"] == 6);
  CHECK(document[0]["column"] == 12);
}

TEST_CASE("the machine says what its drivers ask for", "[apps][pulse]") {
  const std::string list = kHead + "#10 1s #13 0s\n#19 1s #23 0s\n";
  CHECK(call("pulses - --set backend.stepdir.max_rate_hz=111111", list).status == 3);
  CHECK(call("pulses - --set backend.stepdir.max_rate_hz=111112", list).status == 0);
  CHECK(call("pulses - --set backend.stepdir.step_length_ns=3001", list).status == 3);
  CHECK(call("pulses - --backend parport --set backend.parport.base_period_us=3 --set "
             "axis.x.velocity_mm_min=12500 --set axis.y.velocity_mm_min=12500 --set "
             "axis.z.velocity_mm_min=12500",
             list)
            .err.starts_with("<stdin>:7:5: error: x at 19000 ns: step interval 9000 ns, at "
                             "least 12000 ns is required [SC4090]\n"));
  CHECK(call("pulses - --machine /no/such.toml", list).status == 2);
  CHECK(call("pulses - --set backend.stepdir.max_rate=1", list).status == 2);
}

TEST_CASE("what a run has written passes, in every form", "[apps][pulse]") {
  const Folder folder;
  const std::string part = "G17 G02 X10 Y-10 I0 J-10 F3000\nG01 X0 Y0\nM30\n";
  for (const char* name : {"p.vcd", "p.edges"})
    CHECK(call("run -q - --backend stepdir --set backend.stepdir.file=" + (folder / name), part)
              .status == 0);
  CHECK(call("run -q - --backend stepdir --set 'backend.stepdir.file=\"\"' --trace " +
                 (folder / "t.vcd.zst"),
             part)
            .status == 0);
  std::string figures;
  for (const char* name : {"p.vcd", "p.edges", "t.vcd.zst"}) {
    CAPTURE(name);
    const Ended ended = call("pulses " + (folder / name));
    CHECK(ended.err.empty());
    REQUIRE(ended.status == 0);
    const std::string rest = ended.out.substr(ended.out.find(": "));
    CHECK(rest.find(" steps in ") != std::string::npos);
    if (!figures.empty()) CHECK(rest == figures);
    figures = rest;
  }
}

TEST_CASE("a list of edges that cannot be read or is not whole is refused", "[apps][pulse][code]") {
  const Folder folder;
  const auto refused = [&](const std::string& bytes) {
    write(folder / "f", bytes);
    const Ended ended = call("pulses " + (folder / "f"));
    CHECK(ended.status == 5);
    CHECK(ended.out.empty());
    const std::string name = folder / "f";
    REQUIRE(ended.err.starts_with(name));
    return ended.err.substr(name.size());
  };
  CHECK(refused("") == ": error: empty [SC6091]\n");
  CHECK(refused("PK\3\4not a list of edges")
            .starts_with(": error: neither a Value Change Dump nor a list that begins with "
                         "'edges 1' [SC6091]\n"));
  CHECK(begins_showing(refused("edges 7\n"),
                       ": error: a list of edges, but not of form 1... [SC6091]"));
  CHECK(refused(std::string("edges 1\n\x05\x01\x85", 11)) ==
        ": error: not whole: it ends within an edge [SC6091]\n");
  CHECK(refused(kHead + "#10 1s #2") ==
        ":6:8: error: not whole: it ends within a line [SC6091]\n"
        "    6 | #10 1s #2\n"
        "      |        ^~\n");
  CHECK(shows(refused(kHead.substr(0, 60)), " error: not whole: it ends within ... [SC6091]"));
  const Ended missing = call("pulses " + (folder / "none"));
  CHECK(missing.status == 5);
  CHECK(missing.err ==
        (folder / "none") + ": error: cannot be read: No such file or directory [SC6090]\n");
  CHECK(call("pulses").status == 2);
  CHECK(call("pulses a b").status == 2);
  CHECK(call("pulses " + (folder / "f") + " --report " + (folder / "f")).status == 2);
}
