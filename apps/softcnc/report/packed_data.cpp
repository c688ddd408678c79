// SPDX-License-Identifier: MIT
#include "report/packed_data.hpp"

#include "report/gzip.hpp"

namespace softcnc::app {
namespace {

/// Small magnitudes as small numbers: 0, -1, 1, -2, 2, ... as 0, 1, 2, 3, 4.
std::uint64_t zigzag(std::int64_t value) noexcept {
  return (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63);
}

/// Seven bits a byte, the lowest first; the highest bit says that more follow.
void add_leb128(std::uint64_t value, std::string& bytes) {
  constexpr unsigned kBits = 7, kMore = 0x80;
  while (value >= kMore) {
    bytes.push_back(static_cast<char>((value & (kMore - 1)) | kMore));
    value >>= kBits;
  }
  bytes.push_back(static_cast<char>(value));
}

}  // namespace

void PackedData::add(std::int64_t value, Order order) {
  const std::int64_t difference = value - last_;
  switch (order) {
    case Order::values:
      add_leb128(zigzag(value), bytes_);
      break;
    case Order::differences:
      add_leb128(zigzag(difference), bytes_);
      break;
    case Order::second_differences:
      add_leb128(zigzag(difference - last_difference_), bytes_);
      break;
  }
  last_ = value;
  last_difference_ = difference;
}

nlohmann::ordered_json PackedData::slice(std::size_t from) const {
  return {{"offset", from}, {"bytes", bytes_.size() - from}};
}

nlohmann::ordered_json PackedData::add_text(std::string_view text) {
  const std::size_t from = bytes_.size();
  bytes_ += text;
  return slice(from);
}

std::string PackedData::base64() const { return base64_of(gzip(bytes_)); }

}  // namespace softcnc::app
