// SPDX-License-Identifier: MIT
// An operator at the machine: moves line by line, a hold, an override, and a rest wherever the
// lines pause, so that no move waits for the one after it.
#include <iostream>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

int main() {
  auto session = cnc::Session::open(cnc::Machine());
  if (!session) return 5;
  double x = 0;
  const auto run = [&](int periods) {
    for (; periods != 0; --periods) {
      const auto row = session->step();
      if (!row) return;
      x = row->setpoint.position.x();
    }
  };
  constexpr int kToTheEnd = -1;

  session->feed("G21 G90 G01 X20 F1200\n");
  session->rest();
  run(kToTheEnd);
  std::cout << "after the first line: " << x << " mm\n";

  session->feed("X100\n");
  session->rest();
  run(50);
  session->hold();
  run(50);
  const double held = x;
  run(50);
  std::cout << (x == held && x < 100 ? "held on the way\n" : "not held\n");
  session->set_feed_override(1.5);
  session->resume();
  run(kToTheEnd);
  std::cout << "after the second line: " << x << " mm\n";

  session->feed("X0\n");
  session->end();
  run(50);
  session->abort();
  run(kToTheEnd);
  std::cout << (session->status() == cnc::SessionStatus::done && x > 0 ? "aborted on the way\n"
                                                                       : "not aborted\n");
}
