// SPDX-License-Identifier: MIT
// The backend of a parallel port: what is written to a port that records, judged by the validator.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cerrno>
#include <memory>

#include "hal/backends/backend.hpp"
#include "hal/backends/stepdir.hpp"
#include "hal/ports/port_edges.hpp"
#include "hal/ports/port_output.hpp"
#include "hal/ports/ppdev.hpp"
#include "hal/ports/tick_pace.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "support/recorded_port.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using softcnc::test::PortRecord;
using softcnc::test::RecordedPort;
using test::setpoint_at;

/// Plays words as they come, a tick each, without a clock.
class PromptPlayer final : public PortPlayer {
 public:
  PromptPlayer(const Machine& machine, PortRecord& record)
      : record_(record), output_(std::make_unique<RecordedPort>(record), machine) {}

  Alarm play(std::span<const PortWord> words) noexcept override {
    Alarm alarm = output_.look();
    for (const PortWord& word : words) {
      if (alarm == Alarm::none) alarm = output_.write(word);
      ++record_.tick;
    }
    return alarm;
  }
  void rest() noexcept override {}
  double ahead() const noexcept override { return 0; }
  void follow(double) noexcept override {}
  bool next_change(PortChange&) noexcept override { return false; }
  Alarm alarm() const noexcept override { return Alarm::none; }
  Diagnostic trouble() const override { return output_.diagnostic(Alarm::port); }
  Status recover() override { return {}; }
  Status finish() override {
    output_.rest();
    return {};
  }

 private:
  PortRecord& record_;
  PortOutput output_;
};

Machine on_port() {
  Machine machine;
  machine.control.backend = BackendKind::parport;
  machine.parallel_port.charge_pump_pin = 0;
  machine.parallel_port.estop_pin = 0;
  for (Axis& axis : machine.axes) axis.velocity = 25;  // mm/s: 10 kHz
  return machine;
}

std::unique_ptr<Backend> open_recorded(const Machine& machine, PortRecord& record) {
  auto player = std::make_unique<PromptPlayer>(machine, record);
  return std::make_unique<StepDir>(machine, port_timing(machine).rules,
                                   std::make_unique<PortEdges>(machine, std::move(player)));
}

/// The edges of the lines on pins 2 to 7, by ticks of so many ns.
std::vector<SignalEdge> edges_in(const PortRecord& record, std::int64_t base) {
  std::vector<SignalEdge> edges;
  unsigned levels = 0;
  for (const auto& write : record.writes) {
    if (write.control) continue;
    for (unsigned bit = 0; bit < 6; ++bit)
      if (((levels ^ write.bits) >> bit & 1U) != 0)
        edges.push_back({write.tick * base, static_cast<std::uint8_t>(bit / 2),
                         bit % 2 == 0 ? Wire::step : Wire::direction,
                         (write.bits >> bit & 1U) != 0});
    levels = write.bits;
  }
  return edges;
}

struct Driver {
  const char* name;
  double length, space, hold, setup;  // ns
};

}  // namespace

TEST_CASE("what is written to a port keeps the driver's rules and the counts", "[hal][parport]") {
  const auto driver = GENERATE(
      Driver{"Gecko 201", 500, 4000, 20000, 1000}, Driver{"Gecko 540", 5000, 5000, 10000, 10000},
      Driver{"Sherline", 22000, 22000, 100000, 100000}, Driver{"Xylotex", 2000, 1000, 200, 200});
  const double base = GENERATE(10e-6, 50e-6, 70e-6);
  CAPTURE(driver.name, base);
  Machine machine = on_port();
  machine.parallel_port.base_period = base;
  machine.step_port.step_length = driver.length * 1e-9;
  machine.step_port.step_space = driver.space * 1e-9;
  machine.step_port.direction_hold = driver.hold * 1e-9;
  machine.step_port.direction_setup = driver.setup * 1e-9;
  machine.step_port.max_rate = 10e3;
  PortRecord record;
  auto backend = open_recorded(machine, record);
  AxisVector place = AxisVector::Zero();
  backend->exchange(setpoint_at(place));
  const AxisVector speeds[] = {
      {0.017, -0.011, 0.0003}, {-0.017, 0.017, 0}, {0, 0, 0}, {0.0171, -0.0172, 0.009}};
  for (const AxisVector& speed : speeds)
    for (int i = 0; i < 50; ++i) {
      place += speed;
      REQUIRE(backend->exchange(setpoint_at(place)).alarm == Alarm::none);
    }
  REQUIRE(backend->finish());
  PulseRules rules(step_timing(machine.step_port));
  rules.read(edges_in(record, port_timing(machine).base));
  CHECK(rules.broken().value_or("none") == "none");
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(rules.counts()[axis] ==
          Counts(machine.axes[axis].blu)(place[static_cast<Eigen::Index>(axis)]));
  CHECK(rules.steps() > 1500);
}

