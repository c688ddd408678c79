// SPDX-License-Identifier: MIT
// An unlinked temporary file that grows with what is read.
#include "ipr/text/spool.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "motion/core/unnamed_file.hpp"

namespace softcnc::ipr {

Spool::Spool(Spool&& other) noexcept { *this = std::move(other); }

Spool& Spool::operator=(Spool&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(failure_, other.failure_);
  return *this;
}

Spool::~Spool() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Spool::add(const char* bytes, std::size_t size) {
  if (failure_ || (descriptor_ < 0 && !open())) return;
  while (size > 0) {
    const ssize_t written = ::pwrite(descriptor_, bytes, size, static_cast<off_t>(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(errno);
    bytes += written;
    size -= static_cast<std::size_t>(written);
    size_ += static_cast<std::uint64_t>(written);
  }
}

bool Spool::open() {
  descriptor_ = open_unnamed_file();
  if (descriptor_ < 0) fail(errno);
  return descriptor_ >= 0;
}

void Spool::fail(int error) {
  failure_ = {Code::SC6032,
              {},
              "what came through the pipe could not be kept in a temporary file: " +
                  std::generic_category().message(error),
              {},
              {}};
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

std::ptrdiff_t Spool::read(std::uint64_t offset, char* to, std::size_t size) const {
  return ::pread(descriptor_, to, size, static_cast<off_t>(offset));
}

}  // namespace softcnc::ipr
