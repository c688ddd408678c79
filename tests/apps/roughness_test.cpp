// SPDX-License-Identifier: MIT
// The roughness asked for, from outside: what check says of it, and what the report and trace show.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;
using json = nlohmann::json;

namespace {

/// Over the top of a cylinder, from 25 degrees up to 25 degrees down.
std::string cylinder(const std::string& words) {
  return "S6000 M03\nG00 X-21.1309 Z45.3154\nG18\n" + words +
         "G03 X21.1309 I21.1309 K-45.3154 F6000\nM30\n";
}
const std::string kWords = "G06.4 D5 J0.5 H10.67 L2\n";

json report_of(const std::string& program, const std::string& options) {
  const Folder folder;
  const std::string file = folder / "report.json";
  const Ended ended =
      call("run -q --backend none --report " + file + " " + options + " -", program);
  REQUIRE(ended.status == 0);
  std::ifstream stream(file);
  return json::parse(stream);
}

}  // namespace

TEST_CASE("check notes the roughness of every block that asks for one", "[apps][roughness]") {
  const Ended ended = call("check -", cylinder(kWords));
  CHECK(ended.status == 0);
  CHECK(ended.out.find("<stdin>:5:1: note SC4010: an Rmax of 10.6") != std::string::npos);
  CHECK(ended.out.find("where 10.67 um are asked for") != std::string::npos);
  CHECK(ended.out.find("SC4011") == std::string::npos);
  CHECK(call("check -", cylinder("")).out.empty());
}

TEST_CASE("check warns where the formulas of the paper miss the target", "[apps][roughness]") {
  const Ended ended = call("check --set surface.model=paper -", cylinder(kWords));
  CHECK(ended.status == 0);
  CHECK(ended.out.find("<stdin>:5:1: warning SC4011: edges leave an Rmax of 1") !=
        std::string::npos);
}

TEST_CASE("check warns of passes that are not in phase", "[apps][roughness]") {
  const std::string head = "S6000 M03 F6000\n" + kWords;
  const std::string to_and_fro = head + "G01 X20\nY0.5\nX0\nY1\nX20\nM30\n";
  const std::string round = head + "G01 X20\nG03 Y0.5 J0.25\nG01 X0\nM30\n";
  const std::string one_way =
      head + "G01 X20\nG00 Z5\nX0 Y0.5\nZ0\nG01 X20\nG00 Z5\nX0 Y1\nZ0\nG01 X20\nM30\n";
  const std::string contour = head + "G01 X20\nY20\nX0\nY0\nX0.5 Y0.5\nX19.5\nY19.5\nM30\n";
  const std::string warning = "warning SC4012: ";
  CHECK(call("check -", to_and_fro).out.find("<stdin>:5:1: " + warning) != std::string::npos);
  CHECK(call("check -", round).out.find(warning) != std::string::npos);
  CHECK(call("check -", one_way).out.find(warning) == std::string::npos);
  CHECK(call("check -", contour).out.find(warning) == std::string::npos);
  CHECK(call("check -", cylinder(kWords)).out.find(warning) == std::string::npos);
  CHECK(call("check --set surface.phase=time -", cylinder(kWords))
            .out.find("<stdin>:5:1: " + warning + "the spindle begins passes at any phase") !=
        std::string::npos);
}

TEST_CASE("of many blocks check notes a hundred and the roughest of the others",
          "[apps][roughness]") {
  std::string program = "S6000 M03 F6000\n" + kWords;
  for (int i = 1; i <= 150; ++i) program += "G01 X" + std::to_string(i % 2 * 5) + "\n";
  const Ended ended = call("check -", program + "M30\n");
  CHECK(ended.status == 0);
  std::size_t notes = 0;
  for (std::size_t at = 0; (at = ended.out.find("SC4010", at)) != std::string::npos; ++at) ++notes;
  CHECK(notes == 101);
  CHECK(ended.out.find("and 50 blocks more, with at most an Rmax of ") != std::string::npos);
}

TEST_CASE("the report says how near the roughness comes to its target, and what it costs",
          "[apps][roughness]") {
  for (const char* model : {"--set surface.model=paper", "--set surface.model=guaranteed"}) {
    CAPTURE(model);
    const json report = report_of(cylinder(kWords), model);
    CHECK(report["rmax_um_max"].get<double>() <= 10.67 * (1 + 1e-6));
    CHECK(report["rmax_um_max"].get<double>() > 10.67 * 0.98);
    CHECK(report["rmax_target_um"] == 10.67);
    CHECK(report["time_by_limit_s"]["roughness"].get<double>() > 0.03);
  }
  const json plain = report_of(cylinder(""), "");
  CHECK_FALSE(plain.contains("rmax_um_max"));
  CHECK_FALSE(plain["time_by_limit_s"].contains("roughness"));
}

TEST_CASE("the part of paper 004 takes about two per cent longer at its variable feed",
          "[apps][roughness]") {
  const auto time = [](const std::string& name) {
    const Ended ended =
        shell("$softcnc check -v --machine $programs/" + name + ".toml $programs/" + name + ".nc");
    CHECK(ended.status == 0);
    const Folder folder;
    const std::string file = folder / "report.json";
    shell("$softcnc run -q --backend none --report " + file + " --machine $programs/" + name +
          ".toml $programs/" + name + ".nc");
    std::ifstream stream(file);
    return json::parse(stream)["time_s"].get<double>();
  };
  const double fixed = time("22_paper004_part_fixed");
  const double variable = time("23_paper004_part_variable");
  CHECK(variable / fixed > 1.01);
  CHECK(variable / fixed < 1.03);  // the paper: 38m10s against 37m23s, 2.1 %
}
