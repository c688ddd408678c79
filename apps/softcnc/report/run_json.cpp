// SPDX-License-Identifier: MIT
#include "report/run_json.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "hal/files/axis_name.hpp"
#include "hal/machine/state_names.hpp"
#include "motion/core/units.hpp"
#include "report/line_sentence.hpp"
#include "report/node_columns.hpp"
#include "report/surface_json.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

Json axis_limits(const Machine& machine) {
  Json list = Json::array();
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    list.push_back({{"axis", hal::axis_name(i)},
                    {"velocity_mm_s", axis.velocity},
                    {"acceleration_mm_s2", axis.acceleration},
                    {"jerk_mm_s3", axis.jerk},
                    {"min_mm", axis.min},
                    {"max_mm", axis.max}});
  }
  return list;
}

/// The longest first.
Json time_by_limit(const ReportedRun& run) {
  std::vector<std::size_t> order(run.time_by_limit.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return run.time_by_limit[a] > run.time_by_limit[b];
  });
  Json list = Json::array();
  for (const std::size_t i : order)
    if (run.time_by_limit[i] > 0)
      list.push_back({{"limit", kLimitNames[i]}, {"seconds", run.time_by_limit[i]}});
  return list;
}

Json tools(const runtime::TimeSheet& sheet) {
  Json list = Json::array();
  for (const runtime::ToolTime& tool : sheet.tools)
    list.push_back({{"tool", tool.tool},
                    {"cutting_s", tool.cutting},
                    {"rapid_s", tool.rapid},
                    {"dwell_s", tool.dwell},
                    {"rest_s", tool.rest}});
  return list;
}

/// At corners, as the report of `run` has them.
Json rests(const runtime::TimeSheet& sheet) {
  return {{"count", sheet.corners.count}, {"seconds", sheet.corners.seconds}};
}

Json figures(const std::vector<RunFigure>& figures) {
  Json list = Json::array();
  for (const RunFigure& figure : figures)
    list.push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
  return list;
}

Json worst(const ReportedRun& run) {
  Json list = Json::array();
  for (const runtime::LineTime& line : worst_lines(run, kWorstLines))
    list.push_back({{"file", line.file},
                    {"line", line.line},
                    {"lost_s", line.lost},
                    {"seconds", line.seconds},
                    {"limit", name(line.limit)},
                    {"sentence", line_sentence(line.limit)}});
  return list;
}

/// What a page of some megabytes can hold.
constexpr std::size_t kLongestText = std::size_t{64} << 20U;

/// A file that only a diagnostic names comes after the others.
class Files {
 public:
  Files(const ReportedRun& run, PackedData& data) {
    for (const ReportedFile& file : run.files) {
      index_.emplace(file.name, static_cast<int>(list_.size()));
      Json entry{{"name", file.name}};
      if (file.text && file.text->size() <= kLongestText) entry["text"] = data.add_text(*file.text);
      list_.push_back(std::move(entry));
    }
  }

  int number(const std::string& file) {
    const auto [place, is_new] = index_.emplace(file, static_cast<int>(list_.size()));
    if (is_new) list_.push_back({{"name", file}});
    return place->second;
  }
  Json take() { return std::move(list_); }

 private:
  std::map<std::string, int> index_;
  Json list_ = Json::array();
};

Json diagnostics(const ReportedRun& run, Files& files) {
  Json list = Json::array();
  for (const Diagnostic& one : run.diagnostics) {
    const Diagnostic visible = shown(one);
    list.push_back({{"file", one.file.empty() ? 0 : files.number(one.file)},
                    {"line", visible.pos.line},
                    {"column", visible.pos.column},
                    {"length", visible.pos.length},
                    {"severity", name(one.severity())},
                    {"code", code_name(one.code)},
                    {"message", visible.message},
                    {"help", code_info(one.code).help}});
  }
  return list;
}

