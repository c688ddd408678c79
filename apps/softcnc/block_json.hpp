// SPDX-License-Identifier: MIT
// A block as one line of JSON.
#pragma once

#include <string>
#include <string_view>

#include "motion/block.hpp"

namespace softcnc::app {

/// Writes numbers in the shortest form that reads back exactly. Blocks must come in their order:
/// what does not move stands where the last move ended.
class BlockJson {
 public:
  /// Valid until the next call; ends with a newline.
  std::string_view operator()(const Block& block);

 private:
  void key(std::string_view name);
  void number(std::string_view name, double value);
  void vector(std::string_view name, const AxisVector& value);
  void word(std::string_view name, std::string_view value);
  template <typename Range, typename Append>
  void list(std::string_view name, const Range& range, Append&& append);
  void append(double value);
  void append(const AxisVector& value);

  void write(const Move& move);
  void write(const Dwell& dwell);
  void write(const Action& action);
  void details(const Line&) {}
  void details(const Arc& arc);
  void details(const Nurbs& nurbs);

  std::string text_;
};

}  // namespace softcnc::app
