// SPDX-License-Identifier: MIT
// A run from outside: trace, report, summary; and the same pipeline for every command.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/run_report.hpp"
#include "apps/shell.hpp"
#include "motion/model/method.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

double sum(const json& object) {
  double total = 0;
  for (const auto& value : object) total += value.get<double>();
  return total;
}

}  // namespace

TEST_CASE("a run writes nothing to stdout and a summary to stderr", "[apps][run]") {
  const Ended ended = call("run $data/square.nc");
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  for (const char* words :
       {"square.nc on retrofitted mill (built-in)\n", "  limited by  ", "feed 91", "acceleration 4",
        "  chord error  ", " times faster than real time\n", "feed / limit, mm/min"}) {
    CAPTURE(words, ended.err);
    CHECK(ended.err.find(words) != std::string::npos);
  }
  CHECK(std::ranges::count(ended.err, '\n') <= 18);
  const std::string details = call("run -v $data/square.nc").err;
  for (const char* words : {"following error", "counts of BLU", "limited by           time"})
    CHECK(details.find(words) != std::string::npos);
  CHECK(ended.err.find('\033') == std::string::npos);  // no terminal: no colour, no bar
  CHECK(ended.err.find('\r') == std::string::npos);
  CHECK(call("run --quiet $data/square.nc").err.empty());
}

TEST_CASE("the details report the jerk of axes that have a limit of it", "[apps][run]") {
  const std::string told = call("run -v $data/square.nc --set axis.x.jerk_mm_s3=50000").err;
  const std::string name = "  jerk of X, mm/s³ ";
  const std::size_t row = told.find(name);
  REQUIRE(row != std::string::npos);
  const std::size_t begin = row + name.size();
  const std::string figures = told.substr(begin, told.find('\n', row) - begin);
  CHECK(std::stod(figures) == Approx(50000).epsilon(0.05));
  CHECK(figures.find(" / 50000") != std::string::npos);
  CHECK(told.find("jerk of Y") == std::string::npos);
}

TEST_CASE("the report reports the figures of the run", "[apps][run]") {
  const json report = report_of("$data/square.nc --set control.corner_tolerance_um=0");
  CHECK(report["status"] == "done");
  CHECK(report["machine"] == "retrofitted mill (built-in)");
  CHECK(report["blocks"] == 11);
  // 10 sqrt 2 to the first corner, 20 + 15 + 15 + 20 of lines, a quarter of a circle of 5 mm.
  CHECK(report["length_mm"].get<double>() ==
        Approx(10 * std::sqrt(2.0) + 70 + 5 * std::acos(0.0)).epsilon(1e-12));
  CHECK(report["counts"] == json({{"x", 4000}, {"y", 4000}, {"z", 0}}));
  CHECK(report["settled_counts"] == report["counts"]);
  CHECK(report["setpoints"] == std::ceil(report["time_s"].get<double>() * 1000) + 1);
  CHECK(sum(report["time_by_limit_s"]) == Approx(report["time_s"].get<double>()).epsilon(1e-12));
  CHECK(report["time_by_limit_s"]["stop"].get<double>() == Approx(0.05).margin(0.004));
  CHECK(report["diagnostics"] == json::array());
  CHECK(report["chord_error_um_max"].get<double>() <= 1);
  CHECK(report["path_deviation_um_max"].get<double>() < 1e-6);
  CHECK(report["feed_fluctuation_max"].get<double>() < 1e-9);
  for (const char* axis : {"x", "y"}) {
    CHECK(report["velocity_max"][axis].get<double>() > 20);
    CHECK(report["velocity_max"][axis].get<double>() <= 250);
    CHECK(report["acceleration_max"][axis].get<double>() == Approx(1000).epsilon(1e-3));
    CHECK(report["jerk_max"][axis].get<double>() > 0);
    // A ramp lags v / Kv: 6.67 mm at 200 mm/s, less on the short rapid.
    CHECK(report["following_error_um_max"][axis].get<double>() > 500);
  }
  CHECK(report["acceleration_max"]["z"] == 0);
  for (const char* cpu : {"cpu_s", "cpu_planning_s", "cpu_interpolation_s", "cpu_verification_s"})
    CHECK(report[cpu].get<double>() > 0);
}

