// SPDX-License-Identifier: MIT
// softcnc convert: the new program runs where the old one did.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "apps/shell.hpp"
#include "support/files.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app::test;

namespace {

const std::string kWithJerk =
    " --set axis.x.jerk_mm_s3=20000 --set axis.y.jerk_mm_s3=20000 --set axis.z.jerk_mm_s3=20000 ";
constexpr double kHalfCircle = 10, kOfChords = 0.02;  // mm

/// Half a circle about X0 Y10 in chords of 9 degrees, 31 um from it, after a line.
std::string half_circle(const std::string& before = {}, const std::string& after = {}) {
  std::string text = before + "G64 P0.05 F3000\nG01 X20\n";
  for (int i = 1; i <= 20; ++i) {
    const double angle = std::numbers::pi * i / 20;
    text += fmt::format("X{:.3f} Y{:.3f}\n", 20 + kHalfCircle * std::sin(angle),
                        kHalfCircle * (1 - std::cos(angle)));
  }
  return text + "X0\n" + after + "M30\n";
}

/// The largest distance of the rows of a run from the path of half_circle().
double off_half_circle(const Trace& trace) {
  double most = 0;
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const double x = trace.number(i, "x_mm"), y = trace.number(i, "y_mm");
    const double off = x > 20 ? std::abs(std::hypot(x - 20, y - kHalfCircle) - kHalfCircle)
                              : std::min(std::abs(y), std::abs(y - 2 * kHalfCircle));
    most = std::max(most, off);
  }
  return most;
}

std::string part_in(const Folder& folder, const std::string& text) {
  write(folder / "part.nc", text);
  return folder / "part.nc";
}

int times_in(const std::string& text, const std::string& word) {
  int found = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a converted program runs within the tolerance of the old one, in every form",
          "[apps][convert]") {
  const Folder folder;
  const std::string part = part_in(folder, half_circle()), out = folder / "out.nc";
  for (const std::string form : {"g06.2", "g05.2", "g1", "g1g2g3"}) {
    CAPTURE(form);
    const Ended ended = call("convert " + part + kWithJerk + " --to " + form + " -o " + out +
                             " --set " + "control.chord_tolerance_um=20");
    CHECK(ended.status == 0);
    CHECK(ended.out.empty());
    CHECK(shows(ended.err, "lines and arcs became 1 curve within"));
    CHECK(call("check -q " + kWithJerk + out).status == 0);
    const Trace trace = parse_trace(call("run --dry-run -q " + kWithJerk + out).out);
    REQUIRE(trace.rows.size() > 100);
    CHECK(off_half_circle(trace) < 0.05 + kOfChords + 0.002);
    CHECK(trace.number(trace.rows.size() - 1, "x_mm") == 0);
    CHECK(trace.number(trace.rows.size() - 1, "y_mm") == 2 * kHalfCircle);
  }
}

TEST_CASE("each form has its codes, and few lines", "[apps][convert]") {
  const Folder folder;
  const std::string part = part_in(folder, half_circle());
  const auto converted = [&](const std::string& form) {
    return call("convert -q " + part + kWithJerk + " -o - --to " + form).out;
  };
  CHECK(times_in(converted("g06.2"), "G06.2 P6 ") >= 1);
  CHECK(times_in(converted("g06.2"), "R1\n") < 20);
  CHECK(times_in(converted("g05.2"), "G05.2 P1 L6") == times_in(converted("g05.2"), "G05.3"));
  CHECK(times_in(converted("g05.2"), "G05.2") >= 2);
  CHECK(times_in(converted("g1"), "G06.2") + times_in(converted("g1"), "G03") == 0);
  CHECK(times_in(converted("g1g2g3"), "G17 G03") >= 2);
  CHECK(times_in(converted("g1g2g3"), "\n") < times_in(converted("g1"), "\n"));
}

TEST_CASE("what is no move stays where it was", "[apps][convert]") {
  const Folder folder;
  const std::string part = part_in(
      folder, half_circle("T1 M06\nS1000 M03\nM08\nG04 P0.5\nG00 Z5\n", "M09\nM05\nG00 Z20\n"));
  const Ended ended = call("convert -q " + part + kWithJerk + " -o -");
  CHECK(ended.status == 0);
  std::size_t at = 0;
  for (const char* word : {"G21 G90", "T1 M06", "S1000 M03", "M08", "G04 P0.5", "G00 X0 Y0 Z5",
                           "G06.2 P6", "M09", "M05", "G00 X0 Y20 Z20", "M30"}) {
    CAPTURE(word, ended.out);
    at = ended.out.find(word, at);
    REQUIRE(at != ended.out.npos);
  }
}

TEST_CASE("the roughness that is asked for is written where it changes", "[apps][convert]") {
  const Folder folder;
  const std::string part =
      part_in(folder,
              "S6000 M03\nG06.4 D5 J0.5 H10.67 L2\nG01 X10 F6000\nG00 Z5\nG01 X20\nG06.5\nX30\n"
              "G06.4 D4 J0.4 H20 L3 R-30 Q12\nX40\nT2 M06\nM03\nG06.4 D4 J0.4 H20 L3\nX50\nM30\n");
  const std::string out = folder / "out.nc";
  CHECK(call("convert -q " + part + " --to g1 -o " + out).status == 0);
  const std::string text = softcnc::test::bytes_of(out);
  CAPTURE(text);
  std::size_t at = 0;
  for (const char* word :
       {"G06.4 D5 J0.5 H10.67 L2\n", "X10", "Z5", "X20", "G06.5\n", "X30",
        "G06.4 D4 J0.4 H20 L3 R-30 Q12\n", "X40", "T2 M06", "G06.4 D4 J0.4 H20 L3\n", "X50"}) {
    CAPTURE(word);
    at = text.find(word, at);
    REQUIRE(at != text.npos);
  }
  CHECK(times_in(text, "G06.4") == 3);
  CHECK(times_in(text, "G06.5") == 1);
}

TEST_CASE("a program with errors is not converted, and no file is left", "[apps][convert]") {
  const Folder folder;
  const std::string part = part_in(folder, "G01 X10 F600\nG01 X\nM30\n");
  const Ended ended = call("convert " + part + " -o " + (folder / "out.nc"));
  CHECK(ended.status == 1);
  CHECK(shows(ended.err, "part.nc:2:"));
  CHECK(folder.files() == std::vector<std::string>{"part.nc"});
  CHECK(call("convert " + part).status == 2);
}
