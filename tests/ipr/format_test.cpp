// SPDX-License-Identifier: MIT
// Which of two languages a text is in, from a text and through a pipe.
#include "ipr/commands/format.hpp"

#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <thread>

#include "ipr/text/reader.hpp"

namespace softcnc::ipr {
namespace {

std::string format_of(const std::string& text) {
  Reader reader = Reader::from_text(text);
  const Format format = detect_format(reader);
  CHECK(reader.unread() == text);  // nothing is taken
  return std::string(name(format));
}

/// The same, from a pipe that gives one byte at a time.
std::string format_through_pipe(const std::string& text) {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  std::thread writer([&] {
    for (const char& c : text)
      if (::write(ends[1], &c, 1) != 1) break;
    ::close(ends[1]);
  });
  Reader reader(ends[0]);
  const Format format = detect_format(reader);
  std::string read;
  while (const auto line = reader.next()) read += std::string(*line) + "\n";
  writer.join();
  ::close(ends[0]);
  CHECK(read == text);
  return std::string(name(format));
}

}  // namespace

TEST_CASE("the commands of paper 003 are known by their first line", "[ipr][format]") {
  for (const char* text :
       {"l 10 0\n", "L 10,0", "l 1 2 3 ; c\nG01 X1\n", "pcw 10 0 5 0\n", "PCCW\n", "dcw 0 90 5",
        "dccw", "dcaw -90 90 6\n", "s 2 1 1 2 2\n", "s 2\n1 1\n", "s 2\n\n; c\n 1 1\n",
        "(c)\n\n;d\nl 1 1\n", "f 600\nl 1 1\n", "F600\r\ns 3\r\n1 1\r\n", "\xEF\xBB\xBFl 1 1\n",
        "f 5\rl 1 1\r", "pcw x", "l 10\npcw 0 0 5 0\n", "f 100\nl 5\nl 1 2\n"}) {
    INFO(text);
    CHECK(format_of(text) == "commands");
  }
  CHECK(format_of(std::string("l 1 1\0\nf 600\n", 13)) == "commands");
  for (const char* error :
       {"f 300?\n", "xx 10\n", "l 1 ? 2\n", "s 2 $\n", "k 10 10\n", "10 10\n", "x 600\n",
        "F 600 700\n", "f3 00\n", "O 1200\n", "(open\n", "of arcs and (so on)\n", "9of arcs)\n"}) {
    INFO(error);
    CHECK(format_of(std::string(error) + "l 1 1\n") == "commands");
    CHECK(format_of(std::string(error) + "G00 X1\n") == "gcode");
  }
}

TEST_CASE("everything else is G-code", "[ipr][format]") {
  for (const char* text : {"",
                           "\n\n",
                           "%\nl 1 1\n",
                           "G00 X1\n",
                           "G00 X1\nl 1 1\n",
                           "F600\nG01 X1\n",
                           "S1000 M03\n",
                           "S 1000 M03\nl 1 1\n",
                           "s1000\nm3\n",
                           "S500\nX1 Y1\n",
                           "N10 l 1 1\n",
                           "l 10\n",
                           "L10 P2\n",
                           "P3 C4\n",
                           "PCWX 1 1\n",
                           "1 1\n",
                           "f 600\n1 1\n",
                           "s 2\n; only a comment\n",
                           "o100 sub\n",
                           "O100\n5\nG21\nl 1 1\n",
                           "#1=5\n",
                           "$\nl 1 1\n",
                           "lx 1 1\n",
                           "l 1 1 q\n"}) {
    INFO(text);
    CHECK(format_of(text) == "gcode");
  }
}

TEST_CASE("two commands on one line are no G-code", "[ipr][format]") {
  CHECK(format_through_pipe("f 100 l 1 2\n") == "commands");
  CHECK(format_of("f 100 s 2 1 2 3 4\n") == "commands");
  CHECK(format_of("f 100 pcw 1 2 3 4\n") == "commands");
  CHECK(format_of("F100 S1 000\n") == "gcode");
  CHECK(format_of("F100 L3\n") == "gcode");
}

TEST_CASE("a number before a word of G-code is no point of a spline", "[ipr][format]") {
  CHECK(format_through_pipe("S1000\n0M3\nF600\nG1 X1\nM5\nM2\n") == "gcode");
  CHECK(format_through_pipe("S1000\n5 G0 X1\nG1 X2 F100\nM3\nM2\n") == "gcode");
  CHECK(format_through_pipe("s 3\n1 1\n") == "commands");
}

TEST_CASE("a code that no control has decides nothing", "[ipr][format]") {
  CHECK(format_through_pipe("M300\nl 0 5\nl 10 -10\npcw 10 0 5 0\n") == "commands");
  CHECK(format_through_pipe("M300\nG0 X1\n") == "gcode");
  CHECK(format_through_pipe("M30\nl 0 5\n") == "gcode");
}

TEST_CASE("how a text comes in pieces does not matter", "[ipr][format]") {
  CHECK(format_through_pipe("(a comment)\nf 600\nl 10 0\nl 0 10\n") == "commands");
  CHECK(format_through_pipe("f 600\nG01 X1\n") == "gcode");
  CHECK(format_through_pipe("s 2\n1 1\n3 3\n") == "commands");
  CHECK(format_through_pipe("") == "gcode");
}

TEST_CASE("pages of comments are looked through, a buffer full of them is G-code",
          "[ipr][format]") {
  std::string comments;
  while (comments.size() < 20000) comments += "(a comment that says nothing at all)\n";
  CHECK(format_through_pipe(comments + "l 1 1\n") == "commands");
  const auto file = std::filesystem::temp_directory_path() /
                    ("softcnc-format-" + std::to_string(::getpid()) + ".txt");
  {
    while (comments.size() < 200000) comments += comments;
    std::FILE* out = std::fopen(file.c_str(), "wb");
    REQUIRE(out != nullptr);
    std::fputs((comments + "l 1 1\n").c_str(), out);
    std::fclose(out);
  }
  auto reader = Reader::open(file);
  std::filesystem::remove(file);
  REQUIRE(reader);
  CHECK(detect_format(*reader) == Format::gcode);
  CHECK(reader->next() == "(a comment that says nothing at all)");
}

}  // namespace softcnc::ipr
