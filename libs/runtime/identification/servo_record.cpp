// SPDX-License-Identifier: MIT
#include "runtime/identification/servo_record.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "hal/files/axis_name.hpp"
#include "hal/trace/trace_reader.hpp"

namespace softcnc::runtime {
namespace {

/// The columns that are read, and where in the selection each of them is.
class ServoColumns {
 public:
  explicit ServoColumns(const std::vector<std::string>& columns) : columns_(columns) {
    time = place("t_s");
    for (int axis = 0; axis < kAxes; ++axis) {
      const std::string name = hal::axis_name(axis);
      const auto actual_place = place(name + "_act_mm");
      if (!actual_place) continue;
      auto sent = place(name + "_cmd_mm");
      if (!sent) sent = place(name + "_mm");
      if (sent) axes[static_cast<std::size_t>(axis)] = {*sent, *actual_place};
    }
  }

  bool complete() const {
    return time && std::any_of(axes.begin(), axes.end(), [](const auto& axis) { return !!axis; });
  }
  const std::vector<std::size_t>& selection() const noexcept { return selection_; }

  struct Pair {
    std::size_t commanded, actual;
  };
  std::optional<std::size_t> time;
  std::array<std::optional<Pair>, kAxes> axes;

 private:
  std::optional<std::size_t> place(std::string_view name) {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end()) return std::nullopt;
    selection_.push_back(static_cast<std::size_t>(found - columns_.begin()));
    return selection_.size() - 1;
  }

  const std::vector<std::string>& columns_;
  std::vector<std::size_t> selection_;
};

tl::unexpected<Diagnostic> no_record(const std::string& file, std::string why) {
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6100, .message = std::move(why), .file = file});
}

/// Errors: SC6082, where a position is no number.
Status take(const hal::TraceReader& reader, const ServoColumns& columns, ServoRecord& record) {
  const auto values = reader.values();
  for (std::size_t axis = 0; axis < columns.axes.size(); ++axis) {
    if (!columns.axes[axis]) continue;
    for (const std::size_t place : {columns.axes[axis]->commanded, columns.axes[axis]->actual})
      if (!std::isfinite(values[place]))
        return tl::make_unexpected(reader.wrong_value(place, "no finite number"));
    record.axes[axis].commanded.push_back(values[columns.axes[axis]->commanded]);
    record.axes[axis].actual.push_back(values[columns.axes[axis]->actual]);
  }
  return {};
}

}  // namespace

Result<ServoRecord> read_servo_record(const std::string& file) {
  auto reader = hal::TraceReader::open(file);
  if (!reader) return tl::make_unexpected(std::move(reader.error()));
  const ServoColumns columns((*reader)->columns());
  if (!columns.complete())
    return no_record(file, "has no actual positions (columns such as x_act_mm)");
  if (Status selected = (*reader)->select(columns.selection()); !selected)
    return tl::make_unexpected(std::move(selected.error()));
  ServoRecord record;
  double first = 0, last = 0;
  std::size_t rows = 0;
  for (;; ++rows) {
    const auto more = (*reader)->next();
    if (!more) return tl::make_unexpected(more.error());
    if (!*more) break;
    last = (*reader)->values()[*columns.time];
    if (rows == 0) first = last;
    if (Status taken = take(**reader, columns, record); !taken)
      return tl::make_unexpected(std::move(taken.error()));
  }
  if (rows < 2 || !(last > first)) return no_record(file, "has no motion: fewer than two rows");
  record.period = (last - first) / static_cast<double>(rows - 1);
  return record;
}

}  // namespace softcnc::runtime