TEST_CASE("no stage is charged with the planning that another asks for", "[apps][run]") {
  const Folder folder;
  std::string part = "G21 G90 G64 P0.01 G01 F8000\n";
  double x = 0, y = 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2.4 * i * i;  // turns about at random
    x += 0.1 * std::cos(angle);
    y += 0.1 * std::sin(angle);
    part += "X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
  }
  write(folder / "chords.nc", part + "M30\n");
  const json report = report_of((folder / "chords.nc") +
                                " --set axis.x.jerk_mm_s3=50000 --set axis.y.jerk_mm_s3=50000");
  const auto seconds = [&](const char* stage) { return report[stage].get<double>(); };
  double stages = 0;
  for (const char* stage :
       {"cpu_planning_s", "cpu_interpolation_s", "cpu_verification_s", "cpu_output_s"}) {
    CAPTURE(stage);
    CHECK(seconds(stage) > 0);
    stages += seconds(stage);
  }
  CHECK(stages <= seconds("cpu_s"));
  CHECK(seconds("cpu_planning_s") > 2 * seconds("cpu_verification_s"));
}

TEST_CASE("the time of a method that goes its own way is that of its rows", "[apps][run]") {
  const json planned = report_of("--dry-run $programs/08_butterfly.nc");
  const json report = report_of(
      "--dry-run $programs/08_butterfly.nc --set control.interpolation=curvature3p "
      "--set control.chord_tolerance_um=0.05");
  const double rows = (report["setpoints"].get<double>() - 1) * 0.001;
  CHECK(report["time_s"].get<double>() == Approx(rows).epsilon(1e-12));
  CHECK(rows > 1.1 * planned["time_s"].get<double>());
  CHECK(sum(report["time_by_limit_s"]) == Approx(rows).epsilon(1e-9));
}

TEST_CASE("rounded corners leave the programmed path, and no row leaves the rounded one",
          "[apps][run]") {
  const Folder folder;
  write(folder / "corner.nc", "G64 P0.5 F1200\nG01 X10\nY10\nM02\n");
  const json report = report_of(folder / "corner.nc");
  CHECK(report["corner_deviation_um_max"].get<double>() == Approx(500).epsilon(1e-3));
  CHECK(report["path_deviation_um_max"].get<double>() < 1e-6);
}

TEST_CASE("a straight line takes the time that the trapezium of its speed takes", "[apps][run]") {
  const Folder folder;
  write(folder / "line.nc", "G01 X100 F6000\nM30\n");
  const json report = report_of(folder / "line.nc");
  CHECK(report["time_s"].get<double>() == Approx(100.0 / 100 + 100.0 / 1000).epsilon(1e-12));
  CHECK(report["time_by_limit_s"]["feed"].get<double>() == Approx(0.9).epsilon(1e-9));
  CHECK(report["time_by_limit_s"]["acceleration"].get<double>() == Approx(0.2).epsilon(1e-9));
  CHECK(report["time_by_limit_s"].size() == 2);
  CHECK(report["velocity_max"]["x"].get<double>() == Approx(100).epsilon(1e-9));
}

TEST_CASE("an override multiplies the feed and no machine limit", "[apps][run]") {
  const Folder folder;
  write(folder / "line.nc", "G01 X100 F6000\nG00 X0\nM30\n");
  const json half = report_of((folder / "line.nc") + " --feed-override 50");
  const double rapid = 100.0 / 250 + 250.0 / 1000;
  CHECK(half["time_s"].get<double>() == Approx(100.0 / 50 + 0.05 + rapid).epsilon(1e-9));
  CHECK(half["velocity_max"]["x"].get<double>() == Approx(250).epsilon(1e-9));
}

TEST_CASE("the report of one run is that of the next, except for CPU times", "[apps][run]") {
  json reports[2];
  for (json& report : reports) {
    report = report_of("$programs/08_butterfly.nc");
    for (const char* cpu :
         {"cpu_s", "cpu_planning_s", "cpu_interpolation_s", "cpu_verification_s", "cpu_output_s"})
      report.erase(cpu);
  }
  CHECK(reports[0] == reports[1]);
}

