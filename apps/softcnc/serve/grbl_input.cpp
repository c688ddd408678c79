// SPDX-License-Identifier: MIT
#include "serve/grbl_input.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::app {

bool is_real_time(unsigned char byte) noexcept {
  const auto within = [byte](RealTime first, RealTime last) {
    return byte >= static_cast<unsigned char>(first) && byte <= static_cast<unsigned char>(last);
  };
  return byte == '?' || byte == '!' || byte == '~' || within(RealTime::reset, RealTime::reset) ||
         within(RealTime::door, RealTime::jog_cancel) ||
         within(RealTime::feed_100, RealTime::rapid_25) ||
         within(RealTime::spindle_100, RealTime::spindle_stop) ||
         within(RealTime::flood, RealTime::mist);
}

bool is_jog(std::string_view line) noexcept {
  constexpr std::string_view kJog = "$J=";
  for (const char c : kJog) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.empty() || (line.front() & ~0x20) != (c & ~0x20)) return false;
    line.remove_prefix(1);
  }
  return true;
}

void GrblInput::take(std::string_view bytes, const std::function<void(RealTime)>& act) {
  constexpr unsigned char kAscii = 0x7F;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_real_time(byte)) {
      act(static_cast<RealTime>(byte));
    } else if (kept_ >= kMostKept) {
      begun_.too_long = true;
    } else if (c == '\n' || c == '\r') {
      kept_ += begun_.text.size() + 1;
      lines_.push_back(std::exchange(begun_, {}));
    } else if (byte <= kAscii) {
      begun_.too_long = begun_.too_long || begun_.text.size() == kLongestLine;
      if (!begun_.too_long) begun_.text += c;
    }
  }
}

GrblInput::Line GrblInput::next() {
  Line line = std::move(lines_.front());
  lines_.pop_front();
  kept_ -= line.text.size() + 1;
  return line;
}

void GrblInput::blank_jogs() {
  for (Line& line : lines_)
    if (is_jog(line.text)) {
      kept_ -= line.text.size();
      line.text.clear();
    }
}

void GrblInput::forget() {
  lines_.clear();
  begun_ = {};
  kept_ = 0;
}

}  // namespace softcnc::app
