// SPDX-License-Identifier: MIT
// Lists of edges out of files: those of others, and those that are damaged.
#include "hal/signals/edge_reader.hpp"

#include <catch2/catch.hpp>

#include "hal/files/compressed_file.hpp"
#include "hal/files/output_file.hpp"
#include "hal/files/zstd_sink.hpp"
#include "hal/signals/edge_file.hpp"
#include "support/folder.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::step;

/// A dump of another program: its own order, names and scale, with variables that are no lines.
const std::string kDumpHead =
    "$date\n  Sunday $end\n$version logic analyser 3 $end\n$timescale 10us $end\n"
    "$scope module top $end\n$scope module port $end\n"
    "$var wire 8 data bus [7:0] $end\n$var reg 1 s1 z_step $end\n$var wire 1 d1 z_dir $end\n"
    "$var real 64 v speed $end\n$upscope $end\n$upscope $end\n$enddefinitions $end\n";

struct Reading {
  std::vector<SignalEdge> edges, begins;
  std::vector<SourcePos> places;
  std::vector<std::string> lines;
  std::string error;
};

Reading read_in_pieces(std::string_view text, std::size_t piece) {
  Reading reading;
  EdgeReader reader([&](const ReadEdge& read) {
    (read.begins ? reading.begins : reading.edges).push_back(read.edge);
    reading.places.push_back(read.pos);
    reading.lines.emplace_back(read.line);
  });
  Status status;
  for (std::size_t i = 0; status && i < text.size(); i += piece)
    status = reader.read(text.substr(i, piece));
  if (status) status = reader.finish();
  if (!status) {
    CHECK((status.error().code == Code::SC6091 || status.error().code == Code::SC6092));
    reading.error = status.error().message;
  }
  return reading;
}

Reading read_all(std::string_view text) {
  return read_in_pieces(text, std::max<std::size_t>(text.size(), 1));
}

std::string error_of(std::string_view text) { return read_all(text).error; }

}  // namespace

