// SPDX-License-Identifier: MIT
// Writes zip files. With zip_reader.cpp the only file that knows libzip.
#include "hal/files/zip_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zip.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace softcnc::hal {
namespace {

// 1980-01-01 00:00, where the calendar of zip files begins.
constexpr zip_uint16_t kTime = 0;
constexpr zip_uint16_t kDate = (1U << 5U) | 1U;

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

}  // namespace softcnc::hal
