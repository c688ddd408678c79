// SPDX-License-Identifier: MIT
// libFuzzer on Value Change Dumps: every text has edges in the order in which it says them, or is
// an error; and both are the same however the text is cut into pieces.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "hal/signals/vcd_reader.hpp"

namespace {

using namespace softcnc;

/// All edges and what is wrong, in one text.
std::string heard(std::string_view text, std::size_t piece) {
  std::string all;
  hal::VcdReader reader([&](const hal::ReadEdge& read) {
    all += std::to_string(read.edge.time) + '/' + std::to_string(read.edge.axis) +
           (read.edge.high ? '+' : '-') + std::to_string(read.pos.line) + ':' +
           std::to_string(read.pos.column) + ' ';
  });
  for (; !text.empty(); text.remove_prefix(std::min(piece, text.size())))
    if (const Status read = reader.read(text.substr(0, piece)); !read)
      return all + read.error().message;
  const Status finished = reader.finish();
  return finished ? all : all + finished.error().message;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string whole = heard(text, std::max<std::size_t>(1, size));
  const std::string cut = heard(text, 1 + size % 7);
  if (whole == cut) return 0;
  std::fprintf(stderr, "in one piece: %s\nin several: %s\n", whole.c_str(), cut.c_str());
  std::abort();
}
