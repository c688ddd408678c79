// SPDX-License-Identifier: MIT
#include "ipr/text/snapshot.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>
#include <vector>

#include "motion/core/unnamed_file.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::int64_t kPiece = std::int64_t{1} << 20;  // bytes

tl::unexpected<Diagnostic> failure(Code code, const char* what) {
  return tl::make_unexpected(
      Diagnostic{code, {}, what + std::generic_category().message(errno), {}, {}});
}

tl::unexpected<Diagnostic> unreadable() { return failure(Code::SC6002, "cannot be read: "); }

tl::unexpected<Diagnostic> no_room() {
  return failure(Code::SC6003, "cannot be kept in a temporary file: ");
}

int open_for(std::int64_t size) {
  return size <= Snapshot::kLongestInMemory ? ::memfd_create("softcnc", MFD_CLOEXEC)
                                            : open_unnamed_file();
}

std::ptrdiff_t read_at(int file, char* to, std::size_t size, std::int64_t offset) {
  ssize_t got = 0;
  do {
    got = ::pread(file, to, size, offset);
  } while (got < 0 && errno == EINTR);
  return got;
}

bool write_all(int file, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(file, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

/// Within the kernel, as far as that can be done; returns where the rest begins.
std::int64_t copy_quickly(int from, int to, std::int64_t begin, std::int64_t end) {
  ssize_t copied = 1;
  while (begin < end && copied > 0) {
    const auto wanted = static_cast<std::size_t>(std::min(kPiece, end - begin));
    copied = ::copy_file_range(from, &begin, to, nullptr, wanted, 0);
  }
  return begin;
}

Status copy(int from, int to, std::int64_t begin, std::int64_t end) {
  std::vector<char> piece(kPiece);
  begin = copy_quickly(from, to, begin, end);
  while (begin < end) {
    const auto wanted = static_cast<std::size_t>(std::min(kPiece, end - begin));
    const std::ptrdiff_t got = read_at(from, piece.data(), wanted, begin);
    if (got < 0) return unreadable();
    if (got == 0) break;
    if (!write_all(to, piece.data(), static_cast<std::size_t>(got))) return no_room();
    begin += got;
  }
  return {};
}

}  // namespace

Snapshot::~Snapshot() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// Files of /proc have contents, but no size.
Result<Snapshot> Snapshot::of(int file, std::int64_t begin) {
  struct stat status {};
  if (::fstat(file, &status) != 0) return unreadable();
  const std::int64_t end =
      status.st_size > 0 ? status.st_size : std::numeric_limits<std::int64_t>::max();
  Snapshot snapshot(open_for(status.st_size > 0 ? end - begin : 0));
  if (snapshot.descriptor_ < 0) return no_room();
  if (Status copied = copy(file, snapshot.descriptor_, begin, end); !copied)
    return tl::make_unexpected(std::move(copied.error()));
  return snapshot;
}

Result<Snapshot> Snapshot::of(std::string_view text) {
  Snapshot snapshot(open_for(static_cast<std::int64_t>(text.size())));
  if (snapshot.descriptor_ < 0) return no_room();
  if (!write_all(snapshot.descriptor_, text.data(), text.size())) return no_room();
  return snapshot;
}

}  // namespace softcnc::ipr
