// SPDX-License-Identifier: MIT
// softcnc compare: interpolation methods side by side as text, CSV and JSON.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/shell.hpp"
#include "motion/model/machine.hpp"
#include "output/comparison_rows.hpp"
#include "runtime/comparison/compared_figure.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;
using nlohmann::json;

namespace {

/// A full circle of radius 20 mm at 100 mm/s, approached along its tangent's normal.
const std::string kFullCircle = "G21 G90 G00 X20\nG03 X20 Y0 I-20 J0 F6000\nM30\n";

json compared(const std::string& arguments, const std::string& input = {}) {
  const Ended ended = call("compare -q --format json " + arguments, input);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return json::parse(ended.out);
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

/// A row with the same spread for each figure, except the second, which means nothing.
ComparisonRow row(Method method, double median, double worst, int phases) {
  ComparisonRow row{"a, \"b\".nc", "mill", "", method, phases, {}, {}};
  row.spreads.assign(runtime::compared_figures().size(), runtime::Spread{median, worst});
  row.spreads[1].reset();
  return row;
}

ComparisonRow refused() {
  ComparisonRow refused = row(Method::dda, 0, 0, 4);
  for (auto& spread : refused.spreads) spread.reset();
  refused.note = "cannot";
  return refused;
}

}  // namespace

TEST_CASE("a comparison has a row for each method, in the order of their names",
          "[apps][compare]") {
  const json document = compared("- --phases 2", kFullCircle);
  CHECK(document["schema"] == 1);
  std::vector<std::string> methods;
  for (const json& row : document["rows"]) {
    methods.push_back(row["method"]);
    CHECK(row["program"] == "<stdin>");
    CHECK(row["machine"] == "retrofitted mill (built-in)");
    CHECK(row["machine_file"].is_null());
    CHECK(row["phases"] == 2);
    CHECK(row["note"].is_null());
    CHECK(row["time_s_worst"] >= row["time_s_median"]);
    CHECK(row["jerk_over_limit_worst"].is_null());  // no axis has a limit of it
  }
  CHECK(methods == std::vector<std::string>(kMethodNames.begin(), kMethodNames.end()));
}

TEST_CASE("the chord error of a circle is its sagitta, wherever it begins", "[apps][compare]") {
  const json row = compared("- --methods arc-length", kFullCircle)["rows"][0];
  const double r = 20, step = 100 * 0.001;  // mm of arc
  const double sagitta_um = 1000 * r * (1 - std::cos(step / (2 * r)));
  CHECK(row["phases"] == 16);
  for (const char* part : {"chord_error_um_max_median", "chord_error_um_max_worst"}) {
    CHECK(row[part].get<double>() == Approx(sagitta_um).epsilon(1e-6));
    // Paper 000, equation 5, takes the step for the chord.
    CHECK(row[part].get<double>() ==
          Approx(1000 * (r - std::sqrt(r * r - step * step / 4))).epsilon(3e-6));
  }
  CHECK(row["chord_error_um_rms_worst"].get<double>() < sagitta_um);
  CHECK(row["feed_fluctuation_rms_worst"].get<double>() < 1e-9);
  CHECK(row["feed_fluctuation_p99_worst"].get<double>() < 1e-9);
  const double half = step / (2 * r), shorter = 1 - std::sin(half) / half;
  for (const char* part : {"chord_fluctuation_max_median", "chord_fluctuation_max_worst",
                           "chord_fluctuation_p99_median"})
    CHECK(row[part].get<double>() == Approx(shorter).epsilon(1e-4));
  CHECK(row["path_deviation_um_max_worst"].get<double>() < 1e-6);
  CHECK(row["acceleration_over_limit_worst"].get<double>() == Approx(1).epsilon(1e-3));
  // The position loop makes the circle smaller by v^2 / (2 r Kv^2).
  CHECK(row["contour_error_um_rms_median"].get<double>() ==
        Approx(1000 * 100 * 100 / (2 * r * 30 * 30)).epsilon(0.2));
}

TEST_CASE("one phase has the figures of the report of a run", "[apps][compare]") {
  const Folder folder;
  const std::string method = GENERATE("arc-length", "taylor2", "m-dsm");
  const json row = compared("$programs/08_butterfly.nc --phases 1 --methods " + method)["rows"][0];
  REQUIRE(call("run -q $programs/08_butterfly.nc --set control.interpolation=" + method +
               " --report " + (folder / "r.json"))
              .status == 0);
  const json report = json::parse(read(folder / "r.json"));
  const std::vector<std::string> of_all{"time_s", "path_deviation_um_max", "contour_error_um_max",
                                        "contour_error_um_rms"};
  const std::vector<std::string> of_chords{
      "chord_error_um_max",    "feed_fluctuation_max",  "feed_fluctuation_rms",
      "feed_fluctuation_p99",  "chord_fluctuation_max", "chord_fluctuation_rms",
      "chord_fluctuation_p99",
  };
  for (const auto& names : {of_all, of_chords})
    for (const std::string& name : names)
      for (const char* part : {"_median", "_worst"}) {
        CAPTURE(method, name);
        if (names == of_chords && method == "m-dsm")
          CHECK(row[name + part].is_null());
        else
          CHECK(row[name + part] == report[name]);
      }
}

TEST_CASE("phases shift the samples along the path, not the path in time", "[apps][compare]") {
  const std::string common = "$programs/08_butterfly.nc --methods taylor1 --phases ";
  const json one = compared(common + "1")["rows"][0], four = compared(common + "4")["rows"][0];
  CHECK(four["feed_fluctuation_max_worst"] > one["feed_fluctuation_max_worst"]);
  CHECK(four["feed_fluctuation_max_worst"] > four["feed_fluctuation_max_median"]);
  CHECK(four["time_s_worst"].get<double>() ==
        Approx(one["time_s_worst"].get<double>()).margin(0.0011));  // rows are 1 ms apart
}

TEST_CASE("on a line no chord fluctuates", "[apps][compare]") {
  const json rows = compared("- --phases 4 --methods arc-length,taylor1,chords,acc-dec-linear",
                             "G21 G90 G01 X30 Y40 F6000\nM30\n")["rows"];
  for (const json& row : rows) {
    CAPTURE(row["method"]);
    CHECK(row["chord_fluctuation_max_worst"].get<double>() < 1e-9);
    CHECK(row["feed_fluctuation_max_worst"].get<double>() < 1e-9);
  }
}

TEST_CASE("the corner from a rapid to a cut is no fluctuation of chords", "[apps][compare]") {
  const double step = 100 * 0.001, r = 20;  // mm of chord
  const json row = compared("- --methods chords --phases 8", kFullCircle)["rows"][0];
  const double half = std::asin(step / (2 * r));
  CHECK(row["feed_fluctuation_max_worst"].get<double>() ==
        Approx(half / std::sin(half) - 1).epsilon(0.01));
}

TEST_CASE("with the backend none no mill is simulated", "[apps][compare]") {
  const std::string common = "- --phases 2 --methods taylor1";
  json mill = compared(common, kFullCircle)["rows"][0];
  const json none = compared(common + " --set control.backend=none", kFullCircle)["rows"][0];
  for (const char* key : {"contour_error_um_max_median", "contour_error_um_max_worst",
                          "contour_error_um_rms_median", "contour_error_um_rms_worst"}) {
    CHECK(none[key].is_null());
    CHECK(mill[key] > 0);
    mill[key] = nullptr;
  }
  CHECK(none == mill);
}

TEST_CASE("CSV and JSON have the same keys and numbers", "[apps][compare]") {
  const std::string arguments = "- --phases 3 --methods taylor2,arc-length";
  const json document = compared(arguments, kFullCircle);
  const Ended ended = call("compare -q --format csv " + arguments, kFullCircle);
  std::istringstream lines(ended.out);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = fields(line);
  REQUIRE(document["rows"].size() == 2);
  CHECK(document["rows"][0]["method"] == "taylor2");  // as asked for
  for (const json& row : document["rows"]) {
    REQUIRE(std::getline(lines, line));
    auto values = fields(line);
    values.resize(header.size());  // the last field is empty
    REQUIRE(row.size() == header.size());
    for (std::size_t i = 0; i < header.size(); ++i) {
      const json& value = row.at(header[i]);
      CAPTURE(header[i]);
      if (value.is_null()) CHECK(values[i].empty());
      if (value.is_string()) CHECK(values[i] == value);
      if (value.is_number()) CHECK(std::stod(values[i]) == value.get<double>());
    }
  }
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("a comparison as text has a table of medians and one of the worst", "[apps][compare]") {
  const std::vector<ComparisonRow> rows{row(Method::arc_length, 1.5, 2.25, 4), refused()};
  const std::string text = comparison_text(rows);
  const std::string columns =
      "   time, s   max, um   rms, um   max, um       max       rms      99 %       max       rms"
      "      99 %     limit     limit   max, um   rms, um\n";
  const auto figures = [](const std::string& value) {
    const std::string cell = std::string(10 - value.size(), ' ') + value;
    std::string line = cell + "         -";
    for (std::size_t i = 2; i < runtime::compared_figures().size(); ++i) line += cell;
    return line + '\n';
  };
  CHECK(text.starts_with("a, \"b\".nc on mill, begun at 4 places within the period\n\n"));
  CHECK(shows(text, "\nmedian        " + columns));
  CHECK(text.find("\narc-length    " + figures("1.5")) != text.npos);
  CHECK(text.find("\narc-length    " + figures("2.25")) != text.npos);
  CHECK(text.find("\ndda             cannot\n") != text.npos);
  std::istringstream lines(text.substr(text.find("\nmedian ") + 1));
  std::string header, line;
  REQUIRE((std::getline(lines, header) && std::getline(lines, line)));
  CHECK(header.size() == line.size());  // each figure has its heading
  const std::string single = comparison_text(std::vector{row(Method::arc_length, 3, 3, 1)});
  CHECK(single.starts_with("a, \"b\".nc on mill\n\n"));
  CHECK(single.find("\nmethod  ") != single.npos);
  CHECK(single.find("worst") == single.npos);
}

TEST_CASE("a note and a name with commas stand in CSV and JSON", "[apps][compare]") {
  const std::vector<ComparisonRow> rows{refused()};
  const std::string csv = comparison_csv(rows);
  const std::string empty(2 * runtime::compared_figures().size(), ',');
  CHECK(csv.substr(csv.find('\n') + 1) == "\"a, \"\"b\"\".nc\",mill,,dda,4" + empty + ",cannot\n");
  const json row = json::parse(comparison_json(rows))["rows"][0];
  CHECK(row["program"] == "a, \"b\".nc");
  CHECK(row["note"] == "cannot");
  CHECK(row["time_s_median"].is_null());
}

TEST_CASE("a method that cannot run a program does not keep others from it", "[apps][compare]") {
  const json document = compared(
      "- --phases 1 --methods dda,arc-length --set control.pulse_clock=paper "
      "--set axis.y.blu_um=5",
      kFullCircle);
  CHECK(document["rows"][0]["note"].get<std::string>().ends_with("[SC7080]"));
  CHECK(document["rows"][0]["time_s_median"].is_null());
  CHECK(document["rows"][1]["note"].is_null());
  CHECK(document["rows"][1]["time_s_median"] > 1);
}

TEST_CASE("a method that does not fit the machine has the reason as its note", "[apps][compare]") {
  const auto note = [](const std::string& settings, const std::string& method) {
    const json document = compared("- --phases 1 --methods " + method + settings, kFullCircle);
    const json& reason = document["rows"][0]["note"];
    return reason.is_null() ? std::string() : reason.get<std::string>();
  };
  CHECK(shows(note(" --set control.period_ms=20 --set control.servo_period_ms=1", "two-step"),
              "rough_period_ms...[SC7082]"));
  CHECK(shows(note(" --set axis.x.acceleration_mm_s2=0.001", "acc-dec-linear"), "[SC7083]"));
  CHECK(note("", "two-step").empty());
}

TEST_CASE("acceleration after interpolation is the same motion in every phase", "[apps][compare]") {
  const json rows = compared("- --phases 4 --methods acc-dec-linear,two-step", kFullCircle)["rows"];
  for (const json& row : rows) {
    CHECK(row["chord_error_um_max_worst"].is_null());  // it is off the path
    const double median = row["time_s_median"].get<double>();
    CHECK(row["time_s_worst"].get<double>() - median < 0.0011);  // rounded to whole rows
    CHECK(row["path_deviation_um_max_worst"].get<double>() ==
          Approx(row["path_deviation_um_max_median"].get<double>()).epsilon(0.02));
  }
  // The circle shrinks to sin(x) / x, and the speed at least with it.
  const double x = 0.5 * 0.25 * 100 / 20;
  CHECK(rows[0]["feed_fluctuation_rms_median"].get<double>() > 1 - std::sin(x) / x);
}

TEST_CASE("standard input is one program of a comparison", "[apps][compare]") {
  CHECK(call("compare - -", kFullCircle).status == 2);
}

TEST_CASE("each program is compared on each machine", "[apps][compare]") {
  const Folder folder;
  write(folder / "fast.toml",
        "name = \"fast\"\n[axis.x]\nacceleration_mm_s2 = 4000\n[axis.y]\nacceleration_mm_s2 = "
        "4000\n");
  write(folder / "a.nc", kFullCircle);
  write(folder / "b.nc", "G01 X10 F600\nM30\n");
  const json rows = compared((folder / "a.nc") + " " + (folder / "b.nc") +
                             " --phases 1 --methods arc-length --machine builtin --machine " +
                             (folder / "fast.toml"))["rows"];
  REQUIRE(rows.size() == 4);
  CHECK(rows[0]["program"] == folder / "a.nc");
  CHECK(rows[3]["program"] == folder / "b.nc");
  CHECK(rows[0]["machine_file"].is_null());
  CHECK(rows[1]["machine"] == "fast");
  CHECK(rows[1]["machine_file"] == folder / "fast.toml");
  CHECK(rows[1]["time_s_median"] < rows[0]["time_s_median"]);
}

TEST_CASE("of a wrong program the errors are shown, and nothing is compared", "[apps][compare]") {
  const Folder folder;
  write(folder / "good.nc", kFullCircle);
  write(folder / "bad.nc", "G01 X10 F600\nG02 X1\nM30\n");
  write(folder / "out.csv", "before");
  const Ended ended = call("compare --format csv " + (folder / "good.nc") + " " +
                           (folder / "bad.nc") + " -o " + (folder / "out.csv"));
  CHECK(ended.status == 1);
  CHECK(ended.out.empty());
  CHECK(shows(ended.err, "bad.nc:2:5: error: G02 needs a centre or R [SC2107]"));
  CHECK(read(folder / "out.csv") == "before");
  CHECK(call("compare " + (folder / "none.nc")).status == 5);
  CHECK(call("compare " + (folder / "good.nc") + " --machine " + (folder / "none.toml")).status ==
        2);
  CHECK(call("compare " + (folder / "good.nc") + " -o " + (folder / "good.nc")).status == 2);
}

TEST_CASE("a comparison can be written to a file", "[apps][compare]") {
  const Folder folder;
  const std::string arguments = "compare - --phases 1 --methods arc-length --format json";
  const Ended ended = call(arguments + " -o " + (folder / "c.json"), kFullCircle);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err == "comparison written to " + (folder / "c.json") + "\n");
  CHECK(read(folder / "c.json") == call(arguments, kFullCircle).out);
}

TEST_CASE("unknown methods and impossible phases are wrong usage", "[apps][compare]") {
  const auto refused_words = [](const std::string& words) {
    const Ended ended = call("compare $programs/03_arc.nc " + words);
    CAPTURE(words, ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    return ended.err;
  };
  CHECK(shows(refused_words("--methods taylor3"), "'taylor3' is not one of all, arc-length, "));
  CHECK(shows(refused_words("--methods arc-length,m-dms"), "; did you mean 'm-dsm'?"));
  CHECK(shows(refused_words("--format jsn"),
              "'jsn' is not one of text, csv, json; did you mean 'json'?"));
  for (const char* phases : {"0", "-1", "1001", "2.5", "many"})
    CHECK(shows(refused_words(std::string("--phases ") + phases), "--phases"));
  CHECK(shows(refused_words("--phase 4"), "did you mean '--phases'?"));
}
