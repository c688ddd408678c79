// SPDX-License-Identifier: MIT
// Whether a text with errors is a program for another kind of control.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace softcnc::runtime {

/// Sees the lines of a program one by one. Several marks of one control count, each once; or one
/// that no other has.
class ForeignLanguage {
 public:
  void see(std::string_view line, int number);

  bool found() const noexcept;
  /// The control the program is made for, with an article; and the first line that shows it.
  std::string_view control() const noexcept;
  int line() const noexcept;
  const std::string& text() const noexcept;

 private:
  static constexpr std::size_t kControls = 4, kMostMarks = 64;
  struct Evidence {
    int weight = 0;
    int line = 0;  // the first
    std::string text;
  };
  std::size_t best() const noexcept;

  std::array<Evidence, kControls> evidence_;
  std::array<bool, kMostMarks> seen_{};
};

/// Returns what a file is by its first line, "a PNG picture" for example; empty where it may be a
/// part program.
std::string_view kind_of_binary(std::string_view first_line);

}  // namespace softcnc::runtime
