// SPDX-License-Identifier: MIT
// The thread that writes to a parallel port: all words, in order; and at rest on every way out.
#include "job/open_player.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <optional>

#include "apps/shell.hpp"
#include "runtime/realtime/realtime_cycle.hpp"
#include "runtime/session/simulate.hpp"
#include "support/recorded_port.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app;
using softcnc::test::PortRecord;
using softcnc::test::RecordedPort;

namespace {

/// Late by up to a second is no alarm: tests run beside one another.
Machine on_port() {
  Machine machine;
  machine.control.backend = BackendKind::parport;
  machine.control.period = 1;
  machine.parallel_port.base_period = 50e-6;
  machine.parallel_port.charge_pump_pin = 0;
  machine.parallel_port.estop_pin = 0;
  machine.parallel_port.fault_pin = 12;
  return machine;
}

constexpr double kAhead = 0.5;          // s: these threads are ordinary ones
constexpr double kBehindThread = 0.02;  // s: as a run has it

std::unique_ptr<runtime::RealtimePlayer> open(const Machine& machine, PortRecord& record) {
  auto player = open_player(machine, std::make_unique<RecordedPort>(record), kAhead);
  REQUIRE(player);
  return std::move(*player);
}

/// Words that can be distinguished from each other.
std::vector<hal::PortWord> words(int count, int begin = 0) {
  std::vector<hal::PortWord> all;
  for (int i = 0; i < count; ++i)
    all.push_back({static_cast<std::uint8_t>(0x40 | ((begin + i) % 16)), 0});
  return all;
}

std::vector<std::uint8_t> data_of(const PortRecord& record) {
  std::vector<std::uint8_t> data;
  for (const auto& write : record.writes)
    if (!write.control) data.push_back(write.bits);
  return data;
}

/// The drives enabled, these words, the port at rest, and once more when the player goes.
std::vector<std::uint8_t> expected(int count) {
  std::vector<std::uint8_t> data{0x40};
  for (const hal::PortWord& word : words(count))
    if (word.data != data.back()) data.push_back(word.data);
  data.insert(data.end(), 2, 0x00);
  return data;
}

bool is_at_rest(const PortRecord& record) { return record.last(false) == 0x00; }

}  // namespace

