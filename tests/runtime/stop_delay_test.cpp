// SPDX-License-Identifier: MIT
// A stop, whenever it is requested, takes no longer than braking does: also while the machine still
// gains speed, where a stop can begin only once it gains no more.
#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "hal/backends/backend.hpp"
#include "runtime/session/session.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

constexpr double kAcceleration = 1000, kJerk = 20'000;  // mm/s^2, mm/s^3, of each axis

/// A straight way of 600 mm, in parts of about `part` mm.
std::string straight_way(double feed, double part) {
  std::string text = "G90 G94 F" + std::to_string(60 * feed) + "\n";
  const int parts = static_cast<int>(600 / part);
  for (int i = 1; i <= parts; ++i)
    text += "G01 X" + std::to_string(600.0 * i / parts) + " Y" + std::to_string(120.0 * i / parts) +
            "\n";
  return text;
}

/// s from the request, of which `asks` is one, in period `at` to rest; and the speed at `at`, mm/s.
template <typename Ask>
std::pair<double, double> time_to_rest(const std::string& part, int at, Ask&& asks) {
  Machine machine;
  machine.control.backend = BackendKind::none;
  for (Axis& axis : machine.axes) {
    axis.acceleration = kAcceleration;
    axis.jerk = kJerk;
  }
  const auto backend = hal::open_backend(machine);
  Session session(machine, {}, **backend);
  REQUIRE(session.feed(part));
  session.end();
  double v = 0;
  for (int i = 0; i < at; ++i)
    if (const auto row = session.step()) v = row->setpoint.v;
  asks(session);
  int rows = 0;
  for (double now = v; now > 0 && rows < 100'000; ++rows) {
    const auto row = session.step();
    now = row ? row->setpoint.v : 0;
  }
  CHECK(session.measured().acceleration[0] <= kAcceleration * 1.001);
  CHECK(session.measured().jerk[0] <= kJerk * 1.005);
  return {rows * machine.control.period, v};
}

}  // namespace

TEST_CASE("a hold or a stop begins at once, also while the speed still rises",
          "[runtime][session][stop]") {
  std::mt19937 chance(1);
  const auto from_to = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(chance()) / 4294967296.0;
  };
  for (int i = 0; i < (test::kSanitized ? 10 : 150); ++i) {
    const double feed = from_to(5, 240), part = i % 2 == 0 ? 600 : from_to(2, 40);
    const int at = 1 + static_cast<int>(chance() % 350);
    const std::string way = straight_way(feed, part);
    CAPTURE(feed, part, at);
    const auto [time, v] = i % 4 < 2 ? time_to_rest(way, at, [](Session& s) { s.hold(); })
                                     : time_to_rest(way, at, [](Session& s) { s.abort(); });
    const double rise = kAcceleration / kJerk;
    CHECK(time < 1.1 * (feed / kAcceleration + 2 * rise) + 0.02);
    CHECK(v <= feed * 1.001);
  }
}