TEST_CASE("a dry run, a run and their repetition give the same rows", "[apps][run]") {
  const Folder folder;
  const std::string part = "$programs/08_butterfly.nc";
  const Ended dry = call("run -q --dry-run " + part);
  CHECK(dry.status == 0);
  CHECK(dry.err.empty());
  CHECK(call("run -q --dry-run " + part).out == dry.out);
  CHECK(call("run -q --dry-run " + part + " --trace " + (folder / "dry.csv")).out.empty());
  CHECK(read(folder / "dry.csv") == dry.out);

  call("run -q " + part + " --trace " + (folder / "sim.csv"));
  const Trace planned = parse_trace(dry.out), simulated = parse_trace(read(folder / "sim.csv"));
  REQUIRE(planned.rows.size() == simulated.rows.size());
  REQUIRE(planned.columns.size() == 11);
  for (std::size_t i = 0; i < planned.rows.size(); ++i)
    for (std::size_t column = 0; column < planned.columns.size(); ++column)
      if (planned.rows[i][column] != simulated.rows[i][column]) FAIL_CHECK("row " << i);
  CHECK(simulated.columns[11] == "x_act_mm");
}

TEST_CASE("a program through a pipe runs like a file", "[apps][run]") {
  const Ended file = call("run -q --dry-run $data/square.nc");
  CHECK(shell("$softcnc run -q --dry-run - <$data/square.nc").out == file.out);
  CHECK(shell("cat $data/square.nc | $softcnc run -q - --trace -").out.size() > file.out.size());
}

TEST_CASE("standard input that is a file is read from where it stands", "[apps][run]") {
  const Ended ended = shell("{ head -c 0; read first; $softcnc blocks -; } <$data/square.nc");
  CHECK(ended.status == 0);
  CHECK(ended.out.find("\"line\":2,\"block\":1,\"kind\":\"tool\"") != std::string::npos);
}

TEST_CASE("a pipe that cannot be kept for its second reading is refused", "[apps][run]") {
  const Ended ended = shell("cat $data/square.nc | TMPDIR=/no/folder $softcnc run -");
  CHECK(ended.status == 5);
  CHECK(begins_showing(ended.err,
                       "<stdin>: error: cannot be kept in a temporary file: ... [SC6003]"));
}

TEST_CASE("a program with errors moves nothing: no trace, exit status 1", "[apps][run]") {
  const Folder folder;
  const Ended ended = call("run $data/two_errors.nc --trace " + (folder / "t.csv"));
  CHECK(ended.status == 1);
  CHECK(ended.out.empty());
  CHECK(shows(ended.err, ":3:6: error: ... [SC1004]"));
  CHECK(shows(ended.err, ":5:5: error: ... [SC2001]"));
  CHECK(folder.files().empty());
  const json report = report_of("$data/two_errors.nc 2>/dev/null", 1);
  CHECK(report["status"] == "error");
  REQUIRE(report["diagnostics"].size() == 2);
  CHECK(report["diagnostics"][1]["line"] == 5);
  CHECK(report["diagnostics"][1]["column"] == 5);
  CHECK(report["diagnostics"][1]["code"] == "SC2001");
  CHECK(report["diagnostics"][1]["severity"] == "error");
}

TEST_CASE("a dry run ends at rest after the last good block and reports all errors",
          "[apps][run]") {
  const Ended ended = call("run --dry-run $data/two_errors.nc");
  CHECK(ended.status == 1);
  CHECK(shows(ended.err, ":3:6: error: ... [SC1004]"));
  CHECK(shows(ended.err, ":5:5: error: ... [SC2001]"));
  const Trace trace = parse_trace(ended.out);
  const std::size_t last = trace.rows.size() - 1;
  CHECK(trace.number(last, "x_mm") == 10);
  CHECK(trace.number(last, "v_mm_s") == 0);
  CHECK(trace.word(last, "limit") == "stop");
}

