// SPDX-License-Identifier: MIT
#include "output/comparison_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "hal/files/number.hpp"
#include "runtime/comparison/compared_figure.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kComparisonSchema = 1;

/// Characters: of the column of methods.
constexpr std::size_t kNameWidth =
    std::max_element(kMethodNames.begin(), kMethodNames.end(),
                     [](auto a, auto b) { return a.size() < b.size(); }) -> size();

/// The column of a figure for a person: two lines, the first of which may stand over several.
struct Heading {
  const char* above;
  const char* below;
};
constexpr std::array kHeadings{
    Heading{"", "time, s"},        Heading{"chord", "max, um"},
    Heading{"error", "rms, um"},   Heading{"off path", "max, um"},
    Heading{"feed", "max"},        Heading{"fluct.", "rms"},
    Heading{"", "99 %"},           Heading{"chord", "max"},
    Heading{"fluct.", "rms"},      Heading{"", "99 %"},
    Heading{"accel. /", "limit"},  Heading{"jerk /", "limit"},
    Heading{"contour", "max, um"}, Heading{"error", "rms, um"},
};

/// How a text cell is taken from a spread.
using SpreadPart = double runtime::Spread::*;

std::string heading(std::string_view title) {
  std::string above(kNameWidth, ' '), below = fmt::format("{:<{}}", title, kNameWidth);
  for (const Heading& column : kHeadings) {
    above += fmt::format("{:>10}", column.above);
    below += fmt::format("{:>10}", column.below);
  }
  return above + '\n' + below + '\n';
}

std::string line_of(const ComparisonRow& row, SpreadPart part) {
  std::string text = fmt::format("{:<{}}", name(row.method), kNameWidth);
  if (!row.note.empty()) return text + "  " + row.note + '\n';
  for (const auto& spread : row.spreads)
    text += fmt::format("{:>10}", spread ? fmt::format("{:.4g}", *spread.*part) : "-");
  return text + '\n';
}

bool is_same_run(const ComparisonRow& a, const ComparisonRow& b) {
  return a.program == b.program && a.machine == b.machine && a.machine_file == b.machine_file;
}

std::string table(std::string_view title, std::span<const ComparisonRow> rows, SpreadPart part) {
  std::string text = heading(title);
  for (const ComparisonRow& row : rows) text += line_of(row, part);
  return text;
}

std::string machine_text(const ComparisonRow& row) {
  if (row.machine_file.empty()) return row.machine;
  return fmt::format("{} ({})", row.machine, row.machine_file);
}

std::string tables(std::span<const ComparisonRow> rows) {
  const ComparisonRow& first = rows.front();
  if (first.phases == 1)
    return fmt::format("{} on {}\n\n{}", first.program, machine_text(first),
                       table("method", rows, &runtime::Spread::worst));
  return fmt::format("{} on {}, begun at {} places within the period\n\n{}\n{}", first.program,
                     machine_text(first), first.phases,
                     table("median", rows, &runtime::Spread::median),
                     table("worst", rows, &runtime::Spread::worst));
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

std::string csv_number(const std::optional<runtime::Spread>& spread, SpreadPart part) {
  return spread ? hal::number_text(*spread.*part) : std::string();
}

std::string csv_line(const ComparisonRow& row) {
  std::string text = fmt::format("{},{},{},{},{}", csv_field(row.program), csv_field(row.machine),
                                 csv_field(row.machine_file), name(row.method), row.phases);
  for (const auto& spread : row.spreads)
    text += fmt::format(",{},{}", csv_number(spread, &runtime::Spread::median),
                        csv_number(spread, &runtime::Spread::worst));
  return text + ',' + csv_field(row.note) + '\n';
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json json_of(const ComparisonRow& row) {
  Json object{{"program", row.program},
              {"machine", row.machine},
              {"machine_file", text_or_null(row.machine_file)},
              {"method", name(row.method)},
              {"phases", row.phases}};
  const auto figures = runtime::compared_figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto& spread = row.spreads[i];
    const std::string figure(figures[i].name);
    object[figure + "_median"] = spread ? Json(spread->median) : Json();
    object[figure + "_worst"] = spread ? Json(spread->worst) : Json();
  }
  object["note"] = text_or_null(row.note);
  return object;
}

}  // namespace

std::string comparison_text(std::span<const ComparisonRow> rows) {
  std::string text;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    while (end < rows.size() && is_same_run(rows[begin], rows[end])) ++end;
    if (begin > 0) text += '\n';
    text += tables(rows.subspan(begin, end - begin));
  }
  return text;
}

std::string comparison_csv(std::span<const ComparisonRow> rows) {
  std::string text = "program,machine,machine_file,method,phases";
  for (const runtime::ComparedFigure& figure : runtime::compared_figures())
    text += fmt::format(",{0}_median,{0}_worst", figure.name);
  text += ",note\n";
  for (const ComparisonRow& row : rows) text += csv_line(row);
  return text;
}

std::string comparison_json(std::span<const ComparisonRow> rows) {
  Json document{{"schema", kComparisonSchema}, {"rows", Json::array()}};
  for (const ComparisonRow& row : rows) document["rows"].push_back(json_of(row));
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace softcnc::app
