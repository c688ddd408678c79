// SPDX-License-Identifier: MIT
// Pictures of runs: where things lie, in which colours, and that the bytes are always the same.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <regex>
#include <set>

#include "apps/shell.hpp"
#include "pictures/limit_plot.hpp"
#include "pictures/panel_series.hpp"
#include "pictures/path_pieces.hpp"
#include "pictures/path_plot.hpp"
#include "pictures/picture.hpp"
#include "pictures/time_panel.hpp"
#include "support/period.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;
using namespace softcnc::test;
using runtime::MotionKind;
using runtime::RunHistory;
using runtime::RunRow;

namespace {

/// A run that is made by hand, one straight move after another at uniform speed.
class HandMade {
 public:
  HandMade() : history_(std::make_unique<RunHistory>(kPeriod, nullptr)) { take(); }

  /// Moves in `periods` periods, at `ratio` of its programmed feed.
  HandMade& move(const AxisVector& to, int periods, Limit limit = Limit::feed, double ratio = 1,
                 MotionKind motion = MotionKind::cutting) {
    const AxisVector from = row_.position;
    row_.limit = limit;
    row_.motion = motion;
    row_.v = (to - from).norm() / (periods * kPeriod);
    row_.feed = motion == MotionKind::cutting ? row_.v / ratio : 0;
    for (int i = 1; i <= periods; ++i) {
      row_.position = from + (to - from) * i / periods;
      row_.s += row_.v * kPeriod;
      ++row_.period;
      take();
      seconds_[static_cast<std::size_t>(limit)] += kPeriod;
    }
    return *this;
  }
  RunRow& row() { return row_; }

  PictureRun run() {
    history_->finish();
    return {.history = history_.get(),
            .program = "square.nc",
            .machine = "mill",
            .remark = {},
            .time = static_cast<double>(row_.period) * kPeriod,
            .length = row_.s,
            .time_by_limit = seconds_,
            .worst_lines = {{"line 3", 0.25, Limit::corner}, {"line 7", 0.1, Limit::jerk}},
            .velocity_limits = {}};
  }

 private:
  void take() { history_->take(row_); }

  std::unique_ptr<RunHistory> history_;
  RunRow row_;
  std::array<double, kLimits> seconds_{};
};

HandMade& draw_square(HandMade& made) {
  return made.move({40, 0, 0}, 400)
      .move({40, 40, 0}, 400, Limit::acceleration, 0.5)
      .move({0, 40, 0}, 400, Limit::corner, 0.25)
      .move({0, 0, 0}, 400);
}

std::string svg_of(PictureRuns runs, const PictureOptions& options) {
  const auto bytes = draw_picture(runs, options, PictureFormat::svg);
  REQUIRE(bytes);
  return *bytes;
}

struct Stroke {
  Colour colour;
  double width = 0;
  std::vector<Spot> spots;
};

/// The lines of an SVG that are stroked.
std::vector<Stroke> strokes(const std::string& svg) {
  static const std::regex path(
      "stroke-width:([0-9.]+);[^\"]*stroke:rgb\\(([0-9.]+)%,([0-9.]+)%,"
      "([0-9.]+)%\\)[^\"]*\" d=\"([^\"]*)\"");
  static const std::regex spot("[ML] ([-0-9.]+) ([-0-9.]+)");
  std::vector<Stroke> all;
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint8_t>(std::lround(std::stod((*it)[i]) * 2.55));
    };
    Stroke stroke{{byte(2), byte(3), byte(4)}, std::stod((*it)[1]), {}};
    const std::string d = (*it)[5];
    for (std::sregex_iterator at(d.begin(), d.end(), spot); at != end; ++at)
      stroke.spots.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
    all.push_back(std::move(stroke));
  }
  return all;
}

/// Those as wide as a cutting move.
std::vector<Stroke> cuts(const std::string& svg) {
  std::vector<Stroke> found;
  for (Stroke& stroke : strokes(svg))
    if (stroke.width == 1.7) found.push_back(std::move(stroke));
  return found;
}

