// SPDX-License-Identifier: MIT
// Pictures: a canvas of pixels, and the PNG file it becomes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/core/result.hpp"

namespace softcnc::app {

struct OldColour {
  std::uint8_t red = 0, green = 0, blue = 0;
};

class OldCanvas {
 public:
  OldCanvas(int width, int height, OldColour ground);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }

  /// What lies outside is left out.
  void set(int x, int y, OldColour colour) noexcept;
  void fill(int x, int y, int width, int height, OldColour colour) noexcept;
  void frame(int x, int y, int width, int height, OldColour colour) noexcept;
  /// From the left upper corner, each pixel of a letter `scale` wide and high. Letters are small
  /// and capital alike; what the font lacks is left blank.
  void write(int x, int y, std::string_view text, int scale, OldColour colour) noexcept;

  /// The bytes of a PNG file. Errors: SC6012.
  Result<std::string> png(const std::string& file) const;

 private:
  int width_, height_;
  std::vector<OldColour> pixels_;
};

/// Pixels, at scale 1.
int text_width(std::string_view text) noexcept;

}  // namespace softcnc::app
