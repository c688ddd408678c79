// SPDX-License-Identifier: MIT
// What a machine does for the person who stands at it, or who has gone.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace softcnc {

/// What a machine that is served to a sender does after a line with an error: it leaves the line
/// out, and goes on or holds.
enum class OnError : std::uint8_t { go_on, hold };
inline constexpr std::array<std::string_view, 2> kOnErrorNames{"go-on", "hold"};

/// What it does with a program of its own when the sender has gone.
enum class OnDisconnect : std::uint8_t { hold, finish };
inline constexpr std::array<std::string_view, 2> kOnDisconnectNames{"hold", "finish"};

struct Attendance {
  std::vector<double> tool_change;  // mm, machine coordinates: where tools are changed by hand;
                                    // empty: where the machine is
  double alone = 30;                // s: so long the spindle turns once nobody is there any more
  OnError on_error = OnError::go_on;
  OnDisconnect on_disconnect = OnDisconnect::hold;
};

}  // namespace softcnc
