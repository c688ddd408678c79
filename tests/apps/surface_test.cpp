// SPDX-License-Identifier: MIT
// softcnc surface: what it writes, what it says, what it refuses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/shell.hpp"
#include "hal/files/npz_file.hpp"
#include "support/milled.hpp"
#include "support/shown.hpp"
#include "surface/roughness_map.hpp"
#include "surface/surface_bands.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;
using nlohmann::json;

namespace {

std::string program_file(const std::string& name) {
  return std::string(SOFTCNC_SOURCE_DIR) + "/programs/" + name;
}

const std::string kTool = " --set tool.1.radius_mm=5 --set tool.1.teeth=2 ";
const std::string kStock =
    " --set 'stock.origin_mm=[2, 1, -1]' --set stock.x_mm=2 --set stock.y_mm=1 --set "
    "stock.z_mm=3 ";

/// What numpy makes of an expression in f, the arrays of a file.
std::string numpy(const std::string& file, const std::string& expression) {
  const Ended ended = shell("/usr/bin/python3 -c \"import numpy; f = numpy.load('" + file +
                            "'); print(" + expression + ")\"");
  CHECK(ended.err.empty());
  return ended.out;
}

double number(const std::string& file, const std::string& expression) {
  return std::stod(numpy(file, expression));
}

Ended cut(const std::string& file, const std::string& options = {}) {
  return call("surface -q $data/plane.nc" + kTool + kStock + options + " -o " + file);
}

}  // namespace

TEST_CASE("a surface as arrays is what numpy reads", "[apps][surface]") {
  const Folder folder;
  const std::string file = folder / "plane.npz";
  const Ended ended = cut(file);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err.empty());
  CHECK(folder.files() == std::vector<std::string>{"plane.npz"});
  CHECK(numpy(file, "sorted(f.files)") ==
        "['gouges_um', 'heights_mm', 'met', 'origin_mm', 'region_mm', 'rmax_um', 'step_mm', "
        "'target_um']\n");
  CHECK(numpy(file, "numpy.isnan(f['met']).all(), numpy.isnan(f['target_um']).all()") ==
        "True True\n");
  CHECK(numpy(file, "f['heights_mm'].shape, f['heights_mm'].dtype") == "(101, 201) float32\n");
  CHECK(numpy(file, "f['origin_mm'].tolist(), f['step_mm'], f['region_mm']") ==
        "[2.0, 1.0, -1.0] 0.01 0.5\n");
  CHECK(number(file, "1000 * (f['heights_mm'].max() - 1)") == Approx(24.9).epsilon(0.05));
  CHECK(number(file, "1000 * (f['heights_mm'].min() - 1)") == Approx(0).margin(0.01));
  CHECK(number(file, "f['rmax_um'][:2, :4].min()") == Approx(24.9).epsilon(0.05));
  CHECK(number(file, "f['rmax_um'][:2, :4].max()") == Approx(24.9).epsilon(0.05));
}

TEST_CASE("the same surface is the same bytes", "[apps][surface]") {
  const Folder folder;
  for (const char* form : {".npz", ".png"}) {
    REQUIRE(cut(folder / ("a" + std::string(form))).status == 0);
    REQUIRE(cut(folder / ("b" + std::string(form))).status == 0);
    CHECK((read(folder / ("a" + std::string(form))) == read(folder / ("b" + std::string(form)))));
  }
}

