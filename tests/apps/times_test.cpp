// SPDX-License-Identifier: MIT
// What the time of a program goes into: the feed in the trace, the lines that lose most, the time
// sheet, and what rests at corners cost.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "apps/run_report.hpp"
#include "apps/shell.hpp"

namespace softcnc::app::test {
namespace {

using nlohmann::json;

constexpr const char* kSetNoRounding = " --set control.corner_tolerance_um=0 ";

/// Turns of 6 mm radius in 60 chords each, which are tangent nowhere: joints of 6 degrees.
std::string trochoid(const std::string& head, int turns = 6) {
  std::string text = "G21 G90 G17 " + head + "\nG0 X6 Y0\nG1 F2000\n";
  constexpr int kChords = 60;
  for (int i = 1; i <= turns * kChords; ++i) {
    const double angle = 2 * M_PI * i / kChords;
    char line[64];
    std::snprintf(line, sizeof line, "X%.3f Y%.3f\n", 0.6 * i / kChords + 6 * std::cos(angle),
                  6 * std::sin(angle));
    text += line;
  }
  return text + "M2\n";
}

/// The seconds that a message names.
double seconds_in(const std::string& text) {
  static const std::regex seconds(R"(cost (about )?([0-9.]+) s)");
  std::smatch found;
  REQUIRE(std::regex_search(text, found, seconds));
  return std::stod(found[2]);
}

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++found;
  return found;
}

}  // namespace

TEST_CASE("the trace shows the feed that is programmed, with its override", "[apps][times]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\nG0 X5\nG1 X45 F1200\nG4 P0.1\nM49\nG1 X65\nM2\n");
  const Ended ended =
      call("run --dry-run -q --feed-override 80 --at 1.5:override=50 " + (folder / "p.nc"));
  REQUIRE(ended.status == 0);
  const Trace trace = parse_trace(ended.out);
  const auto column = std::find(trace.columns.begin(), trace.columns.end(), "feed_mm_s");
  REQUIRE(column != trace.columns.end());
  CHECK(*(column - 1) == "z_mm");
  CHECK(column + 1 == trace.columns.end());
  for (std::size_t row = 1; row + 1 < trace.rows.size(); ++row) {
    const double feed = trace.number(row, "feed_mm_s"), x = trace.number(row, "x_mm");
    INFO("row " << row << ", X" << x);
    if (x < 4.999) CHECK(feed == 0);  // a rapid
    if (x > 5.001 && x < 44.999) CHECK(feed == (row <= 1500 ? 16 : 10));
    if (x > 45.001) CHECK(feed == 20);  // M49
    if (trace.number(row, "line") == 4) CHECK(feed == 0);
  }
}

TEST_CASE("the lines that lose most time are named, all rounds of a loop together",
          "[apps][times]") {
  const Folder folder;
  // At 1000 mm/s2: a ramp up to v and down again loses v/a, here 20 ms; line 6 three times.
  write(folder / "p.nc",
        "G21 G90 F1200\nG0 X1\nG1 X21\nG4 P0.5\no1 repeat [3]\nG1 X31\nG4 P0.01\nG1 X21\no1 "
        "endrepeat\nG1 X21.1\nM2\n");
  const json report = report_of(folder / "p.nc");
  const json& lines = report["worst_lines"];
  REQUIRE(lines.size() == 4);
  CHECK(lines[0]["line"] == 6);
  CHECK(lines[0]["lost_s"].get<double>() == Approx(3 * 0.02).margin(0.004));
  CHECK(lines[1]["line"] == 8);
  CHECK(lines[2]["line"] == 10);  // 0.1 mm from rest to rest: 2 sqrt(l/a) instead of l/v
  CHECK(lines[2]["lost_s"].get<double>() == Approx(0.02 - 0.005).epsilon(1e-6));
  CHECK(lines[2]["limit"] == "corner");
  CHECK(lines[3]["line"] == 3);  // half of a line's, since the rapid is as fast as it
  CHECK(lines[3]["lost_s"].get<double>() == Approx(0.01).epsilon(1e-6));
  CHECK(lines[3]["limit"] == "acceleration");

  const Ended told = call("run --worst 2 " + (folder / "p.nc"));
  CHECK(told.err.find("        line          lost   limited by\n             6      0.0") !=
        std::string::npos);
  const std::string lines_told = told.err.substr(0, told.err.find("lost   because of"));
  CHECK(count(lines_told.substr(lines_told.find("lost   limited by")), " s   ") == 2);
  const Ended checked = call("check --worst 1 " + (folder / "p.nc"));
  CHECK(checked.out.find("lost") == std::string::npos);
  CHECK(count(checked.err, "\n             6 ") == 1);
  CHECK(call("run --worst 0 " + (folder / "p.nc")).status == 2);
}