TEST_CASE("the port is enabled, moved, and left at rest", "[hal][parport]") {
  Machine machine = on_port();
  machine.parallel_port.enable_pin = -17;  // inverted twice: by the port, and as asked for
  machine.parallel_port.step_pin[1] = -4;
  PortRecord record;
  auto backend = open_recorded(machine, record);
  backend->exchange(setpoint_at({0, 0, 0}));
  backend->exchange(setpoint_at({0.0025, 0.0025, 0}));
  REQUIRE(backend->finish());
  using Write = PortRecord::Write;
  const std::vector<Write> expected{
      {true, 0x08, 0}, {false, 0x04, 0}, {false, 0x01, 10}, {false, 0x04, 11}};
  REQUIRE(record.writes.size() >= expected.size());
  CHECK(std::equal(expected.begin(), expected.end(), record.writes.begin()));
  CHECK(record.last(true) == 0x00);
  CHECK(record.last(false) == 0x04);
}

TEST_CASE("the charge pump turns every base period, until the end", "[hal][parport]") {
  Machine machine = on_port();
  machine.parallel_port.charge_pump_pin = 9;
  PortRecord record;
  auto backend = open_recorded(machine, record);
  for (int i = 0; i < 10; ++i) backend->exchange(setpoint_at({0, 0, 0}));
  CHECK(record.tick == 9 * 20);
  CHECK(record.writes.size() == 9 * 20 + 1);
  for (std::size_t i = 1; i < record.writes.size(); ++i)
    CHECK(record.writes[i].bits == (i % 2 == 1 ? 0xC0 : 0x40));
  REQUIRE(backend->finish());
  CHECK(record.last(false) == 0x00);
}

namespace {

Machine with_outputs() {
  Machine machine = on_port();
  machine.spindle.max_rpm = 6000;
  machine.parallel_port.spindle_pin = 1;  // inverted by the port
  machine.parallel_port.spindle_ccw_pin = -16;
  machine.parallel_port.mist_pin = 9;
  machine.parallel_port.flood_pin = 14;  // inverted by the port
  machine.outputs["clamp"] = {4, SignalKind::digital, -17};
  return machine;
}

constexpr std::uint64_t kClamp = 1U << 4;

/// The control register (pins 1, 14, 16, 17) and the data register behind these outputs.
std::pair<int, int> levels(const Machine& machine, const Outputs& outputs) {
  PortRecord record;
  auto backend = open_recorded(machine, record);
  Setpoint setpoint = setpoint_at({0, 0, 0});
  backend->exchange(setpoint);
  setpoint.outputs = outputs;
  backend->exchange(setpoint);
  const auto before = record.writes.size();
  backend->exchange(setpoint);  // the period that begins with them
  for (std::size_t i = before; i < record.writes.size(); ++i) CHECK(record.writes[i].tick == 20);
  const std::pair<int, int> levels{record.last(true), record.last(false)};
  REQUIRE(backend->finish());
  CHECK(int{record.last(true)} == (0x01 | 0x02 | 0x04));  // all low, those of 16 and 17 inverted
  CHECK(int{record.last(false)} == 0x00);
  return levels;
}

}  // namespace

