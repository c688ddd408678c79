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

/// Lines end with LF, CRLF or a lone CR; the last one may end without. A UTF-8 byte order mark is
/// left out, and so are bytes of 0x1A (Ctrl-Z, by which DOS ended a text) at the end of the text.
class Reader {
 public:
  static constexpr std::size_t kLongestLine = 16384;  // bytes

  /// Between two lines.
  struct Place {
    std::uint64_t offset = 0;  // bytes from where reading began
    int line = 0;              // number of the line before
    bool after_cr = false;     // an LF that follows belongs to the line before
  };

  /// "-" is standard input. Errors: SC6001 with the reason.
  static Result<Reader> open(const std::string& file);
  static Reader from_text(std::string text);
  /// Reads on from where the descriptor stands; closing it is left to the caller.
  explicit Reader(int descriptor) : Reader(descriptor, false) {}
  /// Reads a regular file from `begin` on, in bytes, wherever the descriptor stands: several may
  /// read one descriptor. Closing it is left to the caller.
  static Reader of_file(int descriptor, std::int64_t begin);

  /// Reads what feed() will bring: where that is not enough for a line, next() gives nothing and
  /// waiting() is true, until more comes or end_feed() says that nothing more will. Errors of
  /// feed(): SC6032, where nothing more can be kept.
  static Reader fed();
  Status feed(std::string_view text);
  void end_feed() noexcept { pipe_ended_ = true; }

  /// Another reading from the beginning of what this one, which must outlive it, has got from its
  /// pipe so far; after that it is waiting(). Where the pipe could not be kept it reads nothing.
  Reader again() const;

  Reader(Reader&& other) noexcept;
  Reader& operator=(Reader&& other) noexcept;
  ~Reader();

  /// The next line without its end, valid until the next call; nothing at the end of the text or
  /// after failure().
  std::optional<std::string_view> next();

  /// After the line last read.
  Place place() const noexcept;
  /// Before it, given what next() has returned.
  Place place_before(std::string_view last) const noexcept;
  /// Goes back, or on, to a place of this text. False where that cannot be: seek_failure().
  bool seek(const Place& place);
  /// Why the last seek() failed: SC6002, or SC6032 where a pipe could not be kept.
  Diagnostic seek_failure() const;

  /// What comes next and is in memory, as it is written; read_ahead() adds to it. False: no more,
  /// or no more fits.
  std::string_view unread() const noexcept { return {buffer_.data() + begin_, end_ - begin_}; }
  /// From the line last read on, given what next() has returned.
  std::string_view text_from(std::string_view last) const noexcept {
    return {last.data(), static_cast<std::size_t>(buffer_.data() + end_ - last.data())};
  }
  bool read_ahead() { return end_ - begin_ < buffer_.size() / 2 && fill(); }
  /// From here on next() gives nothing, and waiting() is true, where a pipe has nothing more yet.
  void do_not_wait() noexcept { waits_ = false; }
  /// From here on next() waits for whoever writes; so it is at the beginning.
  void wait() noexcept { waits_ = true; }
  bool waiting() const noexcept { return waiting_; }

  /// From the moment on at which a stop is requested, next() gives nothing, and waiting() is true,
  /// also where it has been waiting for whoever writes.
  void set_stop(std::stop_token stop) noexcept { stop_ = std::move(stop); }
  const std::stop_token& stop() const noexcept { return stop_; }

  /// Takes what is read for the first time, piece by piece.
  using Tap = std::function<void(std::string_view)>;
  void set_tap(Tap tap) { tap_ = std::move(tap); }

  /// Bytes that have come through a pipe so far; 0 of a file.
  std::int64_t bytes() const noexcept { return static_cast<std::int64_t>(kept().size()); }

  /// Number of the line last read, from 1; 0 before the first.
  int line() const noexcept { return line_; }
  /// The line last read was longer than kLongestLine and has been cut there.
  bool line_was_cut() const noexcept { return line_was_cut_; }
  /// Why reading broke off before the end: SC6002.
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
