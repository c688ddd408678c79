// SPDX-License-Identifier: MIT
// The roughness asked for, from outside: what check says of it, and what the report and trace show.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

/// Over the top of a cylinder, from 25 degrees up to 25 degrees down.
std::string cylinder(const std::string& words) {
  return "S6000 M03\nG00 X-21.1309 Z45.3154\nG18\n" + words +
         "G03 X21.1309 I21.1309 K-45.3154 F6000\nM30\n";
}
const std::string kWords = "G06.4 D5 J0.5 H10.67 L2\n";

/// The same at another Y, after it.
std::string cylinder_pass(const std::string& y) {
  return "G03 X21.1309 I21.1309 K-45.3154 F6000\nG00 Z60\nX-21.1309 Y" + y + "\nZ45.3154\n";
}

/// Passes along X, each as far from X0 as stated.
std::string one_way(const std::vector<double>& begins) {
  std::string program;
  for (std::size_t i = 0; i < begins.size(); ++i)
    program +=
        fmt::format("G00 Z5\nX{} Y{}\nZ0\nG01 X20\n", begins[i], 0.5 * static_cast<double>(i));
  return program + "M30\n";
}

/// A plane that rises by 8 degrees along X and 20 along Y, one way, each pass begun alike.
std::string tilted(const std::string& words) {
  std::string program = "S600 M03 F6000\nG06.4 D5 J0.5 H10.67 L2 " + words + "\n";
  for (int i = 0; i < 9; ++i) {
    const double y = 0.5 * i, z = y * std::tan(20 * std::acos(-1) / 180);
    program += fmt::format("G00 Z30\nX0 Y{0}\nZ{1:.6f}\nG01 X8 Z{2:.6f}\n", y, z,
                           z + 8 * std::tan(8 * std::acos(-1) / 180));
  }
  return program + "G00 Z30\nM30\n";
}

bool warns_of_phase(const std::string& program, const std::string& text,
                    const std::string& options = {}) {
  const Ended ended = call("check " + options + " -", program);
  UNSCOPED_INFO(ended.out);
  return ended.status == 0 && shows(ended.out, text);
}

json report_of_program(const std::string& program, const std::string& options) {
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
  CHECK(shows(ended.out, "<stdin>:5:1: note: an Rmax of 10.6... [SC4010]"));
  CHECK(ended.out.find("(target 10.67 um)") != std::string::npos);
  CHECK(ended.out.find("SC4011") == std::string::npos);
  CHECK(call("check -", cylinder("")).out.empty());
}

TEST_CASE("check warns where the formulas of the paper miss the target", "[apps][roughness]") {
  const Ended ended = call("check --set surface.model=paper -", cylinder(kWords));
  CHECK(ended.status == 0);
  CHECK(shows(ended.out,
              "<stdin>:5:1: warning: cutting edges may leave an Rmax of up to 1... [SC4011]"));
}

TEST_CASE("check warns of passes that are not in phase", "[apps][roughness]") {
  const std::string head = "S6000 M03 F6000\n" + kWords;
  const std::string to_and_fro = head + "G01 X20\nY0.5\nX0\nY1\nX20\nM30\n";
  const std::string round = head + "G01 X20\nG03 Y0.5 J0.25\nG01 X0\nM30\n";
  const std::string staggered = head + one_way({0, 0.13, 0.31, 0.07});
  const std::string contour = head + "G01 X20\nY20\nX0\nY0\nX0.5 Y0.5\nX19.5\nY19.5\nM30\n";
  CHECK(warns_of_phase(to_and_fro, "<stdin>:5:1: warning: passes run back and forth... [SC4012]"));
  CHECK(warns_of_phase(round, "<stdin>:5:1: warning: passes run back and forth... [SC4012]"));
  CHECK(warns_of_phase(
      staggered,
      "<stdin>:10:1: warning: this pass is out of phase with the one beside it... [SC4012]"));
  CHECK(warns_of_phase(
      contour,
      "<stdin>:8:1: warning: this pass is out of phase with the one beside it... [SC4012]"));
  const std::string twice = cylinder(kWords + cylinder_pass("0.5"));
  CHECK(warns_of_phase(twice,
                       "<stdin>:9:1: warning: the spindle begins passes at any phase... [SC4012]",
                       "--set surface.phase=time"));
}

