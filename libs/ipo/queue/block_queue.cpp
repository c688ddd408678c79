// SPDX-License-Identifier: MIT
#include "ipo/queue/block_queue.hpp"

#include <utility>

namespace softcnc::ipo {

void BlockQueue::push(TimedPart part) {
  std::visit([this](auto&& timed) { push(std::forward<decltype(timed)>(timed)); }, std::move(part));
}

void BlockQueue::push(const Continuation& more) {
  blocks_.back().profile.append(more.profile);
  t_end_ = blocks_.back().t_end();
}

void BlockQueue::push(TimedBlock block) {
  t_end_ = block.t_end();
  blocks_.push_back(std::move(block));
}

void BlockQueue::trim() {
  for (; current_ > 0; --current_) {
    remembered_.push_back(std::move(blocks_.front()));
    blocks_.pop_front();
  }
  const double now = blocks_.empty() ? t_end_ : blocks_.front().t_start;
  while (!remembered_.empty() && remembered_.front().t_end() < now - memory_)
    remembered_.pop_front();
}

PartlyPassed BlockQueue::take_rest() {
  trim();
  PartlyPassed rest{std::exchange(remembered_, {}), 0};
  rest.passed = rest.blocks.size();
  for (TimedBlock& block : blocks_) rest.blocks.push_back(std::move(block));
  blocks_.clear();
  return rest;
}

void BlockQueue::begin_again(std::deque<TimedBlock> passed, double t) {
  remembered_ = std::move(passed);
  t_end_ = t;
}

}  // namespace softcnc::ipo
