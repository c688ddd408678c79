// SPDX-License-Identifier: MIT
#include "recording/recording.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "hal/files/hash.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/machine/state_file.hpp"
#include "recording/recording_meta.hpp"
#include "runtime/program/descriptor.hpp"

namespace softcnc::app {
namespace {

tl::unexpected<Diagnostic> no_temporary(int error) {
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC6003,
      .message = "cannot be kept in a temporary file: " + std::generic_category().message(error)});
}

/// Calls take(bytes) for a file, piece by piece.
template <typename Take>
Status for_each_piece_of(const std::string& file, Take&& take) {
  std::ifstream in(file, std::ios::binary);
  std::string piece(65536, '\0');
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto n = static_cast<std::size_t>(in.gcount());
    if (Status taken = take(std::string_view(piece.data(), n)); !taken) return taken;
  }
  if (!in.eof()) return no_temporary(errno);
  return {};
}

Result<std::string> hash_of_file(const std::string& file) {
  hal::Hasher hasher;
  const Status read = for_each_piece_of(file, [&](std::string_view piece) -> Status {
    hasher.add(piece);
    return {};
  });
  if (!read) return tl::make_unexpected(read.error());
  return hasher.hex();
}

Result<std::string> hash_of(const hal::TemporaryFile& file) {
  hal::Hasher hasher;
  const Status read = file.for_each_piece([&](std::string_view piece) -> Status {
    hasher.add(piece);
    return {};
  });
  if (!read) return tl::make_unexpected(read.error());
  return hasher.hex();
}

Result<hal::TemporaryFile> copy_of(runtime::Program& program) {
  auto copy = hal::TemporaryFile::make();
  program.for_each_piece([&](std::string_view piece) {
    if (!copy) return;
    if (Status added = copy->add(piece); !added) copy = tl::make_unexpected(added.error());
  });
  if (Status read = program.read_status(); !read) return tl::make_unexpected(read.error());
  return copy;
}

std::string entry_of(const CalledFile& called) { return "called/" + called.name; }

/// The folder of the search path that a name begins with: 3 of "3/hole.ngc"; 0: none, as of a
/// number that no path of this length has.
int number_of_folder(std::string_view name) {
  constexpr int kMostFolders = 1000;
  const auto slash = name.find('/');
  if (slash == std::string_view::npos) return 0;
  int number = 0;
  const auto read = std::from_chars(name.data(), name.data() + slash, number);
  const bool whole = read.ec == std::errc() && read.ptr == name.data() + slash;
  return whole && number > 0 && number <= kMostFolders ? number : 0;
}

std::string path_in(const std::string& folder, const CalledFile& called) {
  return (std::filesystem::path(folder) / called.name).lexically_normal();
}

/// Where that lies which has been run, whatever has become of the file itself.
std::string path_of(const runtime::Program& program, const CalledFile& called) {
  const std::string path = called.path.empty() ? path_in(program.folder(), called) : called.path;
  const auto& text = program.called().find(path);
  return text && *text ? (*text)->name() : path;
}

Status hash_called(const runtime::Program& program, std::vector<CalledFile>& files) {
  for (CalledFile& called : files) {
    auto hash = hash_of_file(path_of(program, called));
    if (!hash) return tl::make_unexpected(std::move(hash.error()));
    called.hash = std::move(*hash);
  }
  return {};
}

}  // namespace

Status write_recording(hal::OutputFile& file, runtime::Program& program, const Machine& machine,
                       RecordingMeta meta, const hal::TemporaryFile& trace) {
  auto trace_hash = hash_of(trace);
  if (!trace_hash) return tl::make_unexpected(std::move(trace_hash.error()));
  const auto copy = copy_of(program);
  if (!copy) return tl::make_unexpected(copy.error());
  const auto archive = hal::TemporaryFile::make();
  if (!archive) return tl::make_unexpected(archive.error());
  const std::string machine_text = hal::machine_toml(machine);
  meta.program_name = program.name();
  meta.program_hash = program.hash();
  meta.machine_hash = hal::hash_hex(machine_text);
  meta.trace_hash = *trace_hash;
  const std::string state_text = hal::state_toml(meta.options.state);
  meta.state_hash = hal::hash_hex(state_text);
  if (Status hashed = hash_called(program, meta.called); !hashed) return hashed;

  hal::ZipWriter zip(archive->descriptor());
  zip.add_text("meta.json", meta_json(meta));
  zip.add_descriptor("program", copy->descriptor(), hal::Compression::deflate);
  for (const CalledFile& called : meta.called)
    zip.add_file(entry_of(called), path_of(program, called), hal::Compression::deflate);
  zip.add_text("machine.toml", machine_text);
  zip.add_text("state.toml", state_text);
  zip.add_descriptor("trace.csv.zst", trace.descriptor(), hal::Compression::store);
  if (Status written = zip.finish(); !written) return written;
  return archive->copy_to(file);
}

