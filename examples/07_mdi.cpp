// SPDX-License-Identifier: MIT
// A console for single lines, as the MDI of a control: each line of standard input is run, a wrong
// one is reported and changes nothing, and place and offsets of earlier sessions come from a state
// file and go back to it:
//
//   echo 'G01 X10 F600' | 07_mdi offsets.toml
#include <fstream>
#include <iostream>
#include <softcnc/softcnc.hpp>
#include <string>

namespace cnc = softcnc;

int main(int argc, char** argv) {
  cnc::RunOptions options;
  if (argc > 1 && std::ifstream(argv[1])) {
    auto state = cnc::State::load(argv[1]);
    if (!state) {
      for (const cnc::Diagnostic& error : state.errors()) std::cerr << error.text;
      return 2;
    }
    options.state = *state;
  }
  auto session = cnc::Session::open(cnc::Machine(), options);
  if (!session) return 5;

  std::size_t shown = 0;
  for (std::string line; std::getline(std::cin, line);) {
    if (!session->feed(line + '\n')) break;
    session->rest();
    do {
      session->resume();  // nobody changes tools here
      while (session->step()) {
      }
    } while (session->status() == cnc::SessionStatus::paused);
    const auto found = session->diagnostics();
    for (; shown < found.size(); ++shown) std::cout << found[shown].text;
    if (session->status() == cnc::SessionStatus::error) session->go_on();
    std::cout << "at " << session->position().transpose() << '\n';
    if (session->status() == cnc::SessionStatus::alarm) std::cout << "alarm\n";
    if (session->status() == cnc::SessionStatus::done) std::cout << "the program has ended\n";
  }
  if (argc > 1) std::ofstream(argv[1]) << session->state().toml();
}
