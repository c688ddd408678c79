// SPDX-License-Identifier: MIT
// A block as one line of JSON.
#pragma once

#include <string>
#include <string_view>

#include "motion/model/block.hpp"
#include "output/text_buffer.hpp"

namespace softcnc::app {

/// Writes numbers in the shortest form that reads back exactly. Blocks must come in their order:
/// what does not move stands where the last move ended.
class BlockJson {
 public:
  /// `outputs` give their names to blocks that set them, and must outlive this; nullptr: none do.
  explicit BlockJson(const OutputPorts* outputs = nullptr) noexcept : outputs_(outputs) {}

  /// Valid until the next call; ends with a newline. `file`: of a block of another file than the
  /// program's own.
  std::string_view operator()(const Block& block, const std::string& file = {});

 private:
  // A key is given as it stands in the text, with quotation marks and colon.
  template <typename Key, typename Value>
  void value(const Key& key, const Value& value);
  void word(std::string_view key, std::string_view value);
  void name_file(const std::string& file);
  template <typename Key>
  void place(const Key& key, const AxisVector& value);
  template <typename Key, typename Range>
  void list(const Key& key, const Range& range);
  void add(int value) { text_.add(value); }
  void add(double value) { text_.add(value); }
  void add(const AxisVector& value);

  void write(const Move& move);
  void write(const Dwell& dwell);
  void write(const Action& action);
  void details(const Line&) {}
  void details(const Arc& arc);
  void details(const Nurbs& nurbs);
  void write(const Surface& surface);
  void write_output(const Action& action);

  const OutputPorts* outputs_;
  TextBuffer text_;
  AxisVector last_ = AxisVector::Zero();  // the place written last, most often the next `from`
  TextBuffer last_text_;                  // how it is written; empty before the first
  std::string file_, file_text_;          // named last, and as a string of JSON
};

}  // namespace softcnc::app
