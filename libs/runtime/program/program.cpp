// SPDX-License-Identifier: MIT
// Part programs from files, or kept in a temporary file where they come through a pipe.
#include "runtime/program/program.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/files/hash.hpp"

namespace softcnc::runtime {
namespace {

tl::unexpected<Diagnostic> unreadable(Code code, const std::string& name, int error) {
  return tl::make_unexpected(
      Diagnostic{.code = code,
                 .message = "cannot be read: " + std::generic_category().message(error),
                 .file = name});
}

Result<Descriptor> copied(const Descriptor& from, const std::string& name) {
  auto to = unlinked_file();
  std::array<char, 65536> piece{};
  while (to) {
    const ssize_t n = ::read(*from, piece.data(), piece.size());
    if (n == 0) break;
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return unreadable(Code::SC6002, name, errno);
    if (auto written = write_all(*to, {piece.data(), static_cast<std::size_t>(n)}); !written)
      to = tl::make_unexpected(written.error());
  }
  if (!to) to.error().file = name;
  return to;
}

Result<Descriptor> snapshot(const Descriptor& file, off_t begin, const std::string& name) {
  auto copy = ipr::Snapshot::of(*file, begin);
  if (copy) return Descriptor(copy->release());
  copy.error().file = name;
  return tl::make_unexpected(std::move(copy.error()));
}

std::string folder_of(const std::string& name) {
  const std::string folder = std::filesystem::path(name).parent_path();
  return folder.empty() ? "." : folder;
}

}  // namespace

Program::Program(std::string name, Descriptor file, off_t begin)
    : name_(std::move(name)), file_(std::move(file)), begin_(begin) {}

Result<Program> Program::open(const std::string& name, Readings readings) {
  const bool standard_input = name == "-";
  const std::string shown = standard_input ? "<stdin>" : name;
  Descriptor file(standard_input ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                 : ::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat info {};
  if (*file < 0 || ::fstat(*file, &info) != 0) return unreadable(Code::SC6001, shown, errno);
  if (S_ISDIR(info.st_mode)) return unreadable(Code::SC6001, shown, EISDIR);
  const std::string folder = standard_input ? "" : folder_of(name);
  if (S_ISREG(info.st_mode)) {
    const off_t begin = ::lseek(*file, 0, SEEK_CUR);
    const bool once = readings == Readings::one;
    auto text = once ? Result<Descriptor>(std::move(file)) : snapshot(file, begin, shown);
    if (!text) return tl::make_unexpected(std::move(text.error()));
    Program program(shown, std::move(*text), once ? begin : 0);
    program.set_folder(folder);
    return program;
  }
  if (readings == Readings::one) {
    Program program = in_file(shown, std::move(file));
    program.stream_ = std::make_unique<StreamMemory>();
    return program;
  }
  auto copy = copied(file, shown);
  if (!copy) return tl::make_unexpected(std::move(copy.error()));
  Program program = in_file(shown, std::move(*copy));
  program.set_folder(folder);
  return program;
}

Program Program::in_file(std::string name, Descriptor file) {
  return {std::move(name), std::move(file), 0};
}

ipr::Reader Program::reader() {
  if (!streamed()) return ipr::Reader::of_file(*file_, begin_);
  ipr::Reader reader(*file_);
  reader.set_tap([memory = stream_.get()](std::string_view bytes) { memory->add(bytes); });
  return reader;
}

/// What nobody has wanted to read.
void Program::read_rest() {
  std::array<char, 65536> piece{};
  for (;;) {
    const ssize_t n = ::read(*file_, piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) error_ = errno;
    if (n <= 0) return;
    stream_->add({piece.data(), static_cast<std::size_t>(n)});
  }
}

std::size_t Program::read(off_t from, char* to, std::size_t size) {
  ssize_t n = 0;
  do {
    n = ::pread(*file_, to, size, from);
  } while (n < 0 && errno == EINTR);
  if (n < 0) error_ = errno;
  return n > 0 ? static_cast<std::size_t>(n) : 0;
}

std::uint64_t Program::size() const noexcept {
  struct stat status {};
  if (streamed() || ::fstat(*file_, &status) != 0 || status.st_size < begin_) return 0;
  return static_cast<std::uint64_t>(status.st_size - begin_);
}

Status Program::read_status() const {
  return error_ == 0 ? Status() : unreadable(Code::SC6002, name_, error_);
}

const std::string& Program::hash() {
  if (!hash_.empty()) return hash_;
  if (streamed()) {
    read_rest();
    return hash_ = stream_->hash();
  }
  hal::Hasher hasher;
  for_each_piece([&](std::string_view piece) { hasher.add(piece); });
  return hash_ = hasher.hex();
}

std::string Program::line(int number) {
  if (streamed()) return stream_->line(number);
  if (!lines_ || lines_->line() > number) {
    lines_.emplace(ipr::Reader::of_file(*file_, begin_));
    line_.clear();
  }
  while (lines_->line() < number) {
    const auto text = lines_->next();
    line_ = text.value_or("");
    if (!text) break;
  }
  return line_;
}

}  // namespace softcnc::runtime
