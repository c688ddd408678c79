// SPDX-License-Identifier: MIT
// `softcnc surface`: the program runs, its edges cut a Z-map, and that is written and summed up.
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <chrono>
#include <thread>

#include "commands/commands.hpp"
#include "job/job.hpp"
#include "job/preflight.hpp"
#include "job/terminal.hpp"
#include "messages/duration_text.hpp"
#include "messages/messages.hpp"
#include "motion/core/units.hpp"
#include "output/summary.hpp"
#include "output/surface_file.hpp"
#include "output/surface_report.hpp"
#include "runtime/cutting/cutting_rows.hpp"
#include "runtime/cutting/surface_grid.hpp"
#include "runtime/figures/cpu_clock.hpp"
#include "runtime/run/repeated_errors.hpp"
#include "runtime/run/run.hpp"
#include "runtime/sinks/contour_rows.hpp"
#include "surface/ideal_surface.hpp"

namespace softcnc::app {
namespace {

class SurfaceJob {
 public:
  SurfaceJob(Job& job, const Options& options)
      : job_(job),
        options_(options),
        terminal_(options.progress, false, job.machine.control.period),
        messages_([this] { terminal_.end(); }) {
    job_.options.interpreter.stop = terminal_.stop();
  }

  int run();

 private:
  int fail(const Diagnostic& diagnostic) { return messages_.fail(diagnostic); }
  int read();
  int move();
  int report(const surface::RoughnessMap& map);
  int cut(hal::OutputFile& output);
  int stopped() { return kSignalled + terminal_.signal(); }
  void log_summary(const surface::RoughnessMap& map, double seconds, double cpu) const;

