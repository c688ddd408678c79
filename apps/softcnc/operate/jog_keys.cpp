// SPDX-License-Identifier: MIT
#include "operate/jog_keys.hpp"

#include <utility>

namespace softcnc::app {
namespace {

constexpr int kHeld = 3;             // presses: the first one and two repeats
constexpr double kAtOnce = 0.004;    // s: no hand and no terminal repeats a key so fast
constexpr double kRepeatGap = 0.15;  // s: between repeats

}  // namespace

JogKeys::Act JogKeys::press(Key::Kind key, double now) noexcept {
  if (key_ != key) {
    const bool ends = release() == Act::stop;
    key_ = key;
    last_ = now;
    chain_ = ends ? 0 : 1;
    return ends ? Act::stop : Act::step;
  }
  const double gap = now - std::exchange(last_, now);
  if (continuous_ || gap < kAtOnce) return Act::nothing;
  chain_ = gap <= kRepeatGap ? chain_ + 1 : gap <= kFirstRepeat ? 2 : 1;
  if (chain_ < kHeld) return Act::step;
  continuous_ = true;
  return Act::begin;
}

JogKeys::Act JogKeys::release() noexcept {
  key_.reset();
  chain_ = 0;
  return std::exchange(continuous_, false) ? Act::stop : Act::nothing;
}

JogKeys::Act JogKeys::wait(double now) noexcept {
  return continuous_ && now - last_ >= kPatience ? release() : Act::nothing;
}

}  // namespace softcnc::app
