// SPDX-License-Identifier: MIT
// The only file that knows libzip.
#include "hal/files/zip_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zip.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/files/decompression_limit.hpp"

namespace softcnc::hal {
namespace {

// 1980-01-01 00:00, where the calendar of zip files begins.
constexpr zip_uint16_t kTime = 0;
constexpr zip_uint16_t kDate = (1U << 5U) | 1U;

constexpr std::size_t kLargestText = 1U << 20U;

tl::unexpected<Diagnostic> unreadable(const std::string& file, const std::string& reason) {
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC6021, .message = "cannot be read as a recording: " + reason, .file = file});
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

/// A zip while it is written; libzip asks for one thing after the other.
class ZipDestination {
 public:
  explicit ZipDestination(int descriptor) noexcept : descriptor_(descriptor) {
    zip_error_init(&error_);
  }
  ZipDestination(const ZipDestination&) = delete;
  ZipDestination& operator=(const ZipDestination&) = delete;
  ~ZipDestination() {
    zip_error_fini(&error_);
    ::close(descriptor_);
  }

  zip_int64_t begin() {
    return ::ftruncate(descriptor_, 0) == 0 && ::lseek(descriptor_, 0, SEEK_SET) == 0
               ? 0
               : failed(ZIP_ER_WRITE);
  }
  zip_int64_t write(const void* bytes, zip_uint64_t size) {
    const char* from = static_cast<const char*>(bytes);
    for (zip_uint64_t done = 0; done < size;) {
      const ssize_t n = ::write(descriptor_, from + done, size - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return failed(ZIP_ER_WRITE);
      done += static_cast<zip_uint64_t>(n);
    }
    return static_cast<zip_int64_t>(size);
  }
  zip_int64_t seek(void* arguments, zip_uint64_t size) {
    const auto* to = ZIP_SOURCE_GET_ARGS(zip_source_args_seek_t, arguments, size, &error_);
    if (!to) return -1;
    return ::lseek(descriptor_, to->offset, to->whence) < 0 ? failed(ZIP_ER_SEEK) : 0;
  }
  zip_int64_t tell() {
    const off_t place = ::lseek(descriptor_, 0, SEEK_CUR);
    return place < 0 ? failed(ZIP_ER_TELL) : place;
  }
  /// There is nothing in it yet that could be read.
  static zip_int64_t stat(void* to) {
    auto* info = static_cast<zip_stat_t*>(to);
    zip_stat_init(info);
    info->size = 0;
    info->valid = ZIP_STAT_SIZE;
    return sizeof *info;
  }
  zip_int64_t error(void* to, zip_uint64_t size) { return zip_error_to_data(&error_, to, size); }
  zip_int64_t refuse() {
    zip_error_set(&error_, ZIP_ER_OPNOTSUPP, 0);
    return -1;
  }

 private:
  zip_int64_t failed(int what) {
    zip_error_set(&error_, what, errno);
    return -1;
  }

  int descriptor_;
  zip_error_t error_;
};

namespace {

zip_int64_t answer(void* destination, void* data, zip_uint64_t size, zip_source_cmd_t asked) {
  auto* to = static_cast<ZipDestination*>(destination);
  switch (asked) {
    case ZIP_SOURCE_SUPPORTS:
      return zip_source_make_command_bitmap(
          ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL,
          ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, ZIP_SOURCE_BEGIN_WRITE,
          ZIP_SOURCE_COMMIT_WRITE, ZIP_SOURCE_ROLLBACK_WRITE, ZIP_SOURCE_WRITE,
          ZIP_SOURCE_SEEK_WRITE, ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_REMOVE, -1);
    case ZIP_SOURCE_STAT:
      return ZipDestination::stat(data);
    case ZIP_SOURCE_ERROR:
      return to->error(data, size);
    case ZIP_SOURCE_BEGIN_WRITE:
    case ZIP_SOURCE_REMOVE:
      return to->begin();
    case ZIP_SOURCE_WRITE:
      return to->write(data, size);
    case ZIP_SOURCE_SEEK_WRITE:
      return to->seek(data, size);
    case ZIP_SOURCE_TELL_WRITE:
      return to->tell();
    case ZIP_SOURCE_OPEN:  // of what there was before, which is nothing
    case ZIP_SOURCE_READ:
    case ZIP_SOURCE_SEEK:
    case ZIP_SOURCE_TELL:
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_COMMIT_WRITE:
    case ZIP_SOURCE_ROLLBACK_WRITE:
    case ZIP_SOURCE_FREE:
      return 0;
    default:
      return to->refuse();
  }
}

}  // namespace

ZipWriter::ZipWriter(std::string file) : file_(std::move(file)) {
  open(::open(file_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
}

ZipWriter::ZipWriter(int descriptor) { open(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)); }

/// libzip writes to a name by a file of another name beside it, which a killed run would leave; to
/// a source of ours it writes what it has to write and nothing else.
void ZipWriter::open(int descriptor) {
  zip_error_t error;
  zip_error_init(&error);
  if (descriptor < 0) zip_error_set(&error, ZIP_ER_OPEN, errno);
  if (descriptor >= 0) {
    destination_ = std::make_unique<ZipDestination>(descriptor);
    zip_source_t* source = zip_source_function_create(answer, destination_.get(), &error);
    if (source) zip_ = zip_open_from_source(source, ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (source && !zip_) zip_source_free(source);
  }
  if (!zip_) reason_ = zip_error_strerror(&error);
  zip_error_fini(&error);
}

ZipWriter::~ZipWriter() {
  if (zip_ != nullptr) zip_discard(zip_);
}

void ZipWriter::add_text(const std::string& name, std::string text) {
  const std::string& kept = texts_.emplace_back(std::move(text));
  add(name, zip_source_buffer(zip_, kept.data(), kept.size(), 0), Compression::deflate);
}

void ZipWriter::add_file(const std::string& name, const std::string& path, Compression packing) {
  add(name, zip_source_file(zip_, path.c_str(), 0, -1), packing);
}

void ZipWriter::add_descriptor(const std::string& name, int descriptor, Compression packing) {
  ::lseek(descriptor, 0, SEEK_SET);  // libzip reads from where it stands
  std::FILE* stream = ::fdopen(::dup(descriptor), "rb");
  zip_source_t* source = stream ? zip_source_filep(zip_, stream, 0, -1) : nullptr;
  if (stream && !source) std::fclose(stream);
  add(name, source, packing);
}

void ZipWriter::set_comment(const std::string& text) {
  const auto length = static_cast<zip_uint16_t>(text.size());
  if (reason_.empty() && zip_set_archive_comment(zip_, text.data(), length) != 0)
    reason_ = zip_strerror(zip_);
}

void ZipWriter::add(const std::string& name, void* source, Compression packing) {
  if (!reason_.empty()) return;
  auto* from = static_cast<zip_source_t*>(source);
  const zip_int64_t added = from ? zip_file_add(zip_, name.c_str(), from, ZIP_FL_ENC_UTF_8) : -1;
  if (added < 0) {
    if (from) zip_source_free(from);
    reason_ = zip_strerror(zip_);
    return;
  }
  const auto index = static_cast<zip_uint64_t>(added);
  const zip_int32_t method = packing == Compression::store ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
  if (zip_set_file_compression(zip_, index, method, 9) != 0 ||
      zip_file_set_dostime(zip_, index, kTime, kDate, 0) != 0)
    reason_ = zip_strerror(zip_);
}

Status ZipWriter::finish() {
  if (!reason_.empty()) return failure();
  if (zip_close(zip_) != 0) {
    reason_ = zip_strerror(zip_);
    return failure();
  }
  zip_ = nullptr;
  return {};
}

Status ZipWriter::failure() const {
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6012, .message = "writing failed: " + reason_, .file = file_});
}

ZipEntry::ZipEntry(zip_file* entry, std::string file, std::uint64_t file_size) noexcept
    : entry_(entry, zip_fclose), file_(std::move(file)), file_size_(file_size) {}

Result<std::size_t> ZipEntry::read(char* to, std::size_t size) {
  const zip_int64_t n = zip_fread(entry_.get(), to, size);
  if (n < 0) return unreadable(file_, zip_file_strerror(entry_.get()));
  return static_cast<std::size_t>(n);
}

ZipReader::ZipReader(zip* archive, std::string file, std::uint64_t size) noexcept
    : zip_(archive, zip_discard), file_(std::move(file)), size_(size) {}

Result<ZipReader> ZipReader::open(const std::string& file) {
  const bool standard_input = file == "-";
  const std::string path = standard_input ? "/dev/stdin" : file;
  const std::string shown = standard_input ? "<stdin>" : file;
  std::error_code unknown;
  const bool exists = std::filesystem::exists(path, unknown);
  if (exists && !std::filesystem::is_regular_file(path, unknown))
    return unreadable(shown, "it is not a regular file, which a recording must be");
  int code = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
  if (archive == nullptr) return unreadable(shown, text_of(code));
  const auto size = std::filesystem::file_size(path, unknown);
  return ZipReader(archive, shown, unknown ? 0 : size);
}

Result<ZipEntry> ZipReader::entry(const std::string& name) const {
  zip_file_t* entry = zip_fopen(zip_.get(), name.c_str(), 0);
  if (entry == nullptr) return unreadable(file_, name + ": " + zip_strerror(zip_.get()));
  return ZipEntry(entry, file_, size_);
}

Result<ZipEntry> ZipReader::entry(std::uint64_t index) const {
  zip_file_t* entry = zip_fopen_index(zip_.get(), index, 0);
  if (entry == nullptr)
    return unreadable(file_,
                      "entry " + std::to_string(index + 1) + ": " + zip_strerror(zip_.get()));
  return ZipEntry(entry, file_, size_);
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
    if (text.size() + piece.size() > kLargestText) return unreadable(file_, name + " is too long");
    text += piece;
    return {};
  });
  if (!read) return tl::make_unexpected(read.error());
  return text;
}

}  // namespace softcnc::hal