TEST_CASE("lost time is reported by cause, with its axis and places", "[apps][times]") {
  const Folder folder;
  // At 20 mm/s and 1000 mm/s2 each reversal and each exact corner loses v/a, a ramp half of it.
  std::string text = "G21 G90 G61 F1200\nG1 X100\n";
  for (int i = 0; i < 5; ++i) text += "X0\nX100\n";
  write(folder / "p.nc", text + "Y20\nG4 P0.1\nY40\nG0 X0\nM2\n");
  const json causes = report_of(folder / "p.nc")["loss_causes"];
  REQUIRE(causes.size() == 3);
  CHECK(causes[0]["cause"] == "reversal");
  CHECK(causes[0]["axis"] == "x");
  CHECK(causes[0]["count"] == 10);
  CHECK(causes[0]["lost_s"].get<double>() == Approx(10 * 0.02).epsilon(1e-9));
  CHECK(causes[0]["from_mm"] == 0);
  CHECK(causes[0]["to_mm"] == 100);
  CHECK(causes[1]["cause"] ==
        "rest");  // at the start, before and after the dwell, before the rapid
  CHECK(causes[1]["count"] == 4);
  CHECK(causes[1]["lost_s"].get<double>() == Approx(4 * 0.01).epsilon(1e-9));
  CHECK(causes[2]["cause"] == "corner");
  CHECK(causes[2]["lost_s"].get<double>() == Approx(0.02).epsilon(1e-9));
  const Ended told = call("run --worst 1 " + (folder / "p.nc"));
  CHECK(told.err.find("10      0.2000 s   reversals of X at X 0 and X 100\n") != std::string::npos);
}

TEST_CASE("the causes add up to what the lines lose, whatever is overridden", "[apps][times]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90 G61 F1200\nG1 X100\nX0\nX100 F3000\nX150 F600\nM2\n");
  for (const std::string at : {"", " --at 2:override=150 --at 3:override=50"}) {
    const json report = report_of((folder / "p.nc") + at);
    const double time = report["time_s"].get<double>();
    double by_cause = 0;
    for (const json& cause : report["loss_causes"]) {
      by_cause += cause["lost_s"].get<double>();
      if (cause["cause"] == "curve" && at.empty()) CHECK(cause["limit"] != "feed");
    }
    if (at.empty()) CHECK(by_cause == Approx(time - (5 + 5 + 2 + 5)).epsilon(1e-6));
    const Ended told = call("run --worst 9 " + (folder / "p.nc") + at);
    CHECK(told.err.find("because of") != std::string::npos);
    CHECK(told.err.find("-0.0") == std::string::npos);
  }
}

TEST_CASE("a line of a called file loses time under the name of that file", "[apps][times]") {
  const Folder folder;
  write(folder / "sub.ngc", "o<sub> sub\nG1 X[#1 + 0.5]\no<sub> endsub\nM2\n");
  write(folder / "p.ngc", "G21 G90 F1200\no<sub> call [1]\nG4 P0.01\no<sub> call [2]\nM2\n");
  const json lines = report_of(folder / "p.ngc")["worst_lines"];
  REQUIRE(lines.size() == 1);
  CHECK(lines[0]["line"] == 2);
  CHECK(lines[0]["file"].get<std::string>().find("sub.ngc") != std::string::npos);
}

TEST_CASE("short lines that are joined lose their time each", "[apps][times]") {
  const Folder folder;
  write(folder / "p.nc", trochoid("G64 P0.01", 1));
  const json report = report_of((folder / "p.nc") + " --worst 1000");
  double lost = 0;
  for (const json& line : report["worst_lines"]) lost += line["lost_s"].get<double>();
  const json& tool = report["time_sheet"]["tools"][0];
  const double length = report["length_mm"].get<double>() - 6;
  CHECK(report["worst_lines"].size() >= 2);
  double by_cause = 0;
  for (const json& cause : report["loss_causes"]) by_cause += cause["lost_s"].get<double>();
  CHECK(by_cause == Approx(lost).epsilon(1e-6));
  CHECK(lost == Approx(tool["cutting_s"].get<double>() - length / (2000.0 / 60)).epsilon(1e-6));
}

