// SPDX-License-Identifier: MIT
#include "hal/trace/trace_csv_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

namespace softcnc::hal {
namespace {

constexpr int kUnselected = -1;

/// A line with its number; its text is valid until the next one is read.
struct TextLine {
  int number = 0;
  std::string_view text;
};

/// The lines of a file, without their ends.
class LineReader {
 public:
  explicit LineReader(CompressedFile bytes) : bytes_(std::move(bytes)) {}

  /// Reads the next line into `line`; false at the end. Errors: those of the file, SC6082, SC6083.
  Result<bool> next(TextLine& line) {
    partial_.clear();
    for (;;) {
      const auto end = rest_.find('\n');
      if (partial_.size() + std::min(end, rest_.size()) > kLongestTraceLine)
        return failed(Code::SC6083, "longer than " + std::to_string(kLongestTraceLine) + " bytes");
      if (end != rest_.npos) return whole(end, line);
      partial_ += rest_;
      const auto more = bytes_.next();
      if (!more) return tl::make_unexpected(more.error());
      rest_ = *more;
      if (rest_.empty())
        return partial_.empty() ? Result<bool>(false)
                                : failed(Code::SC6082, "not whole: it ends within a line");
    }
  }

 private:
  Result<bool> whole(std::size_t end, TextLine& line) {
    line.text = rest_.substr(0, end);
    if (!partial_.empty()) line.text = partial_ += line.text;
    if (line.text.ends_with('\r')) line.text.remove_suffix(1);
    rest_.remove_prefix(end + 1);
    line.number = ++number_;
    return true;
  }

  Result<bool> failed(Code code, std::string why) const {
    return tl::make_unexpected(
        Diagnostic{.code = code, .pos = {.line = number_ + 1}, .message = std::move(why)});
  }

  CompressedFile bytes_;
  std::string_view rest_;  // of the last piece
  std::string partial_;    // a line that began in an earlier piece
  int number_ = 0;
};

class CsvTraceReader final : public TraceReader {
 public:
  CsvTraceReader(CompressedFile bytes, std::string name)
      : lines_(std::move(bytes)), name_(std::move(name)) {}

  Status read_names();
  Diagnostic wrong_value(std::size_t selected, std::string why) const override;

 private:
  Status select_columns(std::span<const std::size_t> columns) override;
  Result<bool> read_next() override;
  Result<bool> next_line();
  Status read_row();
  bool read_value(std::string_view text, std::size_t selected);
  bool read_limit(std::string_view text);
  Diagnostic wrong(std::size_t begin, std::size_t length, std::string why) const;

  LineReader lines_;
  std::string name_;
  TextLine line_;
  std::vector<int> selected_;       // of each column: its place in the selection, or kUnselected
  int limit_column_ = kUnselected;  // its place in the selection
  std::vector<std::string_view> texts_;  // of the selected values
};

/// The place of bytes of the line.
Diagnostic CsvTraceReader::wrong(std::size_t begin, std::size_t length, std::string why) const {
  Diagnostic diagnostic{.code = Code::SC6082, .message = std::move(why), .file = name_};
  diagnostic.pos.line = line_.number;
  if (length > 0) {
    diagnostic.pos.column = static_cast<int>(begin) + 1;
    diagnostic.pos.length = static_cast<int>(length);
    diagnostic.source_line = line_.text;
  }
  return diagnostic;
}

Diagnostic CsvTraceReader::wrong_value(std::size_t selected, std::string why) const {
  const std::string_view text = texts_[selected];
  return wrong(static_cast<std::size_t>(text.data() - line_.text.data()), text.size(),
               std::move(why));
}

/// The next line that is no comment.
Result<bool> CsvTraceReader::next_line() {
  for (;;) {
    auto read = lines_.next(line_);
    if (!read) read.error().file = name_;
    if (!read || !*read || !line_.text.starts_with('#')) return read;
    read_trace_comment(line_.text, comment_);
  }
}

Status CsvTraceReader::read_names() {
  const auto read = next_line();
  if (!read) return tl::make_unexpected(read.error());
  if (!*read)
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6082, .message = "has no names of columns", .file = name_});
  for (std::string_view names = line_.text; !names.empty();) {
    const auto comma = names.find(',');
    columns_.emplace_back(names.substr(0, comma));
    names.remove_prefix(comma == names.npos ? names.size() : comma + 1);
  }
  return {};
}

Status CsvTraceReader::select_columns(std::span<const std::size_t> columns) {
  selected_.assign(columns_.size(), kUnselected);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    selected_[columns[i]] = static_cast<int>(i);
    if (columns_[columns[i]] == kLimitColumn) limit_column_ = static_cast<int>(i);
  }
  values_.assign(columns.size(), 0);
  texts_.resize(columns.size());
  return {};
}

Result<bool> CsvTraceReader::read_next() {
  const auto read = next_line();
  if (!read || !*read) return read;
  if (Status good = read_row(); !good) return tl::make_unexpected(std::move(good.error()));
  return true;
}

Status CsvTraceReader::read_row() {
  const char* at = line_.text.data();
  const char* const end = at + line_.text.size();
  std::size_t column = 0;
  for (bool more = true; more; ++column) {
    const auto* comma =
        static_cast<const char*>(std::memchr(at, ',', static_cast<std::size_t>(end - at)));
    more = comma != nullptr;
    const std::string_view text(at, static_cast<std::size_t>((more ? comma : end) - at));
    if (column < selected_.size() && selected_[column] != kUnselected)
      if (const auto selected = static_cast<std::size_t>(selected_[column]);
          !read_value(text, selected))
        return tl::make_unexpected(
            wrong_value(selected, "'" + std::string(text) + "' is no " +
                                      (columns_[column] == kLimitColumn ? "limit" : "number") +
                                      ", in the column " + columns_[column]));
    if (more) at = comma + 1;
  }
  if (column == columns_.size()) return {};
  return tl::make_unexpected(wrong(0, 0,
                                   "has " + std::to_string(column) + " values, and there are " +
                                       std::to_string(columns_.size()) + " columns"));
}

bool CsvTraceReader::read_value(std::string_view text, std::size_t selected) {
  texts_[selected] = text;
  if (static_cast<int>(selected) == limit_column_) return read_limit(text);
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), values_[selected]);
  return error == std::errc() && end == text.data() + text.size();
}

bool CsvTraceReader::read_limit(std::string_view text) {
  if (text == softcnc::name(limit_)) return true;  // as most are
  const auto found = std::find(kLimitNames.begin(), kLimitNames.end(), text);
  if (found == kLimitNames.end()) return false;
  limit_ = static_cast<Limit>(found - kLimitNames.begin());
  return true;
}

}  // namespace

Result<std::unique_ptr<TraceReader>> open_csv_trace(CompressedFile bytes, const std::string& name) {
  auto reader = std::make_unique<CsvTraceReader>(std::move(bytes), name);
  if (Status read = reader->read_names(); !read) return tl::make_unexpected(read.error());
  return reader;
}

Result<std::unique_ptr<TraceReader>> open_csv_trace(const std::string& file) {
  auto bytes = CompressedFile::open(file, Code::SC6081, Code::SC6082);
  if (!bytes) return tl::make_unexpected(std::move(bytes.error()));
  return open_csv_trace(std::move(*bytes), file);
}

}  // namespace softcnc::hal
