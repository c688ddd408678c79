// SPDX-License-Identifier: MIT
// The only file that knows cairo.
#include "pictures/canvas.hpp"

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <numbers>

#include "motion/core/utf8.hpp"

namespace softcnc::app {
namespace {

constexpr const char* kFont = "DejaVu Sans";

cairo_status_t append(void* closure, const unsigned char* bytes, unsigned length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

/// The surfaces of an SVG are numbered over the whole process; a file begins at 1 instead.
void number_from_one(std::string& svg) {
  constexpr std::string_view kId = "<g id=\"surface";
  const std::size_t at = svg.find(kId);
  if (at == std::string::npos) return;
  const std::size_t begin = at + kId.size();
  svg.replace(begin, svg.find('"', begin) - begin, "1");
}

void set_font(cairo_t* cairo, const TextLook& look) {
  cairo_select_font_face(cairo, kFont, CAIRO_FONT_SLANT_NORMAL,
                         look.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, look.size);
}

/// Outlines are placed as they are designed, whatever the resolution.
void set_font_options(cairo_t* cairo) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
}

void set_colour(cairo_t* cairo, Colour colour) {
  cairo_set_source_rgb(cairo, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

void set_pen(cairo_t* cairo, const Pen& pen) {
  set_colour(cairo, pen.colour);
  cairo_set_line_width(cairo, pen.width);
  const double dashes[] = {4, 3};
  cairo_set_dash(cairo, dashes, pen.dashed ? 2 : 0, 0);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, pen.dashed ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
}

}  // namespace

struct Canvas::Page {
  PictureFormat format;
  std::string svg;  // what has been written so far
  cairo_surface_t* surface;
  cairo_t* cairo;

  Page(double width, double height, PictureFormat form) : format(form) {
    if (form == PictureFormat::svg) {
      surface = cairo_svg_surface_create_for_stream(append, &svg, width, height);
      cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    } else {
      surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                           static_cast<int>(std::ceil(width * kPngScale)),
                                           static_cast<int>(std::ceil(height * kPngScale)));
    }
    cairo = cairo_create(surface);
    if (form == PictureFormat::png) cairo_scale(cairo, kPngScale, kPngScale);
    set_font_options(cairo);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  ~Page() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
};

Canvas::Canvas(double width, double height, PictureFormat format)
    : width_(width), height_(height), page_(std::make_unique<Page>(width, height, format)) {
  fill({0, 0, width, height}, kPaper);
}

Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

void Canvas::line(std::span<const Spot> spots, const Pen& pen) {
  if (spots.size() < 2) return;
  set_pen(page_->cairo, pen);
  cairo_move_to(page_->cairo, spots.front().x, spots.front().y);
  for (const Spot& spot : spots.subspan(1)) cairo_line_to(page_->cairo, spot.x, spot.y);
  cairo_stroke(page_->cairo);
}

void Canvas::line(Spot from, Spot to, const Pen& pen) {
  const Spot spots[] = {from, to};
  line(spots, pen);
}

void Canvas::dots(std::span<const Spot> spots, const Pen& pen) {
  set_colour(page_->cairo, pen.colour);
  for (const Spot& spot : spots) {
    cairo_arc(page_->cairo, spot.x, spot.y, pen.width / 2, 0, 2 * std::numbers::pi);
    cairo_fill(page_->cairo);
  }
}

void Canvas::fill(const Rectangle& area, Colour colour) {
  set_colour(page_->cairo, colour);
  cairo_rectangle(page_->cairo, area.x, area.y, area.width, area.height);
  cairo_fill(page_->cairo);
}

void Canvas::frame(const Rectangle& area, const Pen& pen) {
  set_pen(page_->cairo, pen);
  cairo_rectangle(page_->cairo, area.x, area.y, area.width, area.height);
  cairo_stroke(page_->cairo);
}

void Canvas::image(const Rectangle& area, const Pixels& pixels) {
  cairo_surface_t* image =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height);
  unsigned char* data = cairo_image_surface_get_data(image);
  const int stride = cairo_image_surface_get_stride(image);
  for (int y = 0; data != nullptr && y < pixels.height; ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < pixels.width; ++x) {
      const Colour& colour =
          pixels.colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                         static_cast<std::size_t>(x)];
      row[x] = static_cast<std::uint32_t>(colour.red) << 16 |
               static_cast<std::uint32_t>(colour.green) << 8 | colour.blue;
    }
  }
  cairo_surface_mark_dirty(image);
  cairo_save(page_->cairo);
  cairo_translate(page_->cairo, area.x, area.y);
  cairo_scale(page_->cairo, area.width / pixels.width, area.height / pixels.height);
  cairo_set_source_surface(page_->cairo, image, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(page_->cairo), CAIRO_FILTER_NEAREST);
  cairo_rectangle(page_->cairo, 0, 0, pixels.width, pixels.height);
  cairo_fill(page_->cairo);
  cairo_restore(page_->cairo);
  cairo_surface_destroy(image);
}

void Canvas::text(Spot spot, std::string_view text, const TextLook& look) {
  const double shift = look.anchor == Anchor::left     ? 0
                       : look.anchor == Anchor::middle ? -text_width(text, look) / 2
                                                       : -text_width(text, look);
  cairo_t* cairo = page_->cairo;
  cairo_save(cairo);
  set_font(cairo, look);
  set_colour(cairo, look.colour);
  cairo_translate(cairo, spot.x, spot.y);
  if (look.upright) cairo_rotate(cairo, -std::numbers::pi / 2);
  cairo_move_to(cairo, shift, 0);
  cairo_show_text(cairo, as_utf8(text).c_str());
  cairo_restore(cairo);
}

double Canvas::text_width(std::string_view text, const TextLook& look) {
  cairo_save(page_->cairo);
  set_font(page_->cairo, look);
  cairo_text_extents_t extents{};
  cairo_text_extents(page_->cairo, as_utf8(text).c_str(), &extents);
  cairo_restore(page_->cairo);
  return extents.x_advance;
}

std::string Canvas::shortened(std::string_view text, const TextLook& look, double width) {
  if (text_width(text, look) <= width) return std::string(text);
  while (!text.empty()) {
    text.remove_prefix(1);
    while (!text.empty() && continues_character(text.front())) text.remove_prefix(1);
    const std::string rest = "..." + std::string(text);
    if (text_width(rest, look) <= width) return rest;
  }
  return {};
}

void Canvas::clip(const Rectangle& area) {
  cairo_save(page_->cairo);
  cairo_rectangle(page_->cairo, area.x, area.y, area.width, area.height);
  cairo_clip(page_->cairo);
}

void Canvas::unclip() { cairo_restore(page_->cairo); }

Result<std::string> Canvas::bytes() {
  cairo_status_t status = cairo_status(page_->cairo);
  std::string png;
  if (status == CAIRO_STATUS_SUCCESS && page_->format == PictureFormat::png)
    status = cairo_surface_write_to_png_stream(page_->surface, append, &png);
  cairo_surface_finish(page_->surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(page_->surface);
  if (status != CAIRO_STATUS_SUCCESS)
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6012,
                   .message = std::string("drawing failed: ") + cairo_status_to_string(status)});
  if (page_->format == PictureFormat::png) return png;
  number_from_one(page_->svg);
  return std::move(page_->svg);
}

}  // namespace softcnc::app
