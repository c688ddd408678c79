// SPDX-License-Identifier: MIT
// The trace: its columns, its numbers, its formats, and no half files.
#include "hal/trace/trace.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <csignal>
#include <filesystem>

#include "hal/files/number.hpp"
#include "hal/trace/trace_csv.hpp"
#include "support/property.hpp"
#include "support/zstd.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

namespace fs = std::filesystem;

const TraceHeader kHeader{0.001, "aa11", "bb22"};

Machine two_axes() {
  Machine machine;
  machine.axes[1].present = false;
  return machine;
}

Setpoint setpoint(std::int64_t period) {
  const auto t = static_cast<double>(period);
  Setpoint setpoint;
  setpoint.period = period;
  setpoint.line = 4;
  setpoint.block = 2;
  setpoint.s = 0.1 * t;
  setpoint.v = 20.0;
  setpoint.a = -0.0;
  setpoint.feed = 25.0;
  setpoint.limit = Limit::chord;
  setpoint.position = {t / 3.0, 7.0, -1e-7};
  return setpoint;
}

Status write_rows(const std::string& file, int rows, const Machine& machine = Machine{}) {
  const std::vector<std::string> columns{"x_act_mm", "x_err_um"};
  auto trace = TraceWriter::open(file, kHeader, machine, columns);
  if (!trace) return tl::make_unexpected(trace.error());
  for (int i = 0; i < rows; ++i) (*trace)->row(setpoint(i), std::array{i * 0.1, -0.0});
  return (*trace)->finish();
}

std::string last_line(std::string text) {
  text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

TEST_CASE("a trace is names, comments and rows", "[hal][trace]") {
  const test::Folder folder;
  REQUIRE(write_rows(folder / "t.csv", 4));
  CHECK(test::read(folder / "t.csv") ==
        "t_s,line,block,s_mm,v_mm_s,a_mm_s2,limit,x_mm,y_mm,z_mm,feed_mm_s,x_act_mm,x_err_um\n"
        "# schema: softcnc-trace 2\n"
        "# period_ms: 1\n"
        "# program: aa11\n"
        "# machine: bb22\n"
        "0,4,2,0,20,0,chord,0,7,-1e-07,25,0,0\n"
        "0.001,4,2,0.1,20,0,chord,0.3333333333333333,7,-1e-07,25,0.1,0\n"
        "0.002,4,2,0.2,20,0,chord,0.6666666666666666,7,-1e-07,25,0.2,0\n"
        "0.003,4,2,0.30000000000000004,20,0,chord,1,7,-1e-07,25,0.30000000000000004,0\n");
  CHECK(test::names_in(folder.path()) == test::Names{"t.csv"});
}

TEST_CASE("an axis the machine lacks has no column", "[hal][trace]") {
  const test::Folder folder;
  REQUIRE(write_rows(folder / "t.csv", 1, two_axes()));
  const std::string text = test::read(folder / "t.csv");
  CHECK(text.find(",limit,x_mm,z_mm,feed_mm_s,x_act_mm,") != std::string::npos);
  CHECK(last_line(text) == "0,4,2,0,20,0,chord,0,-1e-07,25,0,0");
}

TEST_CASE("a trace without rows still has its header", "[hal][trace]") {
  const test::Folder folder;
  REQUIRE(write_rows(folder / "t.csv", 0));
  CHECK(test::read(folder / "t.csv").starts_with("t_s,line,block,"));
  CHECK(last_line(test::read(folder / "t.csv")).starts_with("# machine: "));
}

TEST_CASE("instants are the nearest doubles to their decimals", "[hal][trace]") {
  const auto exact = [](std::int64_t n, std::int64_t period_ns) {
    const std::string digits = std::to_string(n * period_ns) + "e-9";
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  };
  for (const std::int64_t period_ns : {1'000'000, 8'000'000, 250'000, 100'000, 125, 1'700'000}) {
    const TraceTime time(static_cast<double>(period_ns) / 1e9);
    for (std::int64_t n = 0; n < 3'000'000; n += 1 + n / 50) {
      INFO(n << " periods of " << period_ns << " ns");
      REQUIRE(time(n) == exact(n, period_ns));
    }
  }
  CHECK(number_text(TraceTime(0.001)(3)) == "0.003");
  CHECK(number_text(TraceTime(0.0001)(1234)) == "0.1234");
  CHECK(TraceTime(1.0 / 3.0)(6) == 2.0);
}

TEST_CASE("the period stands in the comments as a person would write it", "[hal][trace]") {
  const test::Folder folder;
  for (const char* period_ms : {"1", "8", "0.7", "0.25", "0.1", "1.1"}) {
    const TraceHeader header{std::stod(period_ms) / 1000.0, "", ""};
    auto trace = TraceWriter::open(folder / "t.csv", header, Machine{}, {});
    REQUIRE(trace);
    REQUIRE((*trace)->finish());
    CHECK(test::read(folder / "t.csv").find("\n# period_ms: " + std::string(period_ms) + "\n") !=
          std::string::npos);
  }
}

TEST_CASE("numbers read back bit for bit", "[hal][trace][property]") {
  softcnc::test::holds([](std::uint64_t bits) {
    const auto value = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(value));
    const std::string text = number_text(value);
    RC_ASSERT(text.size() <= static_cast<std::size_t>(kNumberLength));
    double back = 1;
    std::from_chars(text.data(), text.data() + text.size(), back);
    RC_ASSERT(std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(value + 0.0));
  });
  CHECK(number_text(-0.0) == "0");
  CHECK(number_text(-2.2250738585072014e-308).size() <= static_cast<std::size_t>(kNumberLength));
}

