// SPDX-License-Identifier: MIT
// Plans a program and prints where the machine is, every tenth of a second: 02_plan PART
#include <iostream>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto program = cnc::Program::open(argv[1]);
  if (!program) return 2;
  const auto trajectory = cnc::plan(*program, cnc::Machine());
  if (!trajectory) {
    for (const cnc::Diagnostic& error : trajectory.errors()) std::cerr << error.text;
    return 1;
  }
  std::cout << "t_s,x_mm,y_mm,z_mm,v_mm_s,limit\n";
  const int tenths = static_cast<int>(trajectory->duration() * 10);
  for (int i = 0; i <= tenths; ++i) {
    const cnc::Motion motion = trajectory->at(0.1 * i);
    std::cout << 0.1 * i << ',' << motion.position.x() << ',' << motion.position.y() << ','
              << motion.position.z() << ',' << motion.v << ',' << motion.limit << '\n';
  }
}
