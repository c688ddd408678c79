// SPDX-License-Identifier: MIT
#include "ipr/interpreter/stated_stock.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "ipr/parser/stock_comment.hpp"
#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::size_t kMostOutlines = 100;
constexpr double kWithin = 5e-4;  // mm: what messages would round to nothing
constexpr int kJudgedAxes = 2;    // how low a stock may lie depends on the lengths of the tools

bool place_is_unknown(const Modal& modal) noexcept {
  const Unknown& unknown = modal.unknown;
  return unknown.has(Part::units) || unknown.has(Part::work_system) || unknown.has(Part::shift) ||
         unknown.has(Part::mirror) || unknown.has(Part::scaling) || unknown.has(Part::rotation);
}

void place(StockOutline& stock, const Modal& modal) {
  const Coordinates coordinates(modal.work(), modal.shift(), AxisVector::Zero());
  const auto placed = [&](const AxisVector& point) -> AxisVector {
    const AxisVector machine = coordinates.to_machine(point);
    return modal.placement ? AxisVector(modal.placement->map(machine)) : machine;
  };
  for (auto& [from, to] : stock.edges) {
    from = placed(from);
    to = placed(to);
  }
}

/// Once a line: a loop may state it again and again.
void check_travel(const StockOutline& stock, SourcePos pos, const Machine& machine, Output& out) {
  const Extent box = extent(stock);
  for (int i = 0; i < kJudgedAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    const double below = axis.min - box.min[i], above = box.max[i] - axis.max;
    if (std::max(below, above) <= kWithin) continue;
    const char letter = kAxisLetters[static_cast<std::size_t>(i)];
    out.report_once(Code::SC4091, pos, std::to_string(pos.line) + letter,
                    std::string("the stock lies from ") + letter + ' ' + number_text(box.min[i]) +
                        " to " + number_text(box.max[i]) + " mm, " +
                        number_text(std::max(below, above)) + " mm beyond the travel from " +
                        number_text(axis.min) + " to " + number_text(axis.max) + " mm");
  }
}

}  // namespace

void StatedStock::add(std::string_view comment, SourcePos pos, const Modal& modal,
                      const Machine& machine, Output& out) {
  if (place_is_unknown(modal)) return;
  auto stock = read_stock(comment, modal.mm_per_unit);
  if (!stock)
    return out.report_once(stock.error().code, pos, std::to_string(pos.line),
                           stock.error().message);
  stock->file = pos.file;
  stock->line = pos.line;
  place(*stock, modal);
  check_travel(*stock, pos, machine, out);
  const bool known = std::find(outlines_.begin(), outlines_.end(), *stock) != outlines_.end();
  if (!known && outlines_.size() < kMostOutlines) outlines_.push_back(std::move(*stock));
}

}  // namespace softcnc::ipr
