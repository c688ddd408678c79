// SPDX-License-Identifier: MIT
// libFuzzer on the way from bytes to blocks: what holds for every program holds for these bytes,
// whichever way they are to be read. Which way goes by their number, so that every file is a seed.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "ipr/invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace softcnc::ipr;
  const std::string text(reinterpret_cast<const char*>(data), size);
  InterpreterOptions options;
  options.dialect = kAllDialects[size % kDialects];
  options.guess_dialect = size % 7 == 0;
  options.block_skip = size % 3 == 0;
  options.optional_stop = options.block_skip;
  options.unreachable_too = options.compare_dialects = size % 5 != 0;
  const std::string broken = broken_invariant(text, options);
  if (broken.empty()) return 0;
  std::fprintf(stderr, "%s\n", broken.c_str());
  std::abort();
}
