// SPDX-License-Identifier: MIT
// Reads a text through one buffer; a line is found by its end, never copied.
#include "ipr/text/reader.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <system_error>
#include <utility>

#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::size_t kBufferSize = 65536;
static_assert(kBufferSize > 2 * Reader::kLongestLine);
constexpr int kBetweenLooks = 100;  // ms: so long a pipe is waited for at a time
constexpr int kMostTextLines = std::numeric_limits<int>::max() - 1;
constexpr char kEndMark = '\x1A';
constexpr std::string_view kBlanksAndEndMarks = " \t\v\f\x1A";
constexpr std::string_view kAfterEndMark = " \t\v\f\x1A\r\n";

Diagnostic cannot_read(Code code, const std::string& what, int error) {
  return {code, {}, "cannot read " + what + ": " + std::generic_category().message(error), {}, {}};
}

}  // namespace

Reader::Reader(int descriptor, bool owned)
    : descriptor_(descriptor), owned_(owned), buffer_(kBufferSize, '\0') {
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))
    origin_ = ::lseek(descriptor, 0, SEEK_CUR);
}

Reader::Reader(Reader&& other) noexcept { *this = std::move(other); }

Reader& Reader::operator=(Reader&& other) noexcept {
  if (this == &other) return *this;
  close();
  descriptor_ = std::exchange(other.descriptor_, -1);
  owned_ = other.owned_;
  fed_ = other.fed_;
  origin_ = other.origin_;
  spool_ = std::move(other.spool_);
  first_ = other.first_;
  pipe_ended_ = other.pipe_ended_;
  buffer_ = std::move(other.buffer_);
  begin_ = std::exchange(other.begin_, 0);
  end_ = std::exchange(other.end_, 0);
  intact_ = other.intact_;
  end_offset_ = other.end_offset_;
  line_feed_ = other.line_feed_;
  line_feed_belongs_to_cr_ = other.line_feed_belongs_to_cr_;
  line_was_cut_ = other.line_was_cut_;
  waits_ = other.waits_;
  waiting_ = other.waiting_;
  stop_ = std::move(other.stop_);
  tap_ = std::move(other.tap_);
  line_ = other.line_;
  seek_error_ = other.seek_error_;
  failure_ = std::move(other.failure_);
  return *this;
}

Reader::~Reader() { close(); }

void Reader::close() noexcept {
  if (owned_ && descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

Result<Reader> Reader::open(const std::string& file) {
  if (file == "-") return Reader(STDIN_FILENO);
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return tl::unexpected(cannot_read(Code::SC6001, "'" + file + "'", errno));
  Reader reader(descriptor, true);
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode))
    return tl::unexpected(cannot_read(Code::SC6001, "'" + file + "'", EISDIR));
  return reader;
}

Reader Reader::of_file(int descriptor, std::int64_t begin) {
  Reader reader(descriptor);
  reader.origin_ = begin;
  return reader;
}

Reader Reader::again() const {
  Reader reader;
  reader.first_ = this;
  reader.descriptor_ = descriptor_;
  reader.buffer_.resize(kBufferSize);
  return reader;
}

Reader Reader::fed() {
  Reader reader;
  reader.fed_ = true;
  reader.buffer_.resize(kBufferSize);
  return reader;
}

Status Reader::feed(std::string_view text) {
  spool_.add(text.data(), text.size());
  if (spool_.failure()) return tl::make_unexpected(*spool_.failure());
  return {};
}

Reader Reader::from_text(std::string text) {
  Reader reader;
  reader.buffer_ = std::move(text);
  reader.end_ = reader.buffer_.size();
  reader.end_offset_ = reader.end_;
  return reader;
}

[[gnu::hot]] std::optional<std::string_view> Reader::next() {
  waiting_ = stop_.stop_requested();
  if (waiting_ || has_too_many_lines()) return std::nullopt;
  std::size_t searched = 0;  // bytes of the line that hold no line end
  for (;;) {
    skip_line_feed();
    const std::size_t line_end = find_line_end(begin_ + searched);
    if (line_end < end_) return ends_in_end_mark(line_end) ? take_marked(line_end) : take(line_end);
    if (!fill()) break;
    searched = 0;
  }
  if (waiting_) return std::nullopt;
  if (begin_ == end_) return std::nullopt;
  return ends_in_end_mark(end_) ? take_marked(end_) : take(end_);
}

/// Which is a failure: a line has a number.
bool Reader::has_too_many_lines() {
  if (line_ < kMostTextLines) return false;
  failure_ = cannot_read(Code::SC6002, "more than 2147483646 lines", EFBIG);
  return true;
}

/// Whether the last byte of the line that is no blank is an end mark.
bool Reader::ends_in_end_mark(std::size_t line_end) const noexcept {
  while (line_end > begin_ && is_blank(buffer_[line_end - 1])) --line_end;
  return line_end > begin_ && buffer_[line_end - 1] == kEndMark;
}

/// The line without its end marks, and the end of the text, if nothing follows them.
std::optional<std::string_view> Reader::take_marked(std::size_t line_end) {
  const std::size_t length = line_end - begin_;
  const bool is_end = only_blanks_follow(length);
  if (waiting_) return std::nullopt;
  const std::string_view text = unread().substr(0, length);
  if (!is_end) return take(begin_ + length);
  const std::string_view line = take(begin_ + text.find_last_not_of(kBlanksAndEndMarks) + 1);
  begin_ = end_;
  line_feed_belongs_to_cr_ = false;
  return line;
}

