// SPDX-License-Identifier: MIT
// softcnc diff: programs, traces and recordings side by side.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "output/junit.hpp"
#include "settings/tolerance.hpp"
#include "support/shown.hpp"

using namespace softcnc::app;
using namespace softcnc::app::test;
using nlohmann::json;
using softcnc::runtime::Aspect;

namespace {

std::vector<std::string> example_programs() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SOFTCNC_SOURCE_DIR "/programs"))
    if (entry.path().extension() == ".nc") names.push_back(entry.path());
  std::sort(names.begin(), names.end());
  return names;
}

void check_empty(const Ended& ended) {
  CAPTURE(ended.err);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
}

json differences(const std::string& arguments, int status) {
  const Ended ended = call("diff -q --format json " + arguments);
  CAPTURE(ended.err);
  REQUIRE(ended.status == status);
  return json::parse(ended.out);
}

json aspect(const json& document, const std::string& name) {
  for (const json& one : document["aspects"])
    if (one["aspect"] == name) return one;
  FAIL("no aspect " << name);
  return {};
}

/// A circle of a radius, from a rest to a rest, in G61.1.
std::string circle(double radius, int feed) {
  const std::string r = std::to_string(radius);
  return "G61.1\nG00 X" + r + "\nG03 X" + r + " I-" + r + " F" + std::to_string(feed) + "\nM30\n";
}

softcnc::runtime::Margin margin(const Tolerance& tolerance, Aspect aspect) {
  return tolerance.margins()[static_cast<std::size_t>(aspect)];
}

}  // namespace

TEST_CASE("no program differs from itself", "[apps][diff]") {
  REQUIRE(example_programs().size() > 20);
  for (const std::string& program : example_programs()) {
    CAPTURE(program);
    const Ended ended = call("diff -q " + program + " " + program);
    CHECK(ended.status == 0);
    CHECK(ended.out.empty());
  }
}

TEST_CASE("a program does not differ from its traces and its recording", "[apps][diff]") {
  const Folder folder;
  const std::string part = "$programs/03_arc.nc", recording = folder / "t.rec";
  std::vector<std::string> files{part, recording};
  REQUIRE(call("record -q " + part + " -o " + recording).status == 0);
  for (const char* name : {"t.csv", "t.csv.zst", "t.npz", "t.npz.zst"}) {
    files.push_back(folder / name);
    REQUIRE(call("run -q " + part + " --trace " + files.back()).status == 0);
  }
  for (const std::string& a : files)
    for (const std::string& b : files) {
      CAPTURE(a, b);
      check_empty(call("diff " + a + " " + b));
    }
  const json same = differences(part + " " + recording, 0);
  CHECK(same["same"] == true);
  CHECK(same["a"]["kind"] == "program");
  CHECK(same["b"]["kind"] == "recording");
  CHECK(same["a"]["rows"] == same["b"]["rows"]);
  CHECK(same["first_difference"].is_null());
}

TEST_CASE("programs that say the same in other words do not differ in path and time",
          "[apps][diff]") {
  const Folder folder;
  write(folder / "a.nc", "G01 X10 F1200\nY5\nM30\n");
  write(folder / "b.nc", "G21 G90\nN10 G1 X10.0 F1200\nN20 G1 Y5\nM30\n");
  const Ended ended = call("diff -q " + (folder / "a.nc") + " " + (folder / "b.nc"));
  CHECK(ended.status == 1);
  CHECK(ended.out.find("the line is 1 in A and 2 in B") != std::string::npos);
  CHECK(call("diff -q --tolerance 0um " + (folder / "a.nc") + " " + (folder / "b.nc")).status == 0);
}

