// SPDX-License-Identifier: MIT
#include "operate/jog_keys.hpp"

#include <utility>

namespace softcnc::app {
namespace {

constexpr double kAtOnce = 0.012;    // s: no hand and no terminal repeats a key so fast
constexpr double kFastHand = 0.06;   // s: between two presses of a hand, at least
constexpr double kRepeatGap = 0.15;  // s: between repeats, at most

}  // namespace

JogKeys::Act JogKeys::press(Key::Kind key, double now) noexcept {
  if (key_ != key) {
    const bool ends = release() == Act::stop;
    key_ = key;
    last_ = now;
    return ends ? Act::stop : Act::step;
  }
  const double gap = now - std::exchange(last_, now);
  if (continuous_ || gap < kAtOnce) return Act::nothing;
  if (repeats_ && gap <= kRepeatGap) {
    continuous_ = true;
    return Act::begin;
  }
  repeats_ = gap > kRepeatGap && gap <= kFirstRepeat;
  return gap < kFastHand ? Act::nothing : Act::step;
}

JogKeys::Act JogKeys::release() noexcept {
  key_.reset();
  repeats_ = false;
  return std::exchange(continuous_, false) ? Act::stop : Act::nothing;
}

JogKeys::Act JogKeys::wait(double now) noexcept {
  return continuous_ && now - last_ >= kPatience ? release() : Act::nothing;
}

}  // namespace softcnc::app
