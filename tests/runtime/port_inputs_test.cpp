// SPDX-License-Identifier: MIT
// A mill behind a parallel port: its switches, its probe and its door follow the very steps that
// are written, and are read a while before the next are planned.
#include <catch2/catch.hpp>
#include <memory>
#include <random>
#include <utility>

#include "hal/backends/stepdir.hpp"
#include "hal/ports/port_edges.hpp"
#include "hal/ports/port_output.hpp"
#include "hal/ports/port_timing.hpp"
#include "runtime/realtime/realtime_queue.hpp"
#include "support/operated.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using namespace softcnc::test;

namespace {

constexpr double kPortAhead = 0.1;  // s of words
constexpr int kHomeX = 12, kHomeYZ = 13, kProbe = 15, kDoor = 11, kEstop = 10;

Machine mill_on_port() {
  Machine machine = machine_to_operate(BackendKind::parport, 0);
  const double ends[] = {51.3, -48.2, 20.125}, searches[] = {20, -15, 10};
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    Axis& axis = machine.axes[i];
    axis.velocity = 20;
    axis.min = -60;
    axis.max = 60;
    axis.home = {searches[i], 0, 3, ends[i], i == 2 ? 1 : 2};
  }
  ParallelPort& port = machine.parallel_port;
  port.home_pin = {kHomeX, kHomeYZ, kHomeYZ};
  port.probe_pin = kProbe;
  port.door_pin = -kDoor;
  port.estop_pin = kEstop;
  machine.axes[1].home.order = 3;
  return machine;
}

/// The mill itself: it counts steps, and its contacts are at counts.
struct Mill {
  std::array<std::int64_t, kAxes> counts{};  // from where it stood at first
  std::array<std::int64_t, kAxes> switches{};
  std::array<int, kAxes> directions{};
  std::int64_t floor = -1'000'000;  // of Z: from there down the probe touches
  bool door = false, estop = false;
  std::optional<std::int64_t> contact;  // where Z was when it touched last

  bool is_home(std::size_t axis) const {
    return (counts[axis] - switches[axis]) * directions[axis] >= 0;
  }
};

/// The registers of the port of that mill. Pins 2 to 7 are bits 0 to 5 of the data.
class MillPort final : public hal::PortRegisters {
 public:
  explicit MillPort(Mill& mill) : mill_(mill) {}

  bool write_data(std::uint8_t bits) noexcept override {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint8_t step = static_cast<std::uint8_t>(1U << (2 * axis));
      const bool rises = (bits & step) != 0 && (data_ & step) == 0;
      const bool back = (bits >> (2 * axis + 1) & 1U) != 0;
      if (rises) mill_.counts[axis] += back ? -1 : 1;
    }
    data_ = bits;
    if (!mill_.contact && mill_.counts[2] <= mill_.floor) mill_.contact = mill_.counts[2];
    return true;
  }
  bool write_control(std::uint8_t) noexcept override { return true; }
  std::optional<std::uint8_t> read_status() noexcept override {
    unsigned bits = 0;
    const auto set = [&](bool high, unsigned bit) { bits |= high ? bit : 0U; };
    set(mill_.estop, 0x40);       // pin 10
    set(mill_.door, 0x80);        // 11: the port inverts it, and so does the machine
    set(mill_.is_home(0), 0x20);  // 12
    set(mill_.is_home(1) || mill_.is_home(2), 0x10);  // 13
    set(mill_.counts[2] <= mill_.floor, 0x08);        // 15
    return static_cast<std::uint8_t>(bits);
  }
  Diagnostic failure() const override { return {Code::SC6074, {}, "it never fails", "port", {}}; }

 private:
  Mill& mill_;
  std::uint8_t data_ = 0;
};

/// Plays as the real-time thread does, a period at a time.
class DrivenPlayer final : public hal::PortPlayer {
 public:
  DrivenPlayer(const Machine& machine, Mill& mill)
      : output_(std::make_unique<MillPort>(mill), machine),
        base_(machine.parallel_port.base_period),
        ticks_(static_cast<int>(machine.control.period / base_)) {
    begin();
  }

  void pass_period() noexcept {
    for (int i = 0; i < ticks_ && alarm_ == Alarm::none; ++i) {
      alarm_ = look();
      if (alarm_ == Alarm::none) write_next();
    }
  }

  Alarm play(std::span<const hal::PortWord> words) noexcept override {
    for (const hal::PortWord& word : words) {
      while (alarm_ == Alarm::none && !words_->push(word)) pass_period();
    }
    return alarm_;
  }
  void rest() noexcept override { words_->rest(); }
  double ahead() const noexcept override { return kPortAhead; }
  void follow(double lead) noexcept override {
    words_->begin_at(static_cast<std::size_t>(lead / base_) / 2);
  }
  bool next_change(hal::PortChange& change) noexcept override {
    if (changes_.empty()) return false;
    change = changes_.front();
    changes_.erase(changes_.begin());
    return true;
  }
  Alarm alarm() const noexcept override { return alarm_; }
  Diagnostic trouble() const override { return output_.diagnostic(alarm_); }
  Status recover() override {
    begin();
    if (alarm_ == Alarm::none) return {};
    return tl::make_unexpected(trouble());
  }
  Status finish() override { return {}; }