std::size_t be32(const std::string& bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// The names of the chunks of a PNG, each once, in their order.
std::vector<std::string> chunks(const std::string& png) {
  std::vector<std::string> names;
  for (std::size_t at = 8; at + 8 <= png.size(); at += 12 + be32(png, at)) {
    const std::string name = png.substr(at + 4, 4);
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

}  // namespace

TEST_CASE("a square is drawn where its corners are", "[apps][pictures]") {
  HandMade made;
  const PictureRun run = draw_square(made).run();
  const std::vector<PictureRun> runs{run};
  PictureOptions options;
  options.plots = {Plot::path};
  options.colour = Colouring::limit;
  const auto found = cuts(svg_of(runs, options));
  REQUIRE(found.size() == 4);  // the colour changes at three corners, and the program begins at one
  // 900 px less margins of 16, 76 for the axis and 24 beside: 768 px wide, at most 560 px high. The
  // square, 40 mm with 5 % around it, takes all of the height and stands in the middle.
  const double scale = 560 / 44.0, side = 40 * scale;
  const double left = 16 + 76 + 768 / 2.0 - side / 2, right = left + side;
  const double top = 16 + 22 + 10 + 20 + 4 + 2 * scale, bottom = top + side;
  const std::vector<Spot> corners{
      {left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}};
  for (std::size_t i = 0; i < 4; ++i) {
    REQUIRE(found[i].spots.size() == 2);
    for (const std::size_t end : {0U, 1U}) {
      CHECK(found[i].spots[end].x == Approx(corners[i + end].x).margin(0.01));
      CHECK(found[i].spots[end].y == Approx(corners[i + end].y).margin(0.01));
    }
  }
}

TEST_CASE("the path has the colours of the legend", "[apps][pictures]") {
  HandMade made;
  const std::vector<PictureRun> runs{draw_square(made).run()};
  const PathColours limits(runs, Colouring::limit);
  REQUIRE(limits.entries().size() == 3);
  CHECK(limits.entries()[0].label == "programmed feed");  // half of the time
  PictureOptions options;
  options.plots = {Plot::path};
  options.colour = Colouring::limit;
  std::set<std::uint32_t> drawn, listed;
  const auto number = [](Colour colour) {
    return static_cast<std::uint32_t>(colour.red << 16 | colour.green << 8 | colour.blue);
  };
  for (const Stroke& stroke : cuts(svg_of(runs, options))) drawn.insert(number(stroke.colour));
  for (const LegendEntry& entry : limits.entries()) listed.insert(number(entry.colour));
  CHECK(drawn == listed);

  options.colour = Colouring::feed;
  const auto found = cuts(svg_of(runs, options));
  const PathColours feed(runs, Colouring::feed);
  const std::array<double, 5> percents{50, 100, 50, 25, 100};  // the first period begins at rest
  REQUIRE(found.size() == percents.size());
  for (std::size_t i = 0; i < percents.size(); ++i)
    CHECK(found[i].colour == feed.shade_of(percents[i]));
  CHECK(found[1].colour == shade(1));
}

TEST_CASE("numbers of nodes become those of the scale", "[apps][pictures]") {
  HandMade made;
  made.row().contour = 12;
  made.row().rmax = std::numeric_limits<float>::quiet_NaN();
  const std::vector<PictureRun> runs{draw_square(made).run()};
  const PathColours speed(runs, Colouring::speed), contour(runs, Colouring::contour);
  const auto& nodes = runs[0].history->nodes();
  CHECK(speed.value(nodes[nodes.size() - 2], nodes.back()) == Approx(6000));  // 40 mm in 0.4 s
  CHECK(contour.scale().high == 12);
  CHECK(contour.shade_of(12) == shade(0));  // what is remarkable is dark
  const PathColours rmax(runs, Colouring::rmax);
  CHECK_FALSE(rmax.known());
  CHECK(rmax.scale().has_unknown);
}

TEST_CASE("what is too short for a colour of its own has the mean feed and the largest error",
          "[apps][pictures]") {
  runtime::HistoryNode a, b, c;
  b.period = 1;
  c.period = 4;
  a.v = b.v = c.v = 10;
  b.feed = 10;
  c.feed = 20;
  b.contour = 7;
  c.contour = 3;
  HandMade made;
  made.row().contour = 8;
  const std::vector<PictureRun> runs{made.move({1, 0, 0}, 10).run()};
  const PathColours feed(runs, Colouring::feed), contour(runs, Colouring::contour);
  ColourMean mean(feed), largest(contour);
  mean.add(a, b);
  mean.add(b, c);
  CHECK(mean.take() == feed.shade_of((100 + 3 * 50) / 4.0));
  CHECK(mean.take() == kUnknownColour);
  largest.add(a, b);
  largest.add(b, c);
  CHECK(largest.take() == contour.shade_of(7));
}

TEST_CASE("coarser colours keep the line where it is", "[apps][pictures]") {
  HandMade made;
  for (int i = 1; i <= 400; ++i)
    made.move({0.1 * i, i % 100 < 50 ? 0.0 : 2.0, 0}, 10, i % 2 == 0 ? Limit::feed : Limit::jerk);
  const std::vector<PictureRun> runs{made.run()};
  const PathColours colours(runs, Colouring::limit);
  const auto place = [](const AxisVector& point) { return Spot{20 * point[0], 20 * point[1]}; };
  const auto pieces_by = [&](double coloured) {
    return path_pieces(*runs[0].history, colours, place, Box::all(), {1, coloured}).cuts;
  };
  const auto fine = pieces_by(1), coarse = pieces_by(30);
  CHECK(fine.size() == 400);
  CHECK(coarse.size() <= (800 + 7 * 40) / 30 + 1);
  const auto has = [&](const Spot& corner) {
    return std::ranges::any_of(coarse, [&](const PathPiece& piece) {
      return std::ranges::any_of(piece.spots, [&](const Spot& spot) {
        return std::hypot(spot.x - corner.x, spot.y - corner.y) < 0.05;
      });
    });
  };
  for (const int i : {49, 50, 99, 100, 149, 150}) CHECK(has({2.0 * i, i % 100 < 50 ? 0.0 : 40.0}));
}

TEST_CASE("flat programs are seen from above, others from a corner", "[apps][pictures]") {
  HandMade flat, helix, drill, pocket;
  const std::vector<PictureRun> square{draw_square(flat).run()};
  CHECK(path_view(square) == PathView::above);
  const std::vector<PictureRun> rising{helix.move({10, 0, 0}, 10).move({10, 10, 5}, 10).run()};
  CHECK(path_view(rising) == PathView::isometric);
  const std::vector<PictureRun> holes{drill.move({0, 0, -10}, 10)
                                          .move({9, 0, 5}, 10, Limit::rapid, 1, MotionKind::rapid)
                                          .move({9, 0, -10}, 10)
                                          .run()};
  CHECK(path_view(holes) == PathView::isometric);
  pocket.move({0, 0, 5}, 10, Limit::rapid, 1, MotionKind::rapid).move({0, 0, 0}, 100);
  const std::vector<PictureRun> plunged{draw_square(pocket).run()};
  CHECK(path_view(plunged) == PathView::above);
}

TEST_CASE("isometric: all axes are shortened alike", "[apps][pictures]") {
  std::vector<Eigen::Vector2d> axes;
  for (int i = 0; i < kAxes; ++i) axes.push_back(seen(PathView::isometric, AxisVector::Unit(i)));
  for (const Eigen::Vector2d& axis : axes) CHECK(axis.norm() == Approx(std::sqrt(2.0 / 3)));
  const auto cosine = [&](std::size_t a, std::size_t b) {
    return axes[a].normalized().dot(axes[b].normalized());
  };
  CHECK(cosine(0, 2) == Approx(-0.5));  // X and Z
  CHECK(cosine(0, 1) == Approx(0.5));   // X and Y, which leads away from who looks
  CHECK(cosine(1, 2) == Approx(0.5));
  CHECK(axes[0][0] > 0);
  CHECK(axes[0][1] < 0);
  CHECK(axes[1][1] > 0);
  CHECK(axes[2][0] == Approx(0).margin(1e-15));
}

TEST_CASE("a line is clipped to what of it lies in the box", "[apps][pictures]") {
  Box box;
  box.add({-1, -2, -3});
  box.add({3, 2, 1});
  holds([&] {
    const AxisVector from(real(-6, 6), real(-6, 6), real(-6, 6));
    const AxisVector to(real(-6, 6), real(-6, 6), real(-6, 6));
    AxisVector a = from, b = to;
    const bool some = clip_line(a, b, box);
    constexpr int kSteps = 500;
    int inside = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const AxisVector point = from + (to - from) * i / kSteps;
      if ((point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all())
        ++inside;
    }
    const double part = some ? (b - a).norm() / (to - from).norm() : 0;
    RC_ASSERT(std::abs(part - inside / (kSteps + 1.0)) < 2.0 / kSteps);
  });
}

TEST_CASE("stretches of limits cover the time, each by its longest limit", "[apps][pictures]") {
  HandMade made;
  made.move({10, 0, 0}, 100)
      .move({10.3, 0, 0}, 3, Limit::corner)
      .move({20, 0, 0}, 97, Limit::acceleration);
  const PictureRun run = made.run();
  const auto fine = limit_stretches(*run.history, 0.0005);
  REQUIRE(fine.size() == 3);
  CHECK(fine[1].limit == Limit::corner);
  CHECK(fine[1].to - fine[1].from == Approx(0.003));
  const auto coarse = limit_stretches(*run.history, 0.05);
  double covered = 0;
  for (const LimitStretch& stretch : coarse) {
    CHECK(stretch.limit != Limit::corner);
    covered += stretch.to - stretch.from;
  }
  CHECK(covered == Approx(run.time));
}

TEST_CASE("limits below 0.2 % of the time have no row, the longest comes first",
          "[apps][pictures]") {
  HandMade made;
  const std::vector<PictureRun> runs{made.move({10, 0, 0}, 300)
                                         .move({10.1, 0, 0}, 1, Limit::corner)
                                         .move({30, 0, 0}, 700, Limit::jerk)
                                         .run()};
  CHECK(shown_limits(runs) == std::vector{Limit::jerk, Limit::feed});
}

TEST_CASE("values over time lie at their time", "[apps][pictures]") {
  HandMade made;
  const std::vector<PictureRun> runs{draw_square(made).run()};
  const auto panels = feed_panels(runs);
  REQUIRE(panels.size() == 1);
  REQUIRE(panels[0].series.size() == 2);
  CHECK(panels[0].least == Approx(24000));  // 6000 mm/min are a quarter of what is programmed
  const Chart chart({0, 0, 160, 100}, {"", 0, 1.6}, {"", 0, 24000});
  const auto programmed = series_lines(panels[0].series[0], chart, 1);
  REQUIRE(programmed.size() == 1);
  const auto level_at = [&](double x) {
    double y = -1;
    for (const Spot& spot : programmed[0])
      if (spot.x <= x) y = spot.y;
    return y;
  };
  CHECK(level_at(20) == Approx(75));
  CHECK(level_at(60) == Approx(50));
  CHECK(level_at(100) == Approx(0).margin(1e-9));
  CHECK(level_at(150) == Approx(75));
}

TEST_CASE("velocity is that of each axis, as a part of its limit", "[apps][pictures]") {
  HandMade made;
  PictureRun run = draw_square(made).run();
  run.velocity_limits = AxisVector(200, 400, 100);
  const std::vector<PictureRun> runs{run};
  const auto panels = axis_panels(runs);
  REQUIRE_FALSE(panels.empty());
  REQUIRE(panels[0].series.size() == 2);  // Z stands still
  CHECK(largest_value(panels[0].series[0]) == Approx(50));
  CHECK(largest_value(panels[0].series[1]) == Approx(25));
}

TEST_CASE("errors that no row knows have no panel", "[apps][pictures]") {
  HandMade made, known;
  const std::vector<PictureRun> runs{draw_square(made).run()};
  CHECK(error_panels(runs).empty());
  known.row().contour = 5;
  known.row().chord_error = 0.5F;
  const std::vector<PictureRun> measured{draw_square(known).run()};
  CHECK(error_panels(measured).size() == 2);
}

TEST_CASE("the same run is the same bytes, without ids or times that change", "[apps][pictures]") {
  HandMade one, other;
  other.row().contour = 5;
  const std::vector<PictureRun> runs{draw_square(one).run(),
                                     other.move({7, 0, 3}, 70).move({20, 9, 4}, 90).run()};
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png})
    for (const std::size_t count : {1U, 2U}) {
      PictureOptions options;
      options.plots = {Plot::path, Plot::feed, Plot::limits, Plot::axes, Plot::error, Plot::worst};
      const PictureRuns shown(runs.data(), count);
      const auto a = draw_picture(shown, options, format);
      const auto b = draw_picture(shown, options, format);
      REQUIRE(a);
      REQUIRE(b);
      CHECK((*a == *b));
      if (format == PictureFormat::png)
        for (const std::string& chunk : chunks(*a)) {
          CAPTURE(chunk);
          CHECK((chunk != "tIME" && chunk != "tEXt"));
        }
    }
}

