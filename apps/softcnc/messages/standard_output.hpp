// SPDX-License-Identifier: MIT
// Data for standard output, in a buffer.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "hal/files/output_file.hpp"

namespace softcnc::app {

/// Data for standard output, in a buffer. After an error what follows is dropped.
class StandardOutput {
 public:
  void write(std::string_view text);
  bool ok() const noexcept { return status_.has_value(); }

  /// Writes what there is.
  void flush();

  /// Writes what is left. Exit status: 0, 5 or 141; an error is shown.
  int finish();

 private:
  std::unique_ptr<hal::OutputFile> file_;
  std::string buffer_;
  Status status_;
};

}  // namespace softcnc::app
