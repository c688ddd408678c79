// SPDX-License-Identifier: MIT
// A stop of a machine that runs by the clock takes back the setpoints that wait: by a clock that
// the tests drive.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/realtime/setpoint_queue.hpp"
#include "runtime/session/session.hpp"
#include "runtime/session/simulate.hpp"
#include "support/files.hpp"
#include "support/machines.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

constexpr int kAhead = 25;  // setpoints that are kept: 25 ms

/// A period passes whenever the planning side waits.
class DrivenQueue final : public SetpointQueue {
 public:
  DrivenQueue(hal::Backend& backend, double period) : SetpointQueue(backend, period) {}
  void wait() noexcept override {
    Slot* slot = nullptr;
    const Queue::Next next = take(slot);
    if (next == Queue::Next::missing) ++missing;
    if (next != Queue::Next::item) return;
    play(*slot);
    ++played;
  }
  int played = 0, missing = 0;
};

class Stopper final : public Watcher {
 public:
  Stopper(const DrivenQueue& queue, int at) : queue_(queue), at_(at) {}
  bool wants_stop() override { return queue_.played >= at_; }
  void sees(const Setpoint&) override {}
  void pause(const Pause&) override {}
  void wait_for_input(int) override {}

 private:
  const DrivenQueue& queue_;
  int at_;
};

struct AllRows final : RowSink {
  std::vector<Setpoint> rows;
  bool row(const Setpoint& setpoint, std::span<const double>) override {
    rows.push_back(setpoint);
    return true;
  }
};

struct ByClock {
  Outcome outcome;
  std::vector<Setpoint> rows;
  int missing = 0;
};

ByClock stopped_by_clock(const std::string& text, const Machine& machine, int at,
                         const ChannelOptions& options = {}) {
  const auto backend = hal::open_backend(machine);
  DrivenQueue queue(**backend, machine.control.period);
  Stopper stopper(queue, at);
  AllRows rows;
  Diagnostics diagnostics;
  ipr::Reader reader = ipr::Reader::from_text(text);
  ByClock driven{
      simulate(reader, -1, machine, options, **backend, diagnostics, &rows, &stopper, &queue),
      {},
      0};
  driven.rows = std::move(rows.rows);
  driven.missing = queue.missing;
  CHECK(diagnostics.errors() == 0);
  return driven;
}

/// The rows of a session that is aborted after the row of that period, as it was planned then.
std::vector<Setpoint> aborted_behind(const std::string& text, const Machine& machine, int period) {
  const auto backend = hal::open_backend(machine);
  AllRows rows;
  Session session(machine, {}, **backend, &rows);
  REQUIRE(session.feed(text));
  session.end();
  while (session.status() == SessionStatus::running) {
    const auto row = session.step();
    if (session.status() == SessionStatus::paused) session.resume();
    if (row && row->setpoint.period == period) session.abort();
  }
  return std::move(rows.rows);
}

void check_same(const std::vector<Setpoint>& rows, const std::vector<Setpoint>& expected) {
  REQUIRE(rows.size() == expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO(i);
    REQUIRE((rows[i].position - expected[i].position).norm() <= 1e-6);
    REQUIRE(rows[i].line == expected[i].line);
    REQUIRE(rows[i].limit == expected[i].limit);
    REQUIRE(rows[i].outputs == expected[i].outputs);
  }
}

/// A circle of chords, so short that the rest of the queue holds many of them.
std::string chords() {
  std::string text = "G01 F3000\n";
  for (int i = 1; i <= 2000; ++i)
    text += "X" + std::to_string(30 * std::sin(i * 0.003)) + " Y" +
            std::to_string(30 - 30 * std::cos(i * 0.003)) + "\n";
  return text;
}

std::vector<std::string> programs() {
  return {test::program_text("02_square.nc"),
          test::program_text("08_butterfly.nc"),
          test::program_text("12_dwell_and_actions.nc"),
          test::program_text("15_splines.nc"),
          "G01 X600 F6000\n",
          chords()};
}

Machine machine_with_jerk(double jerk) {
  Machine machine = test::usual_machine(1000, jerk);
  machine.control.backend = BackendKind::none;
  return machine;
}

}  // namespace