TEST_CASE("a PNG has two pixels along each px, an SVG is as large as asked for",
          "[apps][pictures]") {
  HandMade made;
  const std::vector<PictureRun> runs{draw_square(made).run()};
  PictureOptions options;
  options.size = {640, 700};
  const auto png = draw_picture(runs, options, PictureFormat::png);
  REQUIRE(png);
  CHECK(be32(*png, 16) == 1280);
  CHECK(be32(*png, 20) == 1400);
  CHECK(svg_of(runs, options).find("width=\"640px\" height=\"700px\"") != std::string::npos);
}

TEST_CASE("a picture that is too low for its plots is refused", "[apps][pictures]") {
  HandMade made;
  const std::vector<PictureRun> runs{draw_square(made).run()};
  PictureOptions options;
  options.size = {900, 300};
  const auto low = draw_picture(runs, options, PictureFormat::svg);
  REQUIRE_FALSE(low);
  CHECK(low.error().code == Code::SC6062);
}

TEST_CASE("a run without motion says so", "[apps][pictures]") {
  RunHistory history(kPeriod, nullptr);
  history.finish();
  const std::vector<PictureRun> runs{{.history = &history,
                                      .program = "\xff.nc",  // no UTF-8
                                      .machine = {},
                                      .remark = "(ended by an error)",
                                      .time_by_limit = {},
                                      .worst_lines = {},
                                      .velocity_limits = {}}};
  const std::string svg = svg_of(runs, {});
  CHECK(cuts(svg).empty());
  CHECK(svg.find("</svg>") != std::string::npos);
}

