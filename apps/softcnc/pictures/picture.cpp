// SPDX-License-Identifier: MIT
#include "pictures/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "pictures/chart.hpp"
#include "pictures/limit_plot.hpp"
#include "pictures/panel_series.hpp"
#include "pictures/path_plot.hpp"
#include "pictures/time_panel.hpp"
#include "pictures/worst_plot.hpp"

namespace softcnc::app {
namespace {

constexpr double kPictureMargin = 16, kGap = 16;    // px: around the picture, between plots
constexpr double kTitleLine = 22;                   // px
constexpr double kPanel = 210, kLowestPanel = 110;  // px: of a panel over time, at least
constexpr double kMessage = kHeadingLine + 34;      // px

/// A part of the picture, over its whole width.
struct PicturePart {
  double height = 0;       // px
  bool stretches = false;  // to fill the height that is asked for
  std::function<void(Canvas&, const Rectangle&)> draw;
};

PicturePart panel_part(TimePanel panel, double duration) {
  return {kPanel, true,
          [panel = std::move(panel), duration](Canvas& canvas, const Rectangle& area) {
            draw_panel(canvas, area, panel, duration);
          }};
}

PicturePart message_part(std::string heading, std::string message) {
  return {kMessage, false, [heading, message](Canvas& canvas, const Rectangle& area) {
            draw_heading(canvas, {area.x, area.y}, heading, {}, area.width);
            canvas.text({area.x + kAxisLeft, area.y + kHeadingLine + 18}, message, kLabelLook);
          }};
}

void add_panels(std::vector<PicturePart>& parts, PictureRuns runs, std::vector<TimePanel> panels) {
  for (TimePanel& panel : panels) parts.push_back(panel_part(std::move(panel), longest_time(runs)));
}

/// Whether any run moves.
bool has_motion(PictureRuns runs) {
  return std::ranges::any_of(runs,
                             [](const PictureRun& run) { return run.history->nodes().size() > 1; });
}

void add_plot(std::vector<PicturePart>& parts, Plot plot, PictureRuns runs,
              const PictureOptions& options, double width) {
  const auto fixed = [&](double height, auto draw) {
    parts.push_back({height, false, [runs, draw](Canvas& canvas, const Rectangle& area) {
                       draw(canvas, area, runs);
                     }});
  };
  switch (plot) {
    case Plot::path:
      parts.push_back({path_plot_height(runs, options.colour, width), true,
                       [runs, by = options.colour](Canvas& canvas, const Rectangle& area) {
                         draw_path_plot(canvas, area, runs, by);
                       }});
      return;
    case Plot::feed:
      return add_panels(parts, runs, feed_panels(runs));
    case Plot::limits:
      return fixed(limit_plot_height(runs), draw_limit_plot);
    case Plot::axes:
      return add_panels(parts, runs, axis_panels(runs));
    case Plot::error: {
      std::vector<TimePanel> panels = error_panels(runs);
      if (panels.empty()) parts.push_back(message_part("Errors", "no error of this run is known"));
      return add_panels(parts, runs, std::move(panels));
    }
    case Plot::worst:
      return fixed(worst_plot_height(runs), draw_worst_plot);
  }
}

std::vector<PicturePart> parts_of(PictureRuns runs, const PictureOptions& options, double width) {
  std::vector<PicturePart> parts;
  if (!has_motion(runs)) {
    parts.push_back(message_part("Path", "no motion"));
    return parts;
  }
  const std::vector<Plot> usual{Plot::path, Plot::feed, Plot::limits};
  for (const Plot plot : options.plots.empty() ? usual : options.plots)
    add_plot(parts, plot, runs, options, width);
  return parts;
}

std::string figures_of(const PictureRun& run) {
  std::string text = run.machine.empty() ? std::string() : fmt::format("on {}    ", run.machine);
  text += fmt::format("time {:.2f} s    path {:.6g} mm", run.time, run.length);
  return run.remark.empty() ? text : text + "    " + run.remark;
}

/// A line for each run: the program, its machine, time and length.
void draw_titles(Canvas& canvas, PictureRuns runs) {
  const TextLook bold{.size = 14, .bold = true};
  const TextLook plain{.size = 12, .colour = kFaintInk};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double y = kPictureMargin + kTitleLine * static_cast<double>(i) + 14;
    const double whole = canvas.width() - 2 * kPictureMargin;
    const std::string figures = canvas.shortened(figures_of(runs[i]), plain, 0.75 * whole);
    const double left = whole - canvas.text_width(figures, plain) - 14;
    const std::string name = canvas.shortened(run_prefix(runs, i) + runs[i].program, bold, left);
    canvas.text({kPictureMargin, y}, name, bold);
    canvas.text({kPictureMargin + canvas.text_width(name, bold) + 14, y}, figures, plain);
  }
}

/// Stretches what can be stretched, all by the same factor, to the height that is left.
Status fit(std::vector<PicturePart>& parts, double height) {
  double fixed = kGap * static_cast<double>(parts.size() - 1), elastic = 0;
  for (const PicturePart& part : parts) (part.stretches ? elastic : fixed) += part.height;
  if (elastic > 0)
    for (PicturePart& part : parts)
      if (part.stretches) part.height *= (height - fixed) / elastic;
  const auto too_low = [](const PicturePart& part) {
    return part.stretches && part.height < kLowestPanel;
  };
  if (fixed <= height && std::ranges::none_of(parts, too_low)) return {};
  const double least =
      fixed + kLowestPanel * static_cast<double>(std::ranges::count_if(
                                 parts, [](const PicturePart& part) { return part.stretches; }));
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC6062,
      .message = fmt::format("{:.0f} px are too low for these plots, which need about {:.0f} px",
                             height, least)});
}

}  // namespace

Result<std::string> draw_picture(PictureRuns runs, const PictureOptions& options,
                                 PictureFormat format) {
  assert(!runs.empty() && runs.size() <= 2);
  const double width = options.size.width - 2 * kPictureMargin;
  const double top = kPictureMargin + kTitleLine * static_cast<double>(runs.size()) + 10;
  std::vector<PicturePart> parts = parts_of(runs, options, width);
  if (options.size.height > 0)
    if (Status fits = fit(parts, options.size.height - top - kPictureMargin); !fits)
      return tl::make_unexpected(fits.error());
  double height = top + kPictureMargin - kGap;
  for (const PicturePart& part : parts) height += part.height + kGap;
  Canvas canvas(options.size.width,
                options.size.height > 0 ? options.size.height : std::ceil(height), format);
  draw_titles(canvas, runs);
  Rectangle area{kPictureMargin, top, width, 0};
  for (const PicturePart& part : parts) {
    area.height = part.height;
    part.draw(canvas, area);
    area.y += part.height + kGap;
  }
  return canvas.bytes();
}

}  // namespace softcnc::app
