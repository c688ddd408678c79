// SPDX-License-Identifier: MIT
#include "runtime/history/read_trace.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "hal/files/axis_name.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kDefaultPeriod = 0.001;  // s: of a trace of one row that does not state it
constexpr double kMostRows = 9e15;        // all whole numbers below are doubles
constexpr double kLargestNumber = 2147483647;

using Place = std::optional<std::size_t>;  // of a column in the selection

/// The columns of a trace that make a row.
class RowColumns {
 public:
  explicit RowColumns(const std::vector<std::string>& columns) : columns_(columns) {
    time = place("t_s");
    line = place("line");
    block = place("block");
    s = place("s_mm");
    v = place("v_mm_s");
    limit = place(hal::kLimitColumn);
    for (int axis = 0; axis < kAxes; ++axis)
      axes[static_cast<std::size_t>(axis)] = place(hal::axis_name(axis) + "_mm");
    feed = place("feed_mm_s");
    chord_error = place("chord_error_um");
    contour = place("contour_um");
    rmax = place("rmax_um");
  }

  /// Returns the name of a column that no trace is without, and this one is; empty: none.
  std::string missing() const {
    const std::pair<const Place&, const char*> needed[] = {{time, "t_s"},    {line, "line"},
                                                           {block, "block"}, {s, "s_mm"},
                                                           {v, "v_mm_s"},    {limit, "limit"}};
    for (const auto& [place, name] : needed)
      if (!place) return name;
    const bool has_axis = std::any_of(axes.begin(), axes.end(), [](Place axis) { return !!axis; });
    return has_axis ? std::string() : "x_mm";
  }

  std::span<const std::size_t> selection() const noexcept { return selection_; }

  Place time, line, block, s, v, limit, feed, chord_error, contour, rmax;
  std::array<Place, kAxes> axes;

 private:
  Place place(std::string_view name) {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end()) return std::nullopt;
    selection_.push_back(static_cast<std::size_t>(found - columns_.begin()));
    return selection_.size() - 1;
  }

  const std::vector<std::string>& columns_;
  std::vector<std::size_t> selection_;
};

class TraceRowReader {
 public:
  TraceRowReader(hal::TraceReader& reader, RunRowSink& rows)
      : reader_(reader), rows_(rows), columns_(reader.columns()) {}

  Result<TraceFacts> read(const std::string& name);

 private:
  Status take();
  Status check() const;
  Status set_period(double time);
  void pass(RunRow row, double time);
  MotionKind motion(const RunRow& row) const;
  Status wrong(std::size_t place, std::string why) const {
    return tl::make_unexpected(reader_.wrong_value(place, std::move(why)));
  }
  double value(std::size_t place) const { return reader_.values()[place]; }
  float optional(Place place) const {
    return place ? static_cast<float>(value(*place)) : RunRow::kUnknown;
  }

  hal::TraceReader& reader_;
  RunRowSink& rows_;
  RowColumns columns_;
  TraceFacts facts_;
  std::optional<RunRow> first_;  // until the period is known
  double first_time_ = 0, time_ = 0;
  RunRow last_;
};

Result<TraceFacts> TraceRowReader::read(const std::string& name) {
  if (const std::string missing = columns_.missing(); !missing.empty())
    return tl::make_unexpected(Diagnostic{
        .code = Code::SC6082, .message = "is no trace: it has no column " + missing, .file = name});
  if (Status selected = reader_.select(columns_.selection()); !selected)
    return tl::make_unexpected(std::move(selected.error()));
  for (std::size_t axis = 0; axis < columns_.axes.size(); ++axis)
    if (columns_.axes[axis]) facts_.axes.push_back(hal::axis_name(static_cast<int>(axis))[0]);
  for (;;) {
    const auto more = reader_.next();
    if (!more) return tl::make_unexpected(more.error());
    if (!*more) break;
    if (Status taken = take(); !taken) return tl::make_unexpected(std::move(taken.error()));
  }
  if (first_) {
    facts_.period = kDefaultPeriod;
    pass(*first_, first_time_);
  }
  facts_.program_hash = reader_.comment().program_hash;
  facts_.machine_hash = reader_.comment().machine_hash;
  if (facts_.period == 0) facts_.period = reader_.comment().period;
  return std::move(facts_);
}

