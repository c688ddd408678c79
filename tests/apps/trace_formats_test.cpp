// SPDX-License-Identifier: MIT
// The formats of a trace from outside: each against another way to the same figures.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <sstream>

#include "apps/shell.hpp"
#include "hal/ports/port_timing.hpp"
#include "hal/signals/edge_reader.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "support/shown.hpp"
#include "support/zstd.hpp"

using namespace softcnc;
using namespace softcnc::app::test;

namespace {

using softcnc::test::unpacked;

constexpr const char* kTracedPart =
    "G21 G90 G17 F3000\n"
    "G01 X12.5 Y7.0125\n"
    "M00\n"
    "G03 X2.5 Y17.0125 I-10 J0\n"
    "G04 P0.02\n"
    "G18 G02 X2.5 Z-5 I0 K-2.5\n"
    "G00 X-1.0024 Y0 Z0\n"
    "M30\n";

/// One run of kTracedPart, or a dry one, that writes a trace; its text.
std::string traced(const Folder& folder, const std::string& options, const std::string& suffix) {
  write(folder / "p.nc", kTracedPart);
  const std::string file = folder / ("t" + suffix);
  const Ended ended = call("run -q " + (folder / "p.nc") + " --trace " + file + " " + options);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return read(file);
}

/// What Python finds different between the arrays in t.npz and the columns in t.csv.
std::string numpy_differences(const Folder& folder) {
  write(
      folder / "compare.py",
      "import csv, sys, zipfile\n"
      "import numpy\n"
      "arrays, lines = numpy.load(sys.argv[1]), open(sys.argv[2]).readlines()\n"
      "comments = [line for line in lines if line[0] == '#']\n"
      "rows = list(csv.reader(line for line in lines if line[0] != '#'))\n"
      "if arrays.files != rows[0]: print('columns', arrays.files, rows[0])\n"
      "for i, name in enumerate(rows[0]):\n"
      "    text = [row[i] for row in rows[1:]]\n"
      "    kind = arrays[name].dtype\n"
      "    whole = name in ('line', 'block') or name.endswith('_count')\n"
      "    wanted = 'U' if name == 'limit' else 'i' if whole else 'f'\n"
      "    if kind.kind != wanted: print(name, kind)\n"
      "    read = numpy.array([kind.type(t) for t in text], kind)\n"
      "    same = numpy.array_equal(arrays[name], read, equal_nan=kind.kind == 'f')\n"
      "    if not same: print(name, 'differs')\n"
      "if zipfile.ZipFile(sys.argv[1]).comment.decode() != ''.join(comments): print('comment')\n");
  const Ended ended = shell("/usr/bin/python3 " + (folder / "compare.py") + " " +
                            (folder / "t.npz") + " " + (folder / "t.csv"));
  return ended.out + ended.err;
}

/// Rows of a VCD of real variables, by what stands in force at each instant that is reported.
std::map<std::int64_t, std::map<char, double>> positions(const std::string& vcd) {
  std::istringstream in(vcd.substr(vcd.find("$enddefinitions $end\n") + 21));
  std::map<std::int64_t, std::map<char, double>> all;
  std::map<char, double> now;
  std::int64_t time = -1;
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#') time = std::stoll(line.substr(1));
    if (line[0] == 'r') now[line.back()] = std::stod(line.substr(1));
    all[time] = now;
  }
  return all;
}

}  // namespace

TEST_CASE("the arrays of a trace are the columns of its CSV", "[apps][trace]") {
  const std::string options =
      GENERATE("", "--backend none", "--dry-run", "--set control.interpolation=m-dsm",
               "--backend stepdir --set backend.stepdir.file='\"\"'");
  const Folder folder;
  traced(folder, "--columns all " + options, ".csv");
  const std::string arrays = traced(folder, options, ".npz");
  CHECK(numpy_differences(folder).empty());
  CHECK(traced(folder, options, ".npz") == arrays);
  CHECK(unpacked(traced(folder, options, ".npz.zst")) == arrays);
}

