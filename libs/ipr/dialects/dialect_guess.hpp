// SPDX-License-Identifier: MIT
// In which dialect a program is written, by the marks of its first lines.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "ipr/expressions/dialect.hpp"

namespace softcnc::ipr {

class Reader;

/// Sees the lines of a program one by one. Every kind of mark counts once, with its weight.
class DialectGuess {
 public:
  static constexpr int kLines = 300;  // that are enough to see

  void see(std::string_view line, int number);

  /// Returns the dialect with the most weight; nothing if no dialect has enough, or two have the
  /// same.
  std::optional<Dialect> dialect() const noexcept;

  /// The heaviest mark of dialect(): what it is, as "G154" or "'grbl' in a comment", its line and
  /// the number of that. Requires dialect().
  const std::string& mark() const noexcept { return best().mark; }
  const std::string& text() const noexcept { return best().text; }
  int line() const noexcept { return best().line; }

 private:
  static constexpr std::size_t kMostMarks = 128;

  struct Evidence {
    int weight = 0;
    int heaviest = 0;  // of the mark below
    std::string mark, text;
    int line = 0;
  };

  void add(std::size_t kind, Dialect dialect, int weight, std::string mark);
  void see_comments(std::string_view comments);
  void see_code(const std::string& code);
  void see_words(const std::string& code);
  bool may_be_numbered_elsewhere() const noexcept;
  std::array<int, kDialects> weights() const noexcept;
  const Evidence& best() const noexcept;

  std::array<Evidence, kDialects> evidence_;
  std::bitset<kMostMarks> seen_;
  std::string_view line_;
  int number_ = 0;
  bool moves_ = false;  // a motion code has been seen
};

/// Sees the first lines of what the reader has to give; takes nothing from it. If the reader is
/// waiting() after the call, the result is not known yet.
DialectGuess guess_dialect(Reader& reader);

}  // namespace softcnc::ipr
