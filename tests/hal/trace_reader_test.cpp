// SPDX-License-Identifier: MIT
// Traces read back: the numbers that were written, and what is said of damaged files.
#include "hal/trace/trace_reader.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "hal/files/npz_file.hpp"
#include "hal/files/zip_file.hpp"
#include "hal/trace/trace.hpp"
#include "support/property.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

const std::array<std::string, 4> kSuffixes{".csv", ".csv.zst", ".npz", ".npz.zst"};

struct WrittenTrace {
  std::vector<Setpoint> rows;
  std::vector<double> errors;  // of the column x_err_um
};

Status write_trace(const std::string& file, const WrittenTrace& trace) {
  const std::vector<std::string> columns{"x_err_um", "x_count"};
  auto writer = TraceWriter::open(file, {0.0025, "aa11", "bb22"}, Machine{}, columns);
  if (!writer) return tl::make_unexpected(writer.error());
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    (*writer)->row(trace.rows[i], std::array{trace.errors[i], static_cast<double>(i)});
  return (*writer)->finish();
}

WrittenTrace some_rows(int count) {
  WrittenTrace trace;
  for (int i = 0; i < count; ++i) {
    Setpoint row;
    row.period = i;
    row.line = i / 3;
    row.block = i / 7;
    row.s = i / 3.0;
    row.v = 1e5 / (i + 1.0);
    row.feed = i % 2;
    row.limit = static_cast<Limit>(i % kLimits);
    row.position = {i / 7.0, -i * 1e-9, 1.0};
    trace.rows.push_back(row);
    trace.errors.push_back(i * 0.1);
  }
  return trace;
}

/// Selects all columns.
Status select_all(TraceReader& reader) {
  std::vector<std::size_t> columns(reader.columns().size());
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  return reader.select(columns);
}

bool reads_row(TraceReader& reader) {
  const auto more = reader.next();
  return more && *more;
}

bool is_at_end(TraceReader& reader) {
  const auto more = reader.next();
  return more && !*more;
}

/// What is wrong with a file, however far it can be read.
Diagnostic problem(const std::string& file) {
  auto reader = TraceReader::open(file);
  if (!reader) return reader.error();
  if (Status selected = select_all(**reader); !selected) return selected.error();
  for (;;) {
    const auto more = (*reader)->next();
    if (!more) return more.error();
    if (!*more) break;
  }
  FAIL("nothing is wrong with " << file);
  return {};
}

const std::string kTraceHead = "t_s,line,block,s_mm,v_mm_s,a_mm_s2,limit,x_mm,feed_mm_s\n";
const std::string kRow = "0,1,1,0,0,1000,stop,0,100\n";

}  // namespace

