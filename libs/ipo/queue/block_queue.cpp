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

/// The number of blocks that have been passed and were visited, or had ended by `until`.
std::size_t BlockQueue::passed_by(double until) const noexcept {
  std::size_t end = kept_;
  while (end < current_ && blocks_[end].t_end() <= until) ++end;
  return end;
}

void BlockQueue::trim(double until) {
  kept_ = passed_by(until);
  for (; kept_ > 0 && is_left(blocks_.front()) && blocks_.front().t_end() <= until;
       --kept_, --current_) {
    remembered_.push_back(std::move(blocks_.front()));
    blocks_.pop_front();
  }
  const double now = current_ == blocks_.size() ? t_end_ : blocks_[current_].t_start;
  while (!remembered_.empty() && remembered_.front().t_end() < now - memory_)
    remembered_.pop_front();
}

const TimedBlock* BlockQueue::at_place(double s) const noexcept {
  for (std::size_t i = std::min(current_ + 1, blocks_.size()); i > 0; --i)
    if (i == 1 || blocks_[i - 1].s_start <= s) return &blocks_[i - 1];
  return nullptr;
}

void BlockQueue::go_back(double t, double same) noexcept {
  current_ = 0;
  while (current_ < blocks_.size() && t >= blocks_[current_].t_end() - same) ++current_;
}

PartlyPassed BlockQueue::take_rest() {
  PartlyPassed rest{std::exchange(remembered_, {}), 0};
  taken_memory_ = rest.blocks.size();
  rest.passed = rest.blocks.size() + std::exchange(current_, 0);
  for (TimedBlock& block : blocks_) rest.blocks.push_back(std::move(block));
  blocks_.clear();
  return rest;
}

/// What was remembered is remembered again; setpoints may lag behind the others, and rows of them
/// may still be looked at.
void BlockQueue::keep(std::deque<TimedBlock> passed) {
  for (std::size_t i = 0; i < taken_memory_; ++i) {
    remembered_.push_back(std::move(passed.front()));
    passed.pop_front();
  }
  blocks_ = std::move(passed);
}

void BlockQueue::put_back(PartlyPassed rest) {
  current_ = rest.passed - taken_memory_;
  keep(std::move(rest.blocks));
  t_end_ = blocks_.back().t_end();
}

void BlockQueue::begin_again(std::deque<TimedBlock> passed, double t) {
  keep(std::move(passed));
  current_ = kept_ = blocks_.size();
  t_end_ = t;
}

}  // namespace softcnc::ipo
