// SPDX-License-Identifier: MIT
// A run by the clock: the same rows, in their time; and what is reported when that was not kept.
#include "runtime/realtime/realtime_cycle.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/shell.hpp"
#include "runtime/run/judge.hpp"
#include "support/period.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app;
using app::test::call;
using app::test::Ended;
using nlohmann::json;

namespace {

using softcnc::test::kPeriod;

/// Takes its time in one row, or raises an alarm there.
class Fickle final : public hal::Backend {
 public:
  int slow_at = -1, alarm_at = -1;
  std::int64_t slow_for = 0;  // ns
  std::int64_t exchanges = 0;

  Feedback exchange(const Setpoint& setpoint) noexcept override {
    if (exchanges == slow_at) runtime::sleep_until(runtime::now_ns() + slow_for);
    const bool alarms = exchanges++ == alarm_at;
    position_ = setpoint.position;
    pulses_ = 0;
    for (const TimedStep& timed : setpoint.pulses) pulses_ += timed.step[0];
    return {position_, alarms ? Alarm::following_error : Alarm::none, alarms ? 1 : -1};
  }
  std::span<const std::string> columns() const noexcept override { return columns_; }
  void values(std::span<double> out) const noexcept override {
    out[0] = position_[0] + 1;
    out[1] = pulses_;
  }
  AxisVector settle() const noexcept override { return position_; }

 private:
  std::vector<std::string> columns_{"x_act_mm", "pulses"};
  AxisVector position_ = AxisVector::Zero();
  double pulses_ = 0;
};

/// A cycle and the rows that have come back from it.
struct Driven {
  runtime::RealtimeCycle cycle;
  std::vector<double> x, actual, pulses;
  std::int64_t last_period = -1;
  Feedback feedback;

  explicit Driven(hal::Backend& backend) : cycle(backend, kPeriod) {}
  void collect() {
    cycle.collect(SIZE_MAX, [this](const runtime::SetpointQueue::Row& row) {
      x.push_back(row.setpoint.position[0]);
      actual.push_back(row.values[0]);
      pulses.push_back(row.values[1]);
      last_period = row.setpoint.period;
      feedback = row.feedback;
    });
  }
  void add(const Setpoint& setpoint) {
    for (collect(); cycle.capacity_left() == 0; collect()) cycle.wait();
    cycle.exchange(setpoint);
  }
  void add(int count, int begin = 0);
  void rest() {
    for (cycle.rest(); !cycle.all_back();) cycle.wait();
    collect();
  }
  const runtime::Punctuality& end() {
    cycle.stop();
    return cycle.punctuality();
  }
};

Setpoint at(int i) {
  Setpoint setpoint;
  setpoint.period = i;
  setpoint.position = {0.5 * i, 0, 0};
  return setpoint;
}

void Driven::add(int count, int begin) {
  for (int i = begin; i < begin + count; ++i) add(at(i));
}

/// Status and words follow from the figures, however late this computer was.
void check_told(const Ended& ended, const json& report, double seconds) {
  const json& kept = report["realtime"];
  const bool overrun = kept["overruns"] > 0;
  const bool rights = kept["scheduled_first"] == true && kept["memory_locked"] == true;
  const auto told = [&ended](const char* words) { return shows(ended.err, words); };
  CHECK(ended.status == (overrun && rights ? 4 : 0));
  CHECK(told("error: ... [SC5040]") == (overrun && rights));
  CHECK(told("warning: ... [SC5041]") == (overrun && !rights));
  CHECK(told("warning: ... [SC6075]") == !rights);
  CHECK(told(" periods missed, max "));
  CHECK(kept["periods"] == report["setpoints"]);
  CHECK(kept["late_us"]["max"] >= kept["late_us"]["p50"]);
  CHECK(seconds >= report["time_s"].get<double>());
}

}  // namespace

TEST_CASE("periods missed are an error with real-time rights, a warning without",
          "[apps][realtime][code]") {
  runtime::Punctuality punctuality{runtime::Lateness(1'000'000), 1, {true, true, {}}};
  for (const std::int64_t late : {20'000, 1'500'000, 30'000}) punctuality.lateness.add(late);
  CHECK(render(runtime::missed_periods(punctuality, "part.nc")) ==
        "part.nc: error: 2 of 3 periods were missed; the latest came 1500.0 us late [SC5040]\n");
  punctuality.unplanned = 0;
  punctuality.rights.locked = false;
  CHECK(render(runtime::missed_periods(punctuality, "part.nc")) ==
        "part.nc: warning: 1 of 3 periods was missed; the latest came 1500.0 us late [SC5041]\n");
}