TEST_CASE("a move beyond the travel of an axis is refused with its line, exit status 3",
          "[apps][run]") {
  const Ended ended = call("run $data/beyond.nc");
  CHECK(ended.status == 3);
  const std::string file = data("beyond.nc");
  CHECK(ended.err.starts_with(file + ":4:2: error: X reaches 1010.5 mm, 10.5 mm beyond its travel "
                                     "from -1000 to 1000 mm [SC4001]\n"
                                     "    4 |  X1010.5\n"
                                     "      |  ^~~~~~~\n"
                                     "      = help: in G54 the program spans X 0 to 1010.5"));
  CHECK(shows(ended.err, file + ":6:1: error: Y reaches -1200 mm, 200 mm beyond its travel "
                                "from -1000 to 1000 mm [SC4001]\n"
                                "    6 | Y-1200\n"
                                "      | ^~~~~~\n"));
}

TEST_CASE("an axis that lags too far stops the run with 4 and a whole trace", "[apps][run]") {
  const Folder folder;
  const Ended ended =
      call("run $data/zigzag.nc --set axis.x.drive.following_error_um=500 --trace " +
           (folder / "t.csv") + " --report " + (folder / "r.json"));
  CHECK(ended.status == 4);
  CHECK(shows(ended.err, "zigzag.nc:3:1: error: following error of X: it is 0.51... [SC5001]"));
  const json report = json::parse(read(folder / "r.json"));
  CHECK(report["status"] == "alarm");
  CHECK(report["diagnostics"][0]["code"] == "SC5001");
  CHECK(sum(report["time_by_limit_s"]) == Approx(report["time_s"].get<double>()).epsilon(1e-9));
  const Trace trace = parse_trace(read(folder / "t.csv"));
  CHECK(trace.rows.size() == report["setpoints"]);
  CHECK(std::abs(trace.number(trace.rows.size() - 1, "x_err_um")) > 500);
}

TEST_CASE("an up/down counter that overflows stops the run with 4", "[apps][run]") {
  const Ended ended = call(
      "run $data/zigzag.nc --set axis.x.drive.counter_bits=8 "
      "--set axis.x.drive.following_error_um=50000");
  CHECK(ended.status == 4);
  CHECK(shows(ended.err, "zigzag.nc:3:1: error: counter overflow of X: it is ... [SC5002]"));
}

TEST_CASE("a method that exceeds a limit says by how much and exits with 0", "[apps][run]") {
  const Ended ended = call("run $programs/08_butterfly.nc --set control.interpolation=taylor1");
  CHECK(ended.status == 0);
  CHECK(shows(ended.err, "note: taylor1: the acceleration of X reaches ... [SC4003]"));
}

TEST_CASE("every method runs a program to its end point, whatever it exceeds", "[apps][run]") {
  const Folder folder;
  write(folder / "part.nc",
        "F3000 G01 X10\nY5\nG04 P0.05\nG02 X20 Y15 I10 J0\nM03 S1000\nG06.2 P3 K0 X20 Y15 R1\n"
        "K0 X20 Y25 R0.7071067811865476\nK0 X10 Y25 R1\nK1\nK1\nK1\nG00 X0 Y0\nM30\n");
  for (const std::string_view method : softcnc::kMethodNames) {
    CAPTURE(method);
    const std::string choice = " --set control.interpolation=" + std::string(method);
    const json report = report_of((folder / "part.nc") + choice);
    CHECK(report["status"] == "done");
    CHECK(report["counts"] == json::parse(R"({"x":0,"y":0,"z":0})"));
    CHECK(report["blocks"] == 8);
    // With the fine rows of the simulated mill, the time by limits is that of the run.
    CHECK(sum(report["time_by_limit_s"]) == Approx(report["time_s"].get<double>()).epsilon(1e-6));
  }
}

TEST_CASE("acceleration after interpolation leaves a circle by its closed form", "[apps][run]") {
  // R (1 - sinc(w tau / 2)): R 20 mm at 50 mm/s and tau 0.1 s. No step of the loop lies between.
  const Folder folder;
  write(folder / "circle.nc", "F3000 G02 X0 Y0 I20 J0\nG02 X0 Y0 I20 J0\nM30\n");
  const double x = 50.0 / 20 * 0.1 / 2, sinc = std::sin(x) / x;
  for (const auto& [method, left] :
       {std::pair{"acc-dec-linear", sinc}, std::pair{"acc-dec-bell", sinc * sinc}}) {
    const Ended ended = call("run --dry-run " + (folder / "circle.nc") +
                             " --set control.acc_dec_ms=100 --set control.interpolation=" + method);
    CHECK(ended.status == 0);
    CHECK(shows(ended.err, std::string("note: ") + method +
                               ": the distance of the curve from the motion reaches ... [SC4003]"));
    const json report =
        report_of("--dry-run " + (folder / "circle.nc") +
                  " --set control.acc_dec_ms=100 --set control.interpolation=" + method);
    CHECK(report["path_deviation_um_max"].get<double>() == Approx(20e3 * (1 - left)).epsilon(0.01));
  }
}

