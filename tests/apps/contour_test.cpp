// SPDX-License-Identifier: MIT
// The contour error: in the trace, in the report and in the summary.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/shell.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

struct Run {
  Ended ended;
  Trace trace;
  json report;
  std::string rows;  // of the trace, as they stand
};

Run run_contour(const std::string& program, const std::string& options) {
  Folder folder;
  write(folder / "p.nc", program);
  Run run;
  run.ended = call("run " + (folder / "p.nc") + " --progress none --trace " + (folder / "t.csv") +
                   " --report " + (folder / "r.json") + " " + options);
  INFO(run.ended.err);
  run.rows = read(folder / "t.csv");
  run.trace = parse_trace(run.rows);
  run.report = json::parse(read(folder / "r.json"));
  return run;
}

double largest(const Trace& trace, const std::string& column) {
  double largest = 0;
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    largest = std::max(largest, trace.number(i, column));
  return largest;
}

/// Two turns of radius 50 at F3000, from the tangent and back to it.
const std::string kTwoTurns =
    "G21 G90 G17\nG1 X50 F3000\nG3 X50 Y0 J50\nG3 X50 Y0 J50\nG1 X100\nM2\n";

/// Short chords whose rows leave the queue with little path ahead.
std::string chords() {
  std::string program = "G61 G21 G90 G17\nG1 X20 Y0 F2000\n";
  for (int i = 1; i <= 720; ++i) {
    const double angle = i * std::numbers::pi / 360;
    program += "X" + std::to_string(20 * std::cos(angle)) + " Y" +
               std::to_string(20 * std::sin(angle)) + "\n";
  }
  return program + "M2\n";
}

}  // namespace

TEST_CASE("a circle is smaller by the closed form, and that is said", "[apps][contour]") {
  const Run circle = run_contour(kTwoTurns, "-v");
  const double smaller = 1000 * 50.0 * 50.0 / (2 * 50 * 30 * 30);  // um: v^2 / (2 R Kv^2)
  CHECK(circle.report["contour_error_um_max"].get<double>() == Approx(smaller).epsilon(0.1));
  CHECK(circle.report["contour_error_um_rms"].get<double>() == Approx(smaller).epsilon(0.2));
  const int line = circle.report["contour_error_at"]["line"];
  CHECK((line == 3 || line == 4));
  const double t = circle.report["contour_error_at"]["t_s"];
  CHECK(t > 1);
  CHECK(t < 14);
  CHECK(circle.report["contour_error_rapid_um_max"] == 0);
  CHECK_FALSE(circle.report.contains("contour_error_rapid_at"));
  const std::string& shown = circle.ended.err;
  CHECK(shown.find("contour error  max 2") != std::string::npos);
  CHECK(shown.find("v^2/(2 R Kv^2), here R 50 mm at F3000 by 27.8 µm") != std::string::npos);
  CHECK(shown.find("About 10 µm of that would be left at F1800 in the tightest curve (R 50 mm)") !=
        std::string::npos);
}

TEST_CASE("the feed that the summary names leaves what it says", "[apps][contour]") {
  const Run circle = run_contour(kTwoTurns, "--set limits.feed_mm_min=1800");
  CHECK(circle.report["contour_error_um_max"].get<double>() == Approx(10).epsilon(0.2));
}

TEST_CASE("the column of the trace is what the report is made of", "[apps][contour]") {
  const Run circle = run_contour(kTwoTurns, "");
  CHECK(circle.trace.columns.back() == "contour_um");
  const double in_rows = largest(circle.trace, "contour_um");
  const double in_report = circle.report["contour_error_um_max"];
  CHECK(in_rows <= in_report);
  CHECK(in_rows > 0.99 * in_report);
  // In the middle of the second turn it is the distance from the circle.
  const std::size_t i = circle.trace.rows.size() * 5 / 8;
  const double off = 1000 * std::abs(std::hypot(circle.trace.number(i, "x_act_mm") - 50,
                                                circle.trace.number(i, "y_act_mm") - 50) -
                                     50);
  CHECK(circle.trace.number(i, "contour_um") == Approx(off).epsilon(1e-4));
}

TEST_CASE("small errors are not explained", "[apps][contour]") {
  const Run slow = run_contour("G1 X5 Y2 F100\nM2\n", "-v");
  CHECK(slow.report["contour_error_um_max"].get<double>() < 10);
  CHECK(slow.ended.err.find("contour error") != std::string::npos);
  CHECK(slow.ended.err.find("Kv") == std::string::npos);
  CHECK(slow.ended.err.find("to stay within") == std::string::npos);
}

