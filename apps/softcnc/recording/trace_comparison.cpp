// SPDX-License-Identifier: MIT
#include "recording/trace_comparison.hpp"

#include <fmt/format.h>

#include "recording/row_comparison.hpp"

namespace softcnc::app {
namespace {

class ComparisonSink final : public hal::ByteSink {
 public:
  explicit ComparisonSink(TraceComparison& comparison) : comparison_(comparison) {}
  Status write(std::string_view bytes) override {
    if (comparison_.take(bytes)) return {};
    return tl::make_unexpected(Diagnostic{.code = Code::SC6013, .message = "a row differs"});
  }
  Status finish() override { return {}; }

 private:
  TraceComparison& comparison_;
};

}  // namespace

bool TraceComparison::take(std::string_view bytes) {
  while (difference_.empty() && status()) {
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) {
      partial_ += bytes;
      return true;
    }
    partial_ += bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    line(partial_);
    partial_.clear();
  }
  return false;
}

void TraceComparison::line(std::string_view line) {
  if (line.starts_with('#')) return;
  if (columns_.empty())
    columns(line);
  else
    row(line);
}

void TraceComparison::columns(std::string_view line) {
  columns_ = split(line);
  const auto recorded = recorded_.next();
  if (recorded == line) return;
  difference_ = fmt::format("the columns differ\n  recorded: {}\n  replayed: {}\n",
                            recorded.value_or("none"), line);
  in_words_ = fmt::format("the columns differ: {} in the recording, {} here",
                          recorded.value_or("none"), line);
}

void TraceComparison::row(std::string_view line) {
  const auto recorded = recorded_.next();
  if (recorded && same_row(columns_, *recorded, line)) {
    ++rows_;
    return;
  }
  in_words_ = fmt::format("row {} {}", rows_ + 1,
                          recorded ? "differs" : "is not in the recording, which ends earlier");
  difference_ = in_words_ + '\n' + side_by_side(columns_, recorded.value_or(""), line);
  if (recorded) in_words_ += ": " + app::in_words(columns_, *recorded, line);
}

void TraceComparison::finish() {
  if (!difference_.empty() || !status()) return;
  if (const auto recorded = recorded_.next()) {
    in_words_ = fmt::format("row {} is recorded, but the replay ends earlier", rows_ + 1);
    difference_ = in_words_ + '\n' + side_by_side(columns_, *recorded, "");
  }
}

std::unique_ptr<hal::ByteSink> comparison_sink(TraceComparison& comparison) {
  return std::make_unique<ComparisonSink>(comparison);
}

}  // namespace softcnc::app
