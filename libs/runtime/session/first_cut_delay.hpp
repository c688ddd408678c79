// SPDX-License-Identifier: MIT
// A rest that shifts the first cutting move of a program against the instants of its samples.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "motion/model/block.hpp"

namespace softcnc::runtime {

/// Where the rest may stand: where the machine rests in any case, or before all blocks, for methods
/// that pass corners at speed.
enum class DelayPlace : std::uint8_t { before_cut, at_start };

/// Reads blocks up to the first cutting move, or to the end of the program, and returns them with a
/// dwell of `delay` s where the machine rests in any case: directly before that move if the path
/// turns there, since corners between rapids and cutting moves are never rounded; otherwise after
/// the last block that is no move, or as the first block. So the dwell changes no speed, and all
/// that follows it comes later by exactly `delay`. Of a program with more than 1000 blocks before
/// its first cutting move, the rest counts that comes last among these. `next` returns the blocks
/// of the program, one after the other, and nothing after the last.
std::deque<Block> with_first_cut_delayed(const std::function<std::optional<Block>()>& next,
                                         double delay, DelayPlace where = DelayPlace::before_cut);

}  // namespace softcnc::runtime