TEST_CASE("every number of a row reads back bit for bit", "[hal][trace][property]") {
  const test::Folder folder;
  const std::string file = folder / "t.csv";
  softcnc::test::holds([&] {
    const auto number = [] { return *rc::gen::arbitrary<double>(); };
    Setpoint given;
    for (double* place : {&given.s, &given.v, &given.a}) *place = number();
    for (double& place : given.position) place = number();
    auto trace = TraceWriter::open(file, kHeader, Machine{}, {});
    RC_ASSERT(trace.has_value());
    (*trace)->row(given, {});
    RC_ASSERT((*trace)->finish().has_value());
    std::string row = last_line(test::read(file)) + ',';
    std::vector<std::string> fields;
    for (std::size_t comma; (comma = row.find(',')) != row.npos; row.erase(0, comma + 1))
      fields.push_back(row.substr(0, comma));
    RC_ASSERT(fields.size() == 11U);
    const std::array<double, 6> want{given.s,           given.v,           given.a,
                                     given.position[0], given.position[1], given.position[2]};
    const std::array<std::size_t, 6> column{3, 4, 5, 7, 8, 9};
    for (std::size_t i = 0; i < want.size(); ++i) {
      const double back = std::stod(fields[column[i]]);
      RC_ASSERT(std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(want[i] + 0.0));
    }
  });
}

TEST_CASE("a compressed trace holds the same text, in the same bytes each time", "[hal][trace]") {
  constexpr int kRows = 50'000;
  const test::Folder folder;
  REQUIRE(write_rows(folder / "t.csv", kRows));
  REQUIRE(write_rows(folder / "a.csv.zst", kRows));
  REQUIRE(write_rows(folder / "b.csv.zst", kRows));
  const std::string packed = test::read(folder / "a.csv.zst");
  CHECK(packed == test::read(folder / "b.csv.zst"));
  const std::string text = test::read(folder / "t.csv");
  CHECK(softcnc::test::unpacked(packed) == text);
  CHECK(packed.size() < text.size() / 2);
  CHECK(std::count(text.begin(), text.end(), '\n') == kRows + 5);
}

TEST_CASE("an unknown suffix is refused and names those known", "[hal][trace]") {
  for (const char* file : {"trace.xls", "trace", "trace.zst"}) {
    const auto written = write_rows(file, 1);
    REQUIRE_FALSE(written);
    CHECK(render(written.error()) ==
          std::string(file) +
              ": error: no trace format has this suffix; known are .csv, .npz, .vcd, .hal, "
              "each with or without a further .zst [SC6014]\n");
    CHECK_FALSE(fs::exists(file));
  }
}

TEST_CASE("what is no regular file takes CSV", "[hal][trace]") {
  CHECK(write_rows("/dev/null", 10));
}

TEST_CASE("a full disk ends a trace with its reason", "[hal][trace]") {
  const std::vector<std::string> none;
  auto trace = TraceWriter::open("/dev/full", kHeader, Machine{}, none);
  REQUIRE(trace);
  CHECK_FALSE((*trace)->ok());
  for (int i = 0; i < 10'000; ++i) (*trace)->row(setpoint(i), {});
  const auto finished = (*trace)->finish();
  REQUIRE_FALSE(finished);
  CHECK(render(finished.error()) ==
        "/dev/full: error: writing failed: No space left on device [SC6012]\n");
}

TEST_CASE("a reader that closes the pipe ends a trace", "[hal][trace]") {
  std::signal(SIGPIPE, SIG_IGN);
  const test::Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  auto trace = TraceWriter::open(pipe, kHeader, Machine{}, {});
  REQUIRE(trace);
  CHECK((*trace)->ok());
  ::close(reader);
  for (int i = 0; (*trace)->ok() && i < 100'000; ++i) (*trace)->row(setpoint(i), {});
  CHECK_FALSE((*trace)->ok());
  const auto finished = (*trace)->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().code == Code::SC6013);
}

TEST_CASE("a trace that is given up leaves no file", "[hal][trace]") {
  const test::Folder folder;
  for (const char* name : {"t.csv", "t.csv.zst", "t.npz", "t.vcd", "t.hal", "t.npz.zst"}) {
    auto trace = TraceWriter::open(folder / name, kHeader, Machine{}, {});
    REQUIRE(trace);
    for (int i = 0; i < 5'000; ++i) (*trace)->row(setpoint(i), {});
  }
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("positions as a waveform stand where they change", "[hal][trace]") {
  const test::Folder folder;
  auto trace = TraceWriter::open(folder / "t.vcd", kHeader, two_axes(), {});
  REQUIRE(trace);
  for (const int i : {0, 3, 3, 3}) {
    Setpoint row = setpoint(i);
    row.period = i == 0 ? 0 : row.period;
    (*trace)->row(row, {});
  }
  Setpoint last = setpoint(3);
  last.period = 5;
  (*trace)->row(last, {});
  (*trace)->add_program_hash("cc33");
  REQUIRE((*trace)->finish());
  CHECK(test::read(folder / "t.vcd") ==
        "$comment schema: softcnc-trace 2 $end\n$comment program: aa11 $end\n"
        "$comment machine: bb22 $end\n$timescale 1 ns $end\n$scope module softcnc $end\n"
        "$var real 64 ! x_mm $end\n$var real 64 # z_mm $end\n$upscope $end\n"
        "$enddefinitions $end\n#0\n$dumpvars\nr0 !\nr-1e-07 #\n$end\n#3000000\nr1 !\n"
        "$comment program: cc33 $end\n#5000000\n");
}

}  // namespace softcnc::hal
