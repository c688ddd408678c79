// SPDX-License-Identifier: MIT
#include "hal/files/npz_file.hpp"

#include <bit>
#include <vector>

namespace softcnc::hal {
namespace {

static_assert(std::endian::native == std::endian::little, "the types named are little-endian");

constexpr std::size_t kAlign = 64;
constexpr std::size_t kBeforeText = 10;  // magic, version, length

template <typename T>
std::string_view bytes(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

std::string npy_head(std::string_view type, std::span<const std::int64_t> shape) {
  std::string text = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (";
  for (const std::int64_t extent : shape) text += std::to_string(extent) + ", ";
  text += "), }";
  text.append(kAlign - 1 - (kBeforeText + text.size()) % kAlign, ' ').append(1, '\n');
  std::string head = "\x93NUMPY";
  head.append(
      {'\1', '\0', static_cast<char>(text.size() & 255U), static_cast<char>(text.size() >> 8U)});
  return head + text;
}

std::string npy(std::span<const double> values, std::span<const std::int64_t> shape) {
  return npy_head("<f8", shape).append(bytes(values));
}

std::string npy(std::span<const float> values, std::span<const std::int64_t> shape) {
  return npy_head("<f4", shape).append(bytes(values));
}

NpyWriter::NpyWriter(std::int64_t rows, std::int64_t columns)
    : head_(npy_head("<f4", std::vector{rows, columns})) {}

Status NpyWriter::add(std::span<const float> values) {
  if (!file_.is_open())
    if (Status kept = file_.add(std::as_bytes(std::span<const char>(head_))); !kept) return kept;
  return file_.add(std::as_bytes(values));
}

}  // namespace softcnc::hal
