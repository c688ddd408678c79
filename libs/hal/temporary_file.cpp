// SPDX-License-Identifier: MIT
#include "hal/temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace softcnc::hal {
namespace {

constexpr std::size_t kPiece = 1U << 16U;  // bytes

tl::unexpected<Diagnostic> failure(const std::error_code& error) {
  return tl::make_unexpected(
      Diagnostic{Code::SC6003, {}, "no temporary file: " + error.message(), {}, {}});
}

std::error_code last_error() { return {errno, std::generic_category()}; }

}  // namespace

Result<TemporaryFile> TemporaryFile::make() {
  std::error_code error;
  std::string name = std::filesystem::temp_directory_path(error) / "softcnc-XXXXXX";
  if (error) return failure(error);
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) return failure(last_error());
  ::close(descriptor);
  return TemporaryFile(std::move(name));
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) ::unlink(name_.c_str());
}

Status TemporaryFile::for_each_piece(const std::function<Status(std::string_view)>& take) const {
  std::ifstream in(name_, std::ios::binary);
  std::string piece(kPiece, '\0');
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto size = static_cast<std::size_t>(in.gcount());
    if (Status taken = take(std::string_view(piece.data(), size)); !taken) return taken;
  }
  if (!in.eof()) return failure(last_error());
  return {};
}

}  // namespace softcnc::hal