TEST_CASE("two circles are as far apart as their radii, at any feed", "[apps][diff]") {
  const Folder folder;
  write(folder / "a.nc", circle(20, 1200));
  for (const int feed : {1200, 700}) {
    write(folder / "b.nc", circle(20.05, feed));
    const json found = differences((folder / "a.nc") + " " + (folder / "b.nc"), 1);
    const double um = found["distance"]["um"];
    CHECK(um >= 50 - 1e-6);
    CHECK(um <= 50 + 1);  // the chord tolerance
    CHECK(aspect(found, "path")["difference_mm"].get<double>() == Approx(um / 1000));
  }
}

TEST_CASE("differences of time by line and by limit sum up to that of the whole", "[apps][diff]") {
  const std::string files = "$programs/19_rounded_corners.nc $programs/03_arc.nc";
  const json found = differences(files + " --worst 1000", 1);
  const double total = found["b"]["time_s"].get<double>() - found["a"]["time_s"].get<double>();
  double by_line = 0, by_limit = 0;
  for (const json& line : found["by_line"])
    by_line += line["b_s"].get<double>() - line["a_s"].get<double>();
  for (const json& limit : found["by_limit"])
    by_limit += limit["b_s"].get<double>() - limit["a_s"].get<double>();
  CHECK(found["by_line"].size() == found["lines_that_differ"]);
  CHECK(by_line == Approx(total).margin(1e-9));
  CHECK(by_limit == Approx(total).margin(1e-9));
  CHECK(std::abs(aspect(found, "time")["difference_s"].get<double>()) ==
        Approx(std::abs(total)).margin(1e-9));
}

TEST_CASE("differences are shown as a table with the first row that differs", "[apps][diff]") {
  const Folder folder;
  const std::string a = folder / "a.nc", b = folder / "b.nc";
  write(a, "G01 X10 F1200\nM30\n");
  write(b, "G01 X10 F600\nM30\n");
  const Ended ended = call("diff " + a + " " + b);
  CHECK(ended.status == 1);
  CHECK(ended.err.empty());
  CHECK(shows(
      ended.out,
      "A: " + a + " (program)\nB: " + b +
          " (program)\n"
          "\n"
          "                                 A               B           B - A\n"
          "  time, s                 0.520000        1.010000       +0.490000    +94.231 %\n"
          "  length, mm             10.000000       10.000000       +0.000000\n"
          "  rows                         521            1011            +490\n"
          "  contour max, um         0.000000        0.000000       +0.000000\n"
          "\n"
          "time by limit, s\n"
          "  feed                    0.481000        0.990000       +0.509000   +105.821 %\n"
          "  acceleration            0.038000        0.019000       -0.019000    -50.000 %\n"
          "  stop                    0.001000        0.001000       +0.000000\n"
          "\n"
          "time by line, s: 1 line differs\n"
          "  line 1                  0.519000        1.009000       +0.490000    +94.412 %\n"
          "\n"
          "                        difference       tolerance\n"
          "  time                      0.49 s         1e-09 s  differs\n"
          "  path                        0 um        0.001 um  same\n"
          "  position                 4900 um        0.001 um  differs\n"
          "  speed                    10 mm/s      2e-05 mm/s  differs\n"
          "  line                       1 row          0 rows  differs\n"
          "  limit                    30 rows          0 rows  differs\n"
          "\n"
          "the first row that differs is row 11, at 0.01 s, line 1: the limit is acceleration in "
          "A and feed in B\n"));
}

