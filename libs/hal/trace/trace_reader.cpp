// SPDX-License-Identifier: MIT
#include "hal/trace/trace_reader.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include "hal/trace/trace_csv_reader.hpp"
#include "hal/trace/trace_npz_reader.hpp"
#include "motion/core/axes.hpp"
#include "motion/core/units.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::hal {
namespace {

/// Returns what follows `key` in a line; empty where the line does not begin with it.
std::string_view value_of(std::string_view line, std::string_view key) {
  if (!line.starts_with(key)) return {};
  line.remove_prefix(key.size());
  const auto last = line.find_last_not_of(" \r\n");
  return last == line.npos ? std::string_view() : line.substr(0, last + 1);
}

template <typename T>
void read_number(std::string_view text, T& to) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) to = value;
}

}  // namespace

void read_trace_comment(std::string_view line, TraceComment& comment) {
  read_number(value_of(line, "# schema: softcnc-trace "), comment.schema);
  double period_ms = 0;
  read_number(value_of(line, "# period_ms: "), period_ms);
  if (std::isfinite(period_ms) && period_ms > 0) comment.period = s_from_ms(period_ms);
  if (const auto hash = value_of(line, "# program: "); !hash.empty()) comment.program_hash = hash;
  if (const auto hash = value_of(line, "# machine: "); !hash.empty()) comment.machine_hash = hash;
}

TraceReader::Bound TraceReader::bound_of(std::string_view column) noexcept {
  if (column == "t_s") return Bound::time;
  const bool of_axis = column.size() > 2 && column[1] == '_' && axis_index(column[0]) >= 0;
  const std::string_view what = of_axis ? column.substr(1) : std::string_view();
  const bool position = what == "_mm" || what == "_act_mm" || what == "_cmd_mm";
  return position ? Bound::position : Bound::none;
}

Status TraceReader::select(std::span<const std::size_t> columns) {
  bounds_.clear();
  before_.clear();
  for (const std::size_t column : columns) bounds_.push_back(bound_of(columns_[column]));
  return select_columns(columns);
}

Result<bool> TraceReader::next() {
  auto read = read_next();
  if (!read || !*read) return read;
  for (std::size_t i = 0; i < bounds_.size(); ++i)
    if (std::string why = excess(i); !why.empty())
      return tl::make_unexpected(wrong_value(i, std::move(why)));
  before_ = values_;
  return true;
}

/// Returns what is wrong with a value; empty where nothing is.
std::string TraceReader::excess(std::size_t selected) const {
  const double value = values_[selected];
  const bool first = before_.empty();
  switch (bounds_[selected]) {
    case Bound::time:
      if (!std::isfinite(value)) return "a time that is no number";
      return first || value >= before_[selected] ? "" : "the time runs back";
    case Bound::position:
      if (std::isnan(value)) return "";  // of rows in which it is not known
      if (!is_near(value)) return "a position beyond 1000 m";
      if (!first && std::abs(value - before_[selected]) > kLongestStep)
        return "a position more than 10 m from that of the row before";
      return "";
    case Bound::none:
      break;
  }
  return "";
}

Result<std::unique_ptr<TraceReader>> TraceReader::open(const std::string& file) {
  std::string_view name = file;
  const bool compressed = name.ends_with(".zst");
  if (compressed) name.remove_suffix(std::string_view(".zst").size());
  if (name.ends_with(".csv")) return open_csv_trace(file);
  if (name.ends_with(".npz")) return open_npz_trace(file, compressed);
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6014,
                 .message = "a trace that is read ends in .csv or .npz, or one of them and .zst",
                 .file = file});
}

Result<std::unique_ptr<TraceReader>> TraceReader::open(ZipEntry csv, const std::string& name) {
  return open_csv_trace(CompressedFile(std::move(csv), name, Code::SC6081, Code::SC6082), name);
}

}  // namespace softcnc::hal