TEST_CASE("traces of all forms read back as they were written", "[hal][trace]") {
  const test::Folder folder;
  const WrittenTrace trace = some_rows(10'000);  // more than a piece of every form
  for (const std::string& suffix : kSuffixes) {
    CAPTURE(suffix);
    const std::string file = folder / ("t" + suffix);
    REQUIRE(write_trace(file, trace));
    const auto reader = TraceReader::open(file);
    REQUIRE(reader);
    CHECK((*reader)->columns() ==
          std::vector<std::string>{"t_s", "line", "block", "s_mm", "v_mm_s", "a_mm_s2", "limit",
                                   "x_mm", "y_mm", "z_mm", "feed_mm_s", "x_err_um", "x_count"});
    REQUIRE(select_all(**reader));
    for (std::size_t i = 0; i < trace.rows.size(); ++i) {
      REQUIRE(reads_row(**reader));
      const Setpoint& row = trace.rows[i];
      const auto n = static_cast<double>(i);
      const std::vector<double> expected{
          n * 2.5 / 1000,  double(row.line), double(row.block), row.s,    row.v,           row.a, 0,
          row.position[0], row.position[1],  row.position[2],   row.feed, trace.errors[i], n};
      const auto values = (*reader)->values();
      REQUIRE(std::vector<double>(values.begin(), values.end()) == expected);
      REQUIRE((*reader)->limit() == row.limit);
    }
    CHECK(is_at_end(**reader));
    const TraceComment& comment = (*reader)->comment();
    CHECK(comment.schema == kTraceSchema);
    CHECK(comment.period == 0.0025);
    CHECK(comment.program_hash == "aa11");
    CHECK(comment.machine_hash == "bb22");
  }
}

TEST_CASE("only selected columns are read, in the order of the selection", "[hal][trace]") {
  const test::Folder folder;
  for (const std::string& suffix : kSuffixes) {
    const std::string file = folder / ("t" + suffix);
    REQUIRE(write_trace(file, some_rows(5)));
    const auto reader = TraceReader::open(file);
    REQUIRE(reader);
    REQUIRE((*reader)->select(std::array<std::size_t, 2>{7, 1}));
    for (int i = 0; i < 5; ++i) REQUIRE(reads_row(**reader));
    CHECK((*reader)->values()[0] == 4 / 7.0);
    CHECK((*reader)->values()[1] == 1);
  }
}

TEST_CASE("any numbers read back bit for bit from every form", "[hal][trace][property]") {
  const test::Folder folder;
  softcnc::test::holds([&] {
    WrittenTrace trace = some_rows(*rc::gen::inRange(1, 50));
    for (Setpoint& row : trace.rows) {
      for (double& place : row.position) place = std::fmod(*rc::gen::arbitrary<double>(), 1000);
      row.v = *rc::gen::arbitrary<double>();
    }
    const std::string file = folder / ("t" + *rc::gen::elementOf(kSuffixes));
    RC_ASSERT(write_trace(file, trace).has_value());
    const auto reader = TraceReader::open(file);
    RC_ASSERT(reader.has_value());
    RC_ASSERT((*reader)->select(std::array<std::size_t, 4>{7, 8, 9, 4}).has_value());
    for (const Setpoint& row : trace.rows) {
      RC_ASSERT(reads_row(**reader));
      for (std::size_t axis = 0; axis < 3; ++axis)
        RC_ASSERT((*reader)->values()[axis] == row.position[static_cast<int>(axis)]);
      RC_ASSERT((*reader)->values()[3] == row.v);
    }
  });
}

TEST_CASE("comments are read wherever they stand", "[hal][trace]") {
  const test::Folder folder;
  const std::string file = folder / "t.csv";
  const std::string comments = "# schema: softcnc-trace 1\n# period_ms: 0.7\n# program: -\n";
  test::write(file, comments + kTraceHead + kRow + "# program: cc33\n# anything\n");
  const auto reader = TraceReader::open(file);
  REQUIRE(reader);
  CHECK((*reader)->comment().schema == 1);
  CHECK((*reader)->comment().period == 0.7 / 1000);
  CHECK((*reader)->comment().program_hash == "-");
  REQUIRE(select_all(**reader));
  CHECK(reads_row(**reader));
  CHECK(is_at_end(**reader));
  CHECK((*reader)->comment().program_hash == "cc33");
}

TEST_CASE("lines may end as those of Windows do", "[hal][trace]") {
  const test::Folder folder;
  test::write(folder / "t.csv", "t_s,limit,x_mm\r\n# period_ms: 2\r\n0.5,jerk,7\r\n");
  const auto reader = TraceReader::open(folder / "t.csv");
  REQUIRE(reader);
  CHECK((*reader)->columns() == std::vector<std::string>{"t_s", "limit", "x_mm"});
  REQUIRE(select_all(**reader));
  REQUIRE(reads_row(**reader));
  CHECK((*reader)->values()[2] == 7);
  CHECK((*reader)->limit() == Limit::jerk);
  CHECK((*reader)->comment().period == 0.002);
}

TEST_CASE("a wrong value of a CSV is reported with its place", "[hal][trace][code]") {
  const test::Folder folder;
  const std::string file = folder / "t.csv";
  test::write(file, kTraceHead + "# a comment\n" + kRow + "0.001,1,1,0,zero,1000,stop,0,100\n");
  const Diagnostic number = problem(file);
  CHECK(render(number) == file +
                              ":4:13: error: 'zero' is no number, in the column v_mm_s [SC6082]\n"
                              "    4 | 0.001,1,1,0,zero,1000,stop,0,100\n"
                              "      |             ^~~~\n");
  CHECK(exit_status(number) == 5);
  test::write(file, kTraceHead + "0,1,1,0,0,1000,sometimes,0,100\n");
  CHECK(problem(file).message == "'sometimes' is no limit, in the column limit");
  test::write(file, kTraceHead + "0,1,1,0,0,1000,7,0,100\n");
  CHECK(problem(file).message == "'7' is no limit, in the column limit");
  test::write(file, kTraceHead + "0,1,1,0,feed,1000,feed,0,100\n");
  CHECK(problem(file).message == "'feed' is no number, in the column v_mm_s");
  test::write(file, kTraceHead + "0,1,1,0,,1000,feed,0,100\n");
  CHECK(problem(file).message == "'' is no number, in the column v_mm_s");
}

TEST_CASE("times and positions that no machine has are refused", "[hal][trace][code]") {
  const test::Folder folder;
  const std::string file = folder / "t.csv";
  const auto said_of = [&](const std::string& rows) {
    test::write(file, kTraceHead + rows);
    return problem(file).message;
  };
  const auto row = [](const std::string& t, const std::string& x) {
    return t + ",1,1,0,0,1000,stop," + x + ",100\n";
  };
  CHECK(said_of(row("0", "0") + row("nan", "0")) == "a time that is no number");
  CHECK(said_of(row("inf", "0")) == "a time that is no number");
  CHECK(said_of(row("1", "0") + row("0.5", "0")) == "the time runs back");
  CHECK(said_of(row("0", "1e8")) == "a position beyond 1000 m");
  CHECK(said_of(row("0", "-inf")) == "a position beyond 1000 m");
  CHECK(said_of(row("0", "0") + row("0", "10001")) ==
        "a position more than 10 m from that of the row before");
}

TEST_CASE("a damaged CSV is reported with its line", "[hal][trace][code]") {
  const test::Folder folder;
  const std::string file = folder / "t.csv";
  const auto shown = [&](const std::string& text) {
    test::write(file, text);
    return render(problem(file));
  };
  CHECK(shown("") == file + ": error: has no names of columns [SC6082]\n");
  CHECK(shown(kTraceHead + kRow + "1,2,3\n") ==
        file + ":3:1: error: has 3 values, and there are 9 columns [SC6082]\n");
  CHECK(shown(kTraceHead + "0,1,1,0,0,1000,stop,0,100,7\n") ==
        file + ":2:1: error: has 10 values, and there are 9 columns [SC6082]\n");
  CHECK(shown(kTraceHead + kRow + "0.001,1,1") ==
        file + ":3:1: error: not whole: it ends within a line [SC6082]\n");
  CHECK(shown(kTraceHead + kRow + std::string(70'000, '1') + "\n") ==
        file + ":3:1: error: longer than 65536 bytes [SC6083]\n");
}

TEST_CASE("a compressed trace that is cut off or damaged is reported", "[hal][trace][code]") {
  const test::Folder folder;
  for (const std::string suffix : {".csv.zst", ".npz.zst", ".npz"}) {
    CAPTURE(suffix);
    const std::string file = folder / ("t" + suffix);
    REQUIRE(write_trace(file, some_rows(9000)));
    const std::string bytes = test::read(file);
    test::write(file, bytes.substr(0, bytes.size() / 2));
    CHECK(problem(file).code == Code::SC6082);
    std::string changed = bytes;
    for (std::size_t i = 0; i < 8; ++i) changed[bytes.size() / 2 + i] ^= 0x55;
    test::write(file, changed);
    CHECK(problem(file).code == Code::SC6082);
    CHECK(problem(file).file == file);
  }
}

TEST_CASE("a value of an array that is not what was written is noticed by its checksum",
          "[hal][trace][code]") {
  const test::Folder folder;
  const std::string file = folder / "t.npz";
  REQUIRE(write_trace(file, some_rows(9000)));
  std::string bytes = test::read(file);
  const double written = 100 * 0.1;  // of x_err_um in row 100, a value like any other
  const std::string_view value(reinterpret_cast<const char*>(&written), sizeof written);
  const std::size_t at = bytes.find(value);
  REQUIRE(at != std::string::npos);
  bytes[at] ^= 1;
  test::write(file, bytes);
  CHECK(problem(file).code == Code::SC6082);
}

TEST_CASE("arrays that make no rows are refused", "[hal][trace][code]") {
  const test::Folder folder;
  const std::string file = folder / "t.npz";
  const auto refused = [&](const std::vector<std::pair<std::string, std::string>>& columns) {
    ZipWriter zip(file);
    for (const auto& [name, bytes] : columns) zip.add_text(name + ".npy", bytes);
    REQUIRE(zip.finish());
    return problem(file).message;
  };
  const std::vector<double> three{1, 2, 3}, six{1, 2, 3, 4, 5, 6};
  const std::string column = npy(three, std::array<std::int64_t, 1>{3});
  CHECK(refused({{"t_s", column}, {"x_mm", npy(six, std::array<std::int64_t, 1>{6})}}) ==
        "its column x_mm has 6 rows, and t_s has 3");
  CHECK(refused({{"t_s", npy(six, std::array<std::int64_t, 2>{3, 2})}}) ==
        "its column t_s is no array that can be read");
  CHECK(refused({{"t_s", "no array"}}) == "its column t_s is no array that can be read");
  CHECK(refused({{"t_s", column.substr(0, column.size() - 1)}}) ==
        "not whole: its column t_s ends too early");
  CHECK(refused({{"limit", column}}) == "its column limit holds numbers");
  const std::string text = npy_head("<U2", std::array<std::int64_t, 1>{1}) + std::string(8, '\0');
  CHECK(refused({{"t_s", text}}) == "its column t_s holds text");
  CHECK(refused({{"limit", text}}) == "row 1 of its column limit: '' is no limit");
}

TEST_CASE("arrays of other numbers are read as numpy writes them", "[hal][trace]") {
  const test::Folder folder;
  const std::string file = folder / "t.npz";
  const std::array<std::int64_t, 1> two{2};
  const std::array<float, 2> reals{0.5F, -1.5F};
  const std::array<std::int32_t, 2> wholes{7, -3};
  std::string whole = npy_head("<i4", two);
  whole.append(reinterpret_cast<const char*>(wholes.data()), sizeof wholes);
  ZipWriter zip(file);
  zip.add_text("a.npy", npy(reals, two));
  zip.add_text("b.npy", whole);
  REQUIRE(zip.finish());
  const auto reader = TraceReader::open(file);
  REQUIRE(reader);
  REQUIRE(select_all(**reader));
  REQUIRE(reads_row(**reader));
  REQUIRE(reads_row(**reader));
  CHECK((*reader)->values()[0] == -1.5);
  CHECK((*reader)->values()[1] == -3);
  CHECK(is_at_end(**reader));
}

TEST_CASE("a trace that is not there, or of another form, is refused", "[hal][trace][code]") {
  const test::Folder folder;
  for (const std::string& suffix : kSuffixes) {
    const Diagnostic missing = problem(folder / ("no" + suffix));
    CHECK(render(missing) == (folder / ("no" + suffix)) +
                                 ": error: cannot be read: No such file or directory [SC6081]\n");
  }
  CHECK(problem("t.vcd").code == Code::SC6014);
  CHECK(problem("t.zst").code == Code::SC6014);
  CHECK(exit_status(problem("t.vcd")) == 2);
}

TEST_CASE("the trace of a recording is read from its zip", "[hal][trace]") {
  const test::Folder folder;
  REQUIRE(write_trace(folder / "t.csv.zst", some_rows(9000)));
  {
    ZipWriter zip(folder / "t.rec");
    zip.add_file("trace.csv.zst", folder / "t.csv.zst", Compression::store);
    REQUIRE(zip.finish());
  }
  const auto zip = ZipReader::open(folder / "t.rec");
  REQUIRE(zip);
  auto entry = zip->entry("trace.csv.zst");
  REQUIRE(entry);
  const auto reader = TraceReader::open(std::move(*entry), "t.rec");
  REQUIRE(reader);
  REQUIRE(select_all(**reader));
  int rows = 0;
  while (reads_row(**reader)) ++rows;
  CHECK(rows == 9000);
  CHECK((*reader)->values()[7] == 8999 / 7.0);
}

}  // namespace softcnc::hal
