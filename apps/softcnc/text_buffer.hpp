// SPDX-License-Identifier: MIT
// Text put together from many short pieces.
#pragma once

#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

#include "hal/number.hpp"

namespace softcnc::app {

/// Like a string, but that appending a short piece is compiled into the place where it stands.
class TextBuffer {
 public:
  void clear() noexcept { size_ = 0; }
  std::size_t size() const noexcept { return size_; }
  std::string_view text() const noexcept { return {text_.data(), size_}; }
  char& back() noexcept { return text_[size_ - 1]; }

  void add(std::string_view piece) {
    std::memcpy(room(piece.size()), piece.data(), piece.size());
    size_ += piece.size();
  }
  void add(char letter) {
    *room(1) = letter;
    ++size_;
  }
  void add(double value) { ends_at(hal::write_number(room(hal::kNumberLength), value)); }
  void add(int value) {
    char* const at = room(hal::kNumberLength);
    ends_at(std::to_chars(at, at + hal::kNumberLength, value).ptr);
  }

 private:
  char* room(std::size_t size) {
    if (size_ + size > text_.size()) text_.resize(2 * (size_ + size));
    return text_.data() + size_;
  }
  void ends_at(const char* end) noexcept { size_ = static_cast<std::size_t>(end - text_.data()); }

  std::string text_ = std::string(1024, '\0');
  std::size_t size_ = 0;
};

}  // namespace softcnc::app
