// SPDX-License-Identifier: MIT
// The backend of LinuxCNC's HAL: its rows, read back; and what becomes of pipes and full disks.
#include "hal/backends/hal_stream.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::setpoint_at;

Machine streamed(const std::string& file) {
  Machine machine;
  machine.control.backend = BackendKind::hal_stream;
  machine.hal_stream.file = file;
  return machine;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// A FIFO with a reader, which reads only when asked to.
class Fifo {
 public:
  explicit Fifo(const std::string& name) : name_(name) {
    REQUIRE(::mkfifo(name.c_str(), 0600) == 0);
    reader_ = ::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    REQUIRE(reader_ >= 0);
    std::signal(SIGPIPE, SIG_IGN);
  }
  ~Fifo() { close(); }
  void close() {
    if (reader_ >= 0) ::close(reader_);
    reader_ = -1;
  }
  /// What there is now.
  std::string read() const {
    std::string text(1U << 20U, '\0');
    const auto size = ::read(reader_, text.data(), text.size());
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return text;
  }

 private:
  std::string name_;
  int reader_;
};

/// Rows until the backend says that it cannot go on, at most `most`.
int rows_until_alarm(Backend& backend, int most) {
  for (int i = 0; i < most; ++i)
    if (backend.exchange(setpoint_at(i * 0.001, 1.0 / (i + 1), 0)).alarm == Alarm::port) return i;
  return most;
}

}  // namespace

TEST_CASE("rows say where the axes are, whether the program runs, and their number", "[hal]") {
  const test::Folder folder;
  auto backend = HalRows::open(streamed(folder / "rows"));
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at(0, 0, 0));
  (*backend)->exchange(setpoint_at(0.1, -1.0 / 3, 1e-7));
  const Feedback feedback = (*backend)->exchange(setpoint_at(12.5, 0, 0));
  CHECK(feedback.alarm == Alarm::none);
  CHECK((feedback.position - AxisVector(12.5, 0, 0)).norm() == 0);
  CHECK_FALSE(std::filesystem::exists(folder / "rows"));
  REQUIRE((*backend)->finish());
  const std::string rows =
      "0 0 0 1 1\n"
      "0.1 -0.3333333333333333 1e-07 1 2\n"
      "12.5 0 0 1 3\n"
      "12.5 0 0 0 4\n";
  const auto tally = (*backend)->tally().value();
  CHECK(tally.rows == 4);
  CHECK(tally.checksum == hash_hex(rows));
  CHECK(test::read(folder / "rows") ==
        "# softcnc rows 1 for halstreamer, one every 1 ms\n"
        "# cfg=fffbu: x_mm y_mm z_mm runs row\n" +
            rows + "# 4 rows, xxh3 " + hash_hex(rows) + "\n");
}

TEST_CASE("rows have spindle, coolant and outputs where the machine file wants them", "[hal]") {
  const test::Folder folder;
  Machine machine = streamed(folder / "rows");
  machine.control.period = 0.002;
  machine.hal_stream.outputs = true;
  machine.outputs["clamp"] = {63, SignalKind::digital, 0};
  machine.outputs["door"] = {2, SignalKind::digital, 0};
  machine.outputs["far"] = {64, SignalKind::digital, 0};
  machine.outputs["level"] = {3, SignalKind::analog, 0};
  auto backend = HalRows::open(machine);
  REQUIRE(backend);
  Setpoint setpoint = setpoint_at(0, 0, 0);
  (*backend)->exchange(setpoint);
  setpoint.outputs = {-1234.5, false, true, std::uint64_t{1} << 63 | 1U << 1};
  (*backend)->exchange(setpoint);
  setpoint.outputs = {6000, true, false, 1U << 2};
  (*backend)->exchange(setpoint);
  REQUIRE((*backend)->finish());
  const auto lines = lines_of(test::read(folder / "rows"));
  REQUIRE(lines.size() == 9);
  CHECK(lines[1] == "# cfg=fffbufbbbb: x_mm y_mm z_mm runs row spindle_rpm mist flood door clamp");
  CHECK(lines[2] == "0 0 0 1 1 0 0 0 0 0");
  CHECK(lines[3] == "0 0 0 1 2 0 0 0 0 0");
  CHECK(lines[4] == "0 0 0 1 3 -1234.5 0 1 0 1");
  CHECK(lines[5] == "0 0 0 1 4 -1234.5 0 1 0 1");
  CHECK(lines[6] == "0 0 0 1 5 6000 1 0 1 0");
  CHECK(lines[7] == "0 0 0 0 6 0 0 0 0 0");  // whatever the program has left on
}

TEST_CASE("a row comes every servo period, and only for axes there are", "[hal]") {
  const test::Folder folder;
  Machine machine = streamed(folder / "rows");
  machine.control.period = 0.004;
  machine.control.servo_period = 0.001;
  machine.axes[1].present = false;
  auto backend = HalRows::open(machine);
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at(1, 0, 2));
  (*backend)->exchange(setpoint_at(2, 0, 0));
  REQUIRE((*backend)->finish());
  const auto lines = lines_of(test::read(folder / "rows"));
  REQUIRE(lines.size() == 9);
  CHECK(lines[1] == "# cfg=ffbu: x_mm z_mm runs row");
  CHECK(lines[2] == "1 2 1 1");
  CHECK(lines[3] == "1.25 1.5 1 2");
  CHECK(lines[4] == "1.5 1 1 3");
  CHECK(lines[6] == "2 0 1 5");
  CHECK(lines[7] == "2 0 0 6");
}