TEST_CASE("a trace of no row, and one of a stream, are arrays too", "[apps][trace]") {
  const Folder folder;
  for (const std::string part : {"M30\\n", "G01 X1 F600\\nM30\\n"}) {
    for (const char* suffix : {".csv", ".npz"})
      REQUIRE(shell("printf '" + part + "' | $softcnc run -q --dry-run - --columns all --trace " +
                    (folder / "t") + suffix)
                  .status == 0);
    std::string text = read(folder / "t.csv");
    const std::string unknown = "# program: -\n";
    const auto late = text.rfind("# program: ");  // where the comments of a zip stand anyway
    const std::string hash = text.substr(late);
    text.resize(late);
    write(folder / "t.csv", text.replace(text.find(unknown), unknown.size(), hash));
    CAPTURE(part);
    CHECK(numpy_differences(folder).empty());
  }
}

TEST_CASE("numpy reads names and numbers of a CSV trace without being helped", "[apps][trace]") {
  const Folder folder;
  traced(folder, "", ".csv");
  write(folder / "read.py",
        "import csv, sys\n"
        "import numpy\n"
        "rows = list(csv.DictReader(l for l in open(sys.argv[1]) if l[0] != '#'))\n"
        "table = numpy.genfromtxt(sys.argv[1], names=True, delimiter=',')\n"
        "print(table.dtype.names == tuple(rows[0]), len(table) == len(rows))\n"
        "print(*(name for name in table.dtype.names if name != 'limit'\n"
        "        and any(float(row[name]) != x for row, x in zip(rows, table[name]))))\n"
        "words = numpy.genfromtxt(sys.argv[1], names=True, delimiter=',', dtype=None,\n"
        "                         encoding='utf-8')\n"
        "print(all(row['limit'] == x for row, x in zip(rows, words['limit'])))\n");
  const Ended ended = shell("/usr/bin/python3 " + (folder / "read.py") + " " + (folder / "t.csv"));
  CHECK(ended.err.empty());
  CHECK(ended.out == "True True\n\nTrue\n");
}

TEST_CASE("a trace for HAL is what goes to HAL", "[apps][trace]") {
  const std::string options = GENERATE("", "--set control.period_ms=4",
                                       "--set control.interpolation=sam --set control.period_ms=2");
  const Folder folder;
  const std::string stream = " --backend hal-stream --set backend.hal-stream.file=";
  const std::string trace = traced(folder, options + stream + (folder / "rows"), ".hal");
  const std::string rows = read(folder / "rows");
  CHECK(trace == rows);
  CHECK(std::count(rows.begin(), rows.end(), '\n') > 1000);
  CHECK(traced(folder, options + " --dry-run", ".hal") == rows);
  CHECK(unpacked(traced(folder, options, ".hal.zst")) == rows);
}

TEST_CASE("a trace of drives with step and direction is their edges", "[apps][trace]") {
  const std::string options = GENERATE("", "--set control.interpolation=m-dsm",
                                       "--set control.interpolation=dda --set "
                                       "control.pulse_clock=paper");
  const Folder folder;
  const std::string steps = " --backend stepdir --set backend.stepdir.file=";
  const std::string trace = traced(folder, options + steps + (folder / "s.vcd"), ".vcd");
  CHECK(trace == read(folder / "s.vcd"));
  CHECK(hal::read_edges(trace)->size() > 60000);
  CHECK(traced(folder, options + " --dry-run --backend stepdir", ".vcd") == trace);
  CHECK(unpacked(traced(folder, options + steps + (folder / "s.vcd"), ".vcd.zst")) == trace);
  if (!options.empty()) CHECK(traced(folder, options, ".vcd") == trace);
}

TEST_CASE("a trace of a parallel port is edges of whole base periods", "[apps][trace]") {
  const Folder folder;
  const auto edges =
      hal::read_edges(traced(folder,
                             "--backend parport --set backend.parport.device='\"\"' --set "
                             "axis.x.velocity_mm_min=1500 --set axis.y.velocity_mm_min=1500 --set "
                             "axis.z.velocity_mm_min=1500",
                             ".vcd"));
  REQUIRE(edges);
  hal::PulseRules rules(hal::port_timing(Machine{}).rules);
  rules.read(*edges);
  CHECK(rules.broken().value_or("none") == "none");
  CHECK(rules.counts() == GridPoint{-401, 0, 0});
}

