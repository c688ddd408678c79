// SPDX-License-Identifier: MIT
// A signal is answered within a second, whatever softcnc is doing.
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include "apps/shell.hpp"
#include "apps/talk.hpp"
#include "hal/backends/backend.hpp"
#include "messages/messages.hpp"
#include "process/signals.hpp"
#include "runtime/session/simulate.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// A second, and what a computer that does other things takes beside.
constexpr auto kSoon = 2s;

const std::string kLoop = "o1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n";
const std::vector<std::string> kLong{"--set", "program.block_limit=1000000000"};

struct Answer {
  int status = 0;
  Clock::duration taken{};
};

/// What softcnc, started with these arguments, does half a second later at a signal.
Answer answer_to(int signal, std::vector<std::string> arguments) {
  Talk talk(std::move(arguments));
  std::this_thread::sleep_for(500ms);
  const auto begin = Clock::now();
  talk.send(signal);
  talk.hear_rest();
  const int status = talk.status();
  return {status, Clock::now() - begin};
}

/// The signal that ends a child which waits for signals, and does this with them; or its status.
template <typename Do>
int end_of_child(int signal, Do&& act) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    for (const int taken : {SIGHUP, SIGINT, SIGTERM}) std::signal(taken, SIG_DFL);
    StopSignals signals;
    act(signals);
    ::kill(::getpid(), signal);
    std::this_thread::sleep_for(2 * std::chrono::milliseconds(StopSignals::kPatience));
    ::_exit(signals.token().stop_requested() ? 7 : 8);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status);
}

/// Asks for a stop when rows have come, and then none for a while.
class StopWhenStalled final : public runtime::Watcher {
 public:
  bool wants_stop() override { return stop_.stop_requested(); }
  void sees(const Setpoint& latest) override { rows_ = latest.period; }
  void pause(const runtime::Pause&) override {}
  void wait_for_input(int) override {}
  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch() {
    for (std::int64_t before = -1; rows_ == 0 || before != rows_;) {
      before = rows_;
      std::this_thread::sleep_for(300ms);
    }
    stop_.request_stop();
  }

  std::atomic<std::int64_t> rows_{0};
  std::stop_source stop_;
  std::jthread thread_{[this] { watch(); }};
};

}  // namespace

TEST_CASE("a signal ends every command that reads a loop", "[apps][answer]") {
  const Folder folder;
  write(folder / "loop.nc", kLoop);
  const std::string output = GENERATE("", "-o");
  const std::vector<std::vector<std::string>> commands =
      output.empty() ? std::vector<std::vector<std::string>>{{"run"},    {"run", "--dry-run"},
                                                             {"check"},  {"check", "--watch"},
                                                             {"blocks"}, {"compare"}}
                     : std::vector<std::vector<std::string>>{{"record"}, {"surface"}};
  for (std::vector<std::string> command : commands) {
    CAPTURE(command);
    command.insert(command.end(), kLong.begin(), kLong.end());
    if (!output.empty())
      command.insert(command.end(),
                     {"-o", folder / (command.front() == "record" ? "loop.rec" : "loop.npz")});
    command.push_back(folder / "loop.nc");
    for (const int signal : {SIGINT, SIGTERM}) {
      const Answer answer = answer_to(signal, command);
      CHECK(answer.status == kSignalled + signal);
      CHECK(answer.taken < kSoon);
    }
  }
}

TEST_CASE("a signal ends a run that opens a file which blocks", "[apps][answer]") {
  const Folder folder;
  REQUIRE(shell("mkfifo " + (folder / "fifo.nc")).status == 0);
  write(folder / "p.nc", "G21\nM2\n");
  using Words = std::vector<std::string>;
  Words command = GENERATE(
      Words{"run", "fifo.nc"}, Words{"check", "fifo.nc"},
      Words{"run", "--machine", "fifo.nc", "p.nc"}, Words{"run", "--state", "fifo.nc", "p.nc"},
      Words{"machine", "--machine", "fifo.nc"}, Words{"blocks", "-"}, Words{"run", "-"});
  for (std::string& word : command)
    if (word.ends_with(".nc")) word = folder / word;
  CAPTURE(command);
  const Answer answer = answer_to(SIGINT, command);
  CHECK(answer.status == 130);
  CHECK(answer.taken < kSoon);
}

TEST_CASE("a signal ends the pre-flight of a motion of months", "[apps][answer]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\nG02 X0 Y0 I100 F0.01\nI100\nM30\n");
  for (const int signal : {SIGINT, SIGTERM}) {
    const Answer answer = answer_to(signal, {"run", "-q", folder / "p.nc"});
    CHECK(answer.status == kSignalled + signal);
    CHECK(answer.taken < kSoon);
  }
}

TEST_CASE("a machine that moves comes to rest while its program is in a loop", "[apps][answer]") {
  constexpr int kLines = 20;  // of a second and a ramp each
  std::string text = "G61 F600\n";
  for (int i = 0; i < kLines; ++i) text += i % 2 == 0 ? "G01 X10\n" : "G01 X0\n";
  ipr::Reader reader = ipr::Reader::from_text(text + kLoop);
  StopWhenStalled watcher;
  Machine machine;
  machine.control.backend = BackendKind::none;
  machine.program.block_limit = std::numeric_limits<int>::max();
  const auto backend = hal::open_backend(machine);
  REQUIRE(backend);
  runtime::ChannelOptions options;
  options.interpreter.stop = watcher.token();
  Diagnostics diagnostics;
  const runtime::Outcome outcome =
      runtime::simulate(reader, -1, machine, options, **backend, diagnostics, nullptr, &watcher);
  CHECK(outcome.end == runtime::Outcome::End::stopped);
  CHECK(diagnostics.all().empty());
  CHECK(outcome.last.v == 0);
  CHECK(outcome.last.block > 1);
  CHECK(outcome.setpoints < kLines * 1000);
  CHECK(outcome.measured.acceleration[0] <= 1001);
}

TEST_CASE("a signal that nobody asks for ends what moves nothing", "[apps][answer]") {
  const auto nothing = [](StopSignals&) {};
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    CHECK(end_of_child(signal, nothing) == kSignalled + signal);
  CHECK(end_of_child(SIGINT, [](StopSignals&) { std::signal(SIGINT, SIG_IGN); }) == 130);
}

TEST_CASE("a simulated run has longer to answer", "[apps][answer]") {
  const auto simulated = [](StopSignals& signals) { signals.begin_motion(false); };
  CHECK(end_of_child(SIGINT, simulated) == 7);
}

TEST_CASE("a signal that is answered, or comes to a machine that moves, ends nothing by itself",
          "[apps][answer]") {
  CHECK(end_of_child(SIGINT, [](StopSignals& signals) { signals.begin_motion(true); }) == 7);
  CHECK(end_of_child(SIGINT, [](StopSignals& signals) {
          ::kill(::getpid(), SIGTERM);
          while (signals.poll() != SIGTERM) std::this_thread::sleep_for(1ms);
        }) == 130);  // the second one
  CHECK(end_of_child(0, [](StopSignals& signals) {
          ::kill(::getpid(), SIGTERM);
          while (signals.poll() != SIGTERM) std::this_thread::sleep_for(1ms);
        }) == 7);
}
