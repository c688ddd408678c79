// SPDX-License-Identifier: MIT
#include "difference/difference_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::app {
namespace {

using runtime::Aspect, runtime::AspectDifference, runtime::StoredRow, runtime::TimePair;

double seconds(const StoredRow& row, const ComparedRun& run) {
  return static_cast<double>(row.period) * run.rows.period();
}

constexpr double kPicometres = 1e6;  // in a um; what is smaller is rounding

/// A line of the table of both runs.
std::string figures(const std::string& label, double a, double b) {
  std::string line = fmt::format("  {:<16}{:>16.6f}{:>16.6f}{:>+16.6f}", label, a, b, b - a);
  if (a > 0 && a != b) line += fmt::format("{:>+11.3f} %", 100 * (b - a) / a);
  return line + '\n';
}

std::string times_text(const ComparedPair& pair) {
  const runtime::RowStore &a = pair.a.rows, &b = pair.b.rows;
  std::string text = fmt::format("  {:<16}{:>16}{:>16}{:>16}\n", "", "A", "B", "B - A");
  text += figures("time, s", pair.difference.time.a, pair.difference.time.b);
  text += figures("length, mm", a.length(), b.length());
  const auto rows_a = static_cast<std::int64_t>(a.rows().size());
  const auto rows_b = static_cast<std::int64_t>(b.rows().size());
  text += fmt::format("  {:<16}{:>16}{:>16}{:>+16}\n", "rows", rows_a, rows_b, rows_b - rows_a);
  if (!pair.difference.same_period)
    text += figures("period, ms", ms_from_s(a.period()), ms_from_s(b.period()));
  if (std::isfinite(a.contour()) || std::isfinite(b.contour()))
    text += figures("contour max, um", double{a.contour()}, double{b.contour()});
  return text;
}

std::string limits_text(const runtime::RunDifference& difference) {
  std::string text;
  for (std::size_t i = 0; i < difference.by_limit.size(); ++i) {
    const TimePair& time = difference.by_limit[i];
    if (time.a > 0 || time.b > 0) text += figures(std::string(kLimitNames[i]), time.a, time.b);
  }
  return text.empty() ? text : "\ntime by limit, s\n" + text;
}

/// The values of the machines that differ, where both are known.
std::string machines_text(const ComparedPair& pair) {
  const auto differing = machine_differences(pair);
  if (differing.empty()) return {};
  std::string text = fmt::format("\nmachine: {} value{}\n", differing.size(),
                                 differing.size() == 1 ? " differs" : "s differ");
  for (const hal::DifferingValue& value : differing)
    text += fmt::format("  {:<38} {:>16} {:>16}\n", value.key, value.a.empty() ? "-" : value.a,
                        value.b.empty() ? "-" : value.b);
  return text;
}

std::string lines_text(const runtime::RunDifference& difference, std::size_t most) {
  const auto& lines = difference.by_line;
  if (lines.empty()) return {};
  std::string text = fmt::format("\ntime by line, s: {} line{}", lines.size(),
                                 lines.size() == 1 ? " differs" : "s differ");
  text += lines.size() > most ? fmt::format(", the {} that differ most\n", most) : "\n";
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
    text += figures(fmt::format("line {}", lines[i].line), lines[i].time.a, lines[i].time.b);
  return text;
}

std::string verdict(Aspect aspect, const AspectDifference& own) {
  const auto replayed = runtime::replay_margins()[static_cast<std::size_t>(aspect)];
  if (own.same) return own.largest > replayed.allowed(0) ? "within" : "same";
  return own.judged ? "differs" : "differs, not judged";
}

std::string aspects_text(const ComparedPair& pair) {
  std::string text = fmt::format("\n  {:<12}{:>20}{:>16}\n", "", "difference", "tolerance");
  for (std::size_t i = 0; i < runtime::kAspects; ++i) {
    const auto aspect = static_cast<Aspect>(i);
    const AspectDifference& own = pair.difference.of(aspect);
    const bool is_measured = pair.difference.same_period || !is_of_rows(aspect);
    text += fmt::format("  {:<12}{:>20}{:>16}  {}\n", name(aspect),
                        is_measured ? amount(aspect, own.largest) : "-",
                        own.judged ? amount(aspect, own.allowed) : "-", verdict(aspect, own));
  }
  return text;
}

std::string coordinates(const StoredRow& row) {
  std::string text;
  for (std::size_t axis = 0; axis < row.position.size(); ++axis)
    text += fmt::format("{}{}{:.6g}", axis == 0 ? "" : " ", kAxisLetters[axis], row.position[axis]);
  return text;
}

/// Where the paths are farthest apart.
std::string place_text(const ComparedPair& pair) {
  const auto& distance = pair.difference.distance;
  if (!distance || pair.difference.of(Aspect::path).same) return {};
  const ComparedRun& run = distance->of_first ? pair.a : pair.b;
  const StoredRow& row = run.rows.rows()[distance->index];
  return fmt::format("\nthe paths are farthest apart, by {}, at {:.9g} s of {}, line {}, {}\n",
                     amount(Aspect::path, distance->distance), seconds(row, run),
                     distance->of_first ? "A" : "B", row.line, coordinates(row));
}

/// The position along the axis that differs most.
std::string position_difference(const StoredRow& a, const StoredRow& b) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < a.position.size(); ++i)
    if (std::abs(b.position[i] - a.position[i]) > std::abs(b.position[axis] - a.position[axis]))
      axis = i;
  return fmt::format("{} is {:.12g} mm in A and {:.12g} mm in B", kAxisLetters[axis],
                     a.position[axis], b.position[axis]);
}