TEST_CASE("a picture is a PNG", "[apps][surface]") {
  const Folder folder;
  CHECK(cut(folder / "plane.png").status == 0);
  const std::string bytes = read(folder / "plane.png");
  CHECK(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(bytes.size() > 20000);
  CHECK(bytes.substr(bytes.size() - 8, 4) == "IEND");
  CHECK(folder.files() == std::vector<std::string>{"plane.png"});
}

TEST_CASE("what was cut is summed up", "[apps][surface]") {
  const Folder folder;
  const Ended ended =
      call("surface $data/plane.nc" + kTool + kStock + " -o " + (folder / "plane.npz"));
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  for (const char* text :
       {"stock        2 x 1 x 3 mm from X2 Y1 Z-1", "201 x 101 points, one every 10 um",
        "on average over", "regions of 0.5 x 0.5 mm", "million per second and core", "memory"})
    CHECK(ended.err.find(text) != std::string::npos);
}

TEST_CASE("without a stock of its own a program has one around it", "[apps][surface]") {
  const Folder folder;
  const std::string file = folder / "plane.npz";
  REQUIRE(call("surface -q $data/plane.nc" + kTool + "--set stock.grid_um=50 -o " + file).status ==
          0);
  CHECK(numpy(file, "f['heights_mm'].shape, f['origin_mm'].tolist()") ==
        "(261, 321) [-5.0, -5.0, 0.0]\n");
  CHECK(number(file, "f['heights_mm'][0, 0]") == 5);
  CHECK(number(file, "f['heights_mm'][130, 160]") < 0.03);
}

TEST_CASE("the spindle's phase counts, and so does where the mill really is", "[apps][surface]") {
  const Folder folder;
  REQUIRE(cut(folder / "aligned.npz").status == 0);
  REQUIRE(cut(folder / "time.npz", "--set surface.phase=time").status == 0);
  REQUIRE(cut(folder / "actual.npz", "--actual").status == 0);
  const std::string aligned = read(folder / "aligned.npz");
  CHECK((aligned != read(folder / "time.npz")));
  CHECK((aligned != read(folder / "actual.npz")));
  CHECK(number(folder / "actual.npz", "f['rmax_um'][:2, :4].max()") > 15);
  CHECK(number(folder / "actual.npz", "f['rmax_um'][:2, :4].max()") < 40);
}

TEST_CASE("fast passes are in phase, though they begin between rows", "[apps][surface]") {
  const Folder folder;
  std::string text = read(softcnc::app::test::data("plane.nc"));
  text.replace(text.find("S600 "), 5, "S6000 ");
  text.replace(text.find("X6 F600"), 7, "X20 F6000");
  write(folder / "fast.nc", text);
  const auto spread = [&](const std::string& options) {
    REQUIRE(
        call("surface -q " + (folder / "fast.nc") + kTool +
             " --set 'stock.origin_mm=[9, 0.5, -1]' --set stock.x_mm=1 --set stock.y_mm=2 --set "
             "stock.z_mm=3 " +
             options + " -o " + (folder / "fast.npz"))
            .status == 0);
    return number(folder / "fast.npz",
                  "1000 * abs(f['heights_mm'][:100] - f['heights_mm'][100:200]).mean()");
  };
  CHECK(spread("") < 0.2);
  CHECK(spread("--set axis.x.jerk_mm_s3=50000") < 0.2);
  CHECK(spread("--set surface.phase=time") > 1);
}

TEST_CASE("the target and the teeth may stand in the program", "[apps][surface]") {
  const Folder folder;
  std::string text = read(softcnc::app::test::data("plane.nc"));
  text.replace(text.find("#1 = 0"), 6, "G06.4 D5 J0.5 H25.1 L2\n#1 = 0");
  write(folder / "own.nc", text);
  REQUIRE(
      call("surface -q " + (folder / "own.nc") + kStock + " -o " + (folder / "own.npz")).status ==
      0);
  CHECK(number(folder / "own.npz", "f['rmax_um'][:2, :4].max()") == Approx(24.9).epsilon(0.05));
}

TEST_CASE("a tool that stands in the program turns on between its passes", "[apps][surface]") {
  const Folder folder;
  std::string text = read(softcnc::app::test::data("plane.nc"));
  text.replace(text.find("#1 = 0"), 6, "G06.4 D5 J0.5 H25.1 L2\n#1 = 0");
  write(folder / "own.nc", text);
  for (const char* phase : {"aligned", "time"})
    REQUIRE(call("surface -q " + (folder / "own.nc") + kStock + "--set surface.phase=" + phase +
                 " -o " + (folder / (std::string(phase) + ".npz")))
                .status == 0);
  CHECK((read(folder / "aligned.npz") != read(folder / "time.npz")));
}

TEST_CASE("a surface reports by region whether its target is met", "[apps][surface]") {
  const Folder folder;
  const auto cut_for = [&](const std::string& target) {
    std::string text = read(softcnc::app::test::data("plane.nc"));
    text.replace(text.find("#1 = 0"), 6, "G06.4 D5 J0.5 H" + target + " L2\n#1 = 0");
    write(folder / "own.nc", text);
    return call("surface " + (folder / "own.nc") + kStock + "--set surface.model=paper -o " +
                (folder / "own.npz") + " --report " + (folder / "own.json"));
  };
  const Ended met = cut_for("26");
  CHECK(met.status == 0);
  CHECK(met.err.find("SC4040") == std::string::npos);
  CHECK(met.err.find("\n  target       met in all 8 regions that have one\n") != std::string::npos);
  CHECK(number(folder / "own.npz", "numpy.nansum(f['met'])") == 8);  // 2 x 1 mm, 0.5 x 0.5 each
  CHECK(number(folder / "own.npz", "numpy.nanmax(f['target_um'])") == 26);
  json report = json::parse(read(folder / "own.json"));
  CHECK(report["regions_judged"] == 8);
  CHECK(report["regions_missed"] == 0);
  CHECK(report["missed"] == json::array());

  // The feed of the paper's model leaves 7 % more than these 9 um, where the tip has just begun to
  // cut.
  const Ended missed = cut_for("9");
  CHECK(missed.status == 0);
  const double most = number(folder / "own.npz", "numpy.nanmax(f['rmax_um'])");
  CHECK(most > 9);
  CHECK(shows(missed.err, "own.nc: warning: an Rmax of 9... [SC4040]"));
  CHECK(missed.err.find("(target 9 um) at X") != std::string::npos);
  CHECK(number(folder / "own.npz", "int(((f['met'] == 0) == (f['rmax_um'] > 9.00001)).all())") ==
        1);
  report = json::parse(read(folder / "own.json"));
  CHECK(report["regions_missed"] ==
        static_cast<int>(number(folder / "own.npz", "(f['met'] == 0).sum()")));
  CHECK(report["missed"].size() == report["regions_missed"]);
  CHECK(report["missed"][0]["rmax_target_um"] == 9);
  CHECK(report["rmax_um_max"].get<double>() == Approx(most));
}

TEST_CASE("a report says null of what is not known, and the summary why", "[apps][surface]") {
  const Folder folder;
  const std::string files = "-o " + (folder / "own.npz") + " --report " + (folder / "own.json");
  const std::string head = "S600 M03 F600\nG06.4 D1 J0.77 H200 L2\n";
  const std::string pass = "G01 X4\nG00 Z5\nX0 Y0.77\nZ0\n";
  const Ended ended =
      call("surface --set stock.grid_um=50 - " + files, head + pass + pass + "M30\n");
  CHECK(ended.status == 0);
  CHECK(ended.err.find("Rmax         unknown: the pick-feed exceeds 0.76 of the tool radius") !=
        std::string::npos);
  const json report = json::parse(read(folder / "own.json"));
  CHECK(report.contains("rmax_um_max"));
  CHECK(report["rmax_um_max"].is_null());
  CHECK(report["rmax_um_mean"].is_null());
}

TEST_CASE("the surfaces of paper 004 are as rough as it says", "[apps][surface][paper004]") {
  const Folder folder;
  const std::string file = folder / "surface.npz";
  const auto cut_program = [&](const std::string& name, const std::string& options,
                               const std::string& text) {
    write(folder / "program.nc", text);
    const Ended ended =
        call("surface -q " + (folder / "program.nc") + " --machine $programs/" + name +
             ".toml --set 'stock.origin_mm=[-25, 0, -10]' --set stock.x_mm=100 --set "
             "stock.y_mm=1.5 --set stock.z_mm=80 --set stock.grid_um=12.5 " +
             options + " -o " + file);
    CHECK(ended.status == 0);
    return ended;
  };
  const std::string cylinder = "20_paper004_cylinder", hill = "21_paper004_surface";
  const std::string most = "numpy.nanmax(f['rmax_um'])";
  const std::string known = "(~numpy.isnan(f['rmax_um'])).sum()";
  const std::string tip = "numpy.nanmax(f['rmax_um'][:, 49:51])";  // at X0
  for (const std::string& name : {cylinder, hill}) {
    CAPTURE(name);
    const std::string text = read(program_file(name + ".nc"));
    cut_program(name, "", text);
    CHECK(number(file, known) > 200);
    CHECK(number(file, most) <= 10.67 + 2);
    const Ended guaranteed = cut_program(name, "--set surface.model=guaranteed", text);
    CHECK(guaranteed.err.find("SC4040") == std::string::npos);
    CHECK(number(file, known) > 200);
    CHECK(number(file, most) <= 10.67);
    CHECK(number(file, most) > 10);
    CHECK(number(file, "(f['met'] == 0).sum()") == 0);
  }
  std::string fixed = read(program_file(cylinder + ".nc"));
  fixed.replace(fixed.find("H10.67 L2\n"), 9, "H100 L2");
  cut_program(cylinder, "", fixed);
  CHECK(number(file, tip) > 2 * 10.67);
  CHECK(number(file, tip) < 2.5 * 10.67);
  CHECK(number(file, "numpy.nanmax(f['rmax_um'][:, :30])") < 10.67 + 0.5);
}

TEST_CASE("Ctrl-C ends the cutting at once and leaves no file", "[apps][surface]") {
  const Folder folder;
  const Ended ended = shell(
      "$softcnc surface -q $data/plane.nc --set tool.1.radius_mm=5 --set tool.1.teeth=90 --set "
      "stock.grid_um=1 -o " +
      (folder / "x.npz") + " & pid=$!; sleep 1; kill -INT $pid; wait $pid");
  CHECK(ended.status == 130);
  CHECK(ended.err.empty());
  CHECK(folder.files().empty());
}

TEST_CASE("a surface that cannot be cut is refused, and no file is left", "[apps][surface]") {
  const Folder folder;
  const std::string file = folder / "x.npz";
  const auto refused = [&](const std::string& arguments, int status, const std::string& text) {
    const Ended ended = call("surface -q " + arguments);
    CAPTURE(arguments, ended.err);
    CHECK(ended.status == status);
    CHECK(ended.out.empty());
    CHECK(shows(ended.err, text));
  };
  const Folder programs;
  const auto program = [&](const std::string& text) {
    write(programs / "p.nc", text);
    return programs / "p.nc";
  };
  refused("$data/plane.nc -o " + file, 1,
          "plane.nc:9:3: error: no tool with a radius and teeth is in the spindle [SC2380]");
  refused(
      "$data/plane.nc --set tool.1.radius_mm=5 --set tool.1.teeth=101 -o " + file, 3,
      "plane.nc:9:3: error: a tool of 101 teeth; a surface can be cut with at most 100 [SC4041]");
  refused(program("T1 M06\nG01 X5 F100\nM30\n") + kTool + "-o " + file, 1,
          ":2:1: error: a cutting move while the spindle stands still [SC2381]");
  refused(program("T1 M06\nS100 M03\nG00 X5\nM30\n") + kTool + "-o " + file, 1,
          "p.nc: error: the program has no cutting move [SC2382]");
  refused(program("T1 M06\nS100 M03\nG01 X5 F100 Q\nM30\n") + kTool + "-o " + file, 1, "p.nc:3:");
  refused("$data/plane.nc" + kTool + "-o " + (folder / "x.obj"), 2,
          "x.obj: error: no form of a surface has this suffix; known are .npz, .png [SC6060]");
  refused("$data/plane.nc" + kTool + "--set stock.x_mm=90000 --set stock.grid_um=1 -o " + file, 2,
          "softcnc: error: a surface of 90000001 x 13001 points, one every 1 um: at most 200000 "
          "along X and 4000000000 in total are possible [SC7050]\n");
  refused("$data/plane.nc" + kTool + "--set 'stock.origin_mm=[2, 1, 50]' -o " + file, 1,
          "error: the stock lies outside everything that the program cuts [SC2382]");
  refused("$data/plane.nc" + kTool + "-o " + (folder / "no/x.npz"), 5, "error: ... [SC6011]");
  refused("$data/plane.nc" + kTool + "--set axis.x.max_mm=3 -o " + file, 3, "error: ... [SC4001]");
  refused("$data/plane.nc" + kTool, 2, "--output");
  refused("$data/plane.nc" + kTool + "-o $data/plane.nc", 2, "name the same file");
  CHECK(folder.files().empty());
}

TEST_CASE("a surface on a full disk ends with 5", "[apps][surface]") {
  const Folder folder;
  for (const char* form : {"x.npz", "x.png"}) {
    REQUIRE(shell("ln -s /dev/full " + (folder / form)).status == 0);
    const Ended ended = cut(folder / form);
    CHECK(ended.status == 5);
    CHECK(shows(ended.err, "error: ... [SC6012]"));
  }
}

TEST_CASE("bands are the same whatever the number of threads", "[apps][surface]") {
  const auto track = softcnc::test::milled({.incline = 4}, 9, 6);
  const auto grid = softcnc::test::grid_of(0.5, 0.5, 5, 3, 0.01);
  const surface::Workpiece workpiece(track, grid);
  const auto cut_by = [&](unsigned threads) {
    std::vector<float> all;
    const auto updates = surface::cut_bands(
        workpiece, threads, [&](const surface::SurfaceBand& band) -> Result<bool> {
          CHECK(band.columns == grid.columns);
          all.insert(all.end(), band.heights.begin(), band.heights.end());
          return true;
        });
    REQUIRE(updates);
    all.push_back(static_cast<float>(*updates));
    return all;
  };
  const auto alone = cut_by(1);
  CHECK(alone.size() ==
        static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1);
  CHECK((alone == cut_by(2)));
  CHECK((alone == cut_by(5)));
}

TEST_CASE("whoever takes bands may end the work", "[apps][surface]") {
  const auto track = softcnc::test::milled({}, 3, 2);
  const auto grid = softcnc::test::grid_of(0, 0, 1, 20, 0.02);
  const surface::Workpiece workpiece(track, grid);
  int bands = 0;
  const surface::TakeBand take = [&](const surface::SurfaceBand&) -> Result<bool> {
    return ++bands < 2;
  };
  CHECK(surface::cut_bands(workpiece, 1, take));
  CHECK(bands == 2);
}

TEST_CASE("a stop ends the work within a band", "[apps][surface]") {
  const auto track = softcnc::test::milled({}, 3, 2);
  const auto grid = softcnc::test::grid_of(0, 0, 4, 4, 0.01);
  const surface::Workpiece workpiece(track, grid);
  for (const unsigned threads : {1U, 3U}) {
    // Only the caller's thread asks; among others it may come to no tile but its first.
    const int patience = threads == 1 ? 10 : 0;
    int asked = 0, bands = 0;
    const surface::TakeBand take = [&](const surface::SurfaceBand&) -> Result<bool> {
      return ++bands > 0;
    };
    CHECK(surface::cut_bands(workpiece, threads, take, [&] { return ++asked > patience; }));
    CHECK(bands == 0);
    CHECK(asked < 16);
  }
}

TEST_CASE("a region meets its target if every point of it does", "[apps][surface]") {
  constexpr int kBlock = surface::Workpiece::kBlock;
  surface::StockGrid grid;
  grid.columns = 4 * kBlock;
  grid.rows = kBlock;
  surface::SurfaceBand band{0, kBlock, 4 * kBlock, {}, {}, {0.008F, 0.020F, 0.010F, 0}};
  band.deviations.assign(static_cast<std::size_t>(4 * kBlock * kBlock), 0.009F);
  const auto judged = [&](int side, surface::HeightFrom from) {
    surface::RoughnessMap map(grid, side, from);
    map.add(band);
    return map;
  };
  const auto met = judged(kBlock, surface::HeightFrom::ideal).met();
  CHECK(met[0] == 0);
  CHECK(met[1] == 1);
  CHECK(met[2] == 1);
  CHECK(std::isnan(met[3]));
  CHECK(judged(kBlock, surface::HeightFrom::lowest).met()[0] == 1);  // it is flat
  const surface::RoughnessMap wide = judged(2 * kBlock, surface::HeightFrom::ideal);
  CHECK(wide.met()[0] == 0);
  CHECK(wide.targets()[0] == Approx(8));
  CHECK(wide.met()[1] == 1);
  const surface::TargetFigures target = surface::target_figures(wide);
  CHECK(target.judged == 2);
  CHECK(target.missed == 1);
  CHECK(target.worst == 0);
  CHECK(target.rmax == Approx(9));
  CHECK(target.target == Approx(8));
}

TEST_CASE("a region is as rough as its highest point, and unknown where most of it is",
          "[apps][surface]") {
  surface::StockGrid grid;
  grid.columns = 6;
  grid.rows = 3;
  surface::RoughnessMap map(grid, 3);
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  surface::SurfaceBand band{0, 3, 6, std::vector<float>(18), std::vector<float>(18, unknown), {}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) band.deviations[band.index(column, row)] = 0.001F;
  band.deviations[band.index(1, 2)] = 0.004F;
  band.deviations[band.index(5, 0)] = 0.009F;
  map.add(band);
  const auto rmax = map.rmax();
  REQUIRE(rmax.size() == 2);
  CHECK(rmax[0] == Approx(4));
  CHECK(std::isnan(rmax[1]));
  CHECK(surface::figures(rmax).largest == Approx(4));
  CHECK(surface::figures(rmax).regions == 1);
  CHECK(map.gouges() == std::vector<float>{0, 0});
}

TEST_CASE("what the edge of the grid leaves of a region is no region", "[apps][surface]") {
  surface::StockGrid grid;
  grid.columns = 5;
  grid.rows = 3;
  surface::RoughnessMap map(grid, 2);
  surface::SurfaceBand band{0, 3, 5, std::vector<float>(15), std::vector<float>(15, 0.001F), {}};
  band.deviations[band.index(4, 0)] = 0.009F;
  band.deviations[band.index(1, 2)] = -0.02F;  // a gouge is one wherever it is
  map.add(band);
  const auto rmax = map.rmax();
  REQUIRE(rmax.size() == 6);
  CHECK(surface::figures(rmax).regions == 2);
  CHECK(surface::figures(rmax).mean == Approx(1));
  for (const std::size_t cut_off : {2U, 3U, 4U, 5U}) CHECK(std::isnan(rmax[cut_off]));
  CHECK(surface::figures(map.gouges()).marked == 1);
}

TEST_CASE("a surface that is smaller than a region is one", "[apps][surface]") {
  surface::StockGrid grid;
  grid.columns = 5;
  grid.rows = 3;
  surface::RoughnessMap map(grid, 100);
  map.add({0, 3, 5, std::vector<float>(15), std::vector<float>(15, 0.001F), {}});
  CHECK(surface::figures(map.rmax()).regions == 1);
}

TEST_CASE("a gouge is no roughness", "[apps][surface]") {
  surface::StockGrid grid;
  grid.columns = 4;
  grid.rows = 2;
  surface::RoughnessMap map(grid, 2);
  surface::SurfaceBand band{0, 2, 4, std::vector<float>(8), std::vector<float>(8, 0.001F), {}};
  band.deviations[band.index(0, 0)] = -0.02F;  // in the first region one point, in the other all
  for (const int column : {2, 3})
    for (const int row : {0, 1}) band.deviations[band.index(column, row)] = -0.3F;
  map.add(band);
  const auto rmax = map.rmax(), gouges = map.gouges();
  CHECK(rmax[0] == Approx(1));
  CHECK(std::isnan(rmax[1]));
  CHECK(gouges[0] == Approx(20));
  CHECK(gouges[1] == Approx(300));
  CHECK(surface::figures(gouges).marked == 2);
}

TEST_CASE("where a servo is off, a region is as rough as it is high", "[apps][surface]") {
  surface::StockGrid grid;
  grid.columns = grid.rows = 2;
  surface::RoughnessMap map(grid, 2, surface::HeightFrom::lowest);
  surface::SurfaceBand band{0, 2, 2, std::vector<float>(4), {-0.100F, -0.095F, -0.090F, -0.098F},
                            {}};
  map.add(band);
  CHECK(map.rmax()[0] == Approx(10).epsilon(1e-5));
  CHECK(map.gouges()[0] == 0);
  CHECK(map.range().first == Approx(-100));
  CHECK(map.range().second == Approx(-90));
}

TEST_CASE("heads of npy files end where data may begin", "[apps][surface]") {
  const std::int64_t shape[] = {3, 100000};
  const std::string head = hal::npy_head("<f4", shape);
  CHECK(head.size() % 64 == 0);
  CHECK(head.substr(0, 6) == "\x93NUMPY");
  CHECK(head.find("'shape': (3, 100000, ), }") != std::string::npos);
  CHECK(head.back() == '\n');
}
