// SPDX-License-Identifier: MIT
#include "runtime/session/motion_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"
#include "motion/model/fastest_move.hpp"

namespace softcnc::runtime {
namespace {

double speed(const Move& move, const Machine& machine, double feed_override) {
  return move.rapid ? fastest_move(machine) : asked_feed(move, feed_override);
}

}  // namespace

double least_time(const Block& block, const Machine& machine, double feed_override) {
  if (const auto* dwell = std::get_if<Dwell>(&block.what)) return dwell->duration;
  const auto* move = std::get_if<Move>(&block.what);
  const double fast = move != nullptr ? speed(*move, machine, feed_override) : 0;
  return fast > 0 ? length(move->path) / fast : 0;
}

std::optional<Diagnostic> MotionLimit::check(const Block& block, double planned) {
  if (std::isfinite(planned)) least_ = std::max(least_, planned);
  least_ += least_time(block, machine_, feed_override_);
  return check_end(block, least_);
}

/// A block in which the machine is held has no end until the hold is released.
std::optional<Diagnostic> MotionLimit::check_end(const Block& block, double end) const {
  const double limit = machine_.program.motion_limit;
  if (limit == 0 || end <= limit || std::isinf(end)) return std::nullopt;
  return Diagnostic{
      .code = Code::SC4050,
      .pos = block.source,
      .message = fmt::format("the program moves for more than {:.6g} h: {:.6g} h up to the end "
                             "of this line",
                             h_from_s(limit), h_from_s(end))};
}

}  // namespace softcnc::runtime