/// What a run cannot have.
Status TraceRowReader::check() const {
  for (const Place place : {columns_.time, columns_.s, columns_.v, columns_.feed, columns_.axes[0],
                            columns_.axes[1], columns_.axes[2]})
    if (place && !std::isfinite(value(*place))) return wrong(*place, "no finite number");
  for (const Place place : {columns_.line, columns_.block})
    if (value(*place) != std::floor(value(*place)) || std::abs(value(*place)) > kLargestNumber)
      return wrong(*place, "no number of a line or a block");
  if (facts_.rows + (first_ ? 1 : 0) > 0 && !(value(*columns_.time) > time_))
    return wrong(*columns_.time, "not later than the row before");
  return {};
}

Status TraceRowReader::take() {
  if (Status good = check(); !good) return good;
  RunRow row;
  row.line = static_cast<int>(value(*columns_.line));
  row.block = static_cast<int>(value(*columns_.block));
  row.limit = reader_.limit();
  row.s = value(*columns_.s);
  row.v = value(*columns_.v);
  row.feed = columns_.feed ? value(*columns_.feed) : 0;
  for (int axis = 0; axis < kAxes; ++axis)
    if (const Place place = columns_.axes[static_cast<std::size_t>(axis)])
      row.position[axis] = value(*place);
  row.chord_error = optional(columns_.chord_error);
  row.contour = optional(columns_.contour);
  row.rmax = optional(columns_.rmax);
  time_ = value(*columns_.time);
  if (facts_.period == 0) facts_.period = reader_.comment().period;
  if (facts_.period == 0 && !first_) {
    first_ = row;
    first_time_ = time_;
    return {};
  }
  if (Status known = set_period(time_); !known) return known;
  pass(row, time_);
  return {};
}

/// Errors: SC6082, where no period makes whole numbers of the times.
Status TraceRowReader::set_period(double time) {
  constexpr double kRounding = 0.01;  // of a period
  if (facts_.period == 0) facts_.period = time - first_time_;
  const double periods = time / facts_.period;
  if (!(std::abs(periods) < kMostRows) || std::abs(periods - std::round(periods)) > kRounding)
    return wrong(*columns_.time, "no whole number of periods");
  if (first_) pass(*std::exchange(first_, std::nullopt), first_time_);
  return {};
}

void TraceRowReader::pass(RunRow row, double time) {
  row.period = std::llround(time / facts_.period);
  row.motion = motion(row);
  rows_.take(row);
  ++facts_.rows;
  last_ = row;
}

MotionKind TraceRowReader::motion(const RunRow& row) const {
  if (facts_.rows == 0 || row.position == last_.position) return MotionKind::rest;
  const bool rapid = columns_.feed ? row.feed == 0 : row.limit == Limit::rapid;
  return rapid ? MotionKind::rapid : MotionKind::cutting;
}

Result<TraceFacts> read_rows(Result<std::unique_ptr<hal::TraceReader>> reader,
                             const std::string& name, RunRowSink& rows) {
  if (!reader) return tl::make_unexpected(std::move(reader.error()));
  return TraceRowReader(**reader, rows).read(name);
}

}  // namespace

Result<TraceFacts> read_trace(const std::string& file, RunRowSink& rows) {
  return read_rows(hal::TraceReader::open(file), file, rows);
}

Result<TraceFacts> read_trace(hal::ZipEntry trace, const std::string& name, RunRowSink& rows) {
  return read_rows(hal::TraceReader::open(std::move(trace), name), name, rows);
}

}  // namespace softcnc::runtime
