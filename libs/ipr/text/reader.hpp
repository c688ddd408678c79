// SPDX-License-Identifier: MIT
// A text line by line, however long it is: only one buffer of it is in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "ipr/text/spool.hpp"
#include "motion/core/result.hpp"

namespace softcnc::ipr {

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8

/// Reads a text line by line. Lines end with LF, CRLF or a lone CR; the last one may end without. A
/// UTF-8 byte order mark is left out, and so are bytes of 0x1A (Ctrl-Z, by which DOS ended a text)
/// at the end of the text.
class Reader {
 public:
  static constexpr std::size_t kLongestLine = 16384;  // bytes

  /// A place between two lines.
  struct Place {
    std::uint64_t offset = 0;  // bytes from where reading began
    int line = 0;              // number of the line before
    bool after_cr = false;     // an LF that follows belongs to the line before
  };

  /// Opens a file, or standard input if its name is "-". Errors: SC6001 with the reason.
  static Result<Reader> open(const std::string& file);
  static Reader from_text(std::string text);
  /// Reads from where the descriptor stands. The caller closes the descriptor.
  explicit Reader(int descriptor) : Reader(descriptor, false) {}
  /// Returns a reader of a regular file from `begin` on, in bytes, wherever the descriptor stands:
  /// several readers may share one descriptor. The caller closes it.
  static Reader of_file(int descriptor, std::int64_t begin);

  /// Returns a reader of what feed() will bring. Where that is not enough for a line, next()
  /// returns nothing and waiting() is true, until more comes or end_feed() says that nothing more
  /// will. Errors of feed(): SC6032, where nothing more can be kept.
  static Reader fed();
  Status feed(std::string_view text);
  void end_feed() noexcept {
    pipe_ended_ = true;
    waiting_ = false;
  }

  /// Returns another reader, which begins with what this one has got from its pipe so far and is
  /// then waiting(). This reader must outlive it. Where the pipe could not be kept the new reader
  /// reads nothing.
  Reader again() const;

  Reader(Reader&& other) noexcept;
  Reader& operator=(Reader&& other) noexcept;
  ~Reader();

  /// Returns the next line without its end; the view is valid until the next call. Returns nothing
  /// at the end of the text or after failure(), and while waiting().
  std::optional<std::string_view> next();

  /// Returns the place after the line last read.
  Place place() const noexcept;
  /// Returns the place before the line last read; `last` is what next() has returned.
  Place place_before(std::string_view last) const noexcept;
  /// Goes back, or on, to a place of this text. Returns false where that is not possible;
  /// seek_failure() has the reason.
  bool seek(const Place& place);
  /// Returns why the last seek() failed: SC6002, or SC6032 where a pipe could not be kept.
  Diagnostic seek_failure() const;

  /// Returns the part of the text after the line last read that is in memory, as it is written;
  /// read_ahead() adds to it, and returns false if nothing more comes or fits.
  std::string_view unread() const noexcept { return {buffer_.data() + begin_, end_ - begin_}; }
  /// Returns the part of the text in memory from the line last read on; `last` is what next() has
  /// returned.
  std::string_view text_from(std::string_view last) const noexcept {
    return {last.data(), static_cast<std::size_t>(buffer_.data() + end_ - last.data())};
  }
  bool read_ahead() { return end_ - begin_ < buffer_.size() / 2 && fill(); }
  /// Makes next() return nothing, with waiting() true, where a pipe has nothing more yet.
  void do_not_wait() noexcept { waits_ = false; }
  /// Makes next() wait for whoever writes, as it does at first.
  void wait() noexcept { waits_ = true; }
  bool waiting() const noexcept { return waiting_; }

  /// Makes next() return nothing, with waiting() true, from the moment on at which a stop is
  /// requested; a call that is waiting for whoever writes returns then too.
  void set_stop(std::stop_token stop) noexcept { stop_ = std::move(stop); }
  const std::stop_token& stop() const noexcept { return stop_; }

  /// Receives each piece of the text when it is read for the first time.
  using Tap = std::function<void(std::string_view)>;
  void set_tap(Tap tap) { tap_ = std::move(tap); }

  /// Returns how many bytes have come through a pipe so far; 0 for a file.
  std::int64_t bytes() const noexcept { return static_cast<std::int64_t>(kept().size()); }

  /// Returns the number of the line last read, from 1; 0 before the first.
  int line() const noexcept { return line_; }
  /// Returns whether the line last read was longer than kLongestLine and has been cut there.
  bool line_was_cut() const noexcept { return line_was_cut_; }
  /// Returns why reading broke off before the end: SC6002.
  const std::optional<Diagnostic>& failure() const noexcept { return failure_; }

 private:
  Reader() = default;
  Reader(int descriptor, bool owned);

  bool has_too_many_lines();
  void skip_line_feed() noexcept;
  std::size_t find_line_end(std::size_t from) noexcept;
  std::size_t find(char wanted, std::size_t from, std::size_t to) const noexcept;
  bool fill();
  std::ptrdiff_t read_more(char* to, std::size_t size);
  bool has_nothing_yet(int timeout) const noexcept;
  bool is_to_wait() const noexcept;
  bool is_pipe() const noexcept { return origin_ < 0; }
  bool is_in_memory() const noexcept { return descriptor_ < 0 && !fed_; }
  const Spool& kept() const noexcept { return first_ != nullptr ? first_->spool_ : spool_; }
  std::string_view take(std::size_t line_end) noexcept;
  bool ends_in_end_mark(std::size_t line_end) const noexcept;
  std::optional<std::string_view> take_marked(std::size_t line_end);
  bool only_blanks_follow(std::size_t length);
  void close() noexcept;

  static constexpr std::size_t kUnknown = std::string::npos;

  int descriptor_ = -1;  // -1: all there is lies in the buffer
  bool owned_ = false;
  bool fed_ = false;               // all there is has been fed, and lies in the spool
  std::int64_t origin_ = -1;       // where in the file reading began; -1: a pipe
  Spool spool_;                    // what a pipe has given so far
  const Reader* first_ = nullptr;  // whose spool is read again
  bool pipe_ended_ = false;
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0;   // what is not yet read lies in [begin_, end_)
  std::size_t intact_ = 0;            // the buffer is as the text from here on
  std::uint64_t end_offset_ = 0;      // of the end of the buffer, in the text
  std::size_t line_feed_ = kUnknown;  // the next LF, or end_ if there is none
  bool line_feed_belongs_to_cr_ = false;
  bool line_was_cut_ = false;
  bool waits_ = true, waiting_ = false;
  std::stop_token stop_;
  Tap tap_;
  int line_ = 0;
  int seek_error_ = 0;
  std::optional<Diagnostic> failure_;
};

}  // namespace softcnc::ipr
