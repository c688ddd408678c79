// SPDX-License-Identifier: MIT
// Text put together from many short pieces.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "hal/files/number.hpp"

namespace softcnc::app {

/// Like a string, but that appending a short piece is compiled into the place where it stands.
class TextBuffer {
 public:
  TextBuffer() = default;
  TextBuffer(const TextBuffer&) = delete;
  TextBuffer& operator=(const TextBuffer&) = delete;

  void clear() noexcept { at_ = text_.data(); }
  std::size_t size() const noexcept { return static_cast<std::size_t>(at_ - text_.data()); }
  std::string_view text() const noexcept { return {text_.data(), size()}; }
  char& back() noexcept { return at_[-1]; }

  void add(std::string_view piece) {
    std::memcpy(reserve(piece.size()), piece.data(), piece.size());
    at_ += piece.size();
  }
  template <std::size_t Size>
  void add(const char (&literal)[Size]) {
    std::memcpy(reserve(Size - 1), literal, Size - 1);
    at_ += Size - 1;
  }
  void add(char letter) {
    *reserve(1) = letter;
    ++at_;
  }
  void add(double value) { at_ = hal::write_number(reserve(hal::kNumberLength), value); }
  void add(int value) {
    char* const at = reserve(hal::kNumberLength);
    at_ = value < 0 ? std::to_chars(at, at + hal::kNumberLength, value).ptr
                    : hal::write_whole(at, static_cast<std::uint32_t>(value));
  }

 private:
  /// Where so many bytes are free.
  char* reserve(std::size_t size) {
    if (static_cast<std::size_t>(end_ - at_) < size) [[unlikely]]
      grow(size);
    return at_;
  }
  [[gnu::noinline]] void grow(std::size_t size) {
    const std::size_t used = this->size();
    text_.resize(2 * (used + size));
    at_ = text_.data() + used;
    end_ = text_.data() + text_.size();
  }

  std::string text_ = std::string(1024, '\0');
  char* at_ = text_.data();  // the end of what has been added
  char* end_ = text_.data() + text_.size();
};

}  // namespace softcnc::app
