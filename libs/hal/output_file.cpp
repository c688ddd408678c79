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
#include <utility>

#include "hal/unfinished_file.hpp"

namespace softcnc::hal {
namespace {

constexpr mode_t kMode = 0666;    // less the umask
constexpr mode_t kRights = 0777;  // of a mode
constexpr int kMostLinks = 40;    // as many as the system follows

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

/// What a new file in the place of another has from it.
class Replaced {
 public:
  explicit Replaced(const std::string& target) : exists_(::stat(target.c_str(), &info_) == 0) {}

  mode_t mode() const noexcept { return exists_ ? info_.st_mode & kRights : kMode; }

  /// Rights of a group that cannot be kept would be those of another one.
  void hand_over(int descriptor) const {
    if (!exists_) return;
    const bool kept = ::fchown(descriptor, info_.st_uid, info_.st_gid) == 0 ||
                      ::fchown(descriptor, static_cast<uid_t>(-1), info_.st_gid) == 0;
    const mode_t others = mode() & S_IRWXO;
    const mode_t rights = kept ? mode() : (mode() & S_IRWXU) | (others << 3U) | others;
    if (::fchmod(descriptor, rights) != 0) return;  // a file system without rights
  }

 private:
  struct stat info_ {};
  bool exists_;
};

}  // namespace

/// The object is there before the file is: nothing that fails in between leaves one behind.
Result<std::unique_ptr<OutputFile>> OutputFile::open(const std::string& file) {
  if (leads_nowhere(file)) return failure(Code::SC6011, file, "cannot be created");
  std::unique_ptr<OutputFile> output(new OutputFile(file));
  if (file == "-")
    output->descriptor_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  else if (written_directly(file))
    output->descriptor_ = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  else
    output->begin(target_of(file));
  if (output->descriptor_ < 0) return failure(Code::SC6011, file, "cannot be created");
  return output;
}

void OutputFile::begin(std::string target) {
  target_ = std::move(target);
  const Replaced replaced(target_);
  UnfinishedFile unfinished = make_unfinished(target_, replaced.mode());
  if (unfinished.descriptor < 0) return;
  descriptor_ = unfinished.descriptor;
  unfinished_ = std::move(unfinished.name);
  replaced.hand_over(descriptor_);
}

OutputFile::~OutputFile() {
  if (!unfinished_.empty()) ::unlink(unfinished_.c_str());  // while it is locked
  if (descriptor_ >= 0) ::close(descriptor_);
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

/// The lock is held until the file has its name: nobody takes it for a leftover.
Status OutputFile::finish() {
  if (!unfinished_.empty()) {
    if (::fsync(descriptor_) != 0) return failed();
    if (std::rename(unfinished_.c_str(), target_.c_str()) != 0) return failed();
    unfinished_.clear();
    if (!sync_folder_of(target_)) return failed();
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) return failed();
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

bool is_replaced(const std::string& file) {
  return !file.empty() && file != "-" && !written_directly(file);
}

Status write_file(const std::string& file, std::string_view text) {
  auto output = OutputFile::open(file);
  if (!output) return tl::make_unexpected(output.error());
  if (auto written = (*output)->write(text); !written) return written;
  return (*output)->finish();
}

}  // namespace softcnc::hal