TEST_CASE("progress as JSON lines can be read by a program", "[apps][run]") {
  const Folder folder;
  std::string part = "G90 G01 F600\n";
  for (int i = 0; i < 60; ++i) part += i % 2 == 0 ? "X100\n" : "X0\n";
  write(folder / "long.nc", part + "M30\n");
  const Ended ended = call("run --quiet --progress json " + (folder / "long.nc"));
  CHECK(ended.status == 0);
  std::istringstream lines(ended.err);
  double percent = 0;
  int running = 0;
  json last;
  for (std::string line; std::getline(lines, line);) {
    const json row = json::parse(line);
    last = row;
    if (row["doing"] != "running" || row.contains("done")) continue;
    ++running;
    CHECK(row["percent"].get<double>() > percent);
    percent = row["percent"];
    CHECK(row["time_s"].get<double>() < row["total_s"].get<double>());
  }
  CHECK(running > 0);
  CHECK(last["done"] == true);
  CHECK(last["percent"] == 100);
}

TEST_CASE("JSON progress of a short run is one object, the last", "[apps][run]") {
  const Folder folder;
  write(folder / "p.nc", "G01 X1 F600\nM30\n");
  const json row = json::parse(call("run -q --progress json " + (folder / "p.nc")).err);
  CHECK(row["doing"] == "running");
  CHECK(row["done"] == true);
  CHECK(row["percent"] == 100);
  CHECK(row["line"] == 2);
}

TEST_CASE("a run on step and direction drives leaves every pulse in a file", "[apps][run]") {
  const Folder folder;
  const std::string file = folder / "steps.vcd";
  const std::string arguments = "run -q --backend stepdir --set backend.stepdir.file=" + file +
                                " $data/square.nc --trace " + (folder / "t.csv");
  const Ended ended = call(arguments);
  CAPTURE(ended.err);
  CHECK(ended.status == 0);
  const std::string edges = read(file);
  CHECK(edges.rfind("$timescale 1 ns $end\n", 0) == 0);
  const Trace trace = parse_trace(read(folder / "t.csv"));
  const std::size_t last = trace.rows.size() - 1;
  CHECK(trace.number(last, "x_count") == 4000);
  CHECK(trace.number(last, "y_count") == 4000);
  for (std::size_t i = 0; i <= last; ++i)
    REQUIRE(std::abs(trace.number(i, "x_mm") - 0.0025 * trace.number(i, "x_count")) < 0.00125001);
  CHECK(call("run --dry-run -q --backend stepdir --set backend.stepdir.file=" +
             (folder / "none.vcd") + " $data/square.nc")
            .status == 0);
  CHECK_FALSE(std::filesystem::exists(folder / "none.vcd"));
}

TEST_CASE("a file of edges that cannot be written is status 5", "[apps][run]") {
  const Ended nowhere =
      call("run -q --backend stepdir --set backend.stepdir.file=/no/folder/s.vcd $data/square.nc");
  CHECK(nowhere.status == 5);
  CHECK(shows(nowhere.err, "/no/folder/s.vcd: error: ... [SC6011]"));
  const Folder folder;
  const std::string full = folder / "full.edges";
  const Ended disk =
      shell("ln -s /dev/full " + full +
            " && $softcnc run -q --backend stepdir --set backend.stepdir.file=" + full +
            " $data/square.nc");
  CHECK(disk.status == 5);
  CHECK(shows(disk.err, "error: ... [SC6012]"));
  CHECK(
      call("run --backend stepdir --set backend.stepdir.max_rate_hz=1000 $data/square.nc").status ==
      2);
}