TEST_CASE("spindle, coolant and outputs are on their pins, until the end", "[hal][parport]") {
  const Machine machine = with_outputs();
  using Levels = std::pair<int, int>;
  constexpr int kOff = 0x01 | 0x02 | 0x04, kEnabled = 0x40;
  CHECK(levels(machine, {}) == Levels(kOff, kEnabled));
  CHECK(levels(machine, {1000, false, false, 0}) == Levels(kOff & ~0x01, kEnabled));
  CHECK(levels(machine, {-1000, false, false, 0}) == Levels(kOff & ~0x01 & ~0x04, kEnabled));
  CHECK(levels(machine, {0, true, false, 0}) == Levels(kOff, kEnabled | 0x80));
  CHECK(levels(machine, {0, false, true, 0}) == Levels(kOff & ~0x02, kEnabled));
  CHECK(levels(machine, {0, false, false, kClamp}) == Levels(kOff | 0x08, kEnabled));
  CHECK(levels(machine, {0, false, false, 1U << 5}) == Levels(kOff, kEnabled));
}

TEST_CASE("the signal of the spindle is high for the part that its speed is of the largest",
          "[hal][parport]") {
  Machine machine = on_port();
  machine.spindle.max_rpm = 6000;
  machine.parallel_port.spindle_pwm_pin = 9;
  machine.parallel_port.spindle_pwm_levels = GENERATE(100, 7);
  const auto cycle = machine.parallel_port.spindle_pwm_levels;
  const double rpm = GENERATE(0.0, 60.0, 1500.0, -1500.0, 5999.0, 6000.0, 7000.0);
  CAPTURE(cycle, rpm);
  PortRecord record;
  PortOutput output(std::make_unique<RecordedPort>(record), machine);
  PortWord word = output.pins().enabled();
  Outputs outputs;
  outputs.spindle_rpm = rpm;
  output.pins().set(word, outputs);
  int high = 0, changes = 0;
  bool before = false;
  for (int tick = 0; tick < 10 * cycle; ++tick) {
    REQUIRE((tick == 0 ? output.write(word) : output.write_again()) == Alarm::none);
    const bool now = (record.last(false) & 0x80) != 0;
    high += now ? 1 : 0;
    changes += now != before ? 1 : 0;
    before = now;
  }
  const auto expected = std::lround(std::min(std::abs(rpm) / 6000, 1.0) * cycle);
  CHECK(high == 10 * expected);
  CHECK(changes == (expected == 0 ? 0 : expected == cycle ? 1 : 20));
  output.rest();
  CHECK(record.last(false) == 0);
}

TEST_CASE("inputs are understood, inverted or not", "[hal][parport]") {
  Machine machine = on_port();
  machine.parallel_port.estop_pin = 10;
  machine.parallel_port.limit_pin = 11;  // inverted by the port
  machine.parallel_port.fault_pin = -13;
  const PortPins pins(machine);
  const std::uint8_t quiet = 0x80 | 0x10;
  CHECK(pins.alarm(quiet) == Alarm::none);
  CHECK(pins.alarm(quiet | 0x40) == Alarm::emergency_stop);
  CHECK(pins.alarm(0x10) == Alarm::limit_switch);
  CHECK(pins.alarm(0x80) == Alarm::driver_fault);
  CHECK(pins.alarm(quiet | 0x28) == Alarm::none);  // pins of nobody
  CHECK_FALSE(PortPins(on_port()).looks());

  PortRecord record;
  record.status = quiet;
  auto backend = open_recorded(machine, record);
  backend->exchange(setpoint_at({0, 0, 0}));
  CHECK(backend->exchange(setpoint_at({0.01, 0, 0})).alarm == Alarm::none);
  record.status = quiet | 0x40;
  CHECK(backend->exchange(setpoint_at({0.02, 0, 0})).alarm == Alarm::emergency_stop);
}

