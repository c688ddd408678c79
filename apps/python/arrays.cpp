// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <algorithm>
#include <cstring>

#include "hal/files/axis_name.hpp"
#include "hal/trace/trace_npz.hpp"

namespace softcnc::python {

namespace py = pybind11;

std::byte* GrowingBytes::add(std::size_t size) noexcept {
  constexpr std::size_t kFirst = 4096;
  if (size_ + size > capacity_) {
    const std::size_t capacity = std::max({2 * capacity_, size_ + size, kFirst});
    void* moved = std::realloc(bytes_.get(), capacity);
    if (moved == nullptr) return nullptr;
    (void)bytes_.release();
    bytes_.reset(static_cast<std::byte*>(moved));
    capacity_ = capacity;
  }
  std::byte* end = bytes_.get() + size_;
  size_ += size;
  return end;
}

void* GrowingBytes::release() noexcept {
  void* bytes = bytes_.release();
  void* shrunk = size_ > 0 ? std::realloc(bytes, size_) : nullptr;
  size_ = capacity_ = 0;
  return shrunk != nullptr ? shrunk : bytes;
}

ArrayTrace::ArrayTrace(const Machine& machine, const std::vector<std::string>& further,
                       const std::optional<std::vector<std::string>>& asked)
    : time_(machine.control.period), columns_(all_columns(machine, further)) {
  if (!asked) return;
  std::vector<Column> kept;
  for (const std::string& column : *asked) {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const Column& one) { return one.name == column; });
    if (found == columns_.end()) throw py::value_error("no column '" + column + "' in this run");
    kept.push_back({found->name, found->source, found->index});
  }
  columns_ = std::move(kept);
}

std::vector<ArrayTrace::Column> ArrayTrace::all_columns(const Machine& machine,
                                                        const std::vector<std::string>& further) {
  std::vector<Column> columns;
  const auto add_column = [&](const std::string& column, Source source, std::size_t index = 0) {
    columns.push_back({column, source, index});
  };
  add_column("t_s", Source::t);
  add_column("line", Source::line);
  add_column("block", Source::block);
  add_column("s_mm", Source::s);
  add_column("v_mm_s", Source::v);
  add_column("a_mm_s2", Source::a);
  add_column("limit", Source::limit);
  for (int axis = 0; axis < kAxes; ++axis)
    if (const auto i = static_cast<std::size_t>(axis); machine.axes[i].present)
      add_column(hal::axis_name(axis) + "_mm", Source::axis, i);
  add_column("feed_mm_s", Source::feed);
  for (std::size_t i = 0; i < further.size(); ++i)
    add_column(further[i],
               further[i].ends_with("_count") ? Source::further_whole : Source::further_real, i);
  return columns;
}

void ArrayTrace::row(const Setpoint& setpoint, std::span<const double> further) noexcept {
  for (Column& column : columns_) write(column, setpoint, further);
}

void ArrayTrace::write(Column& column, const Setpoint& setpoint,
                       std::span<const double> further) noexcept {
  const auto real = [&](double value) { add(column, value + 0.0); };  // no -0
  const auto whole = [&](std::int64_t value) { add(column, value); };
  switch (column.source) {
    case Source::t:
      return real(time_(setpoint.period));
    case Source::line:
      return whole(setpoint.line);
    case Source::block:
      return whole(setpoint.block);
    case Source::s:
      return real(setpoint.s);
    case Source::v:
      return real(setpoint.v);
    case Source::a:
      return real(setpoint.a);
    case Source::limit:
      return add_text(column, name(setpoint.limit));
    case Source::axis:
      return real(setpoint.position[static_cast<Eigen::Index>(column.index)]);
    case Source::feed:
      return real(setpoint.feed);
    case Source::further_real:
      return real(further[column.index]);
    case Source::further_whole:
      return whole(static_cast<std::int64_t>(further[column.index]));
  }
}

template <typename T>
void ArrayTrace::add(Column& column, T value) noexcept {
  std::byte* to = column.bytes.add(sizeof value);
  if (to == nullptr)
    ok_ = false;
  else
    std::memcpy(to, &value, sizeof value);
}

/// Characters of four bytes, padded with zeros.
void ArrayTrace::add_text(Column& column, std::string_view text) noexcept {
  static const std::size_t length = hal::longest_limit();
  for (std::size_t i = 0; i < length; ++i)
    add(column, i < text.size() ? static_cast<char32_t>(text[i]) : char32_t{0});
}

py::dict ArrayTrace::take() {
  py::dict arrays;
  for (Column& column : columns_) {
    const bool is_text = column.source == Source::limit;
    const bool is_whole = column.source == Source::line || column.source == Source::block ||
                          column.source == Source::further_whole;
    const py::dtype type(is_text ? "U" + std::to_string(hal::longest_limit())
                                 : std::string(is_whole ? "i8" : "f8"));
    const auto rows = static_cast<py::ssize_t>(column.bytes.size()) / type.itemsize();
    if (rows == 0) {
      arrays[py::str(column.name)] = py::array(type, py::array::ShapeContainer{0});
      continue;
    }
    void* bytes = column.bytes.release();
    const py::capsule owner(bytes, [](void* owned) { std::free(owned); });
    arrays[py::str(column.name)] = py::array(type, {rows}, {type.itemsize()}, bytes, owner);
  }
  return arrays;
}

}  // namespace softcnc::python