 private:
  void begin() {
    words_.emplace(static_cast<std::size_t>(kPortAhead / base_) + 16);
    written_ = 0;
    alarm_ = look();
    if (alarm_ == Alarm::none) alarm_ = output_.write(output_.pins().enabled());
  }
  Alarm look() {
    const Alarm alarm = output_.look();
    if (output_.inputs() != seen_) changes_.push_back({written_, output_.inputs()});
    seen_ = output_.inputs();
    return alarm;
  }
  void write_next() noexcept {
    hal::PortWord word;
    const auto next = words_->take(word);
    using Next = RealtimeQueue<hal::PortWord>::Next;
    if (next == Next::missing) alarm_ = Alarm::overrun;
    if (next != Next::item) return;
    ++written_;
    alarm_ = output_.write(word);
  }

  hal::PortOutput output_;
  double base_;
  int ticks_;
  std::optional<RealtimeQueue<hal::PortWord>> words_;
  std::int64_t written_ = 0;
  hal::InputLevels seen_;
  std::vector<hal::PortChange> changes_;
  Alarm alarm_ = Alarm::none;
};

/// An operator at that mill. The clock of the port is some periods behind the one of the rows.
struct PortShop {
  explicit PortShop(const Machine& on = mill_on_port()) : machine(on), desk(on, backend()) {}

  std::unique_ptr<hal::Backend> backend() {
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
      mill.switches[i] = counts(i, machine.axes[i].home.place);
      mill.directions[i] = machine.axes[i].home.search < 0 ? -1 : 1;
    }
    auto owned = std::make_unique<DrivenPlayer>(machine, mill);
    player = owned.get();
    return std::make_unique<hal::StepDir>(
        machine, hal::port_timing(machine).rules,
        std::make_unique<hal::PortEdges>(machine, std::move(owned)));
  }
  std::int64_t counts(std::size_t axis, double place) const {
    return std::llround(place / machine.axes[axis].blu);
  }
  /// As softcnc operate does.
  void pass() {
    for (;; ++next) {
      const int lead = desk.operated.awaits_input() ? kShortLead : kLead;
      desk.backend->follow(lead * machine.control.period);
      if (next > now + lead) break;
      desk.operated.step();
    }
    player->pass_period();
    ++now;
  }
  void run(int periods) {
    for (int i = 0; i < periods; ++i) pass();
  }
  void settle() {
    for (int i = 0; i < 300'000 && desk.operated.in_motion(); ++i) pass();
    REQUIRE_FALSE(desk.operated.in_motion());
    run(200);  // what waits is played
  }

  static constexpr int kLead = 100, kShortLead = 30;  // periods

  Machine machine;
  int now = 0, next = 0;  // periods
  Mill mill;
  DrivenPlayer* player = nullptr;
  Desk desk;
};

}  // namespace

TEST_CASE("a mill behind a port is homed to one BLU by the steps that its switches saw",
          "[runtime][homing][parport][property]") {
  std::mt19937 engine(50);
  std::uniform_real_distribution<double> part(-0.8, 0.8);
  for (int i = 0; i < std::max(programs_asked(4) / kPart, 1); ++i) {
    CAPTURE(i);
    PortShop shop;
    AxisVector from;  // where it stands, while the control believes 0
    for (int axis = 0; axis < kAxes; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      from[axis] = (axis == 2 ? 15 : 45) * part(engine);
      shop.mill.switches[a] -= shop.counts(a, from[axis]);
    }
    REQUIRE(shop.desk.operated.home());
    shop.settle();
    CHECK(shop.desk.messages == std::vector<std::string>{});
    REQUIRE(shop.desk.operated.has_homed());
    CHECK(shop.desk.operated.knows_position());
    for (int axis = 0; axis < kAxes; ++axis) {
      const Axis& of = shop.machine.axes[static_cast<std::size_t>(axis)];
      const double blu = of.blu;
      const double true_place =
          from[axis] + blu * static_cast<double>(shop.mill.counts[static_cast<std::size_t>(axis)]);
      CAPTURE(axis);
      CHECK(std::abs(shop.desk.operated.position()[axis] - true_place) <= 1.5 * blu);
      CHECK(shop.desk.operated.position()[axis] == Approx(of.home.rest()).margin(0.05));
    }
    shop.desk.check_limits();
  }
}