TEST_CASE("rows are the fine points of a setpoint", "[hal]") {
  const test::Folder folder;
  Machine machine = streamed(folder / "rows");
  machine.control.period = 0.002;
  auto backend = HalRows::open(machine);
  REQUIRE(backend);
  const bool twice = GENERATE(false, true);  // as the simulated mill asks for
  std::vector<FinePoint> points{{0, {0.1, 0, 0}}, {0, {1, 0, 0}}};
  if (twice) points = {{0, {7, 7, 7}}, points[0], {0, {8, 8, 8}}, points[1]};
  Setpoint second = setpoint_at(1, 0, 0);
  second.fine = points;
  (*backend)->exchange(setpoint_at(0, 0, 0));
  (*backend)->exchange(second);
  REQUIRE((*backend)->finish());
  const auto lines = lines_of(test::read(folder / "rows"));
  REQUIRE(lines.size() == 7);
  CHECK(lines[2] == "0 0 0 1 1");
  CHECK(lines[3] == "0.1 0 0 1 2");
  CHECK(lines[4] == "1 0 0 1 3");
}

TEST_CASE("before the program waits, HAL has all rows and is informed of it", "[hal]") {
  const test::Folder folder;
  Fifo fifo(folder / "rows");
  auto backend = HalRows::open(streamed(folder / "rows"));
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at(0, 0, 0));
  (*backend)->exchange(setpoint_at(1, 0, 0));
  CHECK(lines_of(fifo.read()).size() == 2);  // comments: rows are held back for a lead
  (*backend)->rest(setpoint_at(1, 0, 0));
  const auto lines = lines_of(fifo.read());
  REQUIRE(lines.size() == 4);
  CHECK(lines[2] == "1 0 0 1 3");
  CHECK(lines[3] == "1 0 0 0 4");
}

TEST_CASE("nothing is lost in a pipe whose reader is slow", "[hal]") {
  const test::Folder folder;
  Fifo fifo(folder / "rows");
  auto backend = HalRows::open(streamed(folder / "rows"));
  REQUIRE(backend);
  std::string got;
  bool done = false;
  Status finished;
  std::thread writer([&] {
    rows_until_alarm(**backend, 20000);
    finished = (*backend)->finish();
  });
  while (!done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    got += fifo.read();
    done = got.find("rows, xxh3") != std::string::npos;
  }
  writer.join();
  CHECK(finished);
  std::string rows;
  for (const std::string& line : lines_of(got))
    if (line[0] != '#') rows += line + '\n';
  CHECK((*backend)->tally()->rows == 20001);
  CHECK((*backend)->tally()->checksum == hash_hex(rows));
}

TEST_CASE("a pipe that nobody reads is refused", "[hal][code]") {
  const test::Folder folder;
  REQUIRE(::mkfifo((folder / "rows").c_str(), 0600) == 0);
  const auto backend = HalRows::open(streamed(folder / "rows"));
  REQUIRE_FALSE(backend);
  CHECK(render(backend.error()) == (folder / "rows") +
                                       ": error: no program reads this pipe; start its "
                                       "reader first [SC6070]\n");
  CHECK(exit_status(backend.error()) == 5);
}

TEST_CASE("a pipe that stays full, or is closed, is an alarm of the port", "[hal][code]") {
  const test::Folder folder;
  Fifo fifo(folder / "rows");
  Machine machine = streamed(folder / "rows");
  machine.hal_stream.patience = 0.05;
  auto backend = HalRows::open(machine);
  REQUIRE(backend);
  std::string text, code;
  SECTION("full") {
    CHECK(rows_until_alarm(**backend, 100'000) < 10'000);
    text = "the pipe is full, and its reader has taken nothing for 0.05 s";
    code = "SC6071";
  }
  SECTION("closed") {
    CHECK(rows_until_alarm(**backend, 1000) == 1000);
    fifo.close();
    CHECK(rows_until_alarm(**backend, 100'000) < 2000);
    text = "the reader closed the pipe";
    code = "SC6013";
  }
  const Status finished = (*backend)->finish();
  REQUIRE_FALSE(finished);
  CHECK(render(finished.error()) == (folder / "rows") + ": error: " + text +
                                        "; HAL holds the last row it got [" + code + "]\n");
}

TEST_CASE("a full disk and a folder that is not there are reported", "[hal][code]") {
  auto full = HalRows::open(streamed("/dev/full"));
  REQUIRE(full);
  CHECK((*full)->exchange(setpoint_at(0, 0, 0)).alarm == Alarm::port);
  const Status finished = (*full)->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().code == Code::SC6012);
  const auto nowhere = HalRows::open(streamed("/no/such/folder/rows"));
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.error().code == Code::SC6011);
}

TEST_CASE("a machine without its port counts rows and writes none", "[hal]") {
  const test::Folder folder;
  auto backend = open_backend(without_port(streamed(folder / "rows")));
  REQUIRE(backend);
  CHECK(rows_until_alarm(**backend, 10) == 10);
  REQUIRE((*backend)->finish());
  CHECK((*backend)->tally()->rows == 11);
  CHECK_FALSE(std::filesystem::exists(folder / "rows"));
}

}  // namespace softcnc::hal
