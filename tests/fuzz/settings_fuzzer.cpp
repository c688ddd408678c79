// SPDX-License-Identifier: MIT
// libFuzzer on settings of other controls: every text is a machine file that loads, or an error.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "hal/import/import_machine.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/machine/state_file.hpp"

namespace {

using namespace softcnc;

void expect(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
  std::abort();
}

void try_name(const std::string& text, const char* name) {
  const auto imported = hal::import_text(text, name, {});
  if (imported) {
    expect(hal::parse_machine(imported->machine, "made.toml", {}).has_value(),
           "a machine made of settings does not load", imported->machine);
    const std::string state = hal::state_toml(imported->state);
    expect(hal::parse_state(state, "made.state.toml").has_value(),
           "a state made of settings does not load", state);
    return;
  }
  expect(!imported.error().empty(), "refused without an error", {});
  for (const Diagnostic& error : imported.error()) {
    expect(!error.message.empty(), "an error without a text", render(error));
    expect(exit_status(error) == 2, "an error of another family", render(error));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const char* name : {"a", "a.ini", "a.tbl"}) try_name(text, name);
  return 0;
}
