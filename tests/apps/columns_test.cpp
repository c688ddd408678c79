// SPDX-License-Identifier: MIT
// Columns of the trace on demand: what each is on curves whose figures are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/shell.hpp"

using namespace softcnc;
using namespace softcnc::app::test;

namespace {

constexpr double kRadius = 20, kFeed = 50, kLongPeriod = 0.004;  // mm, mm/s, s

/// A full circle at 4 ms, after a dwell, run by a method.
struct Circle {
  Trace trace;
  nlohmann::json report;

  explicit Circle(const std::string& method) {
    const Folder folder;
    write(folder / "c.nc", "G21 G90 G17 F3000\nG04 P0.02\nG02 X0 Y0 I20 J0\nM30\n");
    const Ended ended =
        call("run -q --dry-run " + (folder / "c.nc") +
             " --set control.period_ms=4 --set control.chord_tolerance_um=5"
             " --set control.interpolation=" +
             method + " --columns u,curvature_1_mm,chord_error_um,feed_fluctuation,rmax_um" +
             " --trace " + (folder / "c.csv") + " --report " + (folder / "c.json"));
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    trace = parse_trace(read(folder / "c.csv"));
    report = nlohmann::json::parse(read(folder / "c.json"));
  }
};

}  // namespace

TEST_CASE("the columns of a circle are those of its closed forms", "[apps][columns]") {
  const Circle circle("arc-length");
  const Trace& trace = circle.trace;
  const std::size_t middle = trace.rows.size() / 2;
  const double chord = kRadius * (1 - std::cos(kFeed * kLongPeriod / (2 * kRadius)));
  CHECK(trace.number(middle, "v_mm_s") == Approx(kFeed));
  CHECK(trace.number(middle, "chord_error_um") == Approx(1e3 * chord).epsilon(1e-6));
  CHECK(trace.number(middle, "curvature_1_mm") == Approx(1 / kRadius));
  CHECK(trace.number(middle, "u") ==
        Approx(trace.number(middle, "s_mm") / (2 * std::numbers::pi * kRadius)));
  CHECK(std::abs(trace.number(middle, "feed_fluctuation")) < 1e-9);
}

TEST_CASE("where there is no path and no roughness a column has no value", "[apps][columns]") {
  const Circle circle("arc-length");
  const Trace& trace = circle.trace;
  CHECK(circle.report["columns"]["rmax_um"].is_null());
  CHECK(trace.word(1, "u") == "nan");
  CHECK(trace.number(1, "chord_error_um") == 0);
  for (std::size_t row = 0; row < trace.rows.size(); ++row)
    REQUIRE(trace.word(row, "rmax_um") == "nan");
}

TEST_CASE("the report has the figures of each column", "[apps][columns]") {
  const std::string method = GENERATE("arc-length", "taylor1", "m-dsm");
  CAPTURE(method);
  const Circle circle(method);
  for (const std::string name : {"chord_error_um", "feed_fluctuation"}) {
    double max = 0, sum = 0, squares = 0, rows = 0;
    for (std::size_t row = 1; row < circle.trace.rows.size(); ++row) {
      const auto s = [&](std::size_t at) { return circle.trace.number(at, "s_mm"); };
      if (s(row) == s(row - 1)) continue;  // the dwell
      ++rows;
      const double value = std::abs(circle.trace.number(row, name));
      max = std::max(max, value);
      sum += value;
      squares += value * value;
    }
    const auto& figures = circle.report["columns"][name];
    CAPTURE(name);
    CHECK(figures["max"].get<double>() == Approx(max));
    CHECK(figures["mean"].get<double>() == Approx(sum / rows));
    CHECK(figures["rms"].get<double>() == Approx(std::sqrt(squares / rows)));
    CHECK(circle.report[name + "_max"].get<double>() == Approx(max));
  }
}

TEST_CASE("rows that a dry run may pass over are all looked at for a column", "[apps][columns]") {
  const Folder folder;
  const auto mean_with = [&](const std::string& trace) {
    const Ended ended = call("run -q --dry-run $programs/07_nurbs.nc --columns chord_error_um " +
                             trace + " --report " + (folder / "n.json"));
    REQUIRE(ended.status == 0);
    const auto report = nlohmann::json::parse(read(folder / "n.json"));
    return report["columns"]["chord_error_um"]["mean"].get<double>();
  };
  CHECK(mean_with("--trace /dev/null") == mean_with(""));
}

TEST_CASE("the roughness of a row is that of paper 004 at its inclination", "[apps][columns]") {
  const Folder folder;
  write(folder / "r.nc",
        "G21 G90 S6000 M03\nG06.4 D5 J0.5 H30 L2\nG01 X30 Z0.9 F6000\nG06.5\nM30\n");
  const Ended ended = call("run -q --dry-run " + (folder / "r.nc") + " --columns all --trace " +
                           (folder / "r.csv") + " --set surface.model=paper");
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  const Trace trace = parse_trace(read(folder / "r.csv"));
  const std::size_t middle = trace.rows.size() / 2;
  const double feed = 0.5, inclination = std::atan(0.9 / 30);
  const double across = 5 * std::sin(inclination);
  const double at_tip = 5 - std::sqrt(25 - feed * feed + across * across);  // equation (3)
  CHECK(trace.number(middle, "f_tooth_mm") == Approx(feed));
  CHECK(trace.number(middle, "inclination_deg") ==
        Approx(inclination * 180 / std::numbers::pi).epsilon(1e-9));
  CHECK(trace.number(middle, "rmax_um") == Approx(1e3 * at_tip).epsilon(1e-6));
}

TEST_CASE("columns that nothing would show are wrong usage", "[apps][columns]") {
  CHECK(call("run $programs/01_line.nc --columns u").status == 2);
  CHECK(call("run $programs/01_line.nc --columns u --trace t.hal").status == 2);
}

TEST_CASE("a column that does not exist is wrong usage", "[apps][columns]") {
  const Ended ended = call("run --dry-run $programs/01_line.nc --columns u,chord");
  CHECK(ended.status == 2);
  CHECK(shows(ended.err, "did you mean 'chord_error_um'?"));
}
