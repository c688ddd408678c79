// SPDX-License-Identifier: MIT
// A rest that shifts the first cutting move of a program against the instants of its samples.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "motion/model/block.hpp"
#include "motion/model/method.hpp"

namespace softcnc::runtime {

/// Where the rest may stand: where the machine rests in any case; directly before the first cutting
/// move, for chords, which begin again at every rest; or before all blocks, for methods that
/// accelerate after interpolation, whose motion a rest would change.
enum class DelayPlace : std::uint8_t { at_rest, before_cut, at_start };

/// Returns the place for a method.
constexpr DelayPlace delay_place(Method method) noexcept {
  if (method == Method::chords) return DelayPlace::before_cut;
  return ignores_plan(method) ? DelayPlace::at_start : DelayPlace::at_rest;
}

/// Reads blocks up to the first cutting move, or to the end of the program, and returns them with a
/// dwell of `delay` s where the machine rests in any case: directly before that move if the path
/// turns there, since corners between rapids and cutting moves are never rounded; otherwise after
/// the last block that is no move, or as the first block. So the dwell changes no speed, and all
/// that follows it comes later by exactly `delay`. Of a program with more than 1000 blocks before
/// its first cutting move, the rest counts that comes last among these. `next` returns the blocks
/// of the program, one after the other, and nothing after the last.
std::deque<Block> with_first_cut_delayed(const std::function<std::optional<Block>()>& next,
                                         double delay, DelayPlace where = DelayPlace::at_rest);

}  // namespace softcnc::runtime
