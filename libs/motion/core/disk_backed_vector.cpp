// SPDX-License-Identifier: MIT
#include "motion/core/disk_backed_vector.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "motion/core/unnamed_file.hpp"

namespace softcnc {
namespace {

tl::unexpected<Diagnostic> failure(int error) {
  return tl::make_unexpected(Diagnostic{
      Code::SC6003, {}, "no temporary file: " + std::generic_category().message(error), {}, {}});
}

}  // namespace

OverflowFile& OverflowFile::operator=(OverflowFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(mapped_, other.mapped_);
  std::swap(data_, other.data_);
  return *this;
}

OverflowFile::~OverflowFile() {
  if (data_ != nullptr) ::munmap(const_cast<std::byte*>(data_), mapped_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status OverflowFile::add(std::span<const std::byte> bytes) {
  if (descriptor_ < 0) {
    const int opened = open_unnamed_file();
    if (opened < 0) return failure(errno);
    descriptor_ = opened;
  }
  const Status written = put(size_, bytes);
  if (written) size_ += bytes.size();
  return written;
}

Status OverflowFile::put(std::size_t place, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failure(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    place += static_cast<std::size_t>(written);
  }
  return {};
}

Status OverflowFile::map() {
  void* const data = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, descriptor_, 0);
  if (data == MAP_FAILED) return failure(errno);
  data_ = static_cast<const std::byte*>(data);
  mapped_ = size_;
  return {};
}

void OverflowFile::release() const noexcept {
  if (data_ != nullptr) ::madvise(const_cast<std::byte*>(data_), mapped_, MADV_DONTNEED);
}

}  // namespace softcnc
