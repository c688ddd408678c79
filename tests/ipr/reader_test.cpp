// SPDX-License-Identifier: MIT
// Lines of texts, files and descriptors.
#include "ipr/text/reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "support/folder.hpp"
#include "support/shown.hpp"

namespace softcnc::ipr {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(Reader reader) {
  Lines lines;
  while (const auto line = reader.next()) {
    lines.emplace_back(*line);
    REQUIRE(reader.line() == static_cast<int>(lines.size()));
  }
  return lines;
}

/// The text through a pipe, in pieces of the size given.
Lines lines_through_pipe(const std::string& text, std::size_t piece) {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  const pid_t writer = ::fork();
  if (writer == 0) {
    for (std::size_t at = 0; at < text.size(); at += piece) {
      const std::size_t size = std::min(piece, text.size() - at);
      if (::write(ends[1], text.data() + at, size) < 0) ::_exit(1);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  const Lines lines = lines_of(Reader(ends[0]));
  ::close(ends[0]);
  return lines;
}

}  // namespace

TEST_CASE("lines end with LF, CRLF or a lone CR", "[ipr][reader]") {
  CHECK(lines_of(Reader::from_text("a\nb\n")) == Lines{"a", "b"});
  CHECK(lines_of(Reader::from_text("a\r\nb\r\n")) == Lines{"a", "b"});
  CHECK(lines_of(Reader::from_text("a\rb\r")) == Lines{"a", "b"});
  CHECK(lines_of(Reader::from_text("a\n\nb\r\rc\r\n\r\nd")) ==
        Lines{"a", "", "b", "", "c", "", "d"});
}

TEST_CASE("0x1A ends a text where nothing follows but blanks and line ends", "[ipr][reader]") {
  CHECK(lines_of(Reader::from_text("a\r\nb\r\n\x1a")) == Lines{"a", "b", ""});
  CHECK(lines_of(Reader::from_text("a\nb\x1a")) == Lines{"a", "b"});
  CHECK(lines_of(Reader::from_text("a\nb \x1a\t\x1a \f\r\n\n\x1a\x1a\v \n")) == Lines{"a", "b"});
  CHECK(lines_of(Reader::from_text("\x1a")) == Lines{""});
  CHECK(lines_of(Reader::from_text("a\x1a\nb\n")) == Lines{"a\x1a", "b"});
  CHECK(lines_of(Reader::from_text("a\x1a b\n\x1a")) == Lines{"a\x1a b", ""});
}

TEST_CASE("0x1A ends what comes through a pipe, in whatever pieces", "[ipr][reader]") {
  const std::string padded = "a\r\nb\r\n" + std::string(100, '\x1a');
  const std::string far = "a\n\x1a" + std::string(100'000, '\n') + "b";
  for (const std::size_t piece : {1U, 7U, 65536U}) {
    CAPTURE(piece);
    CHECK(lines_through_pipe(padded, piece) == Lines{"a", "b", ""});
    CHECK(lines_through_pipe("a\x1a\n\nb\n", piece) == Lines{"a\x1a", "", "b"});
    const Lines lines = lines_through_pipe(far, piece);
    CHECK(lines.size() == 100'002);
    CHECK(lines[1] == "\x1a");
  }
}

TEST_CASE("after 0x1A a reader that does not wait asks again", "[ipr][reader]") {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  Reader reader(ends[0]);
  reader.do_not_wait();
  const auto say = [&](std::string_view text) {
    REQUIRE(::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  };
  say("a\x1a\n");
  CHECK_FALSE(reader.next());
  CHECK(reader.waiting());
  say("b\n\x1a");
  CHECK(reader.next() == "a\x1a");
  CHECK(reader.next() == "b");
  CHECK_FALSE(reader.next());
  CHECK(reader.waiting());
  ::close(ends[1]);
  CHECK(reader.next() == "");
  CHECK_FALSE(reader.next());
  CHECK_FALSE(reader.waiting());
  ::close(ends[0]);
}

TEST_CASE("the last line may lack its end, and an empty text has no line", "[ipr][reader]") {
  CHECK(lines_of(Reader::from_text("a\nb")) == Lines{"a", "b"});
  CHECK(lines_of(Reader::from_text("")).empty());
  CHECK(lines_of(Reader::from_text("\n")) == Lines{""});
}

TEST_CASE("a byte order mark is left out, on the first line only", "[ipr][reader]") {
  CHECK(lines_of(Reader::from_text("\xEF\xBB\xBFG0\n\xEF\xBB\xBFG1")) ==
        Lines{"G0", "\xEF\xBB\xBFG1"});
}

TEST_CASE("pieces of a text do not show in its lines", "[ipr][reader]") {
  const std::string text = "one\r\ntwo\rthree\n\r\nfive\r";
  const Lines expected{"one", "two", "three", "", "five"};
  for (const std::size_t piece : {1U, 2U, 3U, 5U, 100U})
    CHECK(lines_through_pipe(text, piece) == expected);
}

TEST_CASE("a text longer than the buffer comes out whole", "[ipr][reader]") {
  std::string text;
  Lines expected;
  for (int i = 0; i < 30000; ++i) {
    expected.push_back("G01 X" + std::to_string(i) +
                       std::string(static_cast<unsigned>(i % 37), ' '));
    text += expected.back() + (i % 3 == 0 ? "\r\n" : "\n");
  }
  CHECK(lines_through_pipe(text, 60000) == expected);
  CHECK(lines_of(Reader::from_text(text)) == expected);
}

TEST_CASE("a line without end is cut, and the next one is read", "[ipr][reader]") {
  const std::string text = "a\n" + std::string(300000, 'x') + "\nb\n";
  CHECK(lines_through_pipe(text, 50000) == Lines{"a", std::string(Reader::kLongestLine, 'x'), "b"});
  Reader reader = Reader::from_text(text);
  reader.next();
  CHECK_FALSE(reader.line_was_cut());
  reader.next();
  CHECK(reader.line_was_cut());
  reader.next();
  CHECK_FALSE(reader.line_was_cut());
}

TEST_CASE("a file is read by its name", "[ipr][reader]") {
  const auto file = std::filesystem::path(SOFTCNC_SOURCE_DIR) / "tests/good/only_end.nc";
  auto reader = Reader::open(file.string());
  REQUIRE(reader);
  CHECK(lines_of(std::move(*reader)).back() == "M30");
}

TEST_CASE("a file that is not there is SC6001, with the reason", "[ipr][reader]") {
  const auto reader = Reader::open("no/such/file.nc");
  REQUIRE_FALSE(reader);
  CHECK(reader.error().code == Code::SC6001);
  CHECK(reader.error().pos.line == 0);
  CHECK(reader.error().message == "cannot read 'no/such/file.nc': No such file or directory");
}

TEST_CASE("a folder is no part program: SC6001", "[ipr][reader]") {
  const auto reader = Reader::open(SOFTCNC_SOURCE_DIR);
  REQUIRE_FALSE(reader);
  CHECK(reader.error().code == Code::SC6001);
  CHECK(reader.error().message ==
        "cannot read '" + std::string(SOFTCNC_SOURCE_DIR) + "': Is a directory");
}

TEST_CASE("reading that fails is SC6002, and ends the text", "[ipr][reader]") {
  const int folder = ::open(SOFTCNC_SOURCE_DIR, O_RDONLY);
  REQUIRE(folder >= 0);
  Reader reader(folder);
  CHECK_FALSE(reader.next());
  REQUIRE(reader.failure());
  CHECK(reader.failure()->code == Code::SC6002);
  CHECK(reader.failure()->pos.line == 0);
  CHECK(reader.failure()->message == "cannot read on: Is a directory");
  ::close(folder);
}

TEST_CASE("a reader keeps its place when it is moved", "[ipr][reader]") {
  Reader first = Reader::from_text("a\nb\nc\n");
  first.next();
  Reader second = std::move(first);
  CHECK(second.next() == "b");
  CHECK(second.line() == 2);
  first = std::move(second);
  CHECK(first.next() == "c");
}

namespace {

/// Goes through the text by `steps` lines forward and then back to each place in turn.
void check_places(Reader reader, const Lines& expected) {
  std::vector<Reader::Place> before;
  for (;;) {
    before.push_back(reader.place());
    if (!reader.next()) break;
  }
  REQUIRE(before.size() == expected.size() + 1);
  for (std::size_t i = expected.size(); i-- > 0;) {
    INFO("line " << i + 1);
    for (const std::size_t from : {i, i * 7 % expected.size()}) {
      REQUIRE(reader.seek(before[from]));
      REQUIRE(reader.line() == static_cast<int>(from));
      REQUIRE(reader.next() == expected[from]);
    }
  }
  REQUIRE(reader.seek(before.front()));
  REQUIRE(lines_of(std::move(reader)) == expected);
}

/// Lines of many lengths, one of them longer than the buffer, with ends of all kinds.
std::string long_text(Lines& lines) {
  const std::string ends[] = {"\n", "\r\n", "\r"};
  std::string text;
  for (unsigned i = 0; i < 9000; ++i) {
    const std::string line(i == 4000 ? 200000 : i * 31 % 61, static_cast<char>('a' + i % 26));
    lines.push_back(line.substr(0, Reader::kLongestLine));
    text += line + ends[i % 5 % 3];
    if (line.empty() && ends[i % 5 % 3] == "\n" && text.size() > 1 && text[text.size() - 2] == '\r')
      lines.pop_back();  // the LF of a CRLF
  }
  return text;
}

/// A pipe into which another process writes the text.
Reader pipe_of(const std::string& text) {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  if (::fork() == 0) {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t n =
          ::write(ends[1], text.data() + at, std::min<std::size_t>(5000, text.size() - at));
      if (n < 0) ::_exit(1);
      at += static_cast<std::size_t>(n);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  return Reader(ends[0]);
}

}  // namespace

TEST_CASE("a text, a file and a pipe can be read again from any line", "[ipr][reader]") {
  Lines expected;
  const std::string text = long_text(expected);
  SECTION("text") { check_places(Reader::from_text(text), expected); }
  SECTION("file") {
    test::Folder folder;
    auto reader = Reader::open(folder.with("text.nc", text) / "text.nc");
    REQUIRE(reader);
    check_places(std::move(*reader), expected);
  }
  SECTION("pipe") { check_places(pipe_of(text), expected); }
}

TEST_CASE("the line last read can be read once more", "[ipr][reader]") {
  Reader reader = Reader::from_text(
      "\xEF\xBB\xBF"
      "a\r\nbc\r\nd");
  for (const char* expected : {"a", "bc", "d"}) {
    const auto line = reader.next();
    REQUIRE(line == expected);
    const int number = reader.line();
    REQUIRE(reader.seek(reader.place_before(*line)));
    CHECK(reader.next() == expected);
    CHECK(reader.line() == number);
  }
  CHECK_FALSE(reader.next());
}

TEST_CASE("a file that is read from its middle on goes back to there", "[ipr][reader]") {
  test::Folder folder;
  const std::string name = folder.with("lines.nc", "a\nb\nc\nd\n") / "lines.nc";
  const int file = ::open(name.c_str(), O_RDONLY);
  REQUIRE(::lseek(file, 4, SEEK_SET) == 4);
  Reader reader(file);
  const Reader::Place begin = reader.place();
  CHECK(reader.next() == "c");
  CHECK(reader.next() == "d");
  CHECK_FALSE(reader.next());
  REQUIRE(reader.seek(begin));
  CHECK(reader.next() == "c");
  ::close(file);
}

TEST_CASE("a file that cannot be read again is SC6002, with the reason", "[ipr][reader]") {
  test::Folder folder;
  std::string text = "first\n";
  for (int i = 0; i < 50000; ++i) text += "a line of it\n";
  const std::string name = folder.with("lines.nc", text) / "lines.nc";
  const int file = ::open(name.c_str(), O_RDONLY);
  Reader reader(file);
  const Reader::Place begin = reader.place();
  while (reader.next()) {
  }
  ::close(file);
  CHECK_FALSE(reader.seek(begin));
  CHECK(reader.seek_failure().code == Code::SC6002);
  CHECK(reader.seek_failure().message.ends_with("Bad file descriptor"));
}

TEST_CASE("without a temporary file a pipe is read, but not twice: SC6032", "[ipr][reader]") {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", "/proc/self/task", 1);  // a folder in which no file can be made
  std::string text = "first\n";
  for (int i = 0; i < 50000; ++i) text += "a line of it\n";
  Reader reader = pipe_of(text);
  const Reader::Place begin = reader.place();
  int lines = 0;
  while (reader.next()) ++lines;
  CHECK(lines == 50001);
  CHECK_FALSE(reader.failure());
  CHECK_FALSE(reader.seek(begin));
  CHECK(begins_showing(render(reader.seek_failure()),
                       "softcnc: error: what came through the pipe could not be kept in a "
                       "temporary file: ... [SC6032]"));
  kept.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", kept.c_str(), 1);
}

}  // namespace softcnc::ipr