Result<Recording> Recording::open(const std::string& file) {
  auto zip = hal::ZipReader::open(file);
  if (!zip) return tl::make_unexpected(std::move(zip.error()));
  Recording recording(file, std::move(*zip));
  if (Status read = recording.read(); !read) {
    if (read.error().file.empty()) read.error().file = file == "-" ? "<stdin>" : file;
    return tl::make_unexpected(std::move(read.error()));
  }
  return recording;
}

Status Recording::read() {
  if (Status whole = zip_.check(); !whole) return whole;
  const auto text = zip_.text("meta.json");
  if (!text) return tl::make_unexpected(text.error());
  auto meta = parse_meta(*text);
  if (!meta) return tl::make_unexpected(std::move(meta.error()));
  meta_ = std::move(*meta);
  auto machine = zip_.text("machine.toml");
  if (!machine) return tl::make_unexpected(std::move(machine.error()));
  machine_ = std::move(*machine);
  if (Status good = check_hash("program", meta_.program_hash); !good) return good;
  for (const CalledFile& called : meta_.called)
    if (Status good = check_hash(entry_of(called), called.hash); !good) return good;
  if (Status good = check_hash("machine.toml", meta_.machine_hash); !good) return good;
  return meta_.state_hash.empty() ? Status() : read_state();
}

Status Recording::read_state() {
  if (Status good = check_hash("state.toml", meta_.state_hash); !good) return good;
  const auto text = zip_.text("state.toml");
  if (!text) return tl::make_unexpected(text.error());
  auto state = hal::parse_state(*text, file_ + ":state.toml");
  if (!state) return tl::make_unexpected(std::move(state.error().front()));
  meta_.options.state = std::move(*state);
  return {};
}

Status Recording::check_hash(const std::string& name, const std::string& expected) const {
  auto entry = zip_.entry(name);
  if (!entry) return tl::make_unexpected(std::move(entry.error()));
  hal::Hasher hasher;
  const Status read = for_each_piece(std::move(*entry), [&](std::string_view piece) -> Status {
    hasher.add(piece);
    return {};
  });
  if (!read || hasher.hex() == expected) return read;
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6021,
                 .message = "its " + name + " is not what was recorded: the hash differs",
                 .file = file_});
}

Result<runtime::Program> Recording::program() const {
  auto entry = zip_.entry("program");
  if (!entry) return tl::make_unexpected(std::move(entry.error()));
  auto file = runtime::unlinked_file();
  if (!file) return tl::make_unexpected(std::move(file.error()));
  const Status copied = for_each_piece(
      std::move(*entry), [&](std::string_view piece) { return runtime::write_all(*file, piece); });
  if (!copied) return tl::make_unexpected(copied.error());
  return runtime::Program::in_file(meta_.program_name, std::move(*file));
}

Status Recording::put_called(const std::string& folder, ipr::CalledTexts& texts) const {
  texts.close();
  for (const CalledFile& called : meta_.called) {
    const auto text = zip_.text(entry_of(called));
    if (!text) return tl::make_unexpected(text.error());
    auto kept = ipr::Snapshot::of(*text);
    if (!kept) return tl::make_unexpected(std::move(kept.error()));
    texts.put(path_in(folder, called), std::move(*kept));
  }
  return {};
}

std::vector<std::string> Recording::folders_of_called(const std::string& folder) const {
  int last = 0;
  for (const CalledFile& called : meta_.called)
    last = std::max(last, number_of_folder(called.name));
  std::vector<std::string> folders;
  for (int i = 1; i <= last; ++i)
    folders.push_back((std::filesystem::path(folder) / std::to_string(i)).string());
  return folders;
}

}  // namespace softcnc::app
