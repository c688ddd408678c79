// SPDX-License-Identifier: MIT
// Reads zip files.
#include <fcntl.h>
#include <unistd.h>
#include <zip.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/files/decompression_limit.hpp"
#include "hal/files/zip_file.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kLargestText = 1U << 20U;

tl::unexpected<Diagnostic> unreadable(const std::string& file, const ZipPurpose& purpose,
                                      const std::string& reason) {
  return tl::make_unexpected(
      Diagnostic{.code = purpose.unreadable,
                 .message = "cannot be read as " + std::string(purpose.name) + ": " + reason,
                 .file = file});
}

Status too_much(const std::string& file, const std::string& why) {
  return tl::make_unexpected(Diagnostic{.code = Code::SC6024, .message = why, .file = file});
}

std::string text_of(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

}  // namespace

ZipEntry::ZipEntry(zip_file* entry, std::string file, ZipPurpose purpose,
                   std::uint64_t file_size) noexcept
    : entry_(entry, zip_fclose), file_(std::move(file)), purpose_(purpose), file_size_(file_size) {}

Result<std::size_t> ZipEntry::read(char* to, std::size_t size) {
  const zip_int64_t n = zip_fread(entry_.get(), to, size);
  if (n < 0) return unreadable(file_, purpose_, zip_file_strerror(entry_.get()));
  return static_cast<std::size_t>(n);
}

ZipReader::ZipReader(zip* archive, std::string file, ZipPurpose purpose,
                     std::uint64_t size) noexcept
    : zip_(archive, zip_discard), file_(std::move(file)), purpose_(purpose), size_(size) {}

Result<ZipReader> ZipReader::open(const std::string& file, ZipPurpose purpose) {
  const bool standard_input = file == "-";
  const std::string path = standard_input ? "/dev/stdin" : file;
  const std::string shown = standard_input ? "<stdin>" : file;
  std::error_code unknown;
  const bool exists = std::filesystem::exists(path, unknown);
  if (exists && !std::filesystem::is_regular_file(path, unknown))
    return unreadable(shown, purpose,
                      "it is not a regular file, which " + std::string(purpose.name) + " must be");
  int code = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
  if (archive == nullptr) return unreadable(shown, purpose, text_of(code));
  const auto size = std::filesystem::file_size(path, unknown);
  return ZipReader(archive, shown, purpose, unknown ? 0 : size);
}

Result<ZipReader> ZipReader::open(int descriptor, const std::string& name, ZipPurpose purpose) {
  int code = 0;
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  ::lseek(descriptor, 0, SEEK_SET);
  const int own = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  zip_t* archive = zip_fdopen(own, ZIP_CHECKCONS, &code);
  if (archive == nullptr) {
    if (own >= 0) ::close(own);
    return unreadable(name, purpose, text_of(code));
  }
  return ZipReader(archive, name, purpose, static_cast<std::uint64_t>(std::max(size, off_t{0})));
}

Result<ZipEntry> ZipReader::entry(const std::string& name) const {
  zip_file_t* entry = zip_fopen(zip_.get(), name.c_str(), 0);
  if (entry == nullptr) return unreadable(file_, purpose_, name + ": " + zip_strerror(zip_.get()));
  return ZipEntry(entry, file_, purpose_, size_);
}

Result<ZipEntry> ZipReader::entry(std::uint64_t index) const {
  zip_file_t* entry = zip_fopen_index(zip_.get(), index, 0);
  if (entry == nullptr)
    return unreadable(file_, purpose_,
                      "entry " + std::to_string(index + 1) + ": " + zip_strerror(zip_.get()));
  return ZipEntry(entry, file_, purpose_, size_);
}

std::vector<std::string> ZipReader::names() const {
  std::vector<std::string> names;
  const zip_int64_t entries = zip_get_num_entries(zip_.get(), 0);
  for (zip_int64_t i = 0; i < entries; ++i)
    if (const char* name = zip_get_name(zip_.get(), static_cast<zip_uint64_t>(i), 0))
      names.emplace_back(name);
  return names;
}

std::string ZipReader::comment() const {
  int length = 0;
  const char* text = zip_get_archive_comment(zip_.get(), &length, 0);
  return text ? std::string(text, static_cast<std::size_t>(length)) : std::string();
}

Status ZipReader::check() const {
  const zip_int64_t entries = zip_get_num_entries(zip_.get(), 0);
  if (entries > kMostEntries)
    return too_much(file_, "has more than " + std::to_string(kMostEntries) + " entries");
  std::uint64_t decompressed = 0;
  const auto count = [&](std::string_view piece) -> Status {
    decompressed += piece.size();
    if (may_decompress(decompressed, size_)) return {};
    return too_much(file_, "unpacks to more than " + std::to_string(kMostDecompressedPerByte) +
                               " times its size");
  };
  for (zip_int64_t i = 0; i < entries; ++i) {
    auto found = entry(static_cast<std::uint64_t>(i));
    if (!found) return tl::make_unexpected(std::move(found.error()));
    if (Status read = for_each_piece(std::move(*found), count); !read) return read;
  }
  return {};
}

Result<std::string> ZipReader::text(const std::string& name) const {
  auto found = entry(name);
  if (!found) return tl::make_unexpected(std::move(found.error()));
  std::string text;
  const Status read = for_each_piece(std::move(*found), [&](std::string_view piece) -> Status {
    if (text.size() + piece.size() > kLargestText)
      return unreadable(file_, purpose_, name + " is too long");
    text += piece;
    return {};
  });
  if (!read) return tl::make_unexpected(read.error());
  return text;
}

}  // namespace softcnc::hal
