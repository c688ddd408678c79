// SPDX-License-Identifier: MIT
// libFuzzer on state files: every text is a state that can be written and read again, or an error.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "hal/machine/state_file.hpp"

namespace {

using namespace softcnc;

void expect(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto state =
      hal::parse_state({reinterpret_cast<const char*>(data), size}, "fuzz.state.toml");
  if (state) {
    const std::string text = hal::state_toml(*state);
    expect(hal::parse_state(text, "again.state.toml").has_value(), "a state written does not load",
           text);
    return 0;
  }
  expect(!state.error().empty(), "refused without an error", {});
  for (const Diagnostic& error : state.error()) {
    expect(!error.message.empty(), "an error without a text", render(error));
    expect(exit_status(error) == 2, "an error of another family", render(error));
  }
  return 0;
}