  Job& job_;
  const Options& options_;
  Terminal terminal_;
  Messages messages_;
  runtime::Cutting cutting_;
  surface::ToolTrack track_;
  surface::StockGrid grid_;
  std::int64_t updates_ = 0;
};

/// The first reading: the cutting moves, and the errors of the text. It takes a small part of the
/// time of the run, and before that the size of the surface is known, and whether it can be cut at
/// all.
int SurfaceJob::read() {
  runtime::ShownOnce shown(job_.program, job_.options.interpreter, messages_.sink(job_.program));
  Diagnostics diagnostics(shown.sink());
  diagnostics.set_file(job_.program.name());
  cutting_ =
      runtime::read_cutting(job_.program, job_.machine, job_.options, diagnostics, terminal_);
  shown.finish();
  return terminal_.signal() != 0 ? stopped() : diagnostics.status();
}

/// The run. What the first reading has reported is not reported again.
int SurfaceJob::move() {
  constexpr int kOfPlanning = 4000;
  Machine machine = runtime::without_backend(job_.machine);
  if (options_.actual) machine.control.backend = BackendKind::sim;
  auto backend = hal::open_backend(machine);
  if (!backend) return fail(backend.error());
  runtime::CuttingRows rows(cutting_, machine.surfacing.phase, machine.control.period,
                            runtime::row_columns(**backend));
  terminal_.begin("running", 0, job_.program.size());
  const runtime::JudgedRun judged =
      runtime::run({job_.program, machine, job_.options, **backend, &rows, &terminal_},
                   [show = messages_.sink(job_.program)](const Diagnostic& diagnostic) {
                     if (static_cast<int>(diagnostic.code) >= kOfPlanning) show(diagnostic);
                   });
  terminal_.end();
  auto track = rows.finish();
  if (!track) return fail(track.error());
  track_ = std::move(*track);
  if (judged.outcome.end == runtime::Outcome::End::stopped) return stopped();
  spdlog::debug("{} of machine time: CPU {:.3f} s planning, {:.3f} s cycle",
                duration_text(judged.outcome.time), judged.outcome.cpu.planning,
                judged.outcome.cpu.cycle);
  return judged.status;
}

int SurfaceJob::cut(hal::OutputFile& output) {
  const int side = runtime::region_side(cutting_, grid_.step);
  auto file = open_surface_file(options_.output,
                                fmt::format("{} on {}", job_.program.name(), job_.machine.name),
                                output, grid_, side);
  if (!file) return fail(file.error());
  surface::RoughnessMap map(
      grid_, side, options_.actual ? surface::HeightFrom::lowest : surface::HeightFrom::ideal);
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  const auto begin = std::chrono::steady_clock::now();
  const double cpu = runtime::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  const auto updates = surface::cut_bands(
      surface::Workpiece(track_, grid_), threads,
      [&](const surface::SurfaceBand& band) -> Result<bool> {
        map.add(band);
        const Status added = (*file)->add(band);
        if (!added) return tl::make_unexpected(added.error());
        return true;
      },
      [&] { return terminal_.signal() != 0; });
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const double cpu_taken = runtime::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  if (!updates) return fail(updates.error());
  if (terminal_.signal() != 0) return stopped();
  updates_ = *updates;
  if (Status written = (*file)->finish(map); !written) return fail(written.error());
  log_summary(map, taken.count(), cpu_taken);
  return report(map);
}

/// What is rougher than asked for.
int SurfaceJob::report(const surface::RoughnessMap& map) {
  const surface::TargetFigures target = target_figures(map);
  Diagnostics diagnostics(messages_.sink(job_.program));
  diagnostics.set_file(job_.program.name());
  if (target.missed > 0)
    diagnostics.report({.code = Code::SC4040, .message = missed_text(target, map, grid_)});
  if (options_.report.empty()) return 0;
  const Status written = hal::write_file(options_.report, surface_report(job_, map, grid_));
  if (!written) return fail(written.error());
  spdlog::info("  report written to {}", options_.report);
  return 0;
}

/// Peak memory of this process, MB.
double memory_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

std::string roughness_text(const surface::RoughnessMap& map, double step,
                           const runtime::Cutting& cutting) {
  const surface::RegionFigures sum = surface::figures(map.rmax());
  if (sum.regions == 0 && cutting.pick_feed > surface::IdealSurface::kWidestPick * cutting.radius)
    return fmt::format("unknown: the pick-feed exceeds {:.2g} of the tool radius",
                       surface::IdealSurface::kWidestPick);
  if (sum.regions == 0)
    return "unknown: no passes lie side by side on a smooth surface without gouges";
  return fmt::format("{:.2f} um, {:.2f} um on average over {} regions of {:.4g} x {:.4g} mm",
                     sum.largest, sum.mean, sum.regions, map.side() * step, map.side() * step);
}

/// A line of its own, where anything is asked for.
std::string target_text(const surface::RoughnessMap& map) {
  const surface::TargetFigures target = target_figures(map);
  if (target.judged == 0) return {};
  if (target.missed == 0)
    return fmt::format("\n  target       met in all {} regions that have one", target.judged);
  return fmt::format("\n  target       met in {} of {} regions that have one",
                     target.judged - target.missed, target.judged);
}

/// A line of its own: gouges, where there are any, or what the servo is off.
std::string form_text(const surface::RoughnessMap& map) {
  const auto [lowest, highest] = map.range();
  if (map.from() == surface::HeightFrom::lowest && lowest <= highest)
    return fmt::format("\n  servo        {:.2f} to {:.2f} um off the commanded surface", lowest,
                       highest);
  const surface::RegionFigures sum = surface::figures(map.gouges());
  if (sum.marked == 0) return {};
  return fmt::format("\n  gouges       up to {:.2f} um below the ideal surface, in {} regions",
                     sum.largest, sum.marked);
}

void SurfaceJob::log_summary(const surface::RoughnessMap& map, double seconds, double cpu) const {
  const double points = static_cast<double>(grid_.columns) * grid_.rows;
  const double updates = static_cast<double>(updates_);
  spdlog::info(
      "surface of {} on {}{}{}\n  stock        {:.6g} x {:.6g} x {:.6g} mm from X{:.6g} Y{:.6g} "
      "Z{:.6g}\n  grid         {} x {} points, one every {:.6g} um\n  edges        {} passes\n"
      "  Rmax         {}{}{}\n  cut          {:.0f} points, {:.3g} updates in {:.2f} s, CPU {:.2f} "
      "s: "
      "{:.1f} million per second and core\n  memory       {:.0f} MB\n\n  surface written to {}",
      job_.program.name(), job_.machine.name, options_.actual ? ", by its actual positions" : "",
      machine_line(job_), (grid_.columns - 1) * grid_.step, (grid_.rows - 1) * grid_.step,
      grid_.top - grid_.corner[2], grid_.corner[0], grid_.corner[1], grid_.corner[2], grid_.columns,
      grid_.rows, um_from_mm(grid_.step), track_.passes().size(),
      roughness_text(map, grid_.step, cutting_), target_text(map), form_text(map), points, updates,
      seconds, cpu, updates / cpu / 1e6, memory_mb(), options_.output);
}

int SurfaceJob::run() {
  if (const int status = read(); status != 0) return status;
  auto grid = runtime::stock_grid(job_.machine.stock, cutting_);
  if (!grid) return fail(grid.error());
  grid_ = *grid;
  const auto output = hal::OutputFile::open(options_.output);  // before the long work
  if (!output) return fail(output.error());
  if (const int status = move(); status != 0) return status;
  return cut(**output);
}

}  // namespace

int surface(const Options& options) {
  if (Status known = known_surface_form(options.output); !known) return failed(known.error());
  auto job = open_job(options);
  if (!job) return failed(job.error());
  return SurfaceJob(*job, options).run();
}

}  // namespace softcnc::app
