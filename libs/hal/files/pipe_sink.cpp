// SPDX-License-Identifier: MIT
#include "hal/files/pipe_sink.hpp"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

#include "hal/files/number.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr std::string_view kStandardOutput = "-";

/// Opened without waiting for a reader; from then on writing may wait.
int open_fifo(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor >= 0) ::fcntl(descriptor, F_SETFL, 0);
  return descriptor;
}

}  // namespace

bool is_pipe(const std::string& file) {
  struct stat info {};
  const bool known = file == kStandardOutput ? ::fstat(STDOUT_FILENO, &info) == 0
                                             : ::stat(file.c_str(), &info) == 0;
  return known && S_ISFIFO(info.st_mode);
}

PipeSink::PipeSink(std::string name, int descriptor, int patience)
    : name_(std::move(name)), descriptor_(descriptor), patience_(patience) {}

Result<std::unique_ptr<PipeSink>> PipeSink::open(const std::string& file, double patience) {
  const int descriptor =
      file == kStandardOutput ? ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0) : open_fifo(file);
  if (descriptor < 0 && errno == ENXIO)
    return file_failure(Code::SC6070, file, "no program reads this pipe; start its reader first");
  if (descriptor < 0)
    return file_failure(Code::SC6011, file,
                        std::string("cannot be opened: ") + std::strerror(errno));
  const auto ms = static_cast<int>(std::ceil(ms_from_s(patience)));
  return std::unique_ptr<PipeSink>(new PipeSink(file, descriptor, ms));
}

PipeSink::~PipeSink() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// A pipe that poll() calls ready takes PIPE_BUF bytes at once.
Status PipeSink::write(std::string_view bytes) {
  while (!bytes.empty()) {
    if (auto ready = wait(); !ready) return ready;
    const auto written =
        ::write(descriptor_, bytes.data(), std::min<std::size_t>(bytes.size(), PIPE_BUF));
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno == EPIPE)
      return failed(Code::SC6013, "the reader closed the pipe");
    else if (errno != EINTR && errno != EAGAIN)
      return failed(Code::SC6012, std::string("writing failed: ") + std::strerror(errno));
  }
  return {};
}

Status PipeSink::wait() {
  pollfd pipe{descriptor_, POLLOUT, 0};
  const int ready = ::poll(&pipe, 1, patience_);
  if (ready > 0 || (ready < 0 && errno == EINTR)) return {};
  if (ready < 0)
    return failed(Code::SC6012, std::string("writing failed: ") + std::strerror(errno));
  return failed(Code::SC6071, "the pipe is full, and its reader has taken nothing for " +
                                  number_text(s_from_ms(patience_)) + " s");
}

Status PipeSink::finish() {
  if (::close(std::exchange(descriptor_, -1)) == 0) return {};
  return failed(Code::SC6012, std::string("writing failed: ") + std::strerror(errno));
}

tl::unexpected<Diagnostic> PipeSink::failed(Code code, const std::string& what) const {
  return file_failure(code, name_, what);
}

}  // namespace softcnc::hal