TEST_CASE("all words are written, in order, and no sooner than they may", "[apps][parport]") {
  PortRecord record;
  {
    auto player = open(on_port(), record);
    const std::int64_t begin = runtime::now_ns();
    for (int i = 0; i < 200; ++i) CHECK(player->play(words(100, 100 * i)) == Alarm::none);
    REQUIRE(player->finish());
    CHECK(runtime::now_ns() - begin >= 20'000 * 50'000LL);
  }
  CHECK(data_of(record) == expected(20'000));
}

TEST_CASE("where the program waits the port stands, and goes on", "[apps][parport]") {
  PortRecord record;
  {
    auto player = open(on_port(), record);
    CHECK(player->play(words(48)) == Alarm::none);
    player->rest();
    runtime::sleep_until(runtime::now_ns() + 50'000'000);
    CHECK(player->play(words(48)) == Alarm::none);
    runtime::sleep_until(runtime::now_ns() + 50'000'000);
    CHECK(player->play(words(48)) == Alarm::none);  // too few yet to begin with
    REQUIRE(player->finish());
  }
  CHECK(data_of(record) == expected(144));
}

TEST_CASE("where the program waits, charge pump and spindle signal go on", "[apps][parport]") {
  Machine machine = on_port();
  machine.parallel_port.charge_pump_pin = 9;
  machine.parallel_port.spindle_pwm_pin = 8;
  machine.parallel_port.spindle_pwm_levels = 10;
  machine.parallel_port.enable_pin = 0;
  PortRecord record;
  {
    auto player = open(machine, record);
    hal::PortWord word;
    word.speed = 3;
    CHECK(player->play(std::vector(48, word)) == Alarm::none);
    player->rest();
    runtime::sleep_until(runtime::now_ns() + 200'000'000);
    REQUIRE(player->finish());
  }
  const auto data = data_of(record);
  CHECK(data.size() > 200);  // of 4,000 in time: tests run beside one another
  for (std::size_t tick = 0; tick + 2 < data.size(); ++tick) {
    if (data[tick] != ((tick % 2 == 0 ? 0x80 : 0) | (tick > 0 && tick % 10 < 3 ? 0x40 : 0)))
      FAIL("tick " << tick << ": " << int{data[tick]});
  }
}

TEST_CASE("words that come too late are an alarm, and the port is at rest", "[apps][parport]") {
  PortRecord record;
  auto player = open(on_port(), record);
  CHECK(player->play(words(6'000)) == Alarm::none);  // enough to begin with
  for (int i = 0; i < 1000 && player->play({}) == Alarm::none; ++i)
    runtime::sleep_until(runtime::now_ns() + 10'000'000);
  CHECK(player->play(words(10)) == Alarm::overrun);
  const Status finished = player->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().code == Code::SC5030);
  CHECK(is_at_rest(record));
}

TEST_CASE("an input that comes on ends it at rest, at once", "[apps][parport]") {
  PortRecord record;
  auto player = open(on_port(), record);
  CHECK(player->play(words(6'000)) == Alarm::none);
  runtime::sleep_until(runtime::now_ns() + 20'000'000);
  record.status = 0x20;
  const Status finished = player->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().code == Code::SC5033);
  CHECK(is_at_rest(record));
  CHECK(record.writes.size() < 6'000);
}

TEST_CASE("a change of an input comes with the word at which it was read", "[apps][parport]") {
  Machine machine = on_port();
  machine.parallel_port.probe_pin = 13;
  PortRecord record;
  auto player = open(machine, record);
  hal::PortChange change;
  CHECK_FALSE(player->next_change(change));
  CHECK(player->play(words(48)) == Alarm::none);
  player->rest();
  runtime::sleep_until(runtime::now_ns() + 100'000'000);
  record.status = 0x10;
  for (int i = 0; i < 1000 && !player->next_change(change); ++i)
    runtime::sleep_until(runtime::now_ns() + 1'000'000);
  CHECK(change.inputs.probe);
  CHECK(change.words == 48);
  REQUIRE(player->finish());
}

TEST_CASE("after an alarm it begins again once the input is off", "[apps][parport]") {
  PortRecord record;
  auto player = open(on_port(), record);
  CHECK(player->play(words(6'000)) == Alarm::none);
  record.status = 0x20;
  for (int i = 0; i < 1000 && player->alarm() == Alarm::none; ++i)
    runtime::sleep_until(runtime::now_ns() + 1'000'000);
  CHECK(player->trouble().code == Code::SC5033);
  const Status still = player->recover();
  REQUIRE_FALSE(still);
  CHECK(still.error().code == Code::SC5033);
  record.status = 0;
  REQUIRE(player->recover());
  CHECK(player->alarm() == Alarm::none);
  const std::size_t before = data_of(record).size();
  CHECK(player->play(words(48)) == Alarm::none);
  REQUIRE(player->finish());
  const auto data = data_of(record);
  CHECK(data.size() - before >= 47);  // of 48, without what had waited
  CHECK(data.size() - before <= 50);
}

TEST_CASE("nothing is enabled while an input is on", "[apps][parport]") {
  PortRecord record;
  record.status = 0x20;
  const auto refused = open_player(on_port(), std::make_unique<RecordedPort>(record), kAhead);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == Code::SC5033);
  CHECK(is_at_rest(record));
  for (const std::uint8_t data : data_of(record)) CHECK((data & 0x40) == 0);
}

TEST_CASE("a port that fails is reported", "[apps][parport]") {
  PortRecord record;
  auto player = open(on_port(), record);
  CHECK(player->play(words(6'000)) == Alarm::none);
  record.fails = true;
  const Status finished = player->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().code == Code::SC6074);
}

TEST_CASE("a player that goes away leaves the port at rest", "[apps][parport]") {
  PortRecord record;
  {
    auto player = open(on_port(), record);
    player->play(words(6'000));
    runtime::sleep_until(runtime::now_ns() + 20'000'000);
  }
  CHECK(is_at_rest(record));
}

namespace {

/// A port that counts its writes; each takes so long, ns, except that of the rest.
class CountingPort final : public hal::PortRegisters {
 public:
  explicit CountingPort(std::atomic<int>& written, std::int64_t slow = 0)
      : written_(written), slow_(slow) {}
  bool write_data(std::uint8_t bits) noexcept override {
    if (bits != 0 && slow_ > 0) runtime::sleep_until(runtime::now_ns() + slow_);
    ++written_;
    return true;
  }
  bool write_control(std::uint8_t) noexcept override { return true; }
  std::optional<std::uint8_t> read_status() noexcept override { return 0; }
  Diagnostic failure() const override { return {Code::SC6074, {}, "", "", {}}; }

 private:
  std::atomic<int>& written_;
  std::int64_t slow_;
};

constexpr std::int64_t kHundredPeriods = 5'000'000;  // ns

}  // namespace

TEST_CASE("after an abandoned player nothing is written any more", "[apps][parport]") {
  std::atomic<int> written{0};
  auto player =
      open_player(on_port(), std::make_unique<CountingPort>(written, kHundredPeriods), kAhead);
  REQUIRE(player);
  (*player)->play(words(6'000));
  for (int i = 0; i < 1000 && written < 5; ++i) runtime::sleep_until(runtime::now_ns() + 1'000'000);
  REQUIRE(written >= 5);
  (*player)->abandon();
  const int before = written;
  runtime::sleep_until(runtime::now_ns() + 20'000'000);
  CHECK(written == before);
}

namespace {

/// A port whose last word goes to a pipe when it is put at rest.
class TellingPort final : public hal::PortRegisters {
 public:
  explicit TellingPort(int pipe) : pipe_(pipe) {}
  bool write_data(std::uint8_t bits) noexcept override { return ::write(pipe_, &bits, 1) == 1; }
  bool write_control(std::uint8_t) noexcept override { return true; }
  std::optional<std::uint8_t> read_status() noexcept override { return 0; }
  Diagnostic failure() const override { return {Code::SC6074, {}, "", "", {}}; }

 private:
  int pipe_;
};

}  // namespace

TEST_CASE("a signal that ends the process leaves the port at rest", "[apps][parport]") {
  const int signal = GENERATE(SIGTERM, SIGINT, SIGABRT, SIGSEGV);
  int pipe[2];
  REQUIRE(::pipe(pipe) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(signal, SIG_DFL);
    auto player = open_player(on_port(), std::make_unique<TellingPort>(pipe[1]), kAhead);
    if (!player) ::_exit(1);
    (*player)->play(words(6'000));
    runtime::sleep_until(runtime::now_ns() + 30'000'000);
    ::raise(signal);
    ::_exit(2);
  }
  ::close(pipe[1]);
  int status = 0;
  std::uint8_t bits = 0xFF;
  int writes = 0;
  while (::read(pipe[0], &bits, 1) == 1) ++writes;
  ::waitpid(child, &status, 0);
  ::close(pipe[0]);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == signal);
  CHECK(writes > 1);
  CHECK(bits == 0x00);
}

namespace {

PortRecord* played = nullptr;  // OpenPlayer takes no more than a machine
double played_ahead = 0;

Result<std::unique_ptr<hal::PortPlayer>> open_recorded(const Machine& machine) {
  return open_player(machine, std::make_unique<RecordedPort>(*played), played_ahead);
}

/// What a run of 1.6 s writes; with `by_cycle` setpoints wait before their words are made.
std::vector<std::uint8_t> written_in_a_run(bool by_cycle) {
  PortRecord record;
  played = &record;
  played_ahead = by_cycle ? kBehindThread : kAhead;
  Machine machine = on_port();
  machine.control.period = 0.1;
  machine.parallel_port.device = "recorded";
  for (Axis& axis : machine.axes) axis.velocity = 25;
  Diagnostics diagnostics;
  ipr::Reader reader = ipr::Reader::from_text("G01 X5 Y-3 F600\nM00\nG02 X9 Y-3 I2 J0\nM30\n");
  {
    auto backend = hal::open_backend(machine, open_recorded);
    REQUIRE(backend);
    using runtime::RealtimeCycle;
    std::optional<RealtimeCycle> cycle;
    if (by_cycle) cycle.emplace(**backend, machine.control.period, RealtimeCycle::Pace::backend);
    const runtime::Outcome outcome =
        runtime::simulate(reader, -1, machine, {}, **backend, diagnostics, nullptr, nullptr,
                          cycle ? &*cycle : nullptr);
    CHECK(outcome.end == runtime::Outcome::End::done);
    CHECK((*backend)->finish());
  }
  return data_of(record);
}

}  // namespace

TEST_CASE("a thread before the port adds and leaves out no word", "[apps][parport]") {
  const auto plain = written_in_a_run(false);
  CHECK(plain.size() > 3000);
  CHECK(written_in_a_run(true) == plain);
}

namespace {

std::atomic<int> writes_counted{0};

class StopAfterWrites final : public runtime::Watcher {
 public:
  bool wants_stop() override { return writes_counted > 2000; }
  void sees(const Setpoint&) override {}
  void pause(const runtime::Pause&) override {}
  void wait_for_input(int) override {}
};

}  // namespace

TEST_CASE("a stop takes back what waits for the port, and it rests", "[apps][parport]") {
  writes_counted = 0;
  Machine machine = on_port();
  machine.control.period = 0.01;
  machine.parallel_port.device = "counted";
  Diagnostics diagnostics;
  ipr::Reader reader = ipr::Reader::from_text("G01 X500 F600\nM30\n");
  auto backend =
      hal::open_backend(machine, [](const Machine& on) -> Result<std::unique_ptr<hal::PortPlayer>> {
        return open_player(on, std::make_unique<CountingPort>(writes_counted), kBehindThread);
      });
  REQUIRE(backend);
  runtime::RealtimeCycle cycle(**backend, machine.control.period,
                               runtime::RealtimeCycle::Pace::backend);
  StopAfterWrites watcher;
  const runtime::Outcome outcome =
      runtime::simulate(reader, -1, machine, {}, **backend, diagnostics, nullptr, &watcher, &cycle);
  static_cast<void>((*backend)->finish());
  CHECK(outcome.end == runtime::Outcome::End::stopped);
  CHECK(outcome.last.v == 0);
  CHECK(outcome.last.position.x() > 1);
  CHECK(outcome.last.position.x() < 490);
}

TEST_CASE("a parallel port that is not there, or none, is status 5", "[apps][parport]") {
  const std::string run =
      "run -q --backend parport --set axis.x.velocity_mm_min=1500 --set "
      "axis.y.velocity_mm_min=1500 "
      "--set axis.z.velocity_mm_min=1500 --set backend.parport.device=";
  const app::test::Ended missing = app::test::call(run + "/dev/parport77 $data/square.nc");
  CHECK(missing.status == 5);
  CHECK(
      missing.err ==
      "/dev/parport77: error: there is no such port (open: No such file or directory) [SC6072]\n");
  const app::test::Ended wrong = app::test::call(run + "/dev/null $data/square.nc");
  CHECK(wrong.status == 5);
  CHECK(shows(wrong.err, "error: this is not a parallel port... [SC6072]"));
  CHECK(app::test::call(run + "'\"\"' $data/square.nc").status == 0);
}
