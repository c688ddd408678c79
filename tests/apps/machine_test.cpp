// SPDX-License-Identifier: MIT
// machine: each value with unit and origin, in columns.
#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;

TEST_CASE("machine shows each value with its unit and where it comes from", "[apps][machine]") {
  const Folder folder;
  write(folder / "mill.toml", "[axis.x]\nvelocity_mm_min = 6000\n[axis.y]\n");
  const Ended ended = shell("cd " + (folder / "") +
                            "; $softcnc machine --machine mill.toml --set "
                            "control.period_ms=2 --backend none");
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  const auto words_of = [&](const std::string& key) {
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(key + ' ')) continue;
      std::istringstream words(line);
      std::string joined;
      for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
      return joined;
    }
    return std::string();
  };
  CHECK(words_of("axis.x.velocity_mm_min") == "axis.x.velocity_mm_min = 6000 # mm/min mill.toml:2");
  CHECK(words_of("axis.y.velocity_mm_min") == "axis.y.velocity_mm_min = 15000 # mm/min default");
  CHECK(words_of("control.period_ms") == "control.period_ms = 2 # ms --set");
  CHECK(words_of("control.backend") == "control.backend = \"none\" # --set");
  CHECK(words_of("axis.z.velocity_mm_min").empty());
}

TEST_CASE("the values of machine stand below each other", "[apps][machine]") {
  std::istringstream lines(call("machine").out);
  std::size_t column = 0;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    if (column == 0) column = line.find(" = ");
    CHECK(line.find(" = ") == column);
    CHECK(line.back() != ' ');
  }
  CHECK(count > 50);
}

TEST_CASE("every command reports all that is wrong with its machine", "[apps][machine]") {
  const Folder folder;
  const std::string mill = folder / "mill.toml", recording = folder / "part.rec";
  REQUIRE(call("record -q $data/square.nc -o " + recording).status == 0);
  write(mill, "[control]\nperiod_ms = -1\n[axsi.x]\nblu_um = 1\n[spindle]\nmax_rpm = 'fast'\n");
  const std::vector<std::string> commands{"machine",
                                          "check $data/square.nc",
                                          "blocks $data/square.nc",
                                          "run $data/square.nc",
                                          "record $data/square.nc -o " + (folder / "x.rec"),
                                          "replay " + recording,
                                          "latency"};
  for (const std::string& command : commands) {
    const Ended ended = shell("$softcnc " + command + " --machine " + mill + " 2>&1");
    CAPTURE(command, ended.out);
    CHECK(ended.status == 2);
    std::istringstream lines(ended.out);
    std::vector<std::string> places;
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(mill)) places.push_back(line.substr(mill.size()));
    REQUIRE(places.size() == 3);
    CHECK(begins_showing(places[0], ":2:13: error: ... [SC7005]"));
    CHECK(begins_showing(places[1], ":3:2: error: ... [SC7001]"));
    CHECK(begins_showing(places[2], ":6:11: error: ... [SC7004]"));
  }
}