std::string value_difference(Aspect aspect, const StoredRow& a, const StoredRow& b) {
  if (aspect == Aspect::position) return position_difference(a, b);
  if (aspect == Aspect::speed)
    return fmt::format("the speed is {:.9g} mm/s in A and {:.9g} mm/s in B", a.v, b.v);
  if (aspect == Aspect::line) return fmt::format("the line is {} in A and {} in B", a.line, b.line);
  return fmt::format("the limit is {} in A and {} in B", softcnc::name(a.limit),
                     softcnc::name(b.limit));
}

}  // namespace

std::vector<hal::DifferingValue> machine_differences(const ComparedPair& pair) {
  if (!pair.a.machine || !pair.b.machine) return {};
  return hal::differing_values(*pair.a.machine, *pair.b.machine);
}

std::string amount(Aspect aspect, double value) {
  switch (aspect) {
    case Aspect::time:
      return fmt::format("{:.6g} s", value);
    case Aspect::path:
    case Aspect::position:
      return fmt::format("{:.6g} um", std::round(um_from_mm(value) * kPicometres) / kPicometres);
    case Aspect::speed:
      return fmt::format("{:.6g} mm/s", value);
    case Aspect::line:
    case Aspect::limit:
      break;
  }
  return fmt::format("{:.0f} row{}", value, value == 1 ? "" : "s");
}

std::string first_difference(const ComparedPair& pair) {
  const auto aspect = pair.difference.first();
  if (!aspect) return {};
  if (!pair.difference.same_period)
    return fmt::format("the periods differ: {:.9g} ms in A and {:.9g} ms in B",
                       ms_from_s(pair.a.rows.period()), ms_from_s(pair.b.rows.period()));
  const auto row = static_cast<std::size_t>(*pair.difference.of(*aspect).first_row);
  const auto rows_a = pair.a.rows.rows(), rows_b = pair.b.rows.rows();
  if (row >= rows_a.size() || row >= rows_b.size())
    return fmt::format("row {} is the first one of {} after the last one of {}", row + 1,
                       row < rows_a.size() ? "A" : "B", row < rows_a.size() ? "B" : "A");
  return fmt::format("row {}, at {:.9g} s, line {}: {}", row + 1, seconds(rows_a[row], pair.a),
                     rows_a[row].line, value_difference(*aspect, rows_a[row], rows_b[row]));
}

namespace {

/// Where one run has more rows, no value needs to be beyond its margin.
std::string failure_message(const ComparedPair& pair, Aspect aspect) {
  const AspectDifference& own = pair.difference.of(aspect);
  if (own.largest <= own.allowed) return first_difference(pair);
  return fmt::format("{} differs by {}, and {} are allowed", name(aspect),
                     amount(aspect, own.largest), amount(aspect, own.allowed));
}

std::string failure_details(const ComparedPair& pair, Aspect aspect) {
  if (aspect == Aspect::time) return times_text(pair);
  return aspect == Aspect::path ? place_text(pair) : first_difference(pair);
}

}  // namespace

std::string difference_text(const ComparedPair& pair, std::size_t lines) {
  std::string text = fmt::format("A: {} ({})\nB: {} ({})\n\n", pair.a.name, name(pair.a.kind),
                                 pair.b.name, name(pair.b.kind));
  text += times_text(pair) + machines_text(pair) + limits_text(pair.difference) +
          lines_text(pair.difference, lines) + aspects_text(pair) + place_text(pair);
  if (const std::string first = first_difference(pair); !first.empty())
    text += fmt::format("\nthe first row that differs is {}\n", first);
  return text;
}

std::vector<TestCase> difference_cases(const ComparedPair& pair) {
  std::vector<TestCase> cases;
  for (std::size_t i = 0; i < runtime::kAspects; ++i) {
    const auto aspect = static_cast<Aspect>(i);
    const AspectDifference& own = pair.difference.of(aspect);
    TestCase& test = cases.emplace_back();
    test.name = test.type = name(aspect);
    if (!own.judged) {
      test.result = TestResult::skipped;
      test.message = "not judged";
    } else if (!own.same) {
      test.result = TestResult::failed;
      test.message = failure_message(pair, aspect);
      test.details = failure_details(pair, aspect);
    }
  }
  return cases;
}

}  // namespace softcnc::app
