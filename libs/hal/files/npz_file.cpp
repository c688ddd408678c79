// SPDX-License-Identifier: MIT
#include "hal/files/npz_file.hpp"

#include <bit>
#include <charconv>
#include <vector>

namespace softcnc::hal {
namespace {

static_assert(std::endian::native == std::endian::little, "the types named are little-endian");

constexpr std::string_view kNpyMagic("\x93NUMPY\1\0", 8);  // of version 1
constexpr std::size_t kAlign = 64;
constexpr std::size_t kLongestText = 1000;  // characters of a value

template <typename T>
std::string_view bytes(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Returns what stands between two texts; empty where they are not there.
std::string_view between(std::string_view text, std::string_view before, std::string_view after) {
  const auto begin = text.find(before);
  if (begin == text.npos) return {};
  text.remove_prefix(begin + before.size());
  return text.substr(0, text.find(after));
}

template <typename T>
bool read_whole(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Reads a type such as "<f8".
bool read_type(std::string_view type, NpyArray& array) {
  if (!type.starts_with('<') || type.size() < 3) return false;
  if (!read_whole(type.substr(2), array.size)) return false;
  if (type[1] == 'U') {
    if (array.size == 0 || array.size > kLongestText) return false;
    array.kind = NpyArray::Kind::text;
    array.size *= sizeof(char32_t);
    return true;
  }
  array.kind = type[1] == 'f' ? NpyArray::Kind::real : NpyArray::Kind::whole;
  return (type[1] == 'f' || type[1] == 'i') && (array.size == 4 || array.size == 8);
}

/// Reads a shape of one dimension: "7," or "7, ".
bool read_shape(std::string_view shape, NpyArray& array) {
  const auto comma = shape.find(',');
  if (comma == shape.npos || shape.find_first_not_of(' ', comma + 1) != shape.npos) return false;
  return read_whole(shape.substr(0, comma), array.rows) && array.rows >= 0;
}

}  // namespace

std::string npy_head(std::string_view type, std::span<const std::int64_t> shape) {
  std::string text = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (";
  for (const std::int64_t extent : shape) text += std::to_string(extent) + ", ";
  text += "), }";
  text.append(kAlign - 1 - (kNpyHeadStart + text.size()) % kAlign, ' ').append(1, '\n');
  std::string head(kNpyMagic);
  head.append({static_cast<char>(text.size() & 255U), static_cast<char>(text.size() >> 8U)});
  return head + text;
}

std::size_t npy_text_length(std::string_view start) {
  if (start.size() != kNpyHeadStart || !start.starts_with(kNpyMagic)) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(start[i]); };
  return byte(kNpyMagic.size()) + 256U * byte(kNpyMagic.size() + 1);
}

std::optional<NpyArray> read_npy_head(std::string_view head) {
  if (!head.starts_with(kNpyMagic)) return std::nullopt;
  NpyArray array;
  if (!read_type(between(head, "'descr': '", "'"), array) ||
      !read_shape(between(head, "'shape': (", ")"), array))
    return std::nullopt;
  return array;
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
