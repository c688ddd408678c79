// SPDX-License-Identifier: MIT
#include "hal/files/text_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace softcnc::hal {
namespace {

tl::unexpected<Diagnostic> unreadable(const std::string& file, Code code) {
  return tl::make_unexpected(
      Diagnostic{.code = code,
                 .message = std::string("cannot be read: ") + std::strerror(errno),
                 .file = file});
}

constexpr std::size_t kLongestTextFile = std::size_t{1} << 24;  // bytes: no machine needs as many

tl::unexpected<Diagnostic> too_long(const std::string& file, Code code) {
  return tl::make_unexpected(
      Diagnostic{.code = code, .message = "cannot be read: longer than 16 MiB", .file = file});
}

}  // namespace

Result<std::string> read_text(const std::string& file, Code code) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"),
                                                               std::fclose);
  if (!stream) return unreadable(file, code);
  std::string text;
  std::array<char, 4096> part{};
  while (const auto n = std::fread(part.data(), 1, part.size(), stream.get())) {
    text.append(part.data(), n);
    if (text.size() > kLongestTextFile) return too_long(file, code);
  }
  if (std::ferror(stream.get())) return unreadable(file, code);
  return text;
}

}  // namespace softcnc::hal
