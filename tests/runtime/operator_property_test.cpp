// SPDX-License-Identifier: MIT
// Random operators: whatever is requested, and whenever, all limits are kept in every row, rows
// count on, nothing hangs, and a program that was held ends as one that was not. SOFTCNC_SESSIONS
// sets how many are tried: scripts/stress operators.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <string>

#include "support/operated.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using namespace softcnc::test;

namespace {

int sessions_to_try() {
  const char* asked = std::getenv("SOFTCNC_SESSIONS");
  return asked != nullptr ? std::atoi(asked) : 200 / kPart;
}

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  int below(int end) { return static_cast<int>(engine_() % static_cast<unsigned>(end)); }
  double from_to(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }

 private:
  std::mt19937 engine_;
};

/// Some moves of all kinds within the travel, in the given modes.
std::string random_lines(Chance& chance, int count) {
  std::string text = "G90 G21 G94 F" + std::to_string(600 + chance.below(9000)) + "\n";
  const auto number = [&](double most) { return std::to_string(chance.from_to(-most, most)); };
  for (int i = 0; i < count; ++i) switch (chance.below(8)) {
      case 0:
        text += "G00 X" + number(60) + " Z" + number(20) + "\n";
        break;
      case 1:
        text += "G91 G02 X4 Y4 I4 J0\nG90\n";
        break;
      case 2:
        text += "G04 P0.05\n";
        break;
      case 3:
        text += "M03 S" + std::to_string(100 + chance.below(900)) + "\n";
        break;
      case 4:
        text += "G64 P0.05\nG01 X" + number(30) + "\nY" + number(30) + "\nX" + number(30) + "\n";
        break;
      default:
        text += "G01 X" + number(60) + " Y" + number(60) + "\n";
    }
  return text;
}

Jog random_jog(Chance& chance) {
  Jog jog{AxisVector(chance.from_to(-20, 20), chance.from_to(-20, 20), chance.from_to(-5, 5)),
          chance.from_to(1, 300), chance.below(3) == 0};
  for (int axis = 0; axis < kAxes; ++axis)
    if (chance.below(2) == 0) jog.distance[axis] = 0;
  return jog;
}

void request_something(Desk& desk, Chance& chance) {
  Operator& operated = desk.operated;
  switch (chance.below(16)) {
    case 0:
    case 1:
      return static_cast<void>(operated.line(random_lines(chance, 1 + chance.below(3))));
    case 2:
      return static_cast<void>(operated.start(random_lines(chance, 5) + "M30\n"));
    case 3:
    case 4:
      return static_cast<void>(operated.jog(random_jog(chance)));
    case 5:
      return static_cast<void>(operated.cancel());
    case 6:
      return static_cast<void>(operated.hold());
    case 7:
    case 8:
      return static_cast<void>(operated.resume());
    case 9:
      return operated.set_feed_override(chance.from_to(0, 2.5));
    case 10:
      return operated.set_rapid_override(chance.from_to(0, 1.2));
    case 11:
      return static_cast<void>(chance.below(2) == 0 ? operated.abort() : operated.reset());
    case 12:
      return static_cast<void>(operated.unlock());
    case 13:
      if (chance.below(2) == 0) return operated.door_closed();
      return static_cast<void>(operated.door());
    case 14: {
      const int axis = chance.below(3);
      return operated.limit_switch(axis, operated.position()[axis] > 0 ? 1 : -1);
    }
    default:
      return static_cast<void>(operated.check());
  }
}

/// Leads the machine to Idle as an operator would, from wherever it is.
void come_to_idle(Desk& desk) {
  Operator& operated = desk.operated;
  desk.settle();
  desk.run(20'000, [&] { return !operated.moving() && operated.mode() != MachineMode::jog; });
  if (operated.mode() == MachineMode::check) REQUIRE(operated.check());
  operated.door_closed();
  static_cast<void>(operated.reset());
  desk.run(20'000, [&] {
    return operated.mode() == MachineMode::alarm || operated.mode() == MachineMode::idle;
  });
  desk.run(20'000, [&] { return !operated.moving(); });
  desk.run(10);
  if (operated.mode() == MachineMode::alarm && !operated.unlock()) {
    for (const int direction : {-1, 1})
      for (int axis = 0; axis < kAxes; ++axis)
        static_cast<void>(operated.jog({0.5 * direction * AxisVector::Unit(axis), 50}));
    desk.run(20'000, [&] { return operated.unlock().has_value(); });
  }
  REQUIRE(operated.mode() == MachineMode::idle);
}

}  // namespace

TEST_CASE("no operator makes the machine exceed a limit, lose rows or hang",
          "[runtime][operator][property]") {
  const int count = sessions_to_try();
  for (int i = 0; i < count; ++i) {
    Chance chance(static_cast<unsigned>(seed() + static_cast<unsigned>(i)));
    CAPTURE(i);
    Desk desk(chance.below(3) == 0 ? BackendKind::sim : BackendKind::none,
              chance.below(2) == 0 ? 0 : 20'000);
    for (int k = 0; k < 40; ++k) {
      request_something(desk, chance);
      desk.run(chance.below(400));
    }
    come_to_idle(desk);
    CHECK(desk.operated.knows_position());
    REQUIRE(desk.operated.line("G90 G00 X1 Y2 Z3\n"));
    desk.settle();
    CHECK(desk.operated.position().x() ==
          Approx(1 + desk.operated.state().work[0].origin.x()).margin(1e-9));
    desk.check_limits();
  }
}

TEST_CASE("a program that is held, slowed down and left by hand ends where it would",
          "[runtime][operator][property]") {
  const int count = sessions_to_try();
  for (int i = 0; i < count; ++i) {
    Chance chance(static_cast<unsigned>(seed() + static_cast<unsigned>(i)));
    CAPTURE(i);
    const BackendKind kind = chance.below(2) == 0 ? BackendKind::sim : BackendKind::stepdir;
    const double jerk = chance.below(2) == 0 ? 0 : 20'000;
    const std::string program = random_lines(chance, 6) + "M30\n";
    Desk undisturbed(kind, jerk), desk(kind, jerk);
    REQUIRE(undisturbed.operated.start(program));
    undisturbed.settle();
    REQUIRE(desk.operated.start(program));
    while (desk.operated.mode() != MachineMode::idle) {
      desk.run(chance.below(600));
      if (desk.operated.mode() != MachineMode::run) break;
      if (chance.below(3) == 0) desk.operated.set_feed_override(chance.from_to(0.1, 2));
      if (chance.below(3) == 0) desk.operated.set_rapid_override(chance.from_to(0.25, 1));
      REQUIRE(desk.operated.hold());
      desk.run(1 + chance.below(800));
      const bool is_held = desk.operated.mode() == MachineMode::hold;
      if (is_held && chance.below(2) == 0 && desk.operated.jog(random_jog(chance))) {
        desk.run(chance.below(400));
        REQUIRE(desk.operated.cancel());
      }
      desk.run(20'000, [&] { return desk.operated.resume().has_value(); });
    }
    desk.settle();
    CHECK(desk.operated.mode() == MachineMode::idle);
    CHECK(desk.operated.position() == undisturbed.operated.position());
    if (kind == BackendKind::stepdir)  // counts of pulses
      CHECK(desk.backend->settle() == undisturbed.backend->settle());
    CHECK(desk.operated.state().work == undisturbed.operated.state().work);
    desk.check_limits();
  }
}
