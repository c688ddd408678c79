// SPDX-License-Identifier: MIT
// What a terminal is to show: characters in rows and columns, and which of them stand out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace softcnc::app {

enum class Emphasis : std::uint8_t { none, bold, reverse };

class Screen {
 public:
  /// A blank screen.
  Screen(int rows, int columns);

  int rows() const noexcept { return rows_; }
  int columns() const noexcept { return columns_; }

  /// Puts text at a place; what lies outside is left out, and what is not ASCII becomes '?'.
  void put(int row, int column, std::string_view text, Emphasis emphasis = Emphasis::none);
  /// The same over the whole width of a row.
  void put_row(int row, std::string_view text, Emphasis emphasis);
  /// Shows the cursor there.
  void set_cursor(int row, int column) { cursor_ = {row, column}; }

  /// Returns a row, padded to the width.
  const std::string& text(int row) const { return text_[static_cast<std::size_t>(row)]; }
  Emphasis emphasis(int row, int column) const {
    return emphasis_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  }
  std::optional<std::pair<int, int>> cursor() const noexcept { return cursor_; }
  /// Returns all rows, without trailing blanks.
  std::string text() const;

 private:
  int rows_, columns_;
  std::vector<std::string> text_;
  std::vector<std::vector<Emphasis>> emphasis_;
  std::optional<std::pair<int, int>> cursor_;
};

}  // namespace softcnc::app
