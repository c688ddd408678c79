// SPDX-License-Identifier: MIT
#include "pictures/limit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pictures/chart.hpp"
#include "pictures/legend.hpp"
#include "pictures/time_panel.hpp"

namespace softcnc::app {
namespace {

constexpr double kStrip = 24, kStripGap = 6, kLimitRow = 18, kLimitBar = 12;  // px
constexpr double kNameColumn = 200, kFigures = 130;                           // px
constexpr double kLimitRight = 24;                                            // px
constexpr double kLeastShare = 2e-3;

double share(const PictureRun& run, Limit limit) {
  const double seconds = run.time_by_limit[static_cast<std::size_t>(limit)];
  return run.time > 0 ? seconds / run.time : 0;
}

void draw_strips(Canvas& canvas, const Rectangle& area, PictureRuns runs) {
  const double duration = longest_time(runs);
  const TimeUnit unit = time_unit(duration);
  Rectangle strip{area.x + kAxisLeft, area.y, area.width - kAxisLeft - kLimitRight, kStrip};
  const double px = strip.width / duration;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0) strip.y += kStrip + kStripGap;
    for (const LimitStretch& stretch : limit_stretches(*runs[i].history, 0.5 / px))
      canvas.fill({strip.x + px * stretch.from, strip.y, px * (stretch.to - stretch.from), kStrip},
                  limit_colour(stretch.limit));
    canvas.frame(strip, {.colour = kFrame, .width = 1});
    TextLook look = kHeadingLook;
    look.anchor = Anchor::right;
    if (runs.size() > 1)
      canvas.text({strip.x - 10, strip.y + kStrip / 2 + 4.5}, i == 0 ? "A" : "B", look);
  }
  draw_x_axis(canvas, strip, {fmt::format("time, {}", unit.name), 0, duration / unit.seconds});
}

void draw_share(Canvas& canvas, const Rectangle& row, const PictureRun& run, Limit limit,
                double most, Colour colour) {
  const double whole = row.width - kNameColumn - kFigures - kLimitRight;
  canvas.fill({row.x + kNameColumn, row.y + (kLimitRow - kLimitBar) / 2,
               whole * share(run, limit) / most, kLimitBar},
              colour);
  const double seconds = run.time_by_limit[static_cast<std::size_t>(limit)];
  TextLook look = kTickLook;
  look.anchor = Anchor::right;
  const double right = row.right() - kLimitRight;
  canvas.text({right - 52, row.y + 13}, fmt::format("{:.2f} s", seconds), look);
  canvas.text({right, row.y + 13}, fmt::format("{:.1f} %", 100 * share(run, limit)), look);
}

}  // namespace

std::vector<LimitStretch> limit_stretches(const runtime::RunHistory& history, double shortest) {
  std::vector<LimitStretch> stretches;
  std::array<double, kLimits> seconds{};
  double from = 0;
  const auto close = [&](double to) {
    if (to <= from) return;
    const auto longest = std::max_element(seconds.begin(), seconds.end());
    const auto limit = static_cast<Limit>(longest - seconds.begin());
    if (!stretches.empty() && stretches.back().limit == limit)
      stretches.back().to = to;
    else
      stretches.push_back({from, to, limit});
    seconds.fill(0);
    from = to;
  };
  const auto& nodes = history.nodes();
  if (!nodes.empty()) from = static_cast<double>(nodes.front().period) * history.period();
  double last = from;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double end = static_cast<double>(nodes[i].period) * history.period();
    seconds[static_cast<std::size_t>(nodes[i].limit)] += end - last;
    last = end;
    if (end - from >= shortest) close(end);
  }
  close(last);
  return stretches;
}

std::vector<Limit> shown_limits(PictureRuns runs) {
  std::vector<Limit> limits;
  const auto most = [&](Limit limit) {
    double seconds = 0;
    for (const PictureRun& run : runs)
      seconds = std::max(seconds, run.time_by_limit[static_cast<std::size_t>(limit)]);
    return seconds;
  };
  for (int i = 0; i < kLimits; ++i) {
    const auto limit = static_cast<Limit>(i);
    if (std::ranges::any_of(
            runs, [&](const PictureRun& run) { return share(run, limit) >= kLeastShare; }))
      limits.push_back(limit);
  }
  std::ranges::stable_sort(limits, [&](Limit a, Limit b) { return most(a) > most(b); });
  return limits;
}

double limit_plot_height(PictureRuns runs) {
  const auto count = static_cast<double>(runs.size());
  const auto limits = static_cast<double>(shown_limits(runs).size());
  return kHeadingLine + 4 + count * kStrip + (count - 1) * kStripGap + kAxisBelow + 10 +
         limits * (count * kLimitRow + (count - 1) * kStripGap);
}

void draw_limit_plot(Canvas& canvas, const Rectangle& area, PictureRuns runs) {
  draw_heading(canvas, {area.x, area.y}, "What limits the feed", {}, area.width);
  const double top = area.y + kHeadingLine + 4;
  draw_strips(canvas, {area.x, top, area.width, kStrip}, runs);
  const std::vector<Limit> limits = shown_limits(runs);
  double most = 0;
  for (const PictureRun& run : runs)
    for (const Limit limit : limits) most = std::max(most, share(run, limit));
  const auto count = static_cast<double>(runs.size());
  Rectangle row{area.x, top + count * kStrip + (count - 1) * kStripGap + kAxisBelow + 10,
                area.width, kLimitRow};
  for (const Limit limit : limits) {
    const Colour colour = limit_colour(limit);
    canvas.fill({row.x + 8, row.y + (kLimitRow - kLimitBar) / 2, kLimitBar, kLimitBar}, colour);
    canvas.text({row.x + 8 + kLimitBar + 6, row.y + 13}, limit_label(limit), kLabelLook);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      TextLook look = kTickLook;
      look.anchor = Anchor::right;
      if (runs.size() > 1)
        canvas.text({row.x + kNameColumn - 6, row.y + 13}, i == 0 ? "A" : "B", look);
      draw_share(canvas, row, runs[i], limit, most, i == 0 ? colour : faded(colour, 0.6));
      row.y += kLimitRow;
    }
    if (runs.size() > 1) row.y += kStripGap;
  }
}

}  // namespace softcnc::app
