// SPDX-License-Identifier: MIT
#include "runtime/sinks/contour_rows.hpp"

#include <algorithm>

namespace softcnc::runtime {
namespace {

/// The part of a planned block between two places along the program, each stretch of it with the
/// line it comes from.
void add_block(const ipo::TimedBlock& timed, double from, double to, Contour& contour) {
  const Move* move = timed.move();
  if (!move) return;
  const double s1 = std::min(to - timed.s_start, length(move->path));
  double s0 = std::max(from - timed.s_start, 0.0);
  while (s0 < s1) {
    const auto next = std::upper_bound(timed.marks.begin(), timed.marks.end(), s0,
                                       [](double s, const ipo::Mark& mark) { return s < mark.s; });
    const double end = next == timed.marks.end() ? s1 : std::min(s1, next->s);
    contour.add({&move->path, s0, end}, timed.s_start + s0,
                {timed.at(s0).source.line, move->rapid});
    s0 = end;
  }
}

}  // namespace

std::vector<std::string> row_columns(const hal::Backend& backend) {
  const auto own = backend.columns();
  std::vector<std::string> columns(own.begin(), own.end());
  if (knows_contour(backend)) columns.emplace_back("contour_um");
  return columns;
}

void add_path(std::span<const Setpoint> rows, double from, const ipo::BlockQueue& queue,
              Contour& contour) {
  if (rows.empty()) return;
  contour.begin(from);
  const double to = rows.back().s + Contour::kAhead;
  queue.for_each([&](const ipo::TimedBlock& timed) { add_block(timed, from, to, contour); });
}

}  // namespace softcnc::runtime
