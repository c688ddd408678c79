// SPDX-License-Identifier: MIT
#include "hal/files/temporary_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "hal/files/file_piece.hpp"
#include "motion/core/unnamed_file.hpp"

namespace softcnc::hal {
namespace {

tl::unexpected<Diagnostic> no_temporary_file() {
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6003,
                 .message = "no temporary file: " + std::generic_category().message(errno)});
}

}  // namespace

Result<TemporaryFile> TemporaryFile::make() {
  const int descriptor = open_unnamed_file();
  if (descriptor < 0) return no_temporary_file();
  return TemporaryFile(descriptor);
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status TemporaryFile::add(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return no_temporary_file();
  }
  return {};
}

Status TemporaryFile::for_each_piece(const std::function<Status(std::string_view)>& take) const {
  std::string piece(kFilePiece, '\0');
  for (off_t at = 0;;) {
    const ssize_t n = ::pread(descriptor_, piece.data(), piece.size(), at);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return no_temporary_file();
    if (n == 0) return {};
    const auto size = static_cast<std::size_t>(n);
    if (Status taken = take(std::string_view(piece).substr(0, size)); !taken) return taken;
    at += n;
  }
}

Status TemporaryFile::copy_to(ByteSink& out) const {
  const Status copied = for_each_piece([&](std::string_view piece) { return out.write(piece); });
  return copied ? out.finish() : copied;
}

}  // namespace softcnc::hal
