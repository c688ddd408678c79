// SPDX-License-Identifier: MIT
#include "hal/trace/trace_vcd.hpp"

#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "hal/backends/stepdir.hpp"
#include "hal/files/axis_name.hpp"
#include "hal/files/file_piece.hpp"
#include "hal/files/number.hpp"
#include "hal/ports/port_timing.hpp"
#include "hal/signals/edge_file.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

class EdgeTrace final : public TraceWriter {
 public:
  EdgeTrace(std::unique_ptr<ByteSink> out, const Machine& machine, const StepTiming& timing)
      : drives_(machine, timing, std::make_unique<EdgeWriter>(EdgeWriter::vcd(std::move(out)))) {}

  void row(const Setpoint& setpoint, std::span<const double> /*backend_values*/) noexcept override {
    if (ok_) ok_ = drives_.exchange(setpoint).alarm == Alarm::none;
  }
  void rest(const Setpoint& at) noexcept override { drives_.rest(at); }
  void flush() noexcept override {}
  void add_program_hash(const std::string& /*hash*/) override {}
  bool ok() const noexcept override { return ok_; }
  Status finish() override { return drives_.finish(); }

 private:
  StepDir drives_;
  bool ok_ = true;
};

/// How VCD calls the variable of an axis.
constexpr char vcd_name_of_axis(int axis) noexcept { return static_cast<char>('!' + axis); }

class PositionTrace final : public TraceWriter {
 public:
  PositionTrace(std::unique_ptr<ByteSink> out, const TraceHeader& header, const Machine& machine);

  void row(const Setpoint& setpoint, std::span<const double> backend_values) noexcept override;
  void flush() noexcept override;
  void add_program_hash(const std::string& hash) override { comment("program: " + hash); }
  bool ok() const noexcept override { return status_.has_value(); }
  Status finish() override;

 private:
  void comment(const std::string& text) { text_ += "$comment " + text + " $end\n"; }
  void instant(std::int64_t ns) noexcept;
  void value(int axis, double position) noexcept;

  std::unique_ptr<ByteSink> out_;
  double period_;  // ns
  std::vector<int> axes_;
  AxisVector last_ = AxisVector::Zero();  // mm
  std::int64_t time_ = -1,
               written_ = -1;  // ns: of the last row, and of the last one that stands there
  std::string text_;
  Status status_;
};

PositionTrace::PositionTrace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                             const Machine& machine)
    : out_(std::move(out)), period_(ns_from_s(header.period)) {
  text_.reserve(kFilePiece + 16 * kNumberLength);
  comment("schema: softcnc-trace " + std::to_string(kTraceSchema));
  comment("program: " + header.program_hash);
  comment("machine: " + header.machine_hash);
  text_ += "$timescale 1 ns $end\n$scope module softcnc $end\n";
  for (int axis = 0; axis < kAxes; ++axis) {
    if (!machine.axes[static_cast<std::size_t>(axis)].present) continue;
    axes_.push_back(axis);
    text_ += std::string("$var real 64 ") + vcd_name_of_axis(axis) + ' ' + axis_name(axis) +
             "_mm $end\n";
  }
  text_ += "$upscope $end\n$enddefinitions $end\n";
}

/// Values stand where they change, and all of them in the first row.
void PositionTrace::row(const Setpoint& setpoint, std::span<const double>) noexcept {
  if (!ok()) return;
  const bool first =
      std::exchange(time_, std::llround(static_cast<double>(setpoint.period) * period_)) < 0;
  if (first) {
    instant(time_);
    text_ += "$dumpvars\n";
  }
  for (const int axis : axes_)
    if (first || setpoint.position[axis] != last_[axis]) value(axis, setpoint.position[axis]);
  if (first) text_ += "$end\n";
  last_ = setpoint.position;
  if (text_.size() >= kFilePiece) flush();
}

void PositionTrace::instant(std::int64_t ns) noexcept {
  char digits[kNumberLength];
  text_ += '#';
  text_.append(digits, std::to_chars(digits, digits + kNumberLength, ns).ptr);
  text_ += '\n';
  written_ = ns;
}

void PositionTrace::value(int axis, double position) noexcept {
  if (written_ != time_) instant(time_);
  char number[kNumberLength];
  text_ += 'r';
  text_.append(number, write_number(number, position));
  text_ += ' ';
  text_ += vcd_name_of_axis(axis);
  text_ += '\n';
}

void PositionTrace::flush() noexcept {
  if (ok()) status_ = out_->write(text_);
  text_.clear();
}

/// A viewer sees the time at rest, too.
Status PositionTrace::finish() {
  if (written_ != time_) instant(time_);
  flush();
  if (ok()) status_ = out_->finish();
  return status_;
}

}  // namespace

std::unique_ptr<TraceWriter> vcd_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> /*backend_columns*/) {
  const Control& control = machine.control;
  if (control.backend == BackendKind::parport)
    return std::make_unique<EdgeTrace>(std::move(out), machine, port_timing(machine).rules);
  if (control.backend == BackendKind::stepdir || is_by_pulses(control.interpolation))
    return std::make_unique<EdgeTrace>(std::move(out), machine, step_timing(machine.step_port));
  return std::make_unique<PositionTrace>(std::move(out), header, machine);
}

}  // namespace softcnc::hal
