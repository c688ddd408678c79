// SPDX-License-Identifier: MIT
#include "hal/machine/toml_depth.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace softcnc::hal {
namespace {

/// Goes through a text once. Strings and comments are passed over as TOML 1.0 reads them; where a
/// text is wrong, a parser stops at the first error, and no deeper than this has counted.
class DepthScan {
 public:
  explicit DepthScan(std::string_view text) : text_(text) {}

  Status run();

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\n'; }
  void take(char c);
  void take_string(char quote);
  void take_long_string(char quote);
  void take_line_end();
  void open();
  void close();
  Status too_deep() const;

  std::string_view text_;
  std::size_t i_ = 0, line_begin_ = 0;
  int line_ = 1;
  std::size_t dots_ = 0;              // of the key, or number, that is being read
  std::vector<std::size_t> open_;     // levels that each open bracket has added
  std::size_t levels_ = 0;            // their sum
  bool blank_ = true, head_ = false;  // nothing on the line yet; it is that of a table's name
};

Status DepthScan::run() {
  for (; i_ < text_.size(); ++i_) {
    take(text_[i_]);
    if (levels_ + dots_ > kMaxTomlDepth) return too_deep();
  }
  return {};
}

void DepthScan::take(char c) {
  if (c == '\n') return take_line_end();
  if (c == '#') {
    i_ = std::min(text_.find('\n', i_), text_.size()) - 1;
  } else if (c == '"' || c == '\'') {
    take_string(c);
  } else if (c == '[' || c == '{') {
    head_ = head_ || (blank_ && open_.empty());
    open();
  } else if (c == ']' || c == '}') {
    close();
  } else if (c == ',') {
    dots_ = 0;
  } else if (c == '.') {
    ++dots_;
  }
  blank_ = blank_ && (c == ' ' || c == '\t');
}

void DepthScan::take_line_end() {
  ++line_;
  line_begin_ = i_ + 1;
  if (head_) {
    open_.clear();
    levels_ = 0;
  }
  if (open_.empty()) dots_ = 0;
  blank_ = true;
  head_ = false;
}

void DepthScan::open() {
  open_.push_back(dots_ + 1);
  levels_ += dots_ + 1;
  dots_ = 0;
}

void DepthScan::close() {
  dots_ = 0;
  if (open_.empty()) return;
  levels_ -= open_.back();
  open_.pop_back();
}

/// Leaves i_ on the last quote, or ahead of the line's end where there is none.
void DepthScan::take_string(char quote) {
  if (at(i_ + 1) == quote && at(i_ + 2) == quote) return take_long_string(quote);
  for (++i_; at(i_) != quote && at(i_) != '\n'; ++i_)
    if (quote == '"' && at(i_) == '\\' && at(i_ + 1) != '\n') ++i_;
  if (at(i_) != quote) --i_;
}

/// Up to two quotes may stand ahead of the three that end it.
void DepthScan::take_long_string(char quote) {
  for (i_ += 3; i_ < text_.size(); ++i_) {
    if (text_[i_] == '\n') {
      ++line_;
      line_begin_ = i_ + 1;
    } else if (quote == '"' && text_[i_] == '\\' && at(i_ + 1) != '\n') {
      ++i_;
    } else if (text_[i_] == quote && at(i_ + 1) == quote && at(i_ + 2) == quote) {
      i_ += 2;
      for (int more = 0; more < 2 && at(i_ + 1) == quote; ++more) ++i_;
      return;
    }
  }
}

Status DepthScan::too_deep() const {
  const int column = static_cast<int>(i_ - line_begin_) + 1;
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC7022,
      .pos = {line_, column, 1},
      .message = "nested too deeply: more than " + std::to_string(kMaxTomlDepth) + " levels"});
}

Status check_lines(std::string_view text) {
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    if (length > kLongestTomlLine)
      return tl::make_unexpected(Diagnostic{
          .code = Code::SC7002,
          .pos = {line, 1, 1},
          .message =
              "not TOML: a line longer than " + std::to_string(kLongestTomlLine) + " bytes"});
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return {};
}

}  // namespace

Status check_toml_depth(std::string_view text) {
  if (Status lines = check_lines(text); !lines) return lines;
  return DepthScan(text).run();
}

}  // namespace softcnc::hal