/// The lines that have taken time, in the order of the program.
Json lines(const ReportedRun& run, PackedData& data) {
  constexpr double kMilliseconds = 0.1;
  const auto& lines = run.lines;
  const auto column = [&](double scale, Order order, auto&& of) {
    return data.add_column(lines.size(), scale, order, [&](std::size_t i) { return of(lines[i]); });
  };
  using runtime::LineTime;
  Json json;
  json["file"] = column(1, Order::differences, [](const LineTime& line) { return line.file; });
  json["line"] = column(1, Order::differences, [](const LineTime& line) { return line.line; });
  json["ms"] = column(kMilliseconds, Order::values,
                      [](const LineTime& line) { return ms_from_s(line.seconds); });
  json["lost_ms"] = column(kMilliseconds, Order::values,
                           [](const LineTime& line) { return ms_from_s(line.lost); });
  return json;
}

std::array<double, kAxes> numbers(const AxisVector& point) {
  return {point[0], point[1], point[2]};
}

/// Of the work systems that moves belong to.
Json origins(const ReportedRun& run) {
  Json list = Json::array();
  for (const auto& [system, origin] : run.origins)
    list.push_back({{"name", hal::system_name(system)}, {"at_mm", numbers(origin)}});
  return list;
}

Json workpieces(const ReportedRun& run) {
  Json list = Json::array();
  for (const StockOutline& stock : run.stocks) {
    Json edges = Json::array();
    for (const auto& [from, to] : stock.edges)
      for (const AxisVector& point : {from, to})
        for (const double mm : numbers(point)) edges.push_back(mm);
    list.push_back({{"name", name(stock.shape)},
                    {"file", stock.file},
                    {"line", stock.line},
                    {"edges_mm", std::move(edges)}});
  }
  return list;
}

void add_figures(const ReportedRun& run, Json& json) {
  json["program"] = run.name;
  json["source"] = name(run.kind);
  json["machine"] = run.machine ? run.machine->name : "";
  if (!run.machine_file.empty()) json["machine_file"] = run.machine_file;
  if (run.machine) json["method"] = name(run.machine->control.interpolation);
  json["status"] = name(run.ending);
  json["time_s"] = run.time;
  json["length_mm"] = run.length;
  json["setpoints"] = run.setpoints;
  json["blocks"] = run.blocks;
  json["period_s"] = run.period;
  json["axis_limits"] = run.machine ? axis_limits(*run.machine) : Json::array();
  json["limits"] = kLimitNames;
  json["time_by_limit_s"] = time_by_limit(run);
  json["tools"] = tools(run.sheet);
  if (run.kind == InputKind::program) json["rests"] = rests(run.sheet);
  if (!run.origins.empty()) json["origins"] = origins(run);
  if (!run.stocks.empty()) json["workpieces"] = workpieces(run);
  json["figures"] = figures(run.figures);
  json["worst_lines"] = worst(run);
}

Json axes(const ReportedRun& run) {
  Json list = Json::array();
  for (int i = 0; i < kAxes; ++i)
    if (!run.machine || run.machine->axes[static_cast<std::size_t>(i)].present)
      list.push_back(hal::axis_name(i));
  return list;
}

}  // namespace

Json run_json(const ReportedRun& run, PackedData& data) {
  Json json;
  add_figures(run, json);
  Files files(run, data);
  json["diagnostics"] = diagnostics(run, files);
  json["files"] = files.take();
  json["axes"] = axes(run);
  const runtime::RunHistory& history = *run.history;
  json["error_um"] = um_from_mm(with_steps(history.position_error()));
  json["error_mm_s"] = with_steps(history.speed_error());
  json["nodes"] = node_columns(history, json["axes"], data);
  json["spans"] = span_columns(history, data);
  json["lines"] = lines(run, data);
  if (run.surface) json["surface"] = surface_json(*run.surface, data);
  return json;
}

}  // namespace softcnc::app
