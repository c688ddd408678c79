// SPDX-License-Identifier: MIT
// Backends that lead out of softcnc, from outside: what arrives, and what is reported when it
// cannot.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "apps/shell.hpp"
#include "hal/files/hash.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;
using softcnc::hal::hash_hex;

namespace {

const std::string kToHal = "$softcnc run --backend hal-stream --set backend.hal-stream.file=";

/// The lines that are no comments.
std::string rows_without_comments(const std::string& text) {
  std::istringstream in(text);
  std::string rows;
  for (std::string line; std::getline(in, line);)
    if (line[0] != '#') rows += line + '\n';
  return rows;
}

}  // namespace

TEST_CASE("the rows for HAL are those of the trace, counted and checksummed", "[apps][ports]") {
  const Folder folder;
  write(folder / "part.nc", "G1 X2.5 F1200\nG2 X3.5 Y1 J1\nG4 P0.01\nG0 X0 Y0 Z-1\nM30\n");
  const Ended ended = shell(kToHal + "- " + (folder / "part.nc") + " --report " +
                            (folder / "r.json") + " --trace " + (folder / "t.csv"));
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  const std::string rows = rows_without_comments(ended.out);
  const Trace trace = parse_trace(read(folder / "t.csv"));
  std::string expected, place;
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    place = trace.word(i, "x_mm") + ' ' + trace.word(i, "y_mm") + ' ' + trace.word(i, "z_mm");
    expected += place + " 1 " + std::to_string(i + 1) + '\n';
  }
  const std::size_t count = trace.rows.size() + 1;
  expected += place + " 0 " + std::to_string(count) + '\n';
  CHECK(rows == expected);
  const auto report = nlohmann::json::parse(read(folder / "r.json"));
  CHECK(report["stream_rows"] == count);
  CHECK(report["stream_xxh3"] == hash_hex(rows));
  CHECK(ended.err.find(std::to_string(count) + " samples sent, xxh3 " + hash_hex(rows)) !=
        std::string::npos);
}

