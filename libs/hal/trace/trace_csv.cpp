// SPDX-License-Identifier: MIT
// CSV rows in a buffer, handed on when it is full.
#include "hal/trace/trace_csv.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hal/files/axis_name.hpp"
#include "hal/files/file_piece.hpp"
#include "hal/files/number.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kOwnColumns = 8;  // t_s to limit, and feed_mm_s

/// The period in ms as a person would write it, unless that is another double.
std::string period_text(double period) {
  const double rounded = std::round(period * 1e12) / 1e9;
  return number_text(s_from_ms(rounded) == period ? rounded : ms_from_s(period));
}

class CsvTrace final : public TraceWriter {
 public:
  CsvTrace(std::unique_ptr<ByteSink> out, const TraceHeader& header, const Machine& machine,
           std::span<const std::string> backend_columns);

  void row(const Setpoint& setpoint, std::span<const double> backend_values) noexcept override;
  void flush() noexcept override;
  void add_program_hash(const std::string& hash) override;
  bool ok() const noexcept override { return !failure_; }
  Status finish() override;

 private:
  void names(std::span<const std::string> backend_columns);

  std::unique_ptr<ByteSink> out_;
  TraceTime time_;
  std::vector<int> axes_;  // those the machine has
  std::vector<char> buffer_;
  std::size_t used_ = 0, row_length_ = 0;
  std::optional<Diagnostic> failure_;
};

CsvTrace::CsvTrace(std::unique_ptr<ByteSink> out, const TraceHeader& header, const Machine& machine,
                   std::span<const std::string> backend_columns)
    : out_(std::move(out)), time_(header.period) {
  for (int axis = 0; axis < kAxes; ++axis)
    if (machine.axes[static_cast<std::size_t>(axis)].present) axes_.push_back(axis);
  row_length_ = (kOwnColumns + axes_.size() + backend_columns.size()) * (kNumberLength + 1) + 1;
  buffer_.resize(kFilePiece + row_length_);
  names(backend_columns);
  const auto written = out_->write(trace_comment(header));
  if (!written && !failure_) failure_ = written.error();
}

void CsvTrace::names(std::span<const std::string> backend_columns) {
  std::string line = "t_s,line,block,s_mm,v_mm_s,a_mm_s2,limit";
  for (const int axis : axes_) line += ',' + axis_name(axis) + "_mm";
  line += ",feed_mm_s";
  for (const auto& column : backend_columns) line += ',' + column;
  const auto written = out_->write(line + '\n');
  if (!written && !failure_) failure_ = written.error();
}

void CsvTrace::row(const Setpoint& setpoint, std::span<const double> backend_values) noexcept {
  if (failure_) return;
  char* at = buffer_.data() + used_;
  const auto number = [&](double value) {
    at = write_number(at, value);
    *at++ = ',';
  };
  const auto whole = [&](int value) {
    at = std::to_chars(at, at + kNumberLength, value).ptr;
    *at++ = ',';
  };
  number(time_(setpoint.period));
  whole(setpoint.line);
  whole(setpoint.block);
  number(setpoint.s);
  number(setpoint.v);
  number(setpoint.a);
  const std::string_view limit = name(setpoint.limit);
  at = static_cast<char*>(std::memcpy(at, limit.data(), limit.size())) + limit.size();
  *at++ = ',';
  for (const int axis : axes_) number(setpoint.position[axis]);
  number(setpoint.feed);
  for (const double value : backend_values) number(value);
  at[-1] = '\n';
  used_ = static_cast<std::size_t>(at - buffer_.data());
  if (used_ + row_length_ > buffer_.size()) flush();
}

void CsvTrace::flush() noexcept {
  if (failure_ || used_ == 0) return;
  const auto written = out_->write({buffer_.data(), std::exchange(used_, 0)});
  if (!written && !failure_) failure_ = written.error();
}

void CsvTrace::add_program_hash(const std::string& hash) {
  if (failure_) return;
  flush();
  const auto written = out_->write("# program: " + hash + '\n');
  if (!written && !failure_) failure_ = written.error();
}

Status CsvTrace::finish() {
  if (!failure_) flush();
  if (failure_) return tl::make_unexpected(*failure_);
  return out_->finish();
}

}  // namespace

std::unique_ptr<TraceWriter> csv_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns) {
  return std::make_unique<CsvTrace>(std::move(out), header, machine, backend_columns);
}

std::string trace_comment(const TraceHeader& header) {
  return "# schema: softcnc-trace " + std::to_string(kTraceSchema) +
         "\n# period_ms: " + period_text(header.period) + "\n# program: " + header.program_hash +
         "\n# machine: " + header.machine_hash + "\n";
}

TraceTime::TraceTime(double period) noexcept : step_(period), per_second_(1) {
  const double nanoseconds = period * 1e9;
  const double whole = std::round(nanoseconds);
  if (std::abs(nanoseconds - whole) > 1e-6 * std::min(1.0, nanoseconds)) return;
  step_ = whole;
  per_second_ = 1e9;
}

double TraceTime::operator()(std::int64_t index) const noexcept {
  return static_cast<double>(index) * step_ / per_second_;
}

}  // namespace softcnc::hal