TEST_CASE("every setpoint is exchanged once, in order, in its period", "[apps][realtime]") {
  Fickle backend;
  const std::int64_t begin = runtime::now_ns();
  Driven rows(backend);
  rows.add(700);
  rows.rest();
  CHECK(runtime::now_ns() - begin >= 699'000'000);
  REQUIRE(rows.x.size() == 700);
  for (int i = 0; i < 700; ++i) {
    REQUIRE(rows.x[static_cast<std::size_t>(i)] == 0.5 * i);
    REQUIRE(rows.actual[static_cast<std::size_t>(i)] == 0.5 * i + 1);
  }
  CHECK(backend.exchanges == 700);
  CHECK(rows.end().lateness.wakeups() == 700);
}

TEST_CASE("pulses of a setpoint reach the backend, though theirs are gone", "[apps][realtime]") {
  Fickle backend;
  Driven rows(backend);
  std::vector<TimedStep> steps;
  for (int i = 0; i < 20; ++i) {
    steps.assign(static_cast<std::size_t>(i), {0.5, Step(0, 1)});
    Setpoint setpoint = at(i);
    setpoint.pulses = steps;
    rows.add(setpoint);
  }
  rows.rest();
  for (int i = 0; i < 20; ++i) CHECK(rows.pulses[static_cast<std::size_t>(i)] == i);
}

TEST_CASE("where the program waits the clock goes on, and nothing is missed", "[apps][realtime]") {
  Fickle backend;
  Driven rows(backend);
  rows.add(10);
  rows.rest();
  runtime::sleep_until(runtime::now_ns() + 30'000'000);
  rows.add(10, 10);
  rows.rest();
  CHECK(rows.end().unplanned == 0);
  CHECK(rows.x.size() == 20);
}

