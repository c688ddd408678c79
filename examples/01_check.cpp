// SPDX-License-Identifier: MIT
// Prints all that is wrong with a part program: 01_check PART [MACHINE]
#include <iostream>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto program = cnc::Program::open(argv[1]);
  const auto machine = argc > 2 ? cnc::Machine::load(argv[2]) : cnc::Machine();
  for (const auto& error : program ? std::vector<cnc::Diagnostic>() : program.errors())
    std::cout << error.text;
  for (const auto& error : machine ? std::vector<cnc::Diagnostic>() : machine.errors())
    std::cout << error.text;
  if (!program || !machine) return 2;
  bool good = true;
  for (const cnc::Diagnostic& diagnostic : cnc::check(*program, *machine)) {
    std::cout << diagnostic.text;
    good = good && diagnostic.severity != cnc::Severity::error;
  }
  return good ? 0 : 1;
}
