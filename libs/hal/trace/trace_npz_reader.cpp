// SPDX-License-Identifier: MIT
#include "hal/trace/trace_npz_reader.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "hal/files/compressed_file.hpp"
#include "hal/files/npz_file.hpp"
#include "hal/files/temporary_file.hpp"
#include "hal/trace/trace_npz.hpp"

namespace softcnc::hal {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they are stored");

constexpr ZipPurpose kPurpose{"a trace", Code::SC6082};
constexpr std::string_view kSuffix = ".npy";

Status damaged(const std::string& file, std::string why) {
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6082, .message = std::move(why), .file = file});
}

/// Reads exactly as many bytes; false where there are fewer.
Result<bool> read_all(ZipEntry& entry, char* to, std::size_t size) {
  while (size > 0) {
    const auto n = entry.read(to, size);
    if (!n) return tl::make_unexpected(n.error());
    if (*n == 0) return false;
    to += *n;
    size -= *n;
  }
  return true;
}

/// An array that is read from its beginning, piece by piece.
class NpzColumnReader {
 public:
  NpzColumnReader(std::string column, ZipEntry entry)
      : column_(std::move(column)), entry_(std::move(entry)) {}

  /// Reads the head. Errors: SC6082.
  Status begin(const std::string& file);
  std::int64_t rows() const noexcept { return array_.rows; }
  bool is_text() const noexcept { return array_.kind == NpyArray::Kind::text; }
  const std::string& name() const noexcept { return column_; }

  /// Reads as many rows into memory. Errors: SC6082.
  Status fill(std::size_t rows, const std::string& file);
  /// Checks, after the last row, that the column ends there and is what its checksum says. Errors:
  /// SC6082.
  Status finish(const std::string& file);
  /// A value of those in memory; its column must hold numbers.
  double number(std::size_t row) const noexcept;
  /// Its text, of which only ASCII characters count; its column must hold texts.
  void read_text(std::size_t row, std::string& text) const;

 private:
  template <typename T>
  T value(std::size_t row) const noexcept {
    T value;
    std::memcpy(&value, bytes_.data() + row * sizeof(T), sizeof value);
    return value;
  }

  std::string column_;
  ZipEntry entry_;
  NpyArray array_;
  std::string bytes_;
};

Status NpzColumnReader::begin(const std::string& file) {
  std::string head(kNpyHeadStart, '\0');
  auto whole = read_all(entry_, head.data(), head.size());
  if (whole && *whole) {
    const std::size_t start = head.size();
    head.resize(start + npy_text_length(head));
    whole = read_all(entry_, head.data() + start, head.size() - start);
  }
  if (!whole) return tl::make_unexpected(whole.error());
  const auto array = *whole ? read_npy_head(head) : std::nullopt;
  if (!array) return damaged(file, "its column " + column_ + " is no array that can be read");
  array_ = *array;
  return {};
}

Status NpzColumnReader::fill(std::size_t rows, const std::string& file) {
  bytes_.resize(rows * array_.size);
  const auto whole = read_all(entry_, bytes_.data(), bytes_.size());
  if (!whole) return tl::make_unexpected(whole.error());
  if (!*whole) return damaged(file, "not whole: its column " + column_ + " ends too early");
  return {};
}

Status NpzColumnReader::finish(const std::string& file) {
  char further = 0;
  const auto read = entry_.read(&further, 1);
  if (!read) return tl::make_unexpected(read.error());
  if (*read > 0) return damaged(file, "its column " + column_ + " goes on after its last row");
  return {};
}

double NpzColumnReader::number(std::size_t row) const noexcept {
  const bool is_short = array_.size == sizeof(float);
  if (array_.kind == NpyArray::Kind::real)
    return is_short ? static_cast<double>(value<float>(row)) : value<double>(row);
  return is_short ? static_cast<double>(value<std::int32_t>(row))
                  : static_cast<double>(value<std::int64_t>(row));
}

void NpzColumnReader::read_text(std::size_t row, std::string& text) const {
  text.clear();
  const std::size_t characters = array_.size / sizeof(char32_t);
  for (std::size_t i = 0; i < characters; ++i) {
    const auto character = value<char32_t>(row * characters + i);
    if (character == 0) return;
    text += character < 0x80 ? static_cast<char>(character) : '?';
  }
}

class NpzTraceReader final : public TraceReader {
 public:
  NpzTraceReader(std::string file, std::optional<TemporaryFile> unpacked, ZipReader zip);

  Diagnostic wrong_value(std::size_t selected, std::string why) const override;

 private:
  Status select_columns(std::span<const std::size_t> columns) override;
  Result<bool> read_next() override;
  Status add(const std::string& column);
  Status fill();
  Status read_limit(const NpzColumnReader& column, std::size_t row);

  std::string file_;
  std::optional<TemporaryFile> unpacked_;
  ZipReader zip_;
  std::vector<NpzColumnReader> selected_;
  std::int64_t rows_ = 0, row_ = 0;  // of the file; that have been read
  std::int64_t filled_ = 0;          // rows up to the end of those in memory
  std::string text_;
};

