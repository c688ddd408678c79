// SPDX-License-Identifier: MIT
// Arrays as numpy reads them: .npy files, and a zip of such.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/core/disk_backed_vector.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// The head of an .npy file: float32 ("<f4") or float64 ("<f8"), row by row.
std::string npy_head(std::string_view type, std::span<const std::int64_t> shape);

/// A whole .npy file of float64.
std::string npy(std::span<const double> values, std::span<const std::int64_t> shape);
/// The same of float32.
std::string npy(std::span<const float> values, std::span<const std::int64_t> shape);

/// A float32 array of two dimensions that is written piece by piece.
class NpyWriter {
 public:
  NpyWriter(std::int64_t rows, std::int64_t columns);

  /// Appends values. Errors: SC6003.
  Status add(std::span<const float> values);

  /// Returns the descriptor of the file without a name that holds the array.
  int descriptor() const noexcept { return file_.descriptor(); }

 private:
  std::string head_;
  OverflowFile file_;
};

}  // namespace softcnc::hal
