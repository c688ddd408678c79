// SPDX-License-Identifier: MIT
// What pictures are drawn on: a page of px that becomes an SVG or a PNG file.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/result.hpp"
#include "pictures/colour.hpp"
#include "pictures/picture_options.hpp"

namespace softcnc::app {

/// px from the left upper corner, y downwards.
struct Spot {
  double x = 0, y = 0;

  bool operator==(const Spot&) const = default;
};

struct Rectangle {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const noexcept { return x + width; }
  double bottom() const noexcept { return y + height; }
};

struct Pen {
  Colour colour = kInk;
  double width = 1;     // px
  bool dashed = false;  // 4 px drawn, 3 px not
};

enum class Anchor : std::uint8_t { left, middle, right };

struct TextLook {
  double size = 11;  // px
  bool bold = false;
  Colour colour = kInk;
  Anchor anchor = Anchor::left;
  bool upright = false;  // reads from below to above
};

/// Pixels of an image, from the left upper corner, row by row.
struct Pixels {
  int width = 0, height = 0;
  std::vector<Colour> colours;

  Pixels(int columns, int rows, Colour ground)
      : width(columns),
        height(rows),
        colours(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), ground) {}
  Colour& at(int x, int y) noexcept {
    return colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

/// Draws by cairo with the font DejaVu Sans, or what the system has in its place. Text becomes
/// outlines in an SVG, so that it looks the same where that font is missing. The same calls give
/// the same bytes.
class Canvas {
 public:
  /// Pixels of a PNG along one px of the page.
  static constexpr int kPngScale = 2;

  /// `width` and `height` in px.
  Canvas(double width, double height, PictureFormat format);
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  double width() const noexcept { return width_; }
  double height() const noexcept { return height_; }

  void line(std::span<const Spot> spots, const Pen& pen);
  void line(Spot from, Spot to, const Pen& pen);
  /// Each spot as a round dot, `pen.width` px across.
  void dots(std::span<const Spot> spots, const Pen& pen);
  void fill(const Rectangle& area, Colour colour);
  void frame(const Rectangle& area, const Pen& pen);
  /// Stretches the pixels over an area, each of them with sharp edges.
  void image(const Rectangle& area, const Pixels& pixels);

  /// The spot is on the base line of the text.
  void text(Spot spot, std::string_view text, const TextLook& look);
  double text_width(std::string_view text, const TextLook& look);
  /// Returns a text that is not wider than `width` px: the end of a longer one, after "...".
  std::string shortened(std::string_view text, const TextLook& look, double width);

  /// Leaves out what lies outside of an area, until unclip().
  void clip(const Rectangle& area);
  void unclip();

  /// Returns the bytes of the file; call it once, after all else. Errors: SC6012.
  Result<std::string> bytes();

 private:
  struct Page;

  double width_, height_;
  std::unique_ptr<Page> page_;
};

}  // namespace softcnc::app
