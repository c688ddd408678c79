// SPDX-License-Identifier: MIT
#include "runtime/session/first_cut_delay.hpp"

#include <utility>

#include "ipo/tuning.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::size_t kMostBlocks = 1000;  // before the first cutting move

/// Whether the machine rests between two moves in any case, of which one is a rapid.
bool rests_between(const Move& before, const Move& after) {
  if (before.path_mode == PathMode::stop) return true;
  const AxisVector turn =
      at(before.path, length(before.path), Side::before).dq - at(after.path, 0).dq;
  return turn.norm() > ipo::tuning::chain::kTangentTolerance;
}

/// Whether the machine rests in any case between the last one of `blocks` and the next block.
bool rests_before(const std::deque<Block>& blocks, const Block& next) {
  if (blocks.empty()) return true;
  const auto* before = std::get_if<Move>(&blocks.back().what);
  const auto* after = std::get_if<Move>(&next.what);
  if (before == nullptr || after == nullptr) return true;
  return before->rapid != after->rapid && rests_between(*before, *after);
}

bool cuts(const Block& block) {
  const auto* move = std::get_if<Move>(&block.what);
  return move != nullptr && !move->rapid;
}

}  // namespace

std::deque<Block> with_first_cut_delayed(const std::function<std::optional<Block>()>& next,
                                         double delay, DelayPlace where) {
  std::deque<Block> blocks;
  std::size_t place = 0;  // of the dwell
  for (bool found = false; !found && blocks.size() < kMostBlocks;) {
    auto block = next();
    if (!block) break;
    found = cuts(*block);
    const bool may_stand = where == DelayPlace::before_cut
                               ? found
                               : where == DelayPlace::at_rest && rests_before(blocks, *block);
    if (may_stand) place = blocks.size();
    blocks.push_back(std::move(*block));
  }
  Block dwell{Dwell{delay}};
  if (place > 0) {
    dwell.source = blocks[place - 1].source;
    dwell.number = blocks[place - 1].number;
  }
  blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(place), std::move(dwell));
  return blocks;
}

}  // namespace softcnc::runtime
