// SPDX-License-Identifier: MIT
#include "operate/screen.hpp"

#include <algorithm>

namespace softcnc::app {
namespace {

bool is_printable(char c) noexcept { return c >= ' ' && c <= '~'; }

}  // namespace

Screen::Screen(int rows, int columns)
    : rows_(std::max(rows, 0)),
      columns_(std::max(columns, 0)),
      text_(static_cast<std::size_t>(rows_), std::string(static_cast<std::size_t>(columns_), ' ')),
      emphasis_(static_cast<std::size_t>(rows_),
                std::vector<Emphasis>(static_cast<std::size_t>(columns_), Emphasis::none)) {}

void Screen::put(int row, int column, std::string_view text, Emphasis emphasis) {
  if (row < 0 || row >= rows_) return;
  for (const char c : text) {
    const bool follows = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // within a character
    if (follows) continue;
    if (column >= 0 && column < columns_) {
      const auto r = static_cast<std::size_t>(row), i = static_cast<std::size_t>(column);
      text_[r][i] = is_printable(c) ? c : '?';
      emphasis_[r][i] = emphasis;
    }
    ++column;
  }
}

void Screen::put_row(int row, std::string_view text, Emphasis emphasis) {
  put(row, 0, std::string(static_cast<std::size_t>(columns_), ' '), emphasis);
  put(row, 0, text, emphasis);
}

std::string Screen::text() const {
  std::string all;
  for (const std::string& row : text_) all += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  return all;
}

}  // namespace softcnc::app
