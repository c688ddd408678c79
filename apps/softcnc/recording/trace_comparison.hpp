// SPDX-License-Identifier: MIT
// A trace that is being written against one that was recorded, row by row.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/output_file.hpp"
#include "recording/trace_lines.hpp"

namespace softcnc::app {

/// Takes the bytes of a trace and compares them with the recorded lines. Neither is kept.
class TraceComparison {
 public:
  explicit TraceComparison(TraceLines recorded) : recorded_(std::move(recorded)) {}

  /// False as soon as a row differs.
  bool take(std::string_view bytes);

  /// After the last row: whether the recording ends here, too.
  void finish();

  /// What differs first, as a table for a person; empty: nothing does.
  const std::string& difference() const noexcept { return difference_; }
  /// The same in one sentence.
  const std::string& in_words() const noexcept { return in_words_; }
  const Status& status() const noexcept { return recorded_.status(); }
  std::int64_t rows() const noexcept { return rows_; }

 private:
  void line(std::string_view line);
  void columns(std::string_view line);
  void row(std::string_view line);

  TraceLines recorded_;
  std::string partial_;  // a line whose end has not come yet
  std::vector<std::string> columns_;
  std::int64_t rows_ = 0;  // that agree
  std::string difference_, in_words_;
};

/// The sink a trace writer writes to; refuses more as soon as a row differs.
std::unique_ptr<hal::ByteSink> comparison_sink(TraceComparison& comparison);

}  // namespace softcnc::app