TEST_CASE("a contact behind a port is that of the step at which it came",
          "[runtime][probing][parport]") {
  for (const double feed : {30.0, 300.0, 1000.0}) {
    CAPTURE(feed);
    PortShop shop;
    shop.mill.floor = -2222;
    REQUIRE(shop.desk.operated.line("G38.2 Z-20 F" + std::to_string(feed) + "\n"));
    shop.settle();
    CHECK(shop.desk.errors.empty());
    const double blu = shop.machine.axes[2].blu;
    REQUIRE(shop.mill.contact);
    CHECK(shop.desk.operated.memory().parameters.read(5070) == 1);
    CHECK(*shop.desk.operated.memory().parameters.read(5063) ==
          Approx(static_cast<double>(*shop.mill.contact) * blu).margin(1.01 * blu));
    const double further = feed / 60 * 0.04 + 0.15;  // what had been planned already, and the ramp
    CHECK(shop.desk.operated.position()[2] > -2222 * blu - further);
    REQUIRE(shop.desk.operated.line("G00 Z1\n"));
    shop.settle();
    CHECK(shop.mill.counts[2] == std::llround(1 / blu));  // no step is lost or invented
    shop.desk.check_limits();
  }
}

TEST_CASE("a probe that touches when its move begins is seen, whatever was planned before",
          "[runtime][probing][parport]") {
  PortShop shop;
  shop.mill.floor = -400;
  REQUIRE(shop.desk.operated.line("G00 Z-1\nG38.2 Z-20 F100\n"));
  shop.settle();
  CHECK(shop.desk.errors == std::vector{Code::SC2393});
  shop.desk.errors.clear();
  REQUIRE(shop.desk.operated.line("G00 Z-0.5\nG38.2 Z-20 F100\n"));
  shop.settle();
  CHECK(shop.desk.errors.empty());
}

TEST_CASE("an input that opens the door stops the program, and its end lets it go on",
          "[runtime][operator][parport]") {
  PortShop shop;
  REQUIRE(shop.desk.operated.start("G21 G90 G94\nM03 S1000\nG01 X20 F600\nM30\n"));
  shop.run(800);
  REQUIRE(shop.desk.operated.mode() == MachineMode::run);
  shop.mill.door = true;
  shop.run(600);
  CHECK(shop.desk.operated.mode() == MachineMode::door);
  CHECK(shop.desk.operated.outputs().spindle_rpm == 0);
  CHECK_FALSE(shop.desk.operated.resume());
  shop.mill.door = false;
  shop.run(200);
  REQUIRE(shop.desk.operated.resume());
  shop.settle();
  CHECK(shop.desk.operated.has_completed());
  CHECK(shop.mill.counts[0] == shop.counts(0, 20));
  shop.mill.door = true;  // in Idle, too
  shop.run(5);
  CHECK(shop.desk.operated.mode() == MachineMode::door);
}

TEST_CASE("after an emergency stop at the port the machine is enabled, homed and run again",
          "[runtime][operator][parport]") {
  PortShop shop;
  REQUIRE(shop.desk.operated.start("G21 G90 G94\nG01 X20 F600\nM30\n"));
  shop.run(800);
  shop.mill.estop = true;
  shop.run(5);
  CHECK(shop.desk.operated.mode() == MachineMode::alarm);
  CHECK(shop.desk.errors == std::vector{Code::SC5031});
  CHECK_FALSE(shop.desk.operated.knows_position());
  const Status pressed = shop.desk.operated.unlock();
  REQUIRE_FALSE(pressed);
  CHECK(pressed.error().code == Code::SC5031);
  CHECK_FALSE(shop.desk.operated.home());
  CHECK(shop.desk.operated.mode() == MachineMode::alarm);
  shop.mill.estop = false;
  REQUIRE(shop.desk.operated.home());
  shop.settle();
  REQUIRE(shop.desk.operated.has_homed());
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(shop.desk.operated.position()[static_cast<Eigen::Index>(axis)] ==
          Approx(shop.machine.axes[axis].blu * static_cast<double>(shop.mill.counts[axis]))
              .margin(1.5 * shop.machine.axes[axis].blu));
  REQUIRE(shop.desk.operated.start("G21 G90 G94\nG01 X20 F600\nM30\n"));
  shop.settle();
  CHECK(shop.desk.operated.has_completed());
  CHECK(std::abs(shop.mill.counts[0] - shop.counts(0, 20)) <= 1);
}

TEST_CASE("a switch, probe or door that is stuck is seen before anything moves towards it",
          "[runtime][operator][parport]") {
  SECTION("a home switch that is closed") {
    PortShop shop;
    shop.mill.switches[0] = -10;
    REQUIRE(shop.desk.operated.home());
    shop.settle();
    CHECK(shop.desk.operated.mode() == MachineMode::alarm);
    REQUIRE(shop.desk.errors == std::vector{Code::SC5090});
    CHECK(shop.desk.messages.front().find("the home switch of X is closed already") !=
          std::string::npos);
    CHECK(shop.mill.counts == std::array<std::int64_t, kAxes>{});
  }
  SECTION("a home switch that never closes") {
    PortShop shop;
    shop.mill.switches[2] = 1'000'000;
    REQUIRE(shop.desk.operated.home());
    shop.settle();
    CHECK(shop.desk.errors == std::vector{Code::SC5090});
    CHECK(shop.mill.counts[2] <= shop.counts(2, 120 + 7));
  }
  SECTION("a machine without a pin for a switch") {
    Machine machine = mill_on_port();
    machine.parallel_port.home_pin[1] = 0;
    PortShop shop(machine);
    CHECK_FALSE(shop.desk.operated.home());
  }
}
