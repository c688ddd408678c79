// SPDX-License-Identifier: MIT
// libFuzzer on the machine file: every text is a machine that reads back, or an error with a place.
// The first line of the bytes is a setting, as after --set, and the rest the file.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "hal/backends/backend.hpp"
#include "hal/machine/machine_file.hpp"

namespace {

using namespace softcnc;

void expect(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
  std::abort();
}

void try_machine(const Machine& machine) {
  const std::string text = hal::machine_toml(machine);
  const auto again = hal::parse_machine(text, "again.toml", {});
  expect(again.has_value(), "a machine written out does not load", text);
  expect(hal::machine_toml(*again) == text, "a machine reads back as another", text);
  const auto backend = hal::open_backend(hal::without_port(machine));  // no file of its choice
  expect(backend.has_value(), "a machine has no backend", text);
  Setpoint setpoint;
  for (int i = 0; i < 3; ++i) {
    setpoint.position.setConstant(i * 0.1);
    const Feedback feedback = (*backend)->exchange(setpoint);
    expect(feedback.position.allFinite(), "the mill is nowhere", text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto end = std::min(bytes.find('\n'), bytes.size());
  const std::string text = bytes.substr(std::min(end + 1, bytes.size()));
  std::vector<std::string> settings;
  if (end > 0) settings.push_back(bytes.substr(0, end));
  const auto machine = hal::parse_machine(text, "fuzz.toml", settings);
  if (machine) {
    try_machine(*machine);
  } else {
    expect(!machine.error().empty(), "refused without an error", text);
    for (const Diagnostic& error : machine.error()) {
      expect(error.pos.line > 0 && error.pos.column > 0, "an error without a place", render(error));
      expect(exit_status(error) == 2, "an error of another family", render(error));
    }
  }
  return 0;
}