/// Whether nothing but blanks, line ends and end marks come after the next `length` bytes; so many
/// of them that they do not fit into the buffer are no end.
bool Reader::only_blanks_follow(std::size_t length) {
  const auto is_blank_so_far = [&] {
    return unread().find_first_not_of(kAfterEndMark, length) == std::string_view::npos;
  };
  while (is_blank_so_far() && read_ahead()) {
  }
  const bool all_is_there = is_in_memory() || end_ - begin_ < buffer_.size() / 2;
  return all_is_there && is_blank_so_far();
}

/// Leaves out the LF of a CRLF, which may come in a later piece than its CR.
void Reader::skip_line_feed() noexcept {
  if (!line_feed_belongs_to_cr_ || begin_ == end_) return;
  if (buffer_[begin_] == '\n') ++begin_;
  line_feed_belongs_to_cr_ = false;
}

std::size_t Reader::find(char wanted, std::size_t from, std::size_t to) const noexcept {
  if (from >= to) return to;
  const char* text = buffer_.data();
  const auto* found = static_cast<const char*>(std::memchr(text + from, wanted, to - from));
  return found ? static_cast<std::size_t>(found - text) : to;
}

/// The place of the line's CR or LF, end_ if neither is in the buffer. The LF is remembered, so
/// that a text with nothing but CRs is not searched to its end for every line.
std::size_t Reader::find_line_end(std::size_t from) noexcept {
  if (line_feed_ == kUnknown || line_feed_ < from) line_feed_ = find('\n', from, end_);
  return find('\r', from, line_feed_);
}

/// Reads more after what is there. False at the end of the text.
bool Reader::fill() {
  if (is_in_memory() || failure_) return false;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  intact_ -= std::min(intact_, begin_);
  end_ -= std::exchange(begin_, 0);
  if (end_ == buffer_.size()) intact_ = end_ = kLongestLine + 1;  // the rest of it is not kept
  line_feed_ = kUnknown;
  const std::ptrdiff_t got = read_more(buffer_.data() + end_, buffer_.size() - end_);
  if (got < 0) failure_ = cannot_read(Code::SC6002, "on", errno);
  if (got <= 0) return false;
  end_ += static_cast<std::size_t>(got);
  end_offset_ += static_cast<std::uint64_t>(got);
  return true;
}

/// Within so many ms.
bool Reader::has_nothing_yet(int timeout) const noexcept {
  pollfd source{descriptor_, POLLIN, 0};
  return ::poll(&source, 1, timeout) == 0;
}

/// Whether a pipe has nothing, and nobody is to wait for it, or not any longer.
bool Reader::is_to_wait() const noexcept {
  if (first_ != nullptr || fed_) return true;
  if (!waits_) return has_nothing_yet(0);
  while (stop_.stop_possible() && has_nothing_yet(kBetweenLooks))
    if (stop_.stop_requested()) return true;
  return false;
}

/// What lies at end_offset_: once more out of the spool, or new.
std::ptrdiff_t Reader::read_more(char* to, std::size_t size) {
  std::ptrdiff_t got = 0;
  const bool again = is_pipe() && end_offset_ < kept().size();
  const bool ended = first_ != nullptr ? first_->pipe_ended_ : pipe_ended_;
  if (is_pipe() && !again && ended) return 0;
  waiting_ = is_pipe() && !again && is_to_wait();
  if (waiting_) return 0;
  do {
    got = again       ? kept().read(end_offset_, to, size)
          : is_pipe() ? ::read(descriptor_, to, size)
                      : ::pread(descriptor_, to, size, static_cast<off_t>(end_offset_) + origin_);
  } while (got < 0 && errno == EINTR);
  if (!again && got > 0 && tap_) tap_({to, static_cast<std::size_t>(got)});
  if (is_pipe() && !again && got > 0) spool_.add(to, static_cast<std::size_t>(got));
  if (!again && got == 0) pipe_ended_ = true;
  return got;
}

Reader::Place Reader::place() const noexcept {
  return {end_offset_ - (end_ - begin_), line_, line_feed_belongs_to_cr_};
}

Reader::Place Reader::place_before(std::string_view last) const noexcept {
  const char* const end = buffer_.data() + end_;
  return {end_offset_ - static_cast<std::uint64_t>(end - last.data()), line_ - 1, false};
}

bool Reader::seek(const Place& place) {
  const bool in_buffer =
      place.offset <= end_offset_ && end_offset_ - place.offset <= end_ - intact_;
  if (!in_buffer) {
    if (is_pipe() && kept().failure()) return false;
    const auto target = static_cast<off_t>(place.offset) + origin_;
    if (!is_pipe() && ::lseek(descriptor_, target, SEEK_SET) < 0) {
      seek_error_ = errno;
      return false;
    }
    begin_ = end_ = intact_ = 0;
    end_offset_ = place.offset;
  } else {
    begin_ = end_ - static_cast<std::size_t>(end_offset_ - place.offset);
  }
  line_feed_ = kUnknown;
  line_ = place.line;
  line_feed_belongs_to_cr_ = place.after_cr;
  return true;
}

Diagnostic Reader::seek_failure() const {
  if (kept().failure()) return *kept().failure();
  return cannot_read(Code::SC6002, "it again", seek_error_);
}

[[gnu::hot]] std::string_view Reader::take(std::size_t line_end) noexcept {
  std::string_view line(buffer_.data() + begin_, line_end - begin_);
  line_feed_belongs_to_cr_ = line_end < end_ && buffer_[line_end] == '\r';
  begin_ = std::min(line_end + 1, end_);
  if (++line_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  line_was_cut_ = line.size() > kLongestLine;
  return line.substr(0, kLongestLine);
}

}  // namespace softcnc::ipr
