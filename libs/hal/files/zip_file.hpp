// SPDX-License-Identifier: MIT
// Zip files: written so that the same content gives the same bytes, read piece by piece.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/result.hpp"

struct zip;
struct zip_file;

namespace softcnc::hal {

enum class Compression { store, deflate };

class ZipDestination;

class ZipWriter {
 public:
  /// Makes a writer into a file, which is made or emptied.
  explicit ZipWriter(std::string file);
  /// Makes a writer into an open file, over all that is in it.
  explicit ZipWriter(int descriptor);
  ~ZipWriter();
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  /// Adds an entry. Entries stand in the zip in the order in which they are added, all with one
  /// fixed date.
  void add_text(const std::string& name, std::string text);
  /// Adds a file as an entry; finish() reads `path`.
  void add_file(const std::string& name, const std::string& path, Compression packing);
  /// The same of a file that is open, from its beginning.
  void add_descriptor(const std::string& name, int descriptor, Compression packing);
  /// Sets the comment of the zip as a whole.
  void set_comment(const std::string& text);

  /// Writes the zip. Errors: SC6012.
  Status finish();

 private:
  void open(int descriptor);
  void add(const std::string& name, void* source, Compression packing);
  Status failure() const;

  std::string file_;  // its name, if it has one
  std::unique_ptr<ZipDestination> destination_;
  zip* zip_ = nullptr;
  std::string reason_;             // of the first error
  std::deque<std::string> texts_;  // alive until finish()
};

/// What a zip that is read has to be, for its messages.
struct ZipPurpose {
  std::string_view name = "a recording";
  Code unreadable = Code::SC6021;
};

/// One entry while it is read.
class ZipEntry {
 public:
  ZipEntry(zip_file* entry, std::string file, ZipPurpose purpose, std::uint64_t file_size) noexcept;

  /// Reads up to `size` bytes and returns how many; 0 at the end. Errors: that of its purpose.
  Result<std::size_t> read(char* to, std::size_t size);

  /// Returns the number of bytes of the zip that holds the entry.
  std::uint64_t file_size() const noexcept { return file_size_; }

 private:
  std::unique_ptr<zip_file, int (*)(zip_file*)> entry_;
  std::string file_;
  ZipPurpose purpose_;
  std::uint64_t file_size_;
};

/// The largest number of entries of a zip that is read: a recording has one for each file that its
/// program calls.
inline constexpr std::int64_t kMostEntries = 10'000;

class ZipReader {
 public:
  /// Opens a zip, or standard input if its name is "-", which must be a regular file like any
  /// other. Errors: that of its purpose.
  static Result<ZipReader> open(const std::string& file, ZipPurpose purpose = {});
  /// Reads an open file from its beginning; `name` is that of messages.
  static Result<ZipReader> open(int descriptor, const std::string& name, ZipPurpose purpose = {});

  /// Returns an entry. Errors: that of its purpose.
  Result<ZipEntry> entry(const std::string& name) const;

  /// Returns the names of its entries, in their order.
  std::vector<std::string> names() const;
  /// Returns the comment of the zip as a whole.
  std::string comment() const;

  /// Reads all entries against their checksums. Errors: SC6021; SC6024 where there are more than
  /// kMostEntries, or more comes out of them than may_decompress().
  Status check() const;

  /// Returns all of an entry that is known to be short.
  Result<std::string> text(const std::string& name) const;

 private:
  ZipReader(zip* archive, std::string file, ZipPurpose purpose, std::uint64_t size) noexcept;
  Result<ZipEntry> entry(std::uint64_t index) const;

  std::unique_ptr<zip, void (*)(zip*)> zip_;
  std::string file_;
  ZipPurpose purpose_;
  std::uint64_t size_;  // bytes of the file
};

/// Calls take(bytes) for an entry, piece by piece.
template <typename Take>
Status for_each_piece(ZipEntry entry, Take&& take) {
  std::string piece(65536, '\0');
  for (;;) {
    const auto n = entry.read(piece.data(), piece.size());
    if (!n) return tl::make_unexpected(n.error());
    if (*n == 0) return {};
    if (Status taken = take(std::string_view(piece.data(), *n)); !taken) return taken;
  }
}

}  // namespace softcnc::hal
