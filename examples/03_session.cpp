// SPDX-License-Identifier: MIT
// Runs a program on the machine's backend and prints the last row: 03_session PART [MACHINE]
#include <fstream>
#include <iostream>
#include <iterator>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto machine = argc > 2 ? cnc::Machine::load(argv[2]) : cnc::Machine();
  if (!machine) return 2;
  auto session = cnc::Session::open(*machine);
  if (!session) return 5;
  std::ifstream part(argv[1]);
  session->feed(std::string(std::istreambuf_iterator<char>(part), {}));
  session->end();

  std::cout.precision(17);
  cnc::Setpoint last;
  do {
    while (const auto row = session->step()) last = row->setpoint;
    session->resume();  // nobody is asked at M00
  } while (session->status() == cnc::SessionStatus::running);
  std::cout << "rows " << last.period + 1 << "\nx_mm " << last.position.x() << "\ny_mm "
            << last.position.y() << '\n';
  for (std::size_t i = 0; i < session->columns().size(); ++i)
    std::cout << session->columns()[i] << ' ' << session->values()[i] << '\n';
  return session->diagnostics().empty() ? 0 : 1;
}
