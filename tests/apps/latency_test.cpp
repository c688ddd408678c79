// SPDX-License-Identifier: MIT
// softcnc latency: the mechanism and its arithmetic. No test asks how late the computer is.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "runtime/realtime/lateness.hpp"
#include "runtime/realtime/realtime.hpp"
#include "support/sanitized.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

TEST_CASE("percentiles, overruns and the shortest period follow from the wake-ups", "[apps]") {
  runtime::Lateness lateness(50'000);
  for (std::int64_t i = 1; i <= 1000; ++i) lateness.add(i * 10);  // 10 ns to 10 us
  CHECK(lateness.percentile(0.5) == 5'000);
  CHECK(lateness.percentile(0.9) == 9'000);
  CHECK(lateness.percentile(0.991) == 10'000);
  CHECK(lateness.percentile(1) == 10'000);
  CHECK(lateness.overruns() == 0);
  CHECK(lateness.shortest_period() == 11'000);
  lateness.add(49'999);
  CHECK(lateness.overruns() == 0);
  CHECK(lateness.percentile(1) == 49'999);
  CHECK(lateness.shortest_period() == 50'000);
  lateness.add(50'000);
  lateness.add(250'000'000);  // beyond all bins
  lateness.add(-5);           // woken before: not late
  CHECK(lateness.overruns() == 2);
  CHECK(lateness.wakeups() == 1004);
  CHECK(lateness.largest() == 250'000'000);
  CHECK(lateness.percentile(1) == 250'000'000);
}

TEST_CASE("percentiles describe lateness of any size", "[apps]") {
  constexpr std::int64_t kMs = 1'000'000;
  for (const std::int64_t unit : {kMs, 100 * kMs, 3'600'000 * kMs}) {
    CAPTURE(unit);
    runtime::Lateness lateness(kMs);
    for (std::int64_t i = 1; i <= 1000; ++i) lateness.add(i * unit);
    for (const double part : {0.001, 0.5, 0.9, 0.999}) {
      const double exact = 1000 * part * static_cast<double>(unit);
      CAPTURE(part);
      CHECK(static_cast<double>(lateness.percentile(part)) >= exact);
      CHECK(static_cast<double>(lateness.percentile(part)) <= exact * (1 + 1.0 / 2048));
    }
    CHECK(lateness.percentile(1) == 1000 * unit);
  }
  runtime::Lateness exact(kMs);
  for (std::int64_t us = 1; us <= 131'071; ++us) exact.add(us * 1000);
  CHECK(exact.percentile(0.5) == 65'536'000);
  CHECK(exact.percentile(0.999) == 130'940'000);
}

TEST_CASE("the time to measure is a bound, however short the period", "[apps]") {
  const Folder folder;
  const std::int64_t begin = runtime::now_ns();
  const Ended ended = call("latency --seconds 0.3 --period-us 1 --report " + (folder / "r.json"));
  CHECK(runtime::now_ns() - begin <
        5'000'000'000);  // 0.3 s, and whatever this computer does besides
  CHECK(ended.status == 0);
  const auto report = nlohmann::json::parse(read(folder / "r.json"));
  CHECK(report["wakeups"].get<int>() + report["left_out"].get<int>() == 300'000);
  const bool told = ended.out.find("  skipped       ") != std::string::npos;
  CHECK(told == (report["left_out"] > 0));
  CHECK(told != (ended.out.find("this computer keeps ") != std::string::npos));
}

TEST_CASE("the clock is waited for", "[apps]") {
  const std::int64_t begin = runtime::now_ns();
  runtime::sleep_until(begin + 2'000'000);
  CHECK(runtime::now_ns() >= begin + 2'000'000);
  runtime::sleep_until(begin);  // past: at once
}

TEST_CASE("latency reports wake-ups, rates and the feed of each axis", "[apps]") {
  const Folder folder;
  const Ended ended =
      call("latency --seconds 0.2 --period-us 500 --set axis.y.blu_um=10 --report " +
           (folder / "r.json"));
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  CHECK(ended.out.rfind("400 wake-ups, one every 500 us: ", 0) == 0);
  const auto report = nlohmann::json::parse(read(folder / "r.json"));
  CHECK(report["wakeups"] == 400);
  CHECK(report["period_us"] == 500);
  const auto& late = report["late_us"];
  CHECK(late["p50"] <= late["p99"]);
  CHECK(late["p99"] <= late["max"]);
  CHECK(report["shortest_period_us"] > late["max"]);
  const double steps = std::min(1e6 / (2 * report["shortest_period_us"].get<double>()), 100e3);
  CHECK(report["steps_hz"].get<double>() == Approx(steps));
  CHECK(report["feed_mm_min_max"]["x"].get<double>() == Approx(steps * 0.0025 * 60));
  CHECK(report["feed_mm_min_max"]["y"].get<double>() == Approx(steps * 0.01 * 60));
}

TEST_CASE("latency says where it has no real-time rights", "[apps]") {
  const Ended ended = shell(
      "without=; setpriv --bounding-set -sys_nice,-ipc_lock,-sys_resource true 2>/dev/null && "
      "without='setpriv --bounding-set -sys_nice,-ipc_lock,-sys_resource'; "
      "prlimit --rtprio=0 --memlock=65536 $without $softcnc latency --seconds 0.01");
  CHECK(ended.status == 0);
  CHECK(shows(ended.err,
              "softcnc: warning: no real-time rights: SCHED_FIFO: Operation not "
              "permitted... [SC6075]"));
  CHECK(ended.out.find("an ordinary thread, memory ") != std::string::npos);
  if (softcnc::test::kSanitized) return;  // there mlockall does nothing, and succeeds
  CHECK(ended.err.find("permitted; mlockall: ") != std::string::npos);
  CHECK(ended.out.find("memory not locked\n") != std::string::npos);
}

TEST_CASE("latency refuses times that make no sense", "[apps]") {
  CHECK(call("latency --seconds 0").status == 2);
  CHECK(call("latency --seconds nan").status == 2);
  CHECK(call("latency --seconds 0.1 --period-us nan").status == 2);
  CHECK(call("latency --period-us 0.1").status == 2);
  CHECK(call("latency extra").status == 2);
}

TEST_CASE("Ctrl-C ends a measurement with its figures", "[apps]") {
  const Ended ended = shell("$softcnc latency --seconds 60 & sleep 0.5; kill -TERM $!; wait $!");
  CHECK(ended.status == 143);
  CHECK(ended.out.find("wake-ups, one every 1000 us: ") != std::string::npos);
}