TEST_CASE("a dump of another program is read, wherever it is cut", "[hal][pulse]") {
  const std::string text = kDumpHead +
                           "#3\n$dumpvars b00xx data xs1 1d1 r0.5 v $end\n"
                           "#4 0s1 b1 data\n$comment 1s1 $end\n#10\n1s1\n\n#12 b0 s1\n0d1\r\n";
  for (const std::size_t piece : {1UL, 2UL, 3UL, 7UL, text.size()}) {
    CAPTURE(piece);
    const Reading reading = read_in_pieces(text, piece);
    CHECK(reading.error.empty());
    CHECK(reading.begins ==
          std::vector{SignalEdge{30'000, 2, Wire::direction, true}, step(40'000, false, 2)});
    CHECK(reading.edges == std::vector{step(100'000, true, 2), step(120'000, false, 2),
                                       SignalEdge{120'000, 2, Wire::direction, false}});
    CHECK(reading.places[2].line == 19);
    CHECK(reading.places[2].column == 1);
    CHECK(reading.places[2].length == 3);
    CHECK(reading.places[3].line == 21);
    CHECK(reading.places[3].column == 8);
    CHECK(reading.places[4].line == 22);
  }
  CHECK(read_all(text).lines[3] == "#12 b0 s1");
  CHECK(read_all(text).lines[4] == "0d1");
}

TEST_CASE("times finer than ns are rounded, coarser ones exact", "[hal][pulse]") {
  const auto time_of = [](const std::string& scale, const std::string& time) {
    const Reading reading = read_all("$timescale " + scale +
                                     " $end $var wire 1 ! x_step $end "
                                     "$enddefinitions $end\n#" +
                                     time + " 1!\n");
    REQUIRE(reading.error.empty());
    return reading.edges.at(0).time;
  };
  CHECK(time_of("1 s", "7") == 7'000'000'000);
  CHECK(time_of("100 ms", "7") == 700'000'000);
  CHECK(time_of("100ns", "7") == 700);
  CHECK(time_of("1 ps", "1499") == 1);
  CHECK(time_of("1 ps", "1500") == 2);
  CHECK(time_of("10ps", "149") == 1);
  CHECK(time_of("10 fs", "150000") == 2);
}

TEST_CASE("a dump that is damaged or says nothing of pulses is refused", "[hal][pulse][code]") {
  CHECK(error_of("") == "empty");
  CHECK(error_of("\n \n") == "not whole: it ends within its definitions");
  CHECK(error_of("steps") == "neither a Value Change Dump nor a list that begins with 'edges 1'");
  CHECK(error_of(std::string("PK\3\4 something else", 20)) ==
        "neither a Value Change Dump nor a list that begins with 'edges 1'");
  CHECK(error_of("edges 2\nxx") ==
        "a list of edges, but not of form 1, the only one this version reads");
  CHECK(error_of("edges") == "neither a Value Change Dump nor a list that begins with 'edges 1'");
  CHECK(error_of("$timescale 1 ns $end\n") == "not whole: it ends within its definitions");
  CHECK(error_of("$timescale 3 ns $end\n") ==
        "$timescale takes 1, 10 or 100 s, ms, us, ns, ps or fs, not '3ns'");
  CHECK(error_of("$timescale 1 ns $end $enddefinitions $end\n") ==
        "no variable is called x_step, x_direction, y_step, ...");
  CHECK(error_of("$var wire 1 ! x_step $end $enddefinitions $end\n") == "no $timescale");
  CHECK(error_of("$var wire 2 ! x_step $end\n") == "x_step is not one bit");
  CHECK(error_of("$var wire 1 ! x_step $end $var wire 1 ? x_step $end\n") ==
        "x_step is there twice");
  CHECK(error_of("$var wire 1 $end\n") == "$var takes a type, a size and two names");
  CHECK(error_of("$end\n") == "an $end without a beginning");
  CHECK(error_of("$date $end\n#1\n") == "'#1' among the definitions");
  CHECK(error_of(kDumpHead + "#4 1s") == "not whole: it ends within a line");
  CHECK(error_of(kDumpHead + "#4 b1\n") == "not whole: it ends within a value");
  CHECK(error_of(kDumpHead + "#4 $comment\n") == "not whole: it ends within $comment");
  CHECK(error_of(kDumpHead + "$dumpvars 1s1\n") ==
        "not whole: it ends within a dump of all values");
  CHECK(error_of(kDumpHead + "#-4\n") == "'#-4' is not a time");
  CHECK(error_of(kDumpHead + "#9223372036854775807\n") == "'#9223372036854775807' is not a time");
  CHECK(error_of(kDumpHead + "#4 hello\n") == "'hello' is not a value of a variable");
  CHECK(error_of(kDumpHead + std::string(1000, 'q') + '\n') ==
        "'" + std::string(40, 'q') + "...' is not a value of a variable");
  CHECK(error_of(kDumpHead + "#4 1s1 #5 xs1\n") == "z_step is neither high nor low");
  CHECK(error_of(kDumpHead + "#4 1s1 #5 b00 s1\n") == "z_step is neither high nor low");
}

TEST_CASE("the place of what is wrong in a dump is reported", "[hal][pulse]") {
  EdgeReader reader([](const ReadEdge&) {});
  const Status read = reader.read(kDumpHead + "#4\n1s1\n#5 ?!\n");
  REQUIRE_FALSE(read);
  CHECK(read.error().pos.line == 16);
  CHECK(read.error().pos.column == 4);
  CHECK(read.error().pos.length == 2);
  CHECK(read.error().source_line == "#5 ?!");
}

TEST_CASE("a line of a dump that does not end is refused before it fills the memory",
          "[hal][pulse][code]") {
  constexpr std::size_t kPiece = 65536;
  for (const std::string word : {" ", "1s1 ", "x"}) {
    CAPTURE(word);
    std::string piece;
    while (piece.size() < kPiece) piece += word;
    EdgeReader reader([](const ReadEdge&) {});
    REQUIRE(reader.read(kDumpHead + "#4\n"));
    Status status;
    int pieces = 0;
    for (; status && pieces < 100; ++pieces) status = reader.read(piece);
    REQUIRE_FALSE(status);
    CHECK(pieces < 18);  // 1 MiB
    status.error().file = "t.vcd";
    CHECK(render(status.error())
              .starts_with("t.vcd:15:1: error: a line longer than 1 MiB [SC6092]\n"));
  }
  std::string names;
  for (int i = 0; i < 1000; ++i) names += "name\n";
  CHECK(error_of("$var " + names) == "too many words after $var");
}

TEST_CASE("a packed list of edges that unpacks to a thousand times its size is refused",
          "[hal][pulse]") {
  const test::Folder folder;
  const std::string file = folder / "bomb.vcd.zst";
  auto out = OutputFile::open(file);
  REQUIRE(out);
  auto sink = zstd_sink(std::move(*out));
  REQUIRE(sink->write(kDumpHead));
  const std::string blank(std::size_t{1} << 20U, '\n');
  for (int i = 0; i < 400; ++i) REQUIRE(sink->write(blank));
  REQUIRE(sink->finish());
  REQUIRE(std::filesystem::file_size(file) < 100'000);
  auto packed = CompressedFile::open(file, Code::SC6090, Code::SC6091);
  REQUIRE(packed);
  std::size_t unpacked = 0;
  Result<std::string_view> bytes = packed->next();
  for (; bytes && !bytes->empty(); bytes = packed->next()) unpacked += bytes->size();
  REQUIRE_FALSE(bytes);
  CHECK(bytes.error().code == Code::SC6091);
  CHECK(bytes.error().message == "unpacks to more than 2000 times its size");
  CHECK(unpacked < 300'000'000);
}

TEST_CASE("a binary list is read wherever it is cut, and refused where it is damaged",
          "[hal][pulse]") {
  const std::string text("edges 1\n\x85\x01\x06\x05\x01\x00\x00", 15);
  for (const std::size_t piece : {1UL, 3UL, 15UL}) {
    const Reading reading = read_in_pieces(text, piece);
    CHECK(reading.error.empty());
    CHECK(reading.edges == std::vector{SignalEdge{133, 1, Wire::direction, false}, step(138, true),
                                       step(138, false)});
  }
  CHECK(error_of(text.substr(0, 14)) == "not whole: it ends within an edge");
  CHECK(error_of(text.substr(0, 10)) == "not whole: it ends within an edge");
  CHECK(error_of(text + "\x01\x0c") == "damaged: byte 17 names no line");
  CHECK(error_of(text + std::string(10, '\xff')) == "damaged: byte 25 makes no time");
  CHECK(error_of(text + "\xff\xff\xff\xff\xff\xff\xff\xff\x7f") ==
        "damaged: byte 24 makes no time");
}

TEST_CASE("a compressed file is unpacked, and must be whole", "[hal]") {
  const test::Folder folder;
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += std::to_string(i * 7919 % 100'003) + '\n';
  auto out = OutputFile::open(folder / "a.zst");
  REQUIRE(out);
  const auto sink = zstd_sink(std::move(*out));
  REQUIRE(sink->write(text));
  REQUIRE(sink->finish());
  const std::string packed = test::read(folder / "a.zst");
  REQUIRE(packed.size() < text.size());
  const auto unpacked = [&](const std::string& bytes) -> std::string {
    REQUIRE(write_file(folder / "b", bytes));
    auto file = CompressedFile::open(folder / "b", Code::SC6090, Code::SC6091);
    REQUIRE(file);
    std::string all;
    for (;;) {
      const auto piece = file->next();
      if (!piece) {
        CHECK(piece.error().code == Code::SC6091);
        CHECK(piece.error().file == folder / "b");
        return piece.error().message;
      }
      if (piece->empty()) return all;
      all += *piece;
    }
  };
  CHECK(unpacked(packed) == text);
  CHECK(unpacked(text) == text);
  CHECK(unpacked(packed + packed) == text + text);
  CHECK(unpacked("").empty());
  for (const std::size_t size :
       {packed.size() - 1, packed.size() / 2, std::size_t{70'000}, std::size_t{5}})
    CHECK(unpacked(packed.substr(0, size)) == "not whole: it ends within its compressed part");
  std::string damaged = packed;
  damaged[packed.size() / 2] = static_cast<char>(~damaged[packed.size() / 2]);
  CHECK(unpacked(damaged).starts_with("damaged: "));
}

TEST_CASE("a file that cannot be read is distinguished from one that is damaged", "[hal][code]") {
  const auto missing = CompressedFile::open("/no/such/list", Code::SC6090, Code::SC6091);
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == Code::SC6090);
  CHECK(missing.error().message == "cannot be read: No such file or directory");
  auto folder = CompressedFile::open("/", Code::SC6090, Code::SC6091);
  REQUIRE(folder);
  const auto bytes = folder->next();
  REQUIRE_FALSE(bytes);
  CHECK(bytes.error().code == Code::SC6090);
  CHECK(bytes.error().message == "cannot be read: Is a directory");
}

}  // namespace softcnc::hal
