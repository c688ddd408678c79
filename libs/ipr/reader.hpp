// SPDX-License-Identifier: MIT
// A text line by line, however long it is: only one buffer of it is in memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "motion/result.hpp"

namespace softcnc::ipr {

/// Lines end with LF, CRLF or a lone CR; the last one may end without. A UTF-8 byte order mark is
/// left out.
class Reader {
 public:
  static constexpr std::size_t kLongestLine = 16384;  // bytes

  /// "-" is standard input. Errors: SC6001 with the reason.
  static Result<Reader> open(const std::string& file);
  static Reader from_text(std::string text);
  /// Reads on from where the descriptor stands; closing it is left to the caller.
  explicit Reader(int descriptor) : Reader(descriptor, false) {}

  Reader(Reader&& other) noexcept;
  Reader& operator=(Reader&& other) noexcept;
  ~Reader();

  /// The next line without its end, valid until the next call; nothing at the end of the text or
  /// after failure().
  std::optional<std::string_view> next();

  /// Number of the line last read, from 1; 0 before the first.
  int line() const noexcept { return line_; }
  /// The line last read was longer than kLongestLine and has been cut there.
  bool line_was_cut() const noexcept { return line_was_cut_; }
  /// Why reading broke off before the end: SC6002.
  const std::optional<Diagnostic>& failure() const noexcept { return failure_; }

 private:
  Reader() = default;
  Reader(int descriptor, bool owned);

  void skip_line_feed() noexcept;
  std::size_t find_line_end(std::size_t from) noexcept;
  std::size_t find(char wanted, std::size_t from, std::size_t to) const noexcept;
  bool fill();
  std::string_view take(std::size_t line_end) noexcept;
  void close() noexcept;

  static constexpr std::size_t kUnknown = std::string::npos;

  int descriptor_ = -1;  // -1: nothing more to come
  bool owned_ = false;
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0;   // what is not yet read lies in [begin_, end_)
  std::size_t line_feed_ = kUnknown;  // the next LF, or end_ if there is none
  bool line_feed_belongs_to_cr_ = false;
  bool line_was_cut_ = false;
  int line_ = 0;
  std::optional<Diagnostic> failure_;
};

}  // namespace softcnc::ipr
