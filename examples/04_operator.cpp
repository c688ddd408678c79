// SPDX-License-Identifier: MIT
// An operator at the machine: a line, a move by hand, a program with a hold in the middle of it, an
// emergency stop, and homing after it.
#include <iostream>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

namespace {

void show(const cnc::Operator& machine, const char* what) {
  std::cout << what << ": " << name(machine.mode()) << " at " << machine.position().transpose()
            << '\n';
}

/// One period after the other, as a clock would.
void run(cnc::Operator& machine, int periods) {
  for (int i = 0; i < periods; ++i) machine.step();
}

}  // namespace

int main() {
  const auto mill = cnc::Machine().with(
      {"axis.x.home.search_mm_min=-3000", "axis.y.home.search_mm_min=-3000",
       "axis.z.home.search_mm_min=1500", "axis.x.home.switch_mm=-30", "axis.y.home.switch_mm=-30",
       "axis.z.home.switch_mm=50", "axis.x.home.order=2", "axis.y.home.order=2"});
  if (!mill) return 2;
  auto machine = cnc::Operator::open(*mill);
  if (!machine) return 5;
  const int minute = 60'000;  // periods of 1 ms

  machine->line("G21 G90 G01 X20 F1200\n");
  run(*machine, minute);
  show(*machine, "after a line");
  machine->jog({{0, 5, 0}, 20});
  run(*machine, minute);
  show(*machine, "after a jog");
  if (const auto refused = machine->jog({{5000, 0, 0}, 20})) std::cout << refused->text;

  machine->start("G01 X100 F3000\nM30\n");
  run(*machine, 200);
  machine->hold();
  run(*machine, 500);
  show(*machine, "held");
  machine->jog({{0, 0, 10}, 20});  // to look at the tool
  run(*machine, minute);
  std::cout << "the way back leads to " << machine->return_point()->transpose() << '\n';
  machine->resume();
  run(*machine, minute);
  show(*machine, "after the program");

  machine->start("G01 X0 F3000\nM30\n");
  run(*machine, 200);
  machine->estop();
  show(*machine, "after an emergency stop");
  std::cout << (machine->knows_position() ? "position known\n" : "position not known\n");
  machine->home();
  run(*machine, minute);
  machine->line("G53 G00 X0 Y0 Z0\n");
  run(*machine, minute);
  show(*machine, "homed, and at machine zero");
}
