// SPDX-License-Identifier: MIT
// The colours of pictures: a scale for numbers, and one colour for each limit and category. All can
// be told apart with the common kinds of colour blindness, and the scale also in print without
// colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "motion/model/limit.hpp"

namespace softcnc::app {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;

  bool operator==(const Colour&) const = default;
};

inline constexpr Colour kPaper{255, 255, 255}, kInk{34, 36, 42}, kFaintInk{96, 102, 112},
    kGrid{226, 229, 234}, kFrame{150, 155, 164}, kUnknownColour{190, 194, 200},
    kRapidColour{160, 165, 173};

/// Returns the colour of a number between 0 and 1: from dark violet over green to yellow. The
/// lightness L* of CIELAB rises evenly from 20 to 80.
Colour shade(double part) noexcept;

/// Returns a colour as so much of it is left on white paper: 0 is white, 1 the colour.
Colour faded(Colour colour, double part) noexcept;

/// Returns a colour under so much light: 0 is black, 1 the colour, more is lighter.
Colour lit_colour(Colour colour, double light) noexcept;

/// Returns the colour of a limit, the same as on a report page.
Colour limit_colour(Limit limit) noexcept;
/// Returns what a legend calls a limit.
std::string_view limit_label(Limit limit) noexcept;

/// Returns the colour of the n-th category (a tool, an axis, a run); after the eighth the first one
/// comes again. Okabe and Ito, Color Universal Design, 2008.
Colour category_colour(std::size_t n) noexcept;

}  // namespace softcnc::app
