// SPDX-License-Identifier: MIT
// libFuzzer on lists of edges as files: of any form, compressed or not. Every file is a list that
// can be read to its end, or an error that names it. An odd first byte has the rest compressed, as
// checksums would stop almost every mutation of what is.
#include <unistd.h>
#include <zstd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "hal/files/compressed_file.hpp"
#include "hal/signals/edge_reader.hpp"

namespace {

using namespace softcnc;

/// In memory where the system allows it.
const std::string& file() {
  static const std::string name = [] {
    const char* folder = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
    return std::string(folder) + "/softcnc-fuzz-" + std::to_string(::getpid()) + ".edges";
  }();
  return name;
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void write_file(std::string_view bytes) {
  std::FILE* out = std::fopen(file().c_str(), "wb");
  expect(out != nullptr, "no file");
  std::fwrite(bytes.data(), 1, bytes.size(), out);
  std::fclose(out);
}

std::string compressed(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  return packed;
}

Status read_all(std::int64_t& edges) {
  auto packed = hal::CompressedFile::open(file(), Code::SC6090, Code::SC6091);
  if (!packed) return tl::make_unexpected(packed.error());
  hal::EdgeReader reader([&](const hal::ReadEdge& read) {
    expect(read.edge.time >= 0, "an edge before the first instant");
    ++edges;
  });
  for (;;) {
    const auto bytes = packed->next();
    if (!bytes) return tl::make_unexpected(bytes.error());
    if (bytes->empty()) return reader.finish();
    if (Status read = reader.read(*bytes); !read) return read;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string_view rest = bytes.substr(size > 0 ? 1 : 0);
  write_file(size > 0 && (data[0] & 1U) != 0 ? compressed(rest) : std::string(rest));
  std::int64_t edges = 0;
  const Status read = read_all(edges);
  if (read) return 0;
  expect(!read.error().message.empty(), "an error without a text");
  expect(exit_status(read.error()) == 5, "an error of another family");
  return 0;
}
