// SPDX-License-Identifier: MIT
// The programs that probe, by hand: where their machine files put what is probed.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using app::test::call;
using app::test::Ended;
using nlohmann::json;

namespace {

/// The end of the last move, as softcnc blocks writes it.
std::vector<double> last_end(const std::string& program) {
  const Ended ended = call("blocks " SOFTCNC_SOURCE_DIR "/programs/" + program + ".nc");
  CHECK(ended.status == 0);
  std::istringstream lines(ended.out);
  std::vector<double> end;
  for (std::string line; std::getline(lines, line);) {
    const json block = json::parse(line);
    if (block.contains("to")) end = block["to"].get<std::vector<double>>();
  }
  return end;
}

void check_near(const std::vector<double>& end, double x, double y, double z) {
  REQUIRE(end.size() == 3);
  CHECK(end[0] == Approx(x).margin(1e-8));
  CHECK(end[1] == Approx(y).margin(1e-8));
  CHECK(end[2] == Approx(z).margin(1e-8));
}

}  // namespace

TEST_CASE("a probed corner becomes the origin", "[apps][probing]") {
  check_near(last_end("28_probe_corner"), 120.5, 80.25, 10 - 40.125);
}

TEST_CASE("the middle of a probed pocket is its centre", "[apps][probing]") {
  check_near(last_end("29_probe_pocket"), 80.75, 43.5, 10);
}

TEST_CASE("tools that a setter has measured reach the height that is programmed",
          "[apps][probing]") {
  check_near(last_end("30_tool_length"), 0, 0, -100 + 81.9);
}

TEST_CASE("the table of tools keeps what a setter has measured", "[apps][probing]") {
  const app::test::Folder folder;
  const Ended ended = call("run -q " SOFTCNC_SOURCE_DIR "/programs/30_tool_length.nc --state " +
                           (folder / "s.toml"));
  CHECK(ended.status == 0);
  const std::string state = app::test::read(folder / "s.toml");
  CHECK(shows(state, "z_mm = 62.3"));
  CHECK(shows(state, "z_mm = 81."));
}

TEST_CASE("a run finds the errors of probing before anything moves", "[apps][probing][code]") {
  const app::test::Folder folder;
  app::test::write(folder / "p.nc", "G01 X5 F1000\nG38.2 Z-10 F100\nM2\n");
  const std::string body =
      " --set contact.a.min_mm=[20,20,-20] --set contact.a.max_mm=[30,30,-5] --trace ";
  const Ended missed = call("run " + (folder / "p.nc") + body + (folder / "t.csv"));
  CHECK(missed.status == 1);
  CHECK(shows(missed.err, "p.nc:2:1: error: G38.2 comes to its end without a contact [SC2394]"));
  CHECK(folder.files() == std::vector<std::string>{"p.nc"});
  const Ended wrong = call("check " + (folder / "p.nc") +
                           " --set contact.a.min_mm=[0,0,0] --set contact.a.max_mm=[1,1,-1]");
  CHECK(wrong.status == 2);
  CHECK(shows(wrong.out + wrong.err,
              "error: contact.a.max_mm must lie above contact.a.min_mm on every axis "
              "[SC7027]"));
}
