// SPDX-License-Identifier: MIT
// Writing, syncing and renaming by POSIX calls, which alone tell why they fail.
#include "hal/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace softcnc::hal {
namespace {

constexpr mode_t kMode = 0666;  // less the umask
constexpr int kMostLinks = 40;  // as many as the system follows

tl::unexpected<Diagnostic> failure(Code code, const std::string& file, std::string_view what) {
  return tl::make_unexpected(
      Diagnostic{code, {}, std::string(what) + ": " + std::strerror(errno), file, {}});
}

/// Symbolic links that lead round in a circle, or too many of them.
bool leads_nowhere(const std::string& file) {
  struct stat info {};
  return ::stat(file.c_str(), &info) != 0 && errno == ELOOP;
}

bool written_directly(const std::string& file) {
  struct stat info {};
  return ::stat(file.c_str(), &info) == 0 && !S_ISREG(info.st_mode);
}

/// A rename that must survive a power cut. Not every kind of file system knows how to sync a
/// folder.
bool sync_folder_of(const std::string& file) {
  const auto folder = std::filesystem::path(file).parent_path();
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;  // it may be written to, but not read
  const bool synced = ::fsync(descriptor) == 0 || errno == EINVAL;
  ::close(descriptor);
  return synced;
}

int open_for_writing(const std::string& file, int flags) {
  return ::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, kMode);
}

}  // namespace

OutputFile::OutputFile(std::string name, std::string part, std::string target, int descriptor)
    : name_(std::move(name)),
      part_(std::move(part)),
      target_(std::move(target)),
      descriptor_(descriptor) {}

Result<std::unique_ptr<OutputFile>> OutputFile::open(const std::string& file) {
  const auto make = [&](const std::string& part, const std::string& target, int descriptor) {
    return std::unique_ptr<OutputFile>(new OutputFile(file, part, target, descriptor));
  };
  if (file == "-") return make({}, {}, ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0));
  if (leads_nowhere(file)) return failure(Code::SC6011, file, "cannot be created");
  const bool direct = written_directly(file);
  const std::string target = direct ? file : target_of(file);
  const std::string part = direct ? std::string() : target + ".part";
  const int descriptor =
      direct ? open_for_writing(target, 0) : open_for_writing(part, O_CREAT | O_TRUNC);
  if (descriptor < 0) return failure(Code::SC6011, file, "cannot be created");
  return make(part, target, descriptor);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!part_.empty()) ::unlink(part_.c_str());
}

Status OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return failed();
  }
  return {};
}

Status OutputFile::finish() {
  if (!part_.empty() && ::fsync(descriptor_) != 0) return failed();
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) return failed();
  if (part_.empty()) return {};
  if (std::rename(part_.c_str(), target_.c_str()) != 0) return failed();
  part_.clear();
  if (!sync_folder_of(target_)) return failed();
  return {};
}

Status OutputFile::failed() const {
  if (errno == EPIPE) return failure(Code::SC6013, name_, "the reader closed the pipe");
  return failure(Code::SC6012, name_, "writing failed");
}

std::string target_of(const std::string& file) {
  std::error_code error;
  if (const auto target = std::filesystem::canonical(file, error); !error) return target;
  std::filesystem::path name = file;
  for (int i = 0; i < kMostLinks; ++i) {
    const auto target = std::filesystem::read_symlink(name, error);
    if (error) break;
    name = name.parent_path() / target;
  }
  return name;
}

std::string part_of(const std::string& file) {
  return file.empty() || file == "-" || written_directly(file) ? std::string()
                                                               : target_of(file) + ".part";
}

Status write_file(const std::string& file, std::string_view text) {
  auto output = OutputFile::open(file);
  if (!output) return tl::make_unexpected(output.error());
  if (auto written = (*output)->write(text); !written) return written;
  return (*output)->finish();
}

}  // namespace softcnc::hal
