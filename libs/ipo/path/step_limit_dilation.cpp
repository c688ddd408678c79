// SPDX-License-Identifier: MIT
#include "ipo/path/step_limit_dilation.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// Times are summed up in whole parts of a period: what lies within a period of a place must not
/// depend on where the sum began.
constexpr std::int64_t kPeriodParts = std::int64_t{1} << 40;

}  // namespace

StepLimitDilation::StepLimitDilation(Chain& chain, const std::vector<double>& times, double period,
                                     std::size_t first)
    : chain_(chain),
      period_(period),
      first_(first),
      last_asked_(first),
      asked_(chain.intervals.size()),
      clock_(chain.nodes.size()) {
  for (std::size_t i = chain.felt_from(first, period); i < times.size(); ++i) {
    const double parts = kPeriodParts * std::min(times[i] / period, 1.0);
    clock_[i + 1] = clock_[i] + static_cast<std::int64_t>(parts);
  }
}

void StepLimitDilation::ask(std::size_t i, const VelocityLimit& bound) {
  Asked& asked = asked_[i];
  const double length = std::sqrt(bound.q) * period_;
  std::size_t left = std::min(i, asked_[last_asked_].left);
  while (left < i && beyond_a_step(left + 1, i, length)) ++left;
  while (left > 0 && !beyond_a_step(left, i, length)) --left;
  std::size_t right = std::max(i + 1, asked_[last_asked_].right);
  while (right > i + 1 && beyond_a_step(i + 1, right - 1, length)) --right;
  while (right + 1 < clock_.size() && !beyond_a_step(i + 1, right, length)) ++right;
  asked = {bound, left, right};
  last_asked_ = i;
}

bool StepLimitDilation::beyond_a_step(std::size_t from, std::size_t to,
                                      double length) const noexcept {
  return clock_[to] - clock_[from] >= kPeriodParts ||
         chain_.nodes[to].s - chain_.nodes[from].s >= length;
}

void StepLimitDilation::lower() {
  for (std::size_t i = first_; i < asked_.size(); ++i) {
    if (asked_[i].bound.q == kUnlimited) continue;
    chain_.inside[i].velocity_limit.lower_to(asked_[i].bound);
    lower_left_of(i);
    lower_right_of(i);
  }
}

void StepLimitDilation::lower_left_of(std::size_t i) {
  const auto& [bound, left, right] = asked_[i];
  std::size_t end = i + 1;
  if (i + 1 < asked_.size() && asked_[i + 1].bound.q <= bound.q)
    end = std::min(end, asked_[i + 1].left);
  if (i > 0 && asked_[i - 1].bound.q < bound.q) end = std::min(end, asked_[i - 1].left);
  for (std::size_t n = end; n-- > left;) {
    chain_.nodes[n].velocity_limit.lower_to(bound);
    chain_.inside[n].velocity_limit.lower_to(bound);
  }
}

void StepLimitDilation::lower_right_of(std::size_t i) {
  const auto& [bound, left, right] = asked_[i];
  std::size_t begin = i + 1;
  if (i > 0 && asked_[i - 1].bound.q <= bound.q) begin = std::max(begin, asked_[i - 1].right + 1);
  if (i + 1 < asked_.size() && asked_[i + 1].bound.q < bound.q)
    begin = std::max(begin, asked_[i + 1].right + 1);
  for (std::size_t n = begin; n <= right; ++n) {
    chain_.nodes[n].velocity_limit.lower_to(bound);
    chain_.inside[n - 1].velocity_limit.lower_to(bound);
  }
}

}  // namespace softcnc::ipo