TEST_CASE("a port that fails is reported, and so is every other alarm", "[hal][parport][code]") {
  const Machine machine = on_port();
  PortRecord record;
  auto backend = open_recorded(machine, record);
  backend->exchange(setpoint_at({0, 0, 0}));
  record.fails = true;
  CHECK(backend->exchange(setpoint_at({0.01, 0, 0})).alarm == Alarm::port);
  const PortOutput output(std::make_unique<RecordedPort>(record), machine);
  CHECK(render(output.diagnostic(Alarm::port)) == "port: error: it was told to [SC6074]\n");
  const auto told = [&](Alarm alarm) {
    CHECK(exit_status(output.diagnostic(alarm)) == 4);
    return render(output.diagnostic(alarm));
  };
  CHECK(told(Alarm::emergency_stop) ==
        "/dev/parport0: error: emergency stop: the input of backend.parport.estop_pin is "
        "on; the drives are disabled [SC5031]\n");
  CHECK(told(Alarm::limit_switch) ==
        "/dev/parport0: error: an axis is on a limit switch: the input of "
        "backend.parport.limit_pin is on; the drives are disabled [SC5032]\n");
  CHECK(told(Alarm::driver_fault) ==
        "/dev/parport0: error: a drive reports a fault: the input of "
        "backend.parport.fault_pin is on; the drives are disabled [SC5033]\n");
  CHECK(told(Alarm::overrun) ==
        "/dev/parport0: error: the port was not written to for a whole period; the drives "
        "are disabled [SC5030]\n");
}

TEST_CASE("what the system refuses is reported by its reason", "[hal][parport][code]") {
  const auto text = [](const char* call, int error) {
    const Diagnostic told = port_refusal("/dev/parport0", call, error);
    CHECK(exit_status(told) == 5);
    return render(told);
  };
  CHECK(text("open", ENOENT) ==
        "/dev/parport0: error: there is no such port (open: No such file or directory) [SC6072]\n");
  CHECK(text("open", ENXIO) ==
        "/dev/parport0: error: there is no such port (open: No such device or address) [SC6072]\n");
  CHECK(
      text("open", EACCES) ==
      "/dev/parport0: error: no permission to use this port (open: Permission denied) [SC6072]\n");
  CHECK(text("PPCLAIM", ENXIO) ==
        "/dev/parport0: error: another driver or program uses "
        "this port (PPCLAIM: No such device or address) [SC6073]\n");
  CHECK(text("open", EBUSY) ==
        "/dev/parport0: error: another driver or program uses this "
        "port (open: Device or resource busy) [SC6073]\n");
  const auto null = Ppdev::open("/dev/null");
  REQUIRE_FALSE(null);
  CHECK(render(null.error()) ==
        "/dev/null: error: this is not a parallel port (PPEXCL: "
        "Inappropriate ioctl for device) [SC6072]\n");
  CHECK_FALSE(Ppdev::open("/no/such/port"));
}

TEST_CASE("ticks that are late never break a rule of the driver", "[hal][parport]") {
  Machine machine = on_port();
  machine.step_port.step_length = 22e-6;
  machine.step_port.direction_setup = 120e-6;
  const PortTiming timing = port_timing(machine);
  CHECK(timing.rules.setup == 150'000);
  CHECK(timing.shortest == 40'000);
  std::int64_t woken = 0;
  TickPace pace(timing.base, timing.shortest, 0);
  for (std::int64_t i = 0; i < 1000; ++i) {
    const std::int64_t due = pace.due();
    const std::int64_t now = due + (i == 500 ? 900'000 : i * 7919 % 10'000);
    if (i > 0) CHECK(now - woken >= timing.shortest);
    CHECK(pace.come(now) == now - due);
    woken = now;
  }
  CHECK(woken < 1000 * timing.base + 1'000'000);  // small delays do not add up
}

TEST_CASE("pulses of a machine without its port are counted", "[hal][parport]") {
  auto backend = open_backend(on_port());
  REQUIRE(backend);
  (*backend)->exchange(setpoint_at({0, 0, 0}));
  const Feedback feedback = (*backend)->exchange(setpoint_at({0.0101, 0, 0}));
  CHECK(feedback.position.x() == Approx(0.01));
  CHECK((*backend)->finish());
}

}  // namespace softcnc::hal
