// SPDX-License-Identifier: MIT
// check: every diagnostic of every file on stdout, and nothing else.
#include <catch2/catch.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

TEST_CASE("check of good programs says nothing", "[apps][check]") {
  const Ended ended = call("check $data/square.nc $data/zigzag.nc");
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err.empty());
}

TEST_CASE("check tells everything wrong with every file, on stdout", "[apps][check]") {
  const Ended ended = shell("cd $data; $softcnc check two_errors.nc square.nc beyond.nc none.nc");
  CHECK(ended.status == 5);  // the first that applies of 2, 5, 1, 3
  CHECK(ended.err.empty());
  for (const char* line :
       {"two_errors.nc:3:6: error SC1004: ", "two_errors.nc:5:5: error SC2001: ",
        "beyond.nc:4:2: error SC4001: X reaches 1010.5 mm",
        "beyond.nc:6:1: error SC4001: ", "none.nc: error SC6001: cannot be read: "}) {
    CAPTURE(line, ended.out);
    CHECK(ended.out.find(line) != std::string::npos);
  }
  CHECK(ended.out.find("square.nc") == std::string::npos);
  CHECK(shell("cd $data; $softcnc check two_errors.nc beyond.nc").status == 1);
  CHECK(shell("cd $data; $softcnc check beyond.nc").status == 3);
}

TEST_CASE("check goes on to look at the travel behind an error of the program", "[apps][check]") {
  const Ended ended = call("check -", "G01 F600 X10\nX20 Y\nX30\nX2000\nM30\n");
  CHECK(ended.status == 1);
  CHECK(ended.out.find("<stdin>:2:5: error SC1002: ") != std::string::npos);
  CHECK(ended.out.find("<stdin>:4:1: error SC4001: X reaches 2000 mm") != std::string::npos);
}

TEST_CASE("check tells a wrong machine file, exit status 2", "[apps][check]") {
  const Ended ended = call("check $data/square.nc --set axis.x.velocity=3");
  CHECK(ended.status == 2);
  CHECK(ended.out.find("error SC7001: ") != std::string::npos);
  CHECK(ended.err.empty());
}

TEST_CASE("many errors of the planner are told with their lines in time", "[apps][check]") {
  std::string part = "G90 G01 F600\n";
  for (int i = 0; i < 20000; ++i) part += "X" + std::to_string(2000 + i % 2) + "\n";
  const Ended ended = call("check -", part + "M30\n");
  CHECK(ended.status == 3);
  CHECK(ended.out.find("<stdin>:20001:1: error SC4001: X reaches 2001 mm") != std::string::npos);
  CHECK(ended.out.find("20001 | X2001\n") != std::string::npos);
}

TEST_CASE("a line with / and M01 count as they are switched", "[apps][check]") {
  const std::string part = "/ X1 G48\nM01\nM30\n";
  CHECK(call("check -", part).status == 1);
  CHECK(call("check --block-skip -", part).status == 0);
  CHECK(call("blocks --block-skip --optional-stop -", part).out ==
        "{\"line\":2,\"block\":1,\"kind\":\"stop\",\"code\":1}\n"
        "{\"line\":3,\"block\":2,\"kind\":\"end\",\"code\":30}\n");
}
