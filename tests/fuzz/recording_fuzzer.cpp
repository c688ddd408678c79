// SPDX-License-Identifier: MIT
// libFuzzer on recordings: every sequence of bytes is a recording that can be read to its end, or
// an error that names the file.
//
// Checksums and hashes would stop almost every mutation at the door. So the first byte says what
// the rest is: the file itself, or its four entries, parted by byte 0x1F, to be packed into a whole
// zip: with their hashes put right, and with the trace compressed.
#include <unistd.h>
#include <zstd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "hal/files/hash.hpp"
#include "hal/machine/machine_file.hpp"
#include "recording/recording.hpp"
#include "recording/recording_meta.hpp"
#include "recording/trace_comparison.hpp"

namespace {

using namespace softcnc;
using Json = nlohmann::ordered_json;

enum Flag : std::uint8_t { packed = 1, hashed = 2, compressed = 4 };
constexpr char kParting = 0x1F;

void expect(bool holds, const char* what, const std::string& text = {}) {
  if (holds) return;
  std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
  std::abort();
}

/// In memory where the system allows it.
const std::string& file() {
  static const std::string name = [] {
    const char* folder = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
    return std::string(folder) + "/softcnc-fuzz-" + std::to_string(::getpid()) + ".rec";
  }();
  return name;
}

struct Entries {
  std::array<std::string, 4> text;  // meta.json, program, machine.toml, trace.csv.zst
};

Entries split(std::string_view bytes) {
  Entries entries;
  for (std::string& entry : entries.text) {
    const auto end = &entry == &entries.text.back() ? bytes.size() : bytes.find(kParting);
    entry = bytes.substr(0, end);
    bytes.remove_prefix(std::min(bytes.size(), entry.size() + 1));
  }
  return entries;
}

/// At once and quickly: tables that go by the length of the text.
std::string compress(std::string_view text) {
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 1));
  return packed;
}

void put_hashes(Entries& entries) {
  Json meta = Json::parse(entries.text[0], nullptr, false);
  if (!meta.is_object()) return;
  const std::array<const char*, 3> names{"program", "machine", "trace"};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (meta.contains(names[i]) && meta[names[i]].is_object())
      meta[names[i]]["hash"] = hal::hash_hex(entries.text[i + 1]);
  entries.text[0] = app::sealed_meta(meta.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void pack(Entries entries) {
  hal::ZipWriter zip(file());
  zip.add_text("meta.json", entries.text[0]);
  zip.add_text("program", entries.text[1]);
  zip.add_text("machine.toml", entries.text[2]);
  zip.add_text("trace.csv.zst", entries.text[3]);
  expect(zip.finish().has_value(), "a recording cannot be written");
}

void write_file(std::string_view bytes) {
  if (bytes.empty()) return static_cast<void>(std::ofstream(file(), std::ios::binary));
  const auto flags = static_cast<std::uint8_t>(bytes.front());
  bytes.remove_prefix(1);
  if ((flags & packed) == 0) {
    std::ofstream out(file(), std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return;
  }
  Entries entries = split(bytes);
  if ((flags & compressed) != 0) entries.text[3] = compress(entries.text[3]);
  if ((flags & hashed) != 0) put_hashes(entries);
  std::filesystem::remove(file());
  pack(std::move(entries));
}

void check_error(const Diagnostic& error) {
  expect(!error.message.empty(), "an error without a text");
  expect(exit_status(error) == 5, "an error of another family", render(error));
}

/// All lines of the trace; nothing where it is damaged.
std::optional<std::string> trace_text(const app::Recording& recording) {
  auto entry = recording.trace();
  if (!entry) return std::nullopt;
  app::TraceLines lines(std::move(*entry));
  std::string text;
  while (const auto line = lines.next()) text += std::string(*line) + "\n";
  if (lines.status()) return text;
  check_error(lines.status().error());
  return std::nullopt;
}

/// A trace agrees with itself.
void compare_with_itself(const app::Recording& recording, const std::string& text) {
  auto entry = recording.trace();
  expect(entry.has_value(), "a trace that could be read is gone");
  app::TraceComparison comparison{app::TraceLines(std::move(*entry))};
  if (comparison.take(text)) comparison.finish();
  expect(comparison.status().has_value(), "a trace that could be read is damaged");
  expect(comparison.difference().empty(), "a trace differs from itself", comparison.difference());
}

void read_recording(const app::Recording& recording) {
  if (Status whole = recording.check_trace(); !whole) check_error(whole.error());
  auto program = recording.program();
  if (program) {
    std::string read;
    program->for_each_piece([&](std::string_view piece) { read += piece; });
    expect(hal::hash_hex(read) == recording.meta().program_hash, "a program of another hash");
  } else {
    check_error(program.error());
  }
  const auto machine = hal::parse_machine(recording.machine(), "machine.toml", {});
  if (!machine) expect(exit_status(machine.error().front()) == 2, "an error of another family");
  if (const auto text = trace_text(recording)) compare_with_itself(recording, *text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  write_file({reinterpret_cast<const char*>(data), size});
  const auto recording = app::Recording::open(file());
  if (recording)
    read_recording(*recording);
  else
    check_error(recording.error());
  return 0;
}