NpzTraceReader::NpzTraceReader(std::string file, std::optional<TemporaryFile> unpacked,
                               ZipReader zip)
    : file_(std::move(file)), unpacked_(std::move(unpacked)), zip_(std::move(zip)) {
  for (const std::string& name : zip_.names())
    if (name.ends_with(kSuffix)) columns_.push_back(name.substr(0, name.size() - kSuffix.size()));
  const std::string comment = zip_.comment();
  for (std::string_view lines = comment; !lines.empty();) {
    const auto end = std::min(lines.find('\n'), lines.size() - 1);
    read_trace_comment(lines.substr(0, end + 1), comment_);
    lines.remove_prefix(end + 1);
  }
}

Status NpzTraceReader::select_columns(std::span<const std::size_t> columns) {
  selected_.clear();
  for (const std::size_t column : columns)
    if (Status added = add(columns_[column]); !added) return added;
  values_.assign(columns.size(), 0);
  rows_ = selected_.empty() ? 0 : selected_.front().rows();
  for (const NpzColumnReader& column : selected_)
    if (column.rows() != rows_)
      return damaged(file_, "its column " + column.name() + " has " +
                                std::to_string(column.rows()) + " rows, and " +
                                selected_.front().name() + " has " + std::to_string(rows_));
  return {};
}

Status NpzTraceReader::add(const std::string& column) {
  auto entry = zip_.entry(column + std::string(kSuffix));
  if (!entry) return tl::make_unexpected(std::move(entry.error()));
  NpzColumnReader& added = selected_.emplace_back(column, std::move(*entry));
  if (Status begun = added.begin(file_); !begun) return begun;
  if (added.is_text() == (column == kLimitColumn)) return {};
  return damaged(file_,
                 "its column " + column + " holds " + (added.is_text() ? "text" : "numbers"));
}

Status NpzTraceReader::fill() {
  const auto rows = std::min(static_cast<std::int64_t>(kNpzRows), rows_ - row_);
  for (NpzColumnReader& column : selected_)
    if (Status filled = column.fill(static_cast<std::size_t>(rows), file_); !filled) return filled;
  filled_ = row_ + rows;
  return {};
}

Result<bool> NpzTraceReader::read_next() {
  if (row_ == rows_) {
    for (NpzColumnReader& column : selected_)
      if (Status whole = column.finish(file_); !whole)
        return tl::make_unexpected(std::move(whole.error()));
    return false;
  }
  if (row_ == filled_)
    if (Status filled = fill(); !filled) return tl::make_unexpected(std::move(filled.error()));
  const auto row = static_cast<std::size_t>(row_ % static_cast<std::int64_t>(kNpzRows));
  ++row_;
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const NpzColumnReader& column = selected_[i];
    if (!column.is_text())
      values_[i] = column.number(row);
    else if (Status read = read_limit(column, row); !read)
      return tl::make_unexpected(wrong_value(i, std::move(read.error().message)));
  }
  return true;
}

Status NpzTraceReader::read_limit(const NpzColumnReader& column, std::size_t row) {
  column.read_text(row, text_);
  if (text_ == name(limit_)) return {};  // as most are
  const auto found = std::find(kLimitNames.begin(), kLimitNames.end(), text_);
  if (found == kLimitNames.end()) return damaged(file_, "'" + text_ + "' is no limit");
  limit_ = static_cast<Limit>(found - kLimitNames.begin());
  return {};
}

Diagnostic NpzTraceReader::wrong_value(std::size_t selected, std::string why) const {
  return {.code = Code::SC6082,
          .message = "row " + std::to_string(row_) + " of its column " +
                     selected_[selected].name() + ": " + std::move(why),
          .file = file_};
}

/// Errors: SC6003, SC6081, SC6082.
Result<TemporaryFile> unpack(const std::string& file) {
  auto bytes = CompressedFile::open(file, Code::SC6081, Code::SC6082);
  if (!bytes) return tl::make_unexpected(std::move(bytes.error()));
  auto unpacked = TemporaryFile::make();
  while (unpacked) {
    const auto piece = bytes->next();
    if (!piece) return tl::make_unexpected(piece.error());
    if (piece->empty()) break;
    if (Status added = unpacked->add(*piece); !added)
      return tl::make_unexpected(std::move(added.error()));
  }
  return unpacked;
}

}  // namespace

Result<std::unique_ptr<TraceReader>> open_npz_trace(const std::string& file, bool compressed) {
  std::optional<TemporaryFile> unpacked;
  if (compressed) {
    auto made = unpack(file);
    if (!made) return tl::make_unexpected(std::move(made.error()));
    unpacked.emplace(std::move(*made));
  }
  std::error_code ignored;
  if (!compressed && !std::filesystem::exists(file, ignored))
    return tl::make_unexpected(Diagnostic{.code = Code::SC6081,
                                          .message = "cannot be read: No such file or directory",
                                          .file = file});
  auto zip = compressed ? ZipReader::open(unpacked->descriptor(), file, kPurpose)
                        : ZipReader::open(file, kPurpose);
  if (!zip) return tl::make_unexpected(std::move(zip.error()));
  return std::make_unique<NpzTraceReader>(file, std::move(unpacked), std::move(*zip));
}

}  // namespace softcnc::hal