TEST_CASE("what differs in the machines is shown, and how far the table is off", "[apps][diff]") {
  const Folder folder;
  for (const char* part : {"a.nc", "b.nc"}) write(folder / part, "G02 X10 Y10 I5 J5 F3000\nM30\n");
  const std::string toml = call("machine --toml --set axis.y.acceleration_mm_s2=500").out;
  write(folder / "b.toml", toml);
  const std::string diff = "cd " + (folder / "") + "; $softcnc diff a.nc b.nc";
  const std::string text = shell(diff).out;
  CHECK(shows(text, "\nmachine: 1 value differs\n  axis.y.acceleration_mm_s2"));
  CHECK(shows(text, "  axis.y.acceleration_mm_s2 ... 1000 ... 500\n\ntime by limit, s\n"));
  CHECK(shows(text, "  contour max, um ...\n\nmachine: "));
  const json document = json::parse(shell(diff + " --format json").out);
  CHECK(document["machine"] ==
        json::parse(R"([{"key": "axis.y.acceleration_mm_s2", "a": "1000", "b": "500"}])"));
  CHECK(double(document["a"]["contour_max_um"]) > double(document["b"]["contour_max_um"]));
  const std::string none = " --set control.backend=none";
  CHECK_FALSE(shows(shell(diff + none).out, "contour max"));
  REQUIRE(shell("cd " + (folder / "") + "; $softcnc record -q a.nc -o a.rec").status == 0);
  CHECK(json::parse(shell("cd " + (folder / "") + "; $softcnc diff a.rec b.nc --format json")
                        .out)["machine"] == document["machine"]);
}

TEST_CASE("a tolerance judges what it names, and nothing else", "[apps][diff]") {
  const Folder folder;
  const std::string a = folder / "a.nc", b = folder / "b.nc", both = " " + a + " " + b;
  write(a, "G01 X10 F1200\nM30\n");
  write(b, "G01 X10.002 F1190\nM30\n");
  CHECK(call("diff -q" + both).status == 1);
  const Ended within = call("diff -q --tolerance time=1%,path=3um" + both);
  CHECK(within.status == 0);
  CHECK(within.out.find("not judged") != std::string::npos);
  CHECK(call("diff -q --tolerance time=0.1%,path=3um" + both).status == 1);
  CHECK(call("diff -q --tolerance path=1um" + both).status == 1);
  CHECK(call("diff -q --tolerance path=3um --tolerance time=10ms" + both).status == 0);
  CHECK(call("diff -q --tolerance 3um" + both).status == 1);  // rows come later
  const json document = differences("--tolerance time=1%" + both, 0);
  CHECK(aspect(document, "time")["judged"] == true);
  CHECK(aspect(document, "position")["judged"] == false);
  CHECK(aspect(document, "position")["same"] == false);
}

TEST_CASE("tolerances are read with their units", "[apps][diff]") {
  Tolerance tolerance;
  CHECK(margin(tolerance, Aspect::position).absolute == 1e-6);
  CHECK(margin(tolerance, Aspect::line).judged);
  CHECK(tolerance.add("time=2%,path=0.01mm,speed=60mm/min").empty());
  CHECK(margin(tolerance, Aspect::time).part == Approx(0.02));
  CHECK(margin(tolerance, Aspect::time).absolute == 0);
  CHECK(margin(tolerance, Aspect::path).absolute == 0.01);
  CHECK(margin(tolerance, Aspect::speed).absolute == Approx(1));
  CHECK_FALSE(margin(tolerance, Aspect::position).judged);
  CHECK_FALSE(margin(tolerance, Aspect::line).judged);
  CHECK(tolerance.add("5um").empty());
  CHECK(margin(tolerance, Aspect::position).absolute == Approx(0.005));
  CHECK(margin(tolerance, Aspect::path).absolute == Approx(0.005));
  CHECK(margin(tolerance, Aspect::time).judged);
  CHECK(tolerance.add("time=3ms").empty());
  CHECK(margin(tolerance, Aspect::time).absolute == Approx(0.003));
  CHECK(tolerance.add("path=5s") == "'5s' is no tolerance of path, which is a number of mm, um");
  CHECK(tolerance.add("5") == "'5' is neither a length nor ASPECT=VALUE");
  CHECK(tolerance.add("tme=1s") ==
        "'tme' is not one of time, path, position, speed; did you mean 'time'?");
  for (const char* wrong : {"", "time=", "time=nan%", "time=-1s", "path=1e999mm", "line=1", "1um,"})
    CHECK_FALSE(tolerance.add(wrong).empty());
}

