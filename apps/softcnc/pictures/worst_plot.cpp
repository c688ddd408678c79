// SPDX-License-Identifier: MIT
#include "pictures/worst_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "pictures/chart.hpp"
#include "pictures/legend.hpp"

namespace softcnc::app {
namespace {

constexpr double kWorstRow = 20, kWorstBar = 13;   // px
constexpr double kWorstNames = 150, kTexts = 220;  // px

std::string heading_of(PictureRuns runs, std::size_t run) {
  return run_prefix(runs, run) + "Lines that lose most time against their feed";
}

void draw_line(Canvas& canvas, const Rectangle& row, const LostLine& line, const PictureRun& run,
               double most) {
  TextLook look = kLabelLook;
  look.anchor = Anchor::right;
  canvas.text({row.x + kWorstNames - 8, row.y + 14},
              canvas.shortened(line.place, look, kWorstNames - 12), look);
  const double length = (row.width - kWorstNames - kTexts) * line.lost / most;
  canvas.fill({row.x + kWorstNames, row.y + (kWorstRow - kWorstBar) / 2, length, kWorstBar},
              limit_colour(line.limit));
  const std::string part =
      run.time > 0 ? fmt::format(" ({:.1f} %)", 100 * line.lost / run.time) : std::string();
  canvas.text({row.x + kWorstNames + length + 8, row.y + 14},
              fmt::format("{:.3g} s{}, {}", line.lost, part, limit_label(line.limit)), kTickLook);
}

double rows_of(const PictureRun& run) {
  return std::max<double>(1, static_cast<double>(run.worst_lines.size()));
}

}  // namespace

double worst_plot_height(PictureRuns runs) {
  double height = 0;
  for (const PictureRun& run : runs) height += kHeadingLine + 4 + kWorstRow * rows_of(run) + 6;
  return height;
}

void draw_worst_plot(Canvas& canvas, const Rectangle& area, PictureRuns runs) {
  double most = 0;
  for (const PictureRun& run : runs)
    for (const LostLine& line : run.worst_lines) most = std::max(most, line.lost);
  Rectangle row{area.x, area.y, area.width, kWorstRow};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    draw_heading(canvas, {row.x, row.y}, heading_of(runs, i), {}, area.width);
    row.y += kHeadingLine + 4;
    for (const LostLine& line : runs[i].worst_lines) {
      draw_line(canvas, row, line, runs[i], most);
      row.y += kWorstRow;
    }
    if (runs[i].worst_lines.empty()) {
      canvas.text({row.x + kWorstNames, row.y + 14}, "none", kLabelLook);
      row.y += kWorstRow;
    }
    row.y += 6;
  }
}

}  // namespace softcnc::app
