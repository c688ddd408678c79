// SPDX-License-Identifier: MIT
#include "motion/core/unnamed_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace softcnc {
namespace {

/// For file systems that know no files without a name.
int open_and_unlink(const std::filesystem::path& folder) {
  std::string name = folder / "softcnc-XXXXXX";
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) ::unlink(name.c_str());
  return descriptor;
}

}  // namespace

int open_unnamed_file() {
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  if (error) {
    errno = error.value();
    return -1;
  }
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600);
  const bool knows_none = errno == EOPNOTSUPP || errno == EISDIR || errno == ENOENT;
  return descriptor < 0 && knows_none ? open_and_unlink(folder) : descriptor;
}

}  // namespace softcnc