TEST_CASE("rows for HAL keep accelerations and jerks at the servo period", "[apps][ports]") {
  const std::string period = GENERATE("1", "4", "8"), servo = GENERATE("1", "0.25");
  CAPTURE(period, servo);
  const Folder folder;
  write(folder / "part.nc", "G1 X10 F3000\nG3 Y20 J10\nG1 X0\nM30\n");
  const Ended ended =
      shell(kToHal + "- -q --machine $programs/machines/retrofit.toml " + (folder / "part.nc") +
            " --set control.period_ms=" + period + " --set control.servo_period_ms=" + servo +
            " --set axis.x.jerk_mm_s3=50000 --set axis.y.jerk_mm_s3=50000");
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  const double t = std::stod(servo) / 1000;
  std::istringstream rows(rows_without_comments(ended.out));
  std::array<double, 4> x{}, y{};  // newest first; the program begins at 0, 0
  double acceleration = 0, jerk = 0;
  const auto take = [&](std::array<double, 4>& last, double place) {
    std::rotate(last.begin(), last.end() - 1, last.end());
    last[0] = place;
    acceleration = std::max(acceleration, std::abs(last[0] - 2 * last[1] + last[2]) / (t * t));
    jerk = std::max(jerk, std::abs(last[0] - 3 * last[1] + 3 * last[2] - last[3]) / (t * t * t));
  };
  double x_mm = 0, y_mm = 0;
  for (std::string line; std::getline(rows, line);) {
    std::istringstream(line) >> x_mm >> y_mm;
    take(x, x_mm);
    take(y, y_mm);
  }
  for (int i = 0; i < 3; ++i) {
    take(x, x_mm);
    take(y, y_mm);
  }
  CHECK(acceleration <= 1005);
  CHECK(acceleration > 900);
  CHECK(jerk <= 50'250);
}

TEST_CASE("the period of the simulated loop counts", "[apps][ports]") {
  const Folder folder;
  std::set<std::string> traces;
  for (const std::string servo : {"8", "1", "0.25"}) {
    const Ended ended = shell(
        "$softcnc run -q $programs/03_arc.nc --backend sim --set control.period_ms=8 --set "
        "control.servo_period_ms=" +
        servo + " --trace " + (folder / "t.csv"));
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    traces.insert(rows_without_comments(read(folder / "t.csv")));
  }
  CHECK(traces.size() == 3);
}

TEST_CASE("a reader of rows that goes away ends the run quietly, one that takes none is status 5",
          "[apps][ports]") {
  const std::string patience = "- --set backend.hal-stream.patience_s=0.1 -q $data/zigzag.nc";
  const Ended gone = shell("{ " + kToHal + patience + "; echo status $? >&2; } | head -c 5000");
  CHECK(gone.err == "status 141\n");
  const Ended stuck = shell("{ " + kToHal + patience + "; echo status $? >&2; } | sleep 2");
  CHECK(stuck.err.find(
            "<stdout>: error: the pipe is full, and its reader has taken nothing for 0.1 s; "
            "HAL holds the last row it got [SC6071]\n") != std::string::npos);
  CHECK(stuck.err.find("status 5\n") != std::string::npos);
}

TEST_CASE("a FIFO that nobody reads is refused before anything moves", "[apps][ports]") {
  const Folder folder;
  const std::string fifo = folder / "rows";
  const Ended ended = shell("mkfifo " + fifo + " && " + kToHal + fifo +
                            " -q $data/square.nc --trace " + (folder / "t.csv"));
  CHECK(ended.status == 5);
  CHECK(ended.err ==
        fifo + ": error: no program reads this pipe; start its reader first [SC6070]\n");
  CHECK_FALSE(std::filesystem::exists(folder / "t.csv"));
}

TEST_CASE("a full disk ends a stream of rows with status 5", "[apps][ports]") {
  const Ended ended = shell(kToHal + "/dev/full -q $data/square.nc");
  CHECK(ended.status == 5);
  CHECK(ended.err.find("/dev/full: error: writing failed: No space left on device; HAL holds "
                       "the last row it got [SC6012]\n") != std::string::npos);
}

TEST_CASE("replay and dry runs send no rows", "[apps][ports]") {
  const Folder folder;
  const std::string rows = folder / "rows";
  const std::string rec = folder / "r.rec";
  REQUIRE(shell("$softcnc record -q --backend hal-stream --set backend.hal-stream.file=" + rows +
                " $data/square.nc -o " + rec)
              .status == 0);
  REQUIRE(std::filesystem::remove(rows));
  CHECK(shell("$softcnc replay -q " + rec).status == 0);
  CHECK(shell(kToHal + rows + " -q --dry-run $data/square.nc").status == 0);
  CHECK_FALSE(std::filesystem::exists(rows));
}

TEST_CASE("a backend does not write over what is read or written besides: SC7072",
          "[apps][ports]") {
  const Folder folder;
  const std::string text = "G1 X1 F600\nM30\n";
  const std::string part = folder / "part.vcd", machine = folder / "mill.toml";
  write(part, text);
  write(machine,
        "[control]\nbackend = \"hal-stream\"\n[backend.hal-stream]\nfile = \"" + machine + "\"\n");
  std::filesystem::create_symlink(part, folder / "link.vcd");
  const auto refused = [](const std::string& command) {
    const Ended ended = shell("$softcnc run -q " + command);
    CAPTURE(command, ended.err);
    CHECK(ended.status == 2);
    CHECK(shows(ended.err, "error: ... [SC7072]"));
    CHECK(ended.err.find(" name the same file: ") != std::string::npos);
    return ended.err;
  };
  const std::string step = "--backend stepdir --set backend.stepdir.file=";
  const std::string rows = "--backend hal-stream --set backend.hal-stream.file=";
  CHECK(refused(step + part + " " + part) ==
        "softcnc: error: PART and backend.stepdir.file name the same file: " + part +
            " [SC7072]\n");
  refused(step + (folder / "link.vcd") + " " + part);
  refused(rows + part + " " + part);
  refused("--machine " + machine + " " + part);
  refused(rows + (folder / "r.json") + " --report " + (folder / "r.json") + " " + part);
  refused(rows + (folder / "t.csv") + " --trace " + (folder / "t.csv") + " " + part);
  refused(rows + "- --trace - " + part);
  CHECK(read(part) == text);
  CHECK(shell("$softcnc run -q --dry-run " + step + part + " " + part).status == 0);
}

TEST_CASE("a parallel port can drive a machine that comes with softcnc", "[apps][ports]") {
  const Folder folder;
  const std::string machine = " --machine $programs/machines/parport_router.toml";
  for (const std::string part : {"01_line", "02_square", "03_arc", "04_helix", "08_butterfly"}) {
    CAPTURE(part);
    const Ended ended = shell("$softcnc run -q $programs/" + part + ".nc" + machine +
                              " --set backend.parport.device= --trace " + (folder / "t.csv"));
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    const Trace trace = parse_trace(read(folder / "t.csv"));
    const std::size_t last = trace.rows.size() - 1;
    for (const std::string axis : {"x", "y", "z"})
      CHECK(trace.number(last, axis + "_count") * 0.00625 ==
            Approx(trace.number(last, axis + "_mm")).margin(0.00625));
  }
}

TEST_CASE("a machine file without an end is refused", "[apps][ports]") {
  const Folder folder;
  write(folder / "part.nc", "G1 X1 F600\nM30\n");
  const Ended ended = shell("$softcnc check --machine /dev/zero " + (folder / "part.nc"));
  CHECK(ended.status == 2);
  CHECK(ended.out.find("cannot be read: longer than 16 MiB") +
            ended.err.find("cannot be read: longer than 16 MiB") !=
        2 * std::string::npos);
}