TEST_CASE("a stop takes back the setpoints that wait", "[runtime][realtime][stop]") {
  std::mt19937 chance(5);
  for (const std::string& text : programs()) {
    for (const double jerk : {0.0, 20'000.0}) {
      const Machine machine = machine_with_jerk(jerk);
      for (int i = 0; i < (test::kSanitized ? 1 : 4); ++i) {
        const int at = 1 + static_cast<int>(chance() % 700);
        CAPTURE(text.substr(0, 60), jerk, at);
        const ByClock driven = stopped_by_clock(text, machine, at);
        const auto expected = aborted_behind(text, machine, at + kAhead - 1);
        check_same(driven.rows, expected);
        CHECK(driven.missing == 0);
        CHECK(driven.rows.back().v == 0);
        CHECK(driven.outcome.end == Outcome::End::stopped);
        for (int axis = 0; axis < 3; ++axis) {
          CHECK(driven.outcome.measured.acceleration[axis] <= 1000 * 1.001);
          if (jerk > 0) CHECK(driven.outcome.measured.jerk[axis] <= jerk * 1.005);
        }
        const auto& times = driven.outcome.time_by_limit;
        CHECK(std::accumulate(times.begin(), times.end(), 0.0) ==
              Approx(driven.outcome.time).margin(1e-9));
      }
    }
  }
}

TEST_CASE("without a stop a run by a driven clock has the rows of any other",
          "[runtime][realtime]") {
  for (const std::string& text : programs()) {
    const Machine machine = machine_with_jerk(0);
    const auto never = 1 << 30;
    check_same(stopped_by_clock(text, machine, never).rows, aborted_behind(text, machine, never));
  }
}

TEST_CASE("a stop begins behind what a script has planned again", "[runtime][realtime][stop]") {
  const Machine machine = machine_with_jerk(20'000);
  ChannelOptions options;
  options.events = {{0.8, FeedEvent::Kind::override_, 50}};
  const ByClock driven = stopped_by_clock("G01 X600 F6000\n", machine, 500, options);
  CHECK(driven.rows.back().v == 0);
  CHECK(driven.rows.back().period > 800);
  CHECK(driven.rows.back().period < 1000);
  CHECK(driven.outcome.measured.acceleration[0] <= 1001);
  CHECK(driven.outcome.measured.jerk[0] <= 20'100);
}

TEST_CASE("a stop whose plan comes too late is planned again for a later setpoint",
          "[runtime][realtime][stop]") {
  for (const std::string& text : programs()) {
    const Machine machine = machine_with_jerk(20'000);
    CAPTURE(text.substr(0, 60));
    Requests requests;
    Diagnostics diagnostics;
    ipr::Reader reader = ipr::Reader::from_text(text);
    Channel channel(reader, -1, machine, {}, requests, diagnostics);
    std::vector<Setpoint> rows;
    const auto run = [&](std::size_t most) {
      while (rows.size() < most) {
        if (channel.pause_ahead()) channel.resume();
        const auto row = channel.step(requests.panel());
        if (!row) return;
        rows.push_back(*row);
      }
    };
    run(600);
    channel.forget_passed(0.09);
    CHECK_FALSE(channel.stop_after(rows[100], [] { return false; }));
    CHECK_FALSE(channel.stop_after(rows[130], [] { return false; }));
    CHECK(channel.stop_after(rows[190], [] { return true; }));
    rows.resize(191);
    requests.stop();
    run(100'000);
    check_same(rows, aborted_behind(text, machine, 190));
  }
}

TEST_CASE("a stop a little before a corner does not count as leaving the path",
          "[runtime][realtime][stop]") {
  const std::string text = "G01 X5 F600\nY5\nX0\nY0\n";
  const Machine machine = machine_with_jerk(0);
  int near_corner = 0;
  for (int at = 420; at < 520; ++at) {
    const ByClock driven = stopped_by_clock(text, machine, at);
    const auto& worst = driven.outcome.deviation;
    CAPTURE(at);
    CHECK(worst.off <= worst.allowed + machine.control.chord_tolerance + 1e-5);
    const double left = 5 - driven.rows.back().position.x();
    near_corner += left > 0.011 && left < 0.04 ? 1 : 0;
  }
  CHECK(near_corner > 0);
}
