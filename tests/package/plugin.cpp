// SPDX-License-Identifier: MIT
// A shared library of someone else that uses softcnc.
#include <softcnc/softcnc.hpp>

extern "C" double duration(const char* file) {
  const auto program = softcnc::api::Program::open(file);
  if (!program) return -1;
  const auto trajectory = softcnc::api::plan(*program, softcnc::api::Machine());
  return trajectory ? trajectory->duration() : -1;
}
