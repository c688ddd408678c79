// SPDX-License-Identifier: MIT
#include "ipo/path/long_curve.hpp"

#include <algorithm>

#include "ipo/tuning.hpp"
#include "motion/geometry/section.hpp"

namespace softcnc::ipo {
namespace {

/// Returns where a part that starts at `begin` ends: at the end of a span, or of the path where
/// little would be left.
double end_of_stretch(const Path& path, double begin) {
  const auto joints = breaks(path);
  const auto next = std::upper_bound(joints.begin(), joints.end(), begin);
  const auto left = static_cast<std::size_t>(joints.end() - next);
  return left > 2 * tuning::path::kSpansOfPart ? next[tuning::path::kSpansOfPart - 1]
                                               : length(path);
}

}  // namespace

bool is_long_curve(const Piece& piece) noexcept {
  const Move* move = std::get_if<Move>(&piece.block.what);
  return move && piece.marks.empty() && breaks(move->path).size() > tuning::path::kMostSpansAtOnce;
}

Piece next_stretch(const Piece& curve, double& begin) {
  const Move& whole = std::get<Move>(curve.block.what);
  const double end = end_of_stretch(whole.path, begin);
  Move part = make_move(section(whole.path, begin, end), attributes_of(whole));
  const bool is_last = end >= length(whole.path);
  part.path_mode = is_last ? whole.path_mode : PathMode::follow;
  part.exact = whole.exact;
  begin = end;
  return {{std::move(part), curve.block.source, curve.block.number}, {}, curve.deviation};
}

}  // namespace softcnc::ipo
