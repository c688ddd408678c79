// SPDX-License-Identifier: MIT
// Bytes into a pipe whose reader sets the pace, with a timeout.
#pragma once

#include <memory>
#include <string>

#include "hal/files/output_file.hpp"

namespace softcnc::hal {

/// Returns whether `file` is a pipe: a FIFO, or "-" where standard output is one.
bool is_pipe(const std::string& file);

class PipeSink final : public ByteSink {
 public:
  /// Opens a pipe; `patience` is the timeout for a full pipe, s. Errors: SC6011, SC6070 (nobody
  /// reads).
  static Result<std::unique_ptr<PipeSink>> open(const std::string& file, double patience);

  PipeSink(const PipeSink&) = delete;
  PipeSink& operator=(const PipeSink&) = delete;
  ~PipeSink() override;

  /// Writes bytes. Errors: SC6071 (full for too long), SC6013 (closed; only where SIGPIPE is
  /// ignored), SC6012.
  Status write(std::string_view bytes) override;
  Status finish() override;

 private:
  PipeSink(std::string name, int descriptor, int patience);
  Status wait();
  tl::unexpected<Diagnostic> failed(Code code, const std::string& what) const;

  std::string name_;
  int descriptor_;
  int patience_;  // ms
};

}  // namespace softcnc::hal
