// SPDX-License-Identifier: MIT
// The stocks that a program states, where they lie on the machine.
#pragma once

#include <string_view>
#include <vector>

#include "ipr/lines/output.hpp"
#include "ipr/state/modal.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/stock_outline.hpp"

namespace softcnc::ipr {

class StatedStock {
 public:
  /// Adds the stock of a comment, which lies where moves to its corners would end without a tool
  /// offset. It is left out where an error has left open where that is. Warnings: SC2388 (it cannot
  /// be read), SC4091 (it reaches beyond the travel of X or Y).
  void add(std::string_view comment, SourcePos pos, const Modal& modal, const Machine& machine,
           Output& out);

  /// Returns the first hundred that differ, in machine coordinates.
  const std::vector<StockOutline>& outlines() const noexcept { return outlines_; }

 private:
  std::vector<StockOutline> outlines_;
};

}  // namespace softcnc::ipr