TEST_CASE("runs of other periods differ in all rows, and are compared all the same",
          "[apps][diff]") {
  const Folder folder;
  const std::string part = "$programs/03_arc.nc", trace = folder / "t.npz";
  REQUIRE(call("run -q --dry-run " + part + " --set control.period_ms=2 --trace " + trace).status ==
          0);
  const Ended ended = call("diff " + part + " " + trace);
  CHECK(ended.status == 1);
  CHECK(ended.out.find("the periods differ: 1 ms in A and 2 ms in B") != std::string::npos);
  CHECK(ended.out.find("  position                       -        0.001 um  differs\n") !=
        std::string::npos);
  CHECK(call("diff -q --tolerance time=1%,path=15um " + part + " " + trace).status == 0);
}

TEST_CASE("what cannot be compared has the exit status of its reason", "[apps][diff]") {
  const Folder folder;
  const std::string good = "$data/square.nc";
  const Ended wrong = call("diff $data/two_errors.nc " + good);
  CHECK(wrong.status == 1);
  CHECK(wrong.out.empty());
  CHECK(wrong.err.find(": error: ") != std::string::npos);
  const Ended missing = call("diff " + good + " no.csv");
  CHECK(missing.status == 5);
  CHECK(missing.err == "no.csv: error: cannot be read: No such file or directory [SC6081]\n");
  write(folder / "bad.rec", "no recording");
  CHECK(call("diff " + good + " " + (folder / "bad.rec")).status == 5);
  write(folder / "bad.csv", "t_s,line\n");
  CHECK(call("diff " + good + " " + (folder / "bad.csv")).status == 5);
  CHECK(call("diff " + good).status == 2);
  CHECK(call("diff - -").status == 2);
  const Ended tolerance = call("diff a b --tolerance time=1");
  CHECK(tolerance.status == 2);
  CHECK(tolerance.err.find("--tolerance") != std::string::npos);
}

TEST_CASE("a program may come through a pipe", "[apps][diff]") {
  check_empty(call("diff -q - $data/square.nc", read(data("square.nc"))));
}

TEST_CASE("aspects are test cases of a JUnit file", "[apps][diff]") {
  const Folder folder;
  const std::string a = folder / "a.nc", b = folder / "b.nc", file = folder / "j.xml";
  write(a, "G01 X10 F1200\nM30\n");
  write(b, "G01 X10 F600\nM30\n");
  CHECK(call("diff -q " + a + " " + b + " --tolerance time=1%,path=1um --junit " + file).status ==
        1);
  const std::string xml = read(file);
  CHECK(xml.starts_with(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"softcnc "
      "diff\" tests=\"6\" failures=\"1\" errors=\"0\" skipped=\"4\" time=\"0.000\">\n"
      "    <testcase classname=\"" +
      a + " and " + b +
      "\" name=\"time\"><failure message=\"time differs by "
      "0.49 s, and 0.0052 s are allowed\" type=\"time\">"));
  CHECK(xml.find(" and " + b + "\" name=\"path\"/>\n") != xml.npos);
  CHECK(xml.find("name=\"speed\"><skipped message=\"not judged\"/></testcase>") != xml.npos);
  CHECK(call("diff " + a + " " + b + " --junit " + a).status == 2);
}

TEST_CASE("XML holds any text", "[apps][diff]") {
  TestCase test{"a<&>\"b\x01\xFF", TestResult::error, "two\nlines", "SC1", "<x>", 1.5};
  CHECK(junit_xml("s", "c", {test}) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"s\" "
        "tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"1.500\">\n"
        "    <testcase classname=\"c\" name=\"a&lt;&amp;&gt;&quot;b\xEF\xBF\xBD\xEF\xBF\xBD\" "
        "time=\"1.500\"><error message=\"two&#10;lines\" type=\"SC1\">&lt;x&gt;</error>"
        "</testcase>\n  </testsuite>\n</testsuites>\n");
}
