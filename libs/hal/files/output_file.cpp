// SPDX-License-Identifier: MIT
// Writing, syncing and renaming by POSIX calls, which alone report why they fail.
#include "hal/files/output_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "hal/files/unfinished_file.hpp"

namespace softcnc::hal {
namespace {

constexpr mode_t kRights = 0777;           // of a mode
constexpr int kMostLinks = 40;             // as many as the system follows
constexpr int kLook = 50;                  // ms from one look for a reader to the next
constexpr std::size_t kAtOnce = PIPE_BUF;  // what a pipe takes that is ready for any

/// Of the call that has failed last.
tl::unexpected<Diagnostic> call_failure(Code code, const std::string& file, std::string_view what) {
  return file_failure(code, file, std::string(what) + ": " + std::strerror(errno));
}

/// Symbolic links that lead round in a circle, or too many of them.
bool leads_nowhere(const std::string& file) {
  struct stat info {};
  return ::stat(file.c_str(), &info) != 0 && errno == ELOOP;
}

bool is_regular(int descriptor) {
  struct stat info {};
  return ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode);
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
  explicit Replaced(const std::string& target)
      : exists_(::stat(target.c_str(), &info_) == 0), can_be_(exists_ || errno != ENAMETOOLONG) {}

  /// False with errno where no file can have that name: one beside it could be written.
  bool can_be() const noexcept { return can_be_; }

  mode_t mode() const noexcept { return exists_ ? info_.st_mode & kRights : kNewFileMode; }

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
  bool exists_, can_be_;
};

}  // namespace

tl::unexpected<Diagnostic> file_failure(Code code, const std::string& file, std::string message) {
  return tl::make_unexpected(Diagnostic{.code = code, .message = std::move(message), .file = file});
}

/// The object is there before the file is: no failure in between leaves a file.
Result<std::unique_ptr<OutputFile>> OutputFile::open(const std::string& file, Patience patience) {
  if (leads_nowhere(file)) return call_failure(Code::SC6011, file, "cannot be created");
  std::unique_ptr<OutputFile> output(new OutputFile(file, std::move(patience)));
  if (file == "-")
    output->descriptor_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  else if (written_directly(file))
    output->descriptor_ = output->open_directly();
  else
    output->begin(target_of(file));
  if (output->descriptor_ < 0) return call_failure(Code::SC6011, file, "cannot be created");
  output->may_wait_ = output->patience_.stop.stop_possible() && !is_regular(output->descriptor_);
  return output;
}

/// Without a reader a pipe is opened only by waiting for it.
int OutputFile::open_directly() const {
  constexpr int kFlags = O_WRONLY | O_CLOEXEC;
  if (!patience_.stop.stop_possible()) return ::open(name_.c_str(), kFlags);
  int file = -1;
  do {
    file = ::open(name_.c_str(), kFlags | O_NONBLOCK);
  } while (file < 0 && errno == ENXIO && !patience_.stop.stop_requested() &&
           ::poll(nullptr, 0, kLook) == 0);
  if (file >= 0) ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return file;
}

void OutputFile::begin(std::string target) {
  target_ = std::move(target);
  const Replaced replaced(target_);
  if (!replaced.can_be()) return;
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
    if (may_wait_ && !has_reader())
      return file_failure(Code::SC6012, name_, "writing failed: nobody reads what is written");
    const auto size = may_wait_ ? std::min(bytes.size(), kAtOnce) : bytes.size();
    const auto written = ::write(descriptor_, bytes.data(), size);
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return failed();
  }
  return {};
}

/// Waits for a reader that takes what is written.
bool OutputFile::has_reader() const {
  int after_stop = 0;
  for (int waited = 0; patience_.while_running < 0 || waited <= patience_.while_running;
       waited += kLook) {
    pollfd out{descriptor_, POLLOUT, 0};
    const int ready = ::poll(&out, 1, kLook);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
    if (patience_.stop.stop_requested() && (after_stop += kLook) > Patience::kAfterStop) break;
  }
  return false;
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
  if (errno == EPIPE) return call_failure(Code::SC6013, name_, "the reader closed the pipe");
  return call_failure(Code::SC6012, name_, "writing failed");
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

Status write_file(const std::string& file, std::string_view text, Patience patience) {
  auto output = OutputFile::open(file, std::move(patience));
  if (!output) return tl::make_unexpected(output.error());
  if (auto written = (*output)->write(text); !written) return written;
  return (*output)->finish();
}

}  // namespace softcnc::hal
