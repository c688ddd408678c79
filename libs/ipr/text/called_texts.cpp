// SPDX-License-Identifier: MIT
#include "ipr/text/called_texts.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace softcnc::ipr {
namespace {

using Found = Result<std::optional<Snapshot>>;

tl::unexpected<Diagnostic> refused(Code code, std::string message) {
  return tl::make_unexpected(Diagnostic{code, {}, std::move(message), {}, {}});
}

tl::unexpected<Diagnostic> unreadable(const std::string& path, std::string_view why) {
  return refused(Code::SC6031, "cannot read '" + path + "': " + std::string(why));
}

tl::unexpected<Diagnostic> unreadable(const std::string& path, int error) {
  return unreadable(path, std::generic_category().message(error));
}

tl::unexpected<Diagnostic> uncallable(Code code, const std::string& path, const std::string& what) {
  return refused(code, "cannot call '" + path + "': it is " + what);
}

std::string_view kind_of(mode_t mode) {
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

/// Why a file of this kind and size is not called, if it is not.
Status check(const std::string& path, const struct stat& info) {
  if (S_ISDIR(info.st_mode)) return unreadable(path, EISDIR);
  if (!S_ISREG(info.st_mode))
    return uncallable(
        Code::SC6033, path,
        std::string(kind_of(info.st_mode)) + ", and only a regular file can be called");
  if (info.st_size > CalledTexts::kLongest)
    return uncallable(Code::SC6034, path,
                      "longer than " + std::to_string(CalledTexts::kLongest >> 20) + " MiB");
  return {};
}

Found copy_of(const std::string& path, int file) {
  struct stat info {};
  if (file < 0 || ::fstat(file, &info) != 0) return unreadable(path, errno);
  if (Status callable = check(path, info); !callable)
    return tl::make_unexpected(std::move(callable.error()));
  auto copy = Snapshot::of(file, 0);
  if (copy) return std::optional(std::move(*copy));
  if (copy.error().code == Code::SC6002) return unreadable(path, copy.error().message);
  copy.error().message = "'" + path + "' " + copy.error().message;
  return tl::make_unexpected(std::move(copy.error()));
}

bool is_missing(const std::string& path, const struct stat& info) {
  return S_ISDIR(info.st_mode) && !std::filesystem::path(path).has_extension();
}

/// It is looked at before it is opened: to open a device may do something. Should another one stand
/// in its place then, nobody waits for it.
Found look(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0 || is_missing(path, info)) return std::nullopt;
  if (Status callable = check(path, info); !callable)
    return tl::make_unexpected(std::move(callable.error()));
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  Found found = copy_of(path, file);
  if (file >= 0) ::close(file);
  return found;
}

bool is_below(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const auto [left_of_path, left_of_folder] =
      std::mismatch(path.begin(), path.end(), folder.begin(), folder.end());
  return left_of_folder == folder.end() && left_of_path != path.end();
}

/// What is read is the file that was found below the folder, not where its name leads by then.
Found look_within(const std::string& path, const std::string& folder) {
  std::error_code missing;
  const auto real = std::filesystem::canonical(path, missing);
  if (missing) return std::nullopt;
  const auto real_folder = std::filesystem::canonical(folder, missing);
  if (missing) return std::nullopt;
  if (is_below(real, real_folder)) return look(real.string());
  return uncallable(Code::SC2317, path, "a link that leads out of '" + folder + "'");
}

}  // namespace

const Found& CalledTexts::find(const std::string& path, const std::string& within) {
  const auto known = found_.find(path);
  if (known != found_.end()) return known->second;
  const auto read = [&] { return within.empty() ? look(path) : look_within(path, within); };
  return found_.emplace(path, is_closed_ ? Found(std::nullopt) : read()).first->second;
}

void CalledTexts::put(const std::string& path, Snapshot text) {
  found_.insert_or_assign(path, Found(std::optional(std::move(text))));
}

}  // namespace softcnc::ipr
