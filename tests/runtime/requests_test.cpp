// SPDX-License-Identifier: MIT
// The mailbox of requests: what is due when, and that an operator and a script get the same rows.
#include "runtime/session/requests.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "runtime/session/session.hpp"
#include "runtime/session/simulate.hpp"
#include "support/files.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

using Kind = FeedEvent::Kind;

struct Positions final : RowSink {
  std::vector<AxisVector> rows;
  bool row(const Setpoint& setpoint, std::span<const double>) override {
    rows.push_back(setpoint.position);
    return true;
  }
};

Machine without_backend() {
  Machine machine;
  machine.control.backend = BackendKind::none;
  return machine;
}

}  // namespace

TEST_CASE("a request is due once, and a script at its times", "[runtime][requests]") {
  Requests requests(0.8, {{1, Kind::override_, 50}, {1, Kind::hold, 100}, {2, Kind::resume, 100}});
  CHECK_FALSE(requests.due(0.999));
  CHECK(requests.control().feed_override == 0.8);
  CHECK(requests.due(1));
  CHECK(requests.answer(1).hold);
  CHECK(requests.control().feed_override == 0.5);
  CHECK_FALSE(requests.due(1.5));
  CHECK(requests.script_left() == 1);
  requests.set_feed_override(1.2);
  CHECK(requests.due(1.5));
  CHECK(requests.answer(1.5).feed_override == 1.2);
  CHECK(requests.control().hold);
  CHECK_FALSE(requests.answer(2).hold);
  CHECK(requests.script_left() == 0);
  requests.resume();  // nothing holds
  CHECK_FALSE(requests.due(9));
  requests.hold();
  requests.stop();
  CHECK(requests.stops());
  CHECK_FALSE(requests.due(9));  // nothing but the stop counts
}

TEST_CASE("an override is held within its limits", "[runtime][requests]") {
  Requests requests;
  const auto given = [&](double wanted) {
    requests.set_feed_override(wanted);
    return requests.control().feed_override;
  };
  CHECK(given(3) == 2);
  CHECK(given(0.001) == 0.001);
  CHECK(given(0.0009) == 0);
  CHECK(given(-1) == 0);
  CHECK(given(0.7) == 0.7);
  CHECK(given(std::numeric_limits<double>::quiet_NaN()) == 0.7);
}

TEST_CASE("an operator gets the rows that a script with the same requests gets",
          "[runtime][requests]") {
  for (const char* name : {"02_square.nc", "03_arc.nc", "08_butterfly.nc"}) {
    INFO(name);
    const std::string text = test::program_text(name);
    const Machine machine = without_backend();
    const double period = machine.control.period;
    constexpr int kOverride = 100, kHold = 300, kResume = 700;  // rows

    ChannelOptions options;
    options.events = {{kOverride * period, Kind::override_, 60},
                      {kHold * period, Kind::hold, 100},
                      {kResume * period, Kind::resume, 100}};
    const auto of_script = hal::open_backend(machine);
    Diagnostics diagnostics;
    Positions scripted;
    ipr::Reader reader = ipr::Reader::from_text(text);
    simulate(reader, -1, machine, options, **of_script, diagnostics, &scripted, nullptr);

    const auto of_operator = hal::open_backend(machine);
    Positions operated;
    Session session(machine, {}, **of_operator, &operated);
    REQUIRE(session.feed(text));
    session.end();
    for (int row = 0; session.status() == SessionStatus::running; ++row) {
      if (row == kOverride + 1) session.set_feed_override(0.6);
      if (row == kHold + 1) session.hold();
      if (row == kResume + 1) session.resume();
      session.step();
    }
    REQUIRE(session.status() == SessionStatus::done);
    REQUIRE(scripted.rows.size() > kResume);
    REQUIRE(operated.rows.size() == scripted.rows.size());
    double largest = 0;
    for (std::size_t i = 0; i < scripted.rows.size(); ++i)
      largest = std::max(largest, (operated.rows[i] - scripted.rows[i]).norm());
    CHECK(largest == 0);
  }
}

TEST_CASE("an override of rapids slows down rapids alone, and ends where it would",
          "[runtime][requests]") {
  Machine machine = without_backend();
  machine.control.interpolation = GENERATE(Method::arc_length, Method::acc_dec_linear);
  for (Axis& axis : machine.axes) axis.jerk = GENERATE(0.0, 20'000.0);
  const auto backend = hal::open_backend(machine);
  Session session(machine, {}, **backend);
  REQUIRE(session.feed("G00 X60 Y30\nG01 X30 Y0 F3000\nG00 X0\nM30\n"));
  session.end();
  const double fastest = machine.axes[0].velocity;
  double rapid = 0, feed = 0;
  Setpoint last;
  while (const auto row = session.step()) {
    last = row->setpoint;
    if (last.period == 150) session.set_rapid_override(0.25);
    if (last.period == 400) CHECK(last.limit == Limit::override_);
    if (last.line == 2) feed = std::max(feed, last.v);
    if (last.line == 3) rapid = std::max(rapid, last.v);
  }
  CHECK(rapid == Approx(0.25 * fastest).epsilon(1e-6));
  if (follows_time(machine.control.interpolation)) CHECK(feed == Approx(50).epsilon(1e-6));
  CHECK(last.position.norm() < 1e-9);
  CHECK(session.measured().velocity[0] <= fastest * (1 + 1e-9));
  session.set_rapid_override(std::nan(""));
}