TEST_CASE("without such drives it is positions, to the nanosecond", "[apps][trace]") {
  const std::string options = GENERATE("", "--backend none --set control.period_ms=0.7",
                                       "--backend hal-stream --set backend.hal-stream.file='\"\"'");
  const Folder folder;
  const Trace rows = parse_trace(traced(folder, options, ".csv"));
  const std::string text = traced(folder, options, ".vcd");
  CHECK(text.find("$timescale 1 ns $end\n") != std::string::npos);
  CHECK(text.find("$var real 64 \" y_mm $end\n") != std::string::npos);
  CHECK(unpacked(traced(folder, options, ".vcd.zst")) == text);
  const auto all = positions(text);
  auto told = all.begin();
  for (std::size_t row = 0; row < rows.rows.size(); ++row) {
    const auto ns = std::llround(rows.number(row, "t_s") * 1e9);
    while (std::next(told) != all.end() && std::next(told)->first <= ns) ++told;
    REQUIRE(told->second.at('!') == rows.number(row, "x_mm"));
    REQUIRE(told->second.at('"') == rows.number(row, "y_mm"));
    REQUIRE(told->second.at('#') == rows.number(row, "z_mm"));
  }
  CHECK(all.rbegin()->first == std::llround(rows.number(rows.rows.size() - 1, "t_s") * 1e9));
}

TEST_CASE("an unknown suffix of a trace is wrong usage, before anything moves", "[apps][trace]") {
  const Folder folder;
  for (const std::string run : {"run -q ", "run -q --dry-run "}) {
    const Ended ended = call(run + "$data/square.nc --trace " + (folder / "t.xls"));
    CHECK(ended.status == 2);
    CHECK(ended.err == (folder / "t.xls") +
                           ": error: no trace format has this suffix; known are .csv, .npz, "
                           ".vcd, .hal, each with or without a further .zst [SC6014]\n");
  }
  CHECK(folder.files().empty());
}

TEST_CASE("a full disk, a full folder for temporary files, no folder: status 5", "[apps][trace]") {
  const Folder folder;
  const std::string suffix = GENERATE(".npz", ".vcd", ".hal", ".npz.zst", ".vcd.zst", ".hal.zst");
  std::filesystem::create_symlink("/dev/full", folder / ("t" + suffix));
  const std::string run = "run -q --backend none $data/square.nc --trace ";
  const Ended full = call(run + (folder / ("t" + suffix)));
  CHECK(full.status == 5);
  CHECK(full.err ==
        (folder / ("t" + suffix)) + ": error: writing failed: No space left on device [SC6012]\n");
  const Ended nowhere = call(run + (folder / "none/t") + suffix);
  CHECK(nowhere.status == 5);
  CHECK(shows(nowhere.err, "error: cannot be created: ... [SC6011]"));
  if (!suffix.starts_with(".npz")) return;
  const Ended homeless =
      shell("TMPDIR=" + (folder / "none") + " $softcnc " + run + (folder / ("u" + suffix)));
  CHECK(homeless.status == 5);
  CHECK(shows(homeless.err, "error: no temporary file: ... [SC6003]"));
  CHECK(folder.files() == std::vector<std::string>{"t" + suffix});
}

TEST_CASE("a reader that closes the pipe of a trace ends the run quietly", "[apps][trace]") {
  const Folder folder;
  const std::string suffix = GENERATE(".vcd", ".hal", ".csv", ".npz");
  const std::string pipe = folder / ("t" + suffix);
  const Ended ended = shell("mkfifo " + pipe + "; head -c 100 <" + pipe +
                            " >/dev/null & $softcnc run -q --dry-run " +
                            "$programs/08_butterfly.nc --trace " + pipe);
  CHECK(ended.status == 141);
  CHECK(ended.err.empty());
}