TEST_CASE("check does not warn where passes are in phase, in the air or alone",
          "[apps][roughness]") {
  const std::string head = "S6000 M03 F6000\n" + kWords;
  const std::string returns =
      "G01 X20\nZ5\nX0 Y0\nZ0\nX20\nZ5\nX0 Y0.5\nZ0\nX20\nZ5\nX0 Y1\nZ0\nX20\nM30\n";
  for (const std::string& program :
       {head + one_way({0, 0, 0}), head + returns, head + "G01 X20\nX0\nM30\n",
        head + "G01 X20\nG03 Y4 J2\nG01 X0\nM30\n", cylinder(kWords)}) {
    CAPTURE(program);
    CHECK(call("check -", program).out.find("SC4012") == std::string::npos);
  }
  CHECK(call("check --set surface.phase=time -", cylinder(kWords)).out.find("SC4012") ==
        std::string::npos);
}

TEST_CASE("where Q stands for any phase check does not warn of it", "[apps][roughness]") {
  const std::string program =
      "S6000 M03 F6000\nG06.4 D5 J0.5 H10.67 L2 Q1\nG01 X20\nY0.5\nX0\nY1\nX20\nM30\n";
  CHECK(call("check -", program).out.find("SC4012") == std::string::npos);
  CHECK(warns_of_phase(program, "<stdin>:5:1: warning: passes run back and forth... [SC4012]",
                       "--set surface.model=paper"));
}

TEST_CASE("a plunge leaves no surface", "[apps][roughness]") {
  const Ended ended = call("check --set surface.phase=time -",
                           "S6000 M03 F6000 G61\n" + kWords + "G01 Z-5\nX5\nM30\n");
  CHECK(ended.out.find("<stdin>:3:1") == std::string::npos);
  CHECK(shows(ended.out, "<stdin>:4:1: note: ... [SC4010]"));
  CHECK(ended.out.find("SC4012") == std::string::npos);
}

TEST_CASE("check warns of slopes across the feed that are not stated, and says which Q to write",
          "[apps][roughness]") {
  const Ended without = call("check -", tilted(""));
  CHECK(without.status == 0);
  CHECK(shows(without.out,
              "<stdin>:26:1: warning: the surface slopes by 20.0 degrees across the feed, "
              "which is not stated: cutting edges may leave an Rmax of up to 1... [SC4042]"));
  CHECK(without.out.find("; Q20 in G06.4 covers all of its slopes") != std::string::npos);
  CHECK(call("check -", tilted("Q20")).out.find("SC4042") == std::string::npos);
  CHECK(call("check -", tilted("Q10")).out.find("SC4042") != std::string::npos);
  CHECK(call("check -", "S6000 M03 F6000\n" + kWords + one_way({0, 0, 0})).out.find("SC4042") ==
        std::string::npos);
}

TEST_CASE("with the Q that check names the surface meets its target", "[apps][roughness]") {
  const Folder folder;
  const std::string stock =
      " --set 'stock.origin_mm=[3, 3.2, -3]' --set stock.x_mm=1 --set stock.y_mm=0.5 --set "
      "stock.z_mm=9 --set stock.grid_um=5 ";
  const std::string call_surface = "surface -q -" + stock + "-o " + (folder / "tilted.npz");
  CHECK(call(call_surface, tilted("")).err.find("SC4040") != std::string::npos);
  const Ended stated = call(call_surface + " --report " + (folder / "report.json"), tilted("Q20"));
  CHECK(stated.err.empty());
  std::ifstream stream(folder / "report.json");
  const json report = json::parse(stream);
  CHECK(report["regions_judged"].get<int>() > 0);
  CHECK(report["regions_missed"] == 0);
  CHECK(report["rmax_um_max"].get<double>() > 0.7 * 10.67);
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
    const json report = report_of_program(cylinder(kWords), model);
    CHECK(report["rmax_um_max"].get<double>() <= 10.67 * (1 + 1e-6));
    CHECK(report["rmax_um_max"].get<double>() > 10.67 * 0.98);
    CHECK(report["rmax_target_um"] == 10.67);
    CHECK(report["time_by_limit_s"]["roughness"].get<double>() > 0.03);
  }
  const json plain = report_of_program(cylinder(""), "");
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