TEST_CASE("sizes and formats of pictures are read", "[apps][pictures]") {
  CHECK(picture_format("a.SVG") == PictureFormat::svg);
  CHECK(picture_format("a.png") == PictureFormat::png);
  CHECK_FALSE(picture_format("a.html"));
  CHECK(picture_size("1200x800")->height == 800);
  CHECK(picture_size("1200")->width == 1200);
  CHECK(picture_size("1200")->height == 0);
  for (const char* wrong : {"", "x", "399x300", "900x", "900x199", "900x10001", "9e2", "900x300x2"})
    CHECK_FALSE(picture_size(wrong));
}

TEST_CASE("report draws pictures", "[apps][pictures]") {
  const Folder folder;
  const std::string part = std::string(SOFTCNC_SOURCE_DIR) + "/programs/03_arc.nc";
  const auto report = [&](const std::string& options) {
    return call("report -q " + part + " " + options);
  };
  REQUIRE(report("-o " + (folder / "a.svg")).status == 0);
  REQUIRE(report("-o " + (folder / "b.svg")).status == 0);
  CHECK((read(folder / "a.svg") == read(folder / "b.svg")));
  CHECK(read(folder / "a.svg").substr(0, 5) == "<?xml");
  REQUIRE(report("-o " + (folder / "a.png") +
                 " --plot path,axes,error,worst --colour limit --compare-set "
                 "control.interpolation=taylor1")
              .status == 0);
  CHECK(chunks(read(folder / "a.png")).back() == "IEND");
  const Ended low = report("-o " + (folder / "c.svg") + " --size 900x300");
  CHECK(low.status == 2);
  CHECK(shows(low.err,
              "c.svg: error: 236 px are too low for these plots, which need about 408 px "
              "[SC6062]"));
  CHECK(report("-o " + (folder / "c.svg") + " --size 90").status == 2);
  CHECK(report("-o " + (folder / "c.svg") + " --plot paths").status == 2);
  CHECK(report("-o " + (folder / "c.svg") + " --colour red").status == 2);
  CHECK(folder.files() == std::vector<std::string>{"a.png", "a.svg", "b.svg"});
}
