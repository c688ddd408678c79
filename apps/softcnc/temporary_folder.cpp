// SPDX-License-Identifier: MIT
#include "temporary_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "hal/unfinished_file.hpp"

namespace softcnc::app {
namespace {

constexpr std::string_view kBegin = "softcnc-folder-";
constexpr int kAttempts = 100;

tl::unexpected<Diagnostic> failure(const std::error_code& error) {
  return tl::make_unexpected(
      Diagnostic{Code::SC6003, {}, "no temporary folder: " + error.message(), {}, {}});
}

Descriptor open(const std::string& folder) {
  return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

bool lock(const Descriptor& folder) { return ::flock(*folder, LOCK_EX | LOCK_NB) == 0; }

bool is_ours(const Descriptor& folder) {
  struct stat info {};
  return ::fstat(*folder, &info) == 0 && info.st_uid == ::geteuid();
}

void remove_leftovers(const std::filesystem::path& in) {
  std::error_code error;
  std::filesystem::directory_iterator entries(in, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    const std::filesystem::path folder = entries->path();
    if (!folder.filename().string().starts_with(kBegin)) continue;
    std::error_code ignored;
    if (const Descriptor opened = open(folder); is_ours(opened) && lock(opened))
      std::filesystem::remove_all(folder, ignored);
  }
}

}  // namespace

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code error;
  const auto in = std::filesystem::temp_directory_path(error);
  if (error) return failure(error);
  remove_leftovers(in);
  for (int i = 0; i < kAttempts; ++i) {
    std::string name = in / (std::string(kBegin) + "XXXXXX");
    if (::mkdtemp(name.data()) == nullptr) return failure({errno, std::generic_category()});
    // Until it is locked, another run may take it for a leftover.
    Descriptor opened = open(name);
    if (*opened < 0) {
      const int reason = errno;
      ::rmdir(name.c_str());
      return failure({reason, std::generic_category()});
    }
    const bool is_taken = !lock(opened) && errno == EWOULDBLOCK;
    if (!is_taken && hal::bears(*opened, name)) return TemporaryFolder(name, std::move(opened));
  }
  return failure(std::make_error_code(std::errc::file_exists));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (path_.empty() || ::rmdir(path_.c_str()) == 0) return;  // an empty one, without a descriptor
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace softcnc::app
