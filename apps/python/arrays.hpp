// SPDX-License-Identifier: MIT
// The rows of a run as arrays, one for each column that is asked for.
#pragma once

#include <pybind11/numpy.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hal/trace/trace.hpp"
#include "hal/trace/trace_csv.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::python {

/// Memory that grows at its end, where the system moves pages instead of bytes, and that an array
/// of numpy takes over.
class GrowingBytes {
 public:
  /// Returns room for so many bytes more, or null where there is none.
  std::byte* add(std::size_t size) noexcept;
  std::size_t size() const noexcept { return size_; }
  /// Returns the memory, which the caller then frees, without what has not been used.
  void* release() noexcept;

 private:
  struct Free {
    void operator()(void* bytes) const noexcept { std::free(bytes); }
  };
  std::unique_ptr<std::byte, Free> bytes_;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Writes rows into arrays. Columns are those of a trace, with their names and types in an .npz
/// file: numbers as 8 bytes, the limit as text.
class ArrayTrace final : public hal::TraceWriter {
 public:
  /// `further` are the columns after those of every trace. Only columns of `asked` are kept, in
  /// that order; all where it is empty. Raises ValueError for one that is no column.
  ArrayTrace(const Machine& machine, const std::vector<std::string>& further,
             const std::optional<std::vector<std::string>>& asked);

  void row(const Setpoint& setpoint, std::span<const double> further) noexcept override;
  void flush() noexcept override {}
  void add_program_hash(const std::string&) override {}
  bool ok() const noexcept override { return ok_; }
  Status finish() override { return {}; }

  /// Returns a dict of the arrays by name; they own the memory. Requires the GIL.
  pybind11::dict take();

 private:
  enum class Source : std::uint8_t {
    t,
    line,
    block,
    s,
    v,
    a,
    limit,
    axis,
    feed,
    further_real,
    further_whole
  };
  struct Column {
    std::string name;
    Source source;
    std::size_t index = 0;  // of an axis, or of the columns that follow
    GrowingBytes bytes = {};
  };

  static std::vector<Column> all_columns(const Machine& machine,
                                         const std::vector<std::string>& further);
  void write(Column& column, const Setpoint& setpoint, std::span<const double> further) noexcept;
  template <typename T>
  void add(Column& column, T value) noexcept;
  void add_text(Column& column, std::string_view text) noexcept;

  hal::TraceTime time_;
  std::vector<Column> columns_;
  bool ok_ = true;
};

}  // namespace softcnc::python
