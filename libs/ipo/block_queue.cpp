// SPDX-License-Identifier: MIT
#include "ipo/block_queue.hpp"

#include <iterator>

namespace softcnc::ipo {

void BlockQueue::push(TimedBlock block) {
  t_end_ = block.t_end();
  blocks_.push_back(std::move(block));
}

void BlockQueue::trim() {
  for (; current_ > 0; --current_) blocks_.pop_front();
}

std::deque<TimedBlock> BlockQueue::take_rest() {
  trim();
  return std::exchange(blocks_, {});
}

}  // namespace softcnc::ipo
