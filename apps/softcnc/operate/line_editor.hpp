// SPDX-License-Identifier: MIT
// A line that is typed, with those typed before.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "operate/key.hpp"

namespace softcnc::app {

class LineEditor {
 public:
  static constexpr std::size_t kLongest = 255;  // characters
  static constexpr std::size_t kKept = 200;     // lines

  /// Takes a key that edits, or goes through the lines before.
  void key(const Key& key);
  /// Returns the line, keeps it for later, and begins a new one.
  std::string take();
  void clear();

  const std::string& text() const noexcept { return text_; }
  std::size_t cursor() const noexcept { return cursor_; }

 private:
  void recall(std::size_t index);

  std::string text_;
  std::size_t cursor_ = 0;
  std::vector<std::string> before_;
  std::size_t recalled_ = 0;  // index in `before_`; its size: the line that is being typed
  std::string typed_;         // that line, while another one is shown
};

}  // namespace softcnc::app