TEST_CASE("the time sheet adds up to the time, by tool and by what it does", "[apps][times]") {
  const Folder folder;
  write(
      folder / "p.nc",
      "G21 G90\nT1 M6\nS1000 M3\nG0 X10\nG1 X20 F600\nG4 P0.2\nX30\nX35 S1100\nX40 M8\nT2 M6\nM3\n"
      "G0 X0 Y10\nG1 X10\nG4 P0.1\nG0 X0\nM2\n");
  const json report = report_of((folder / "p.nc") + kSetNoRounding);
  const json& tools = report["time_sheet"]["tools"];
  REQUIRE(tools.size() == 2);
  double all = 0;
  for (const json& tool : tools)
    for (const char* part : {"cutting_s", "rapid_s", "dwell_s", "rest_s"})
      all += tool[part].get<double>();
  CHECK(all == Approx(report["time_s"].get<double>()).epsilon(1e-9));
  CHECK(tools[0]["tool"] == 1);
  CHECK(tools[0]["cutting_s"].get<double>() == Approx(3 + 3.5 * 0.01).epsilon(1e-6));
  CHECK(tools[0]["dwell_s"].get<double>() == Approx(0.2).epsilon(1e-9));
  CHECK(tools[1]["dwell_s"].get<double>() == Approx(0.1).epsilon(1e-9));
  const json rests = report["time_sheet"]["rests"];
  CHECK(rests["dwell"] == 2);
  CHECK(rests["spindle"] == 1);  // S on a cutting line
  CHECK(rests["coolant"] == 1);
  CHECK(rests["tool"] == 1);
  CHECK(rests["corner"] == 1);  // from the rapid to the feed square to it
  CHECK(report["rests"]["count"] == 1);

  const Ended told = call("run -v " + (folder / "p.nc") + kSetNoRounding);
  CHECK(told.err.find(
            "  stops          1 at a corner, 2 for dwells, 1 for a tool, 1 for the spindle, "
            "1 for the coolant\n") != std::string::npos);
  CHECK(told.err.find("\n  T1        ") != std::string::npos);
  CHECK(call("run " + (folder / "p.nc") + kSetNoRounding).err.find("\n  T1 ") == std::string::npos);
}

TEST_CASE("what rests at corners cost is reported, with the tolerance that wins it back",
          "[apps][times]") {
  const Folder folder;
  const std::string part = folder / "p.nc";
  write(part, trochoid(""));
  const Ended checked = call("check " + part + kSetNoRounding);
  INFO(checked.out);
  CHECK(checked.status == 0);
  CHECK(checked.out ==
        part +
            ": warning: 359 rests at corners cost 10.3 s, 60 % of the time; G64 P0.01 (mm) or "
            "control.corner_tolerance_um = 10 would save that [SC4030]\n");
  const json exact = report_of(part + kSetNoRounding);
  const json rounded = report_of(part + " --set control.corner_tolerance_um=10");
  const double won = exact["time_s"].get<double>() - rounded["time_s"].get<double>();
  CHECK(seconds_in(checked.out) == Approx(won).epsilon(0.01));
  CHECK(exact["rests"]["seconds"].get<double>() == Approx(won).epsilon(1e-6));
  CHECK(exact["rests"]["corner_tolerance_um"] == 10);
  CHECK(exact["rests"]["count"] >= 360);
  CHECK(exact["time_by_limit_s"]["corner"].get<double>() > 0.95 * exact["time_s"].get<double>());
  CHECK(rounded["diagnostics"] == json::array());
  CHECK(rounded["rests"]["count"] == 1);  // from the rapid to the first chord
  // A dry run reports the same, and a pipe about the same.
  CHECK(seconds_in(call("run --dry-run " + part + kSetNoRounding + "--trace /dev/null").err) ==
        Approx(won).epsilon(0.01));
  const Ended piped = shell("cat " + part + " | $softcnc check -" + kSetNoRounding);
  CHECK(piped.out.find("cost about ") != std::string::npos);
  CHECK(seconds_in(piped.out) == Approx(won).epsilon(0.15));
}

TEST_CASE("who asks for sharp corners gets a note of what they cost", "[apps][times]") {
  const Folder folder;
  for (const char* head : {"G61", "G61.1"}) {
    const std::string part = folder / "p.nc";
    write(part, trochoid(head));
    const Ended checked = call("check " + part);
    INFO(checked.out);
    CHECK(count(checked.out, "SC4030") == 0);
    CHECK(checked.out.find(
              ": note: 359 rests at corners, which must stay sharp, cost 10.3 s, 60 % of "
              "the time; G64 P0.01 (mm) would save that [SC4031]\n") != std::string::npos);
    write(folder / "g64.nc", trochoid("G64 P0.01"));
    const double won = report_of(part)["time_s"].get<double>() -
                       report_of(folder / "g64.nc")["time_s"].get<double>();
    CHECK(seconds_in(checked.out) == Approx(won).epsilon(0.01));
  }
}

TEST_CASE("rests that no rounding wins back are not complained of", "[apps][times]") {
  const Folder folder;
  std::string holes = "G21 G90 F600\n";
  for (int i = 0; i < 20; ++i) holes += "G0 X" + std::to_string(3 * i) + "\nG1 Z-1\nG0 Z1\n";
  write(folder / "holes.nc", holes + "M2\n");
  const Ended checked = call("check " + (folder / "holes.nc") + kSetNoRounding);
  CHECK(checked.out.empty());
  write(folder / "few.nc", "G21 G90 F600\nG1 X50\nY50\nX0\nY0\nM2\n");
  CHECK(call("check " + (folder / "few.nc") + kSetNoRounding).out.empty());
  write(folder / "p.nc", trochoid(""));
  CHECK(call("run --quiet --single-block " + (folder / "p.nc") + kSetNoRounding).err.empty());
}

}  // namespace softcnc::app::test
