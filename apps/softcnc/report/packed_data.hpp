// SPDX-License-Identifier: MIT
// The numbers of a report as bytes: columns of integers, as differences in variable length.
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "motion/core/result.hpp"

namespace softcnc::app {

/// How often differences are taken before a column is written.
enum class Order : std::uint8_t { values, differences, second_differences };

/// Bytes to which columns and texts are added one after the other. The page finds each of them by
/// the JSON that is returned: docs/report.md.
class PackedData {
 public:
  /// Adds `count` values of(i), each rounded to a multiple of `scale`; NaN becomes -1.
  template <typename Of>
  nlohmann::ordered_json add_column(std::size_t count, double scale, Order order, Of&& of) {
    const std::size_t from = bytes_.size();
    last_ = last_difference_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = static_cast<double>(of(i));
      add(std::isnan(value) ? -1 : std::llround(value / scale), order);
    }
    auto column = slice(from);
    column["count"] = count;
    column["scale"] = scale;
    column["order"] = static_cast<int>(order);
    return column;
  }
  nlohmann::ordered_json add_text(std::string_view text);

  /// Returns all of it, compressed by gzip and written in base64.
  std::string base64() const;

 private:
  void add(std::int64_t value, Order order);
  nlohmann::ordered_json slice(std::size_t from) const;

  std::string bytes_;
  std::int64_t last_ = 0, last_difference_ = 0;
};

}  // namespace softcnc::app
