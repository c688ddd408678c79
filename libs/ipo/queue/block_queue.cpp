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

/// Blocks that setpoints no longer lag behind.
bool BlockQueue::is_left(const TimedBlock& passed) const noexcept {
  const double now = current_ == blocks_.size() ? t_end_ : blocks_[current_].t_start;
  return lag_ == 0 || passed.t_end() < now - lag_;
}

void BlockQueue::trim() {
  for (; current_ > 0 && is_left(blocks_.front()); --current_) {
    remembered_.push_back(std::move(blocks_.front()));
    blocks_.pop_front();
  }
  kept_ = current_;
  const double now = current_ == blocks_.size() ? t_end_ : blocks_[current_].t_start;
  while (!remembered_.empty() && remembered_.front().t_end() < now - memory_)
    remembered_.pop_front();
}

const TimedBlock* BlockQueue::at_place(double s) const noexcept {
  for (std::size_t i = std::min(current_ + 1, blocks_.size()); i > 0; --i)
    if (i == 1 || blocks_[i - 1].s_start <= s) return &blocks_[i - 1];
  return nullptr;
}

PartlyPassed BlockQueue::take_rest() {
  trim();
  PartlyPassed rest{std::exchange(remembered_, {}), 0};
  rest.passed = rest.blocks.size() + std::exchange(current_, 0);
  kept_ = 0;
  for (TimedBlock& block : blocks_) rest.blocks.push_back(std::move(block));
  blocks_.clear();
  return rest;
}

/// Setpoints may still lag behind what has been passed.
void BlockQueue::begin_again(std::deque<TimedBlock> passed, double t) {
  (lag_ > 0 ? blocks_ : remembered_) = std::move(passed);
  current_ = kept_ = blocks_.size();
  t_end_ = t;
}

}  // namespace softcnc::ipo
