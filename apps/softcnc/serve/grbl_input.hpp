// SPDX-License-Identifier: MIT
// The bytes that a sender of grbl sends: real-time bytes wherever they stand, and lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

namespace softcnc::app {

/// The real-time bytes of grbl 1.1, by their values.
enum class RealTime : std::uint8_t {
  reset = 0x18,
  hold = '!',
  report = '?',
  resume = '~',
  door = 0x84,
  jog_cancel = 0x85,
  feed_100 = 0x90,
  feed_more_10,
  feed_less_10,
  feed_more_1,
  feed_less_1,
  rapid_100,
  rapid_50,
  rapid_25,
  spindle_100 = 0x99,
  spindle_more_10,
  spindle_less_10,
  spindle_more_1,
  spindle_less_1,
  spindle_stop,
  flood = 0xA0,
  mist = 0xA1,
};

class GrblInput {
 public:
  static constexpr std::size_t kLongestLine = 4096;                // bytes
  static constexpr std::size_t kMostKept = std::size_t{1} << 20U;  // bytes: of lines not yet read

  struct Line {
    std::string text;
    bool too_long = false;
  };

  /// Takes bytes as they come. Each real-time byte goes to `act` at once; every other one above
  /// 0x7F is dropped. A line ends at a line feed or a carriage return. Of a sender that does not
  /// wait for answers, what is beyond kMostKept is lost.
  void take(std::string_view bytes, const std::function<void(RealTime)>& act);

  bool empty() const noexcept { return lines_.empty(); }
  Line next();
  /// Lines that request jogs become blank ones, which get their answers in their turn.
  void blank_jogs();
  /// Drops everything, the beginning of a line included.
  void forget();

 private:
  std::deque<Line> lines_;
  Line begun_;
  std::size_t kept_ = 0;  // bytes in `lines_`
};

/// Returns whether a byte is a real-time one.
bool is_real_time(unsigned char byte) noexcept;
/// Returns whether a line requests a jog.
bool is_jog(std::string_view line) noexcept;

}  // namespace softcnc::app
