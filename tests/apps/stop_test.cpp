// SPDX-License-Identifier: MIT
// Ctrl-C: a stop on the path within the limits, whole files, and the exit status of the signal.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

/// Interrupts a long run when thousands of rows of its trace are written, so that it moves at full
/// speed. The run goes round a circle without a corner, so that nothing but the stop brings it to
/// rest, whenever the signal arrives.
Ended interrupted(const std::string& signal, const Folder& folder) {
  std::string part = "G90 G00 X0 Y100\nG02 F6000\n";
  for (int i = 0; i < 200; ++i) part += "I50\n";
  write(folder / "long.nc", part + "M30\n");
  return shell("$softcnc run " + (folder / "long.nc") + " --trace " + (folder / "t.csv") +
               " --report " + (folder / "r.json") + " & pid=$!; until [ \"$(stat -c %s " +
               (folder / ".t.csv.softcnc-*") +
               " 2>/dev/null || echo 0)\" -gt 500000 ]; do sleep 0.02; done; kill -" + signal +
               " $pid; wait $pid");
}

double second_difference(const Trace& trace, std::size_t i, const char* column) {
  const auto at = [&](std::size_t row) {
    return trace.number(std::min(row, trace.rows.size() - 1), column);
  };
  return (at(i + 2) - 2 * at(i + 1) + at(i)) / 1e-6;
}

}  // namespace

TEST_CASE("a stop waits for nobody who reads rows or words", "[apps][stop]") {
  const Folder folder;
  write(folder / "part.nc", "G21 G90 G1 X400 F600\nM30\n");
  const std::string begin = "cd " + (folder / "") + "; mkfifo full; exec 3<>full; ";
  const std::string fill = "head -c 65536 /dev/zero >&3; ";
  const std::string end =
      " & pid=$!; sleep 1; kill -TERM $pid; "
      "(sleep 20; kill -9 $pid) 2>/dev/null >/dev/null & wait $pid";
  const Ended rows = shell(begin + "$softcnc run -q part.nc --trace - --report r.json >full" + end);
  CHECK(rows.status == 5);
  CHECK(shows(rows.err, "nobody reads what is written [SC6012]"));
  CHECK(json::parse(read(folder / "r.json"))["status"] == "error");
  std::filesystem::remove(folder / "full");
  const Ended words =
      shell(begin + fill + "$softcnc run -v --realtime part.nc --trace t.csv 2>full" + end);
  CHECK(words.status == 143);
  CHECK(std::filesystem::exists(folder / "t.csv"));
  std::filesystem::remove(folder / "full");
  const Ended report =
      shell(begin + "mkfifo nobody; $softcnc run -q --realtime part.nc --report nobody" + end);
  CHECK(report.status == 5);
  CHECK(shows(report.err, "nobody: error: cannot be created: ... [SC6011]"));
}

TEST_CASE("an interrupted run stops within its limits and leaves whole files", "[apps][stop]") {
  const Folder folder;
  const Ended ended = interrupted("INT", folder);
  CHECK(ended.status == 130);
  CHECK(ended.err.find(", stopped at rest in line ") != std::string::npos);
  CHECK(folder.files() == std::vector<std::string>{"long.nc", "r.json", "t.csv"});

  const json report = json::parse(read(folder / "r.json"));
  CHECK(report["status"] == "stopped");
  double total = 0;
  for (const auto& time : report["time_by_limit_s"]) total += time.get<double>();
  CHECK(total == Approx(report["time_s"].get<double>()).epsilon(1e-9));

  const Trace trace = parse_trace(read(folder / "t.csv"));
  REQUIRE(trace.rows.size() == report["setpoints"]);
  const std::size_t last = trace.rows.size() - 1;
  CHECK(trace.number(last, "v_mm_s") == 0);
  CHECK(trace.word(last, "limit") == "stop");
  CHECK(trace.word(last - 1, "limit") == "stop");
  // It ends as soon as it is at rest, which may be just on a row.
  CHECK(trace.number(last - 2, "v_mm_s") > 0);
  for (std::size_t i = last > 500 ? last - 500 : 0; i <= last; ++i)
    for (const char* column : {"x_mm", "y_mm"})
      if (std::abs(second_difference(trace, i, column)) > 1001) FAIL_CHECK("row " << i);
}

TEST_CASE("SIGTERM, SIGHUP and SIGQUIT stop a run as Ctrl-C does", "[apps][stop]") {
  const auto [signal, status] =
      GENERATE(table<std::string, int>({{"TERM", 143}, {"HUP", 129}, {"QUIT", 131}}));
  const Folder folder;
  CHECK(interrupted(signal, folder).status == status);
  CHECK(folder.files() == std::vector<std::string>{"long.nc", "r.json", "t.csv"});
  const Trace trace = parse_trace(read(folder / "t.csv"));
  CHECK(trace.number(trace.rows.size() - 1, "v_mm_s") == 0);
}

TEST_CASE("a run under nohup survives a hang-up", "[apps][stop]") {
  const Folder folder;
  const Ended ended = shell(
      "trap '' HUP; { sleep 0.2; cat $data/square.nc; } | { exec 3<&0; $softcnc run -q - <&3 "
      "--trace " +
      (folder / "t.csv") + " & pid=$!; sleep 0.1; kill -HUP $pid; wait $pid; }");
  CHECK(ended.status == 0);
  CHECK(folder.files() == std::vector<std::string>{"t.csv"});
}

TEST_CASE("a second signal ends at once and leaves no half-written file", "[apps][stop]") {
  const Folder folder;
  std::string part = "G90 G00 X0 Y100\nG02 F6000\n";
  for (int i = 0; i < 20; ++i) part += "I50\n";
  write(folder / "long.nc", part + "M30\n");
  write(folder / "old.csv", "of a run before\n");
  // By the clock the stop takes half a second, and the signals after the first one come before.
  const Ended ended = shell(
      "$softcnc run --realtime --backend stepdir --set backend.stepdir.file=" + (folder / "e.vcd") +
      " " + (folder / "long.nc") + " --trace " + (folder / "old.csv") + " & pid=$!; until ls " +
      (folder / ".old.csv.softcnc-*") + " " + (folder / ".e.vcd.softcnc-*") +
      " >/dev/null 2>&1; do sleep 0.02; done; sleep 0.2; " +
      "for i in 1 2 3 4 5 6; do kill -TERM $pid; sleep 0.04; done; wait $pid");
  CHECK(ended.status == 143);
  CHECK(folder.files() == std::vector<std::string>{"long.nc", "old.csv"});
  CHECK(read(folder / "old.csv") == "of a run before\n");
}

TEST_CASE("a stop during the pre-flight moves nothing", "[apps][stop]") {
  const Folder folder;
  std::string part = "G90 G01 F60\n";
  for (int i = 0; i < 20000; ++i) part += i % 2 == 0 ? "X100\n" : "X0\n";
  write(folder / "long.nc", part + "M30\n");
  const Ended ended = shell("$softcnc run " + (folder / "long.nc") + " --trace " +
                            (folder / "t.csv") + " & pid=$!; sleep 0.3; kill -INT $pid; wait $pid");
  CHECK(ended.status == 130);
  CHECK(ended.err == "stopped before anything moved\n");
  CHECK(folder.files() == std::vector<std::string>{"long.nc"});
}