TEST_CASE("without a backend that knows the axes there is no contour error", "[apps][contour]") {
  const Folder folder;
  const std::string steps = "--backend stepdir --set backend.stepdir.file=" + (folder / "s.vcd");
  for (const std::string& options :
       {std::string("--backend none"), steps, std::string("--dry-run")}) {
    const Run none = run_contour(kTwoTurns, options);
    CHECK_FALSE(none.report.contains("contour_error_um_max"));
    CHECK(none.ended.err.find("contour") == std::string::npos);
    CHECK(std::count(none.trace.columns.begin(), none.trace.columns.end(), "contour_um") == 0);
  }
}

TEST_CASE("by the clock the contour error is the same", "[apps][contour]") {
  const std::string program = "G21 G90 G17\nG1 X5 F3000\nG3 X5 Y0 J5\nG0 X0\nM2\n";
  const Run plain = run_contour(program, ""), paced = run_contour(program, "--realtime");
  CHECK(plain.rows == paced.rows);
  for (const char* key : {"contour_error_um_max", "contour_error_um_rms", "contour_error_at",
                          "contour_error_rapid_um_max", "contour_error_rapid_um_rms"})
    CHECK(plain.report[key] == paced.report[key]);
}

TEST_CASE("methods that go their own way have a contour error, too", "[apps][contour]") {
  for (const char* method : {"taylor1", "curvature3p", "m-dsm"}) {
    const Run circle = run_contour(kTwoTurns, std::string("--set control.interpolation=") + method);
    CHECK(circle.report["contour_error_um_max"].get<double>() == Approx(28).epsilon(0.2));
  }
}

TEST_CASE("with stiff loops the tool is on the path, whatever becomes of the feed",
          "[apps][contour]") {
  const std::string stiff = "--set axis.x.drive.kv_1_s=1000 --set axis.y.drive.kv_1_s=1000 ";
  for (const char* events :
       {"", "--at 0.5:override=30 --at 1:override=100", "--at 0.7:hold --at 1.5:resume"}) {
    const Run polygon = run_contour(chords(), stiff + events);
    INFO(polygon.ended.err);
    CHECK(polygon.report["status"] == "done");
    CHECK(polygon.report["contour_error_um_max"].get<double>() < 10);
  }
}

TEST_CASE("a drill that goes back the way it came is on its path", "[apps][contour]") {
  const Run drilled =
      run_contour("G21 G90 G17 G0 Z5\nG1 Z-0.4 F300\nG1 Z0.4\nG1 Z-0.6\nG0 Z5\nM2\n",
                  "--set axis.z.drive.kv_1_s=1000");
  CHECK(drilled.report["contour_error_um_max"].get<double>() < 10);
}

TEST_CASE("where the gains of the axes differ, that is said", "[apps][contour]") {
  const Run line = run_contour("G1 X50 Y50 F3000\nM2\n", "-v --set axis.y.drive.kv_1_s=25");
  // Across a line of 45 degrees: half of v (1/25 - 1/30).
  CHECK(line.report["contour_error_um_max"].get<double>() ==
        Approx(1000 * 50.0 / 2 * (1 / 25.0 - 1 / 30.0)).epsilon(0.1));
  CHECK(line.ended.err.find("The gains of the axes differ, from 25 to 30 1/s") !=
        std::string::npos);
}

TEST_CASE("on a line to and fro the tool is never off", "[apps][contour]") {
  const Run there = run_contour("G21 G90\nG1 X5 F1000\nX0\nX5\nX0\nM2\n", "");
  CHECK(there.report["contour_error_um_max"].get<double>() < 0.02);
}

TEST_CASE("a contour error beyond its tolerance is reported", "[apps][contour]") {
  const std::string tolerance =
      "--set control.corner_tolerance_um=0 --set control.contour_tolerance_um=";
  const Run kept = run_contour(kTwoTurns, "-v " + tolerance + "10");
  CHECK(kept.ended.status == 0);
  CHECK(kept.ended.err.find("SC5061") == std::string::npos);
  CHECK(double(kept.report["contour_error_um_max"]) <= 12.5);
  CHECK(double(kept.report["time_by_limit_s"]["contour"]) > 10);
  CHECK(shows(kept.ended.err, "leaves 10 µm\n  (control.contour_tolerance_um)"));
  // Friction holds an axis that turns back, however slow it is.
  const Run beyond = run_contour(kTwoTurns, tolerance + "2");
  CHECK(beyond.ended.status == 0);
  CHECK(shows(beyond.ended.err,
              "p.nc:3:1: warning: the table is ... um off the path at ... s, where "
              "control.contour_tolerance_um allows 2 and a BLU of 2.5 [SC5061]"));
}