TEST_CASE("a backend that takes too long is an overrun, and so is a plan", "[apps][realtime]") {
  Fickle backend;
  backend.slow_at = 100;
  backend.slow_for = 20'000'000;
  Driven slow(backend);
  slow.add(300);
  slow.rest();
  CHECK(slow.end().overruns() >= 1);
  CHECK(slow.x.size() == 300);
  CHECK(slow.end().lateness.largest() >= 18'000'000);

  Fickle quick;
  Driven starved(quick);
  starved.add(400);  // enough to begin with
  runtime::sleep_until(runtime::now_ns() + 1'500'000'000);
  starved.add(10, 400);
  starved.rest();
  CHECK(starved.end().unplanned >= 1);
  CHECK(starved.x.size() == 410);
}

TEST_CASE("after an alarm nothing is exchanged any more", "[apps][realtime]") {
  Fickle backend;
  backend.alarm_at = 50;
  Driven rows(backend);
  rows.add(400);
  rows.rest();
  CHECK(backend.exchanges == 51);
  CHECK(rows.x.size() == 51);
  CHECK(rows.last_period == 50);
  CHECK(rows.feedback.alarm == Alarm::following_error);
  CHECK(rows.feedback.alarm_axis == 1);
}

TEST_CASE("setpoints that wait can be taken back, and others come in their place",
          "[apps][realtime]") {
  Fickle backend;
  Driven rows(backend);
  rows.add(500);
  rows.cycle.rest();
  const auto cut = rows.cycle.cut_in(0.1, 0);
  REQUIRE(cut);
  REQUIRE(rows.cycle.take_back(*cut));
  const auto kept = static_cast<int>(cut->last.period) + 1;
  CHECK(kept <= 102);
  rows.add(20, 1000);
  rows.rest();
  CHECK(rows.end().unplanned == 0);
  REQUIRE(rows.x.size() == static_cast<std::size_t>(kept) + 20);
  for (int i = 0; i < kept; ++i) REQUIRE(rows.x[static_cast<std::size_t>(i)] == 0.5 * i);
  for (int i = 0; i < 20; ++i)
    REQUIRE(rows.x[static_cast<std::size_t>(kept + i)] == 0.5 * (1000 + i));
}

TEST_CASE("a queue between two threads loses nothing and keeps its bound", "[apps][realtime]") {
  runtime::RealtimeQueue<int> queue(100);
  constexpr int kItems = 300'000;
  std::thread planner([&] {
    for (int i = 0; i < kItems;) i += queue.push(i) ? 1 : 0;
    queue.rest();
  });
  int expected = 0;
  for (int item = -1; expected < kItems;)
    if (queue.take(item) == runtime::RealtimeQueue<int>::Next::item && item == expected) ++expected;
  planner.join();
  CHECK(expected == kItems);
  int item = 0;
  CHECK(queue.take(item) == runtime::RealtimeQueue<int>::Next::stands);
  for (int i = 0; i < 100; ++i) REQUIRE(queue.push(i));
  CHECK_FALSE(queue.push(100));
}

TEST_CASE("what is taken back while another thread takes comes to one of the two",
          "[apps][realtime]") {
  runtime::RealtimeQueue<int> queue(64);
  constexpr int kItems = 200'000;
  std::atomic<bool> finished{false};
  std::vector<int> taken;
  std::thread cycle([&] {
    const auto take_all = [&] {
      for (int item = -1; queue.take(item) == runtime::RealtimeQueue<int>::Next::item;)
        taken.push_back(item);
    };
    while (!finished) take_all();
    take_all();
  });
  std::vector<int> back;
  int refused = 0;
  for (int i = 0; i < kItems; ++i) {
    while (!queue.push(i)) {
    }
    queue.rest();
    const auto counts = queue.load();
    if (i % 7 != 0 || counts.waiting() < 3) continue;
    const bool comes =
        queue.take_back(counts.taken + 2, 1, [&](int item) { back.push_back(item); });
    refused += comes ? 0 : 1;
    queue.rest();
  }
  finished = true;
  cycle.join();
  CHECK(!back.empty());
  REQUIRE(taken.size() + back.size() == kItems);
  REQUIRE(std::is_sorted(taken.begin(), taken.end()));
  back.insert(back.end(), taken.begin(), taken.end());
  std::sort(back.begin(), back.end());
  for (int i = 0; i < kItems; ++i) REQUIRE(back[static_cast<std::size_t>(i)] == i);
  CAPTURE(refused);
}

TEST_CASE("a run by the clock gives the same rows and files, in its time", "[apps][realtime]") {
  const std::string backend =
      GENERATE("none", "sim", "sim --set control.interpolation=m-dsm",
               "stepdir --set backend.stepdir.file=$f/out.edges",
               "hal-stream --set backend.hal-stream.file=$f/out.rows", "none --dry-run");
  const app::test::Folder folder;
  app::test::write(folder / "p.nc", "G01 X5 Y3 F1500\nM00\nG02 X5 Y3 I1 J0\nM30\n");
  std::string traces[2], outs[2];
  for (const int paced : {0, 1}) {
    const std::int64_t begin = runtime::now_ns();
    const Ended ended = app::test::shell(
        "f=" + (folder / ".") + "; $softcnc run $f/p.nc " + (paced ? "--realtime " : "") +
        "--trace $f/t.csv --report $f/r.json --backend " + backend);
    const double seconds = static_cast<double>(runtime::now_ns() - begin) / 1e9;
    CAPTURE(ended.err, backend);
    const json report = json::parse(app::test::read(folder / "r.json"));
    traces[paced] = app::test::read(folder / "t.csv");
    for (const char* out : {"out.edges", "out.rows"})
      if (backend.find(out) != std::string::npos) outs[paced] = app::test::read(folder / out);
    REQUIRE(report.contains("realtime") == (paced == 1));
    if (paced)
      check_told(ended, report, seconds);
    else
      CHECK(ended.status == 0);
  }
  CHECK(traces[0] == traces[1]);
  CHECK(outs[0] == outs[1]);
}

TEST_CASE("without the rights a run by the clock goes on, with a word", "[apps][realtime]") {
  const Ended ended = app::test::shell(
      "ulimit -r 0 2>/dev/null; setpriv --bounding-set -all --inh-caps -all --no-new-privs "
      "--reuid 65534 --regid 65534 --clear-groups $softcnc run -q --realtime --backend none "
      "- <<'.'\nG01 X1 F600\nM30\n.\n");
  if (ended.err.find("setpriv") != std::string::npos) return;  // itself not allowed to give up any
  CHECK(ended.status == 0);
  CHECK(shows(ended.err, "warning: no real-time rights: ... [SC6075]"));
}

TEST_CASE("an alarm of the mill ends a run by the clock where it came", "[apps][realtime]") {
  const std::string run = "run -q $data/square.nc --set axis.y.drive.lost_pulse=3000 --trace ";
  const app::test::Folder folder;
  const Ended plain = call(run + (folder / "a.csv"));
  const Ended paced = call(run + (folder / "b.csv") + " --realtime");
  CHECK(plain.status == 4);
  CHECK(paced.status == 4);
  CHECK(paced.err.find(plain.err) != std::string::npos);
  CHECK(app::test::read(folder / "a.csv") == app::test::read(folder / "b.csv"));
}

TEST_CASE("Ctrl-C stops a run by the clock at rest, with whole files", "[apps][realtime]") {
  const app::test::Folder folder;
  app::test::write(folder / "p.nc", "G01 X500 F3000\nM30\n");
  const Ended ended = app::test::shell(
      "$softcnc run " + (folder / "p.nc") + " --realtime --trace " + (folder / "t.npz") +
      " --report " + (folder / "r.json") + " & pid=$!; sleep 1; kill -INT $pid; wait $pid");
  CHECK((ended.status == 130 || ended.status == 4));
  CHECK(folder.files() == std::vector<std::string>{"p.nc", "r.json", "t.npz"});
  const json report = json::parse(app::test::read(folder / "r.json"));
  CHECK(report["status"] == "stopped");
  CHECK(report["time_s"].get<double>() < 8);
  const Ended last = app::test::shell("/usr/bin/python3 -c \"import numpy; f = numpy.load('" +
                                      (folder / "t.npz") + "'); print(f['v_mm_s'][-1])\"");
  CHECK(last.out == "0.0\n");
}
