// SPDX-License-Identifier: MIT
// Arrays as numpy reads them: .npy files, and a zip of such.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// An array of one dimension: how its values stand in its file, after the head.
struct NpyArray {
  enum class Kind : std::uint8_t { real, whole, text };
  Kind kind = Kind::real;
  std::size_t size = sizeof(double);  // bytes of a value; of a text 4 for each of its characters
  std::int64_t rows = 0;
};

/// The bytes of a head before its text.
inline constexpr std::size_t kNpyHeadStart = 10;

/// Returns how many bytes of text follow such a start; 0 where it is none of a version 1 file.
std::size_t npy_text_length(std::string_view start);

/// Reads a whole head. Returns nothing where it is none, or of an array of another shape or type
/// than little-endian numbers of 4 or 8 bytes, or texts.
std::optional<NpyArray> read_npy_head(std::string_view head);

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
