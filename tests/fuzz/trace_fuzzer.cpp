// SPDX-License-Identifier: MIT
// libFuzzer on traces as files: CSV, and arrays in a zip, compressed or not. Every file gives rows
// that a run can have, or an error that names it. The first byte says which form the rest has, as
// checksums would stop almost every mutation of what is compressed or in a zip.
#include <unistd.h>
#include <zstd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "hal/files/zip_file.hpp"
#include "runtime/history/read_trace.hpp"

namespace {

using namespace softcnc;

constexpr unsigned kCompressed = 1, kArrays = 2;  // bits of the first byte
constexpr const char* kColumns[] = {"t_s", "line", "block", "s_mm", "v_mm_s", "limit", "x_mm"};
constexpr std::string_view kBetweenColumns = "\xFE\xFE";

/// In memory where the system allows it.
std::string file(const char* suffix) {
  const char* folder = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
  return std::string(folder) + "/softcnc-fuzz-" + std::to_string(::getpid()) + suffix;
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void write_file(const std::string& name, std::string_view bytes) {
  std::FILE* out = std::fopen(name.c_str(), "wb");
  expect(out != nullptr, "no file");
  std::fwrite(bytes.data(), 1, bytes.size(), out);
  std::fclose(out);
}

std::string compressed(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  return packed;
}

/// Writes a zip whose columns have the pieces of a text.
void write_arrays(const std::string& name, std::string_view bytes) {
  hal::ZipWriter zip(name);
  for (const char* column : kColumns) {
    const auto end = bytes.find(kBetweenColumns);
    zip.add_text(std::string(column) + ".npy", std::string(bytes.substr(0, end)));
    if (end == bytes.npos) break;
    bytes.remove_prefix(end + kBetweenColumns.size());
  }
  expect(zip.finish().has_value(), "no zip");
}

class CheckedRows final : public runtime::RunRowSink {
 public:
  void take(const runtime::RunRow& row) override {
    expect(rows == 0 || row.period > last_.period, "rows out of order");
    expect(row.position.allFinite() && std::isfinite(row.s) && std::isfinite(row.v),
           "a number that no run has");
    last_ = row;
    ++rows;
  }
  std::int64_t rows = 0;

 private:
  runtime::RunRow last_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  const bool is_compressed = (data[0] & kCompressed) != 0, is_arrays = (data[0] & kArrays) != 0;
  static const std::string csv = file(".csv"), npz = file(".npz");
  if (is_arrays)
    write_arrays(npz, rest);
  else
    write_file(csv, is_compressed ? compressed(rest) : std::string(rest));
  CheckedRows rows;
  const auto facts = runtime::read_trace(is_arrays ? npz : csv, rows);
  if (facts) {
    expect(facts->rows == rows.rows, "another number of rows");
    return 0;
  }
  expect(!facts.error().message.empty(), "an error without a text");
  expect(!facts.error().file.empty(), "an error without a file");
  expect(exit_status(facts.error()) == 5, "an error of another family");
  return 0;
}
