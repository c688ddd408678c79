// SPDX-License-Identifier: MIT
// Lists of edges in files: VCD for waveform viewers, or a compact binary form.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/files/output_file.hpp"
#include "hal/signals/edge_sink.hpp"

namespace softcnc::hal {

/// A form in which edges stand in a file.
class EdgeFormat {
 public:
  virtual ~EdgeFormat() = default;
  virtual std::string head() const = 0;
  /// Takes edges in order of time.
  virtual void append(const SignalEdge& edge, std::string& bytes) = 0;
};

/// ".vcd": a Value Change Dump (IEEE 1364) with a scale of 1 ns, for GTKWave and PulseView.
/// ".edges": the 8 bytes "edges 1\n", then for each edge the ns since the one before, 7 bits a
/// byte, low ones first, all but the last byte with bit 7 set, and a byte of 4 * axis, plus 2 for
/// the direction line, plus 1 for high.
class EdgeWriter final : public EdgeSink {
 public:
  /// Opens a file for edges. Errors: SC6011, SC6050 (unknown suffix).
  static Result<EdgeWriter> open(const std::string& file);
  /// Returns a writer into `out`, as VCD.
  static EdgeWriter vcd(std::unique_ptr<ByteSink> out);

  /// Writes edges. After an error, which returns Alarm::port, edges are dropped.
  Alarm take(std::span<const SignalEdge> edges, std::int64_t until) noexcept override;

  /// Completes the file; without this call no file is left. Errors: SC6012, SC6013.
  Status finish() override;

 private:
  EdgeWriter(std::unique_ptr<EdgeFormat> format, std::unique_ptr<ByteSink> out);
  bool ok() const noexcept { return status_.has_value(); }
  void hand_on();

  std::unique_ptr<EdgeFormat> format_;
  std::unique_ptr<ByteSink> out_;
  std::string bytes_;
  Status status_;
};

}  // namespace softcnc::hal
