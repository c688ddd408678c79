// SPDX-License-Identifier: MIT
#include "pictures/picture_options.hpp"

#include <charconv>

#include "hal/files/suffix.hpp"

namespace softcnc::app {
namespace {

/// Reads all of a text as a number between two others.
std::optional<int> number_in(std::string_view text, int least, int most) noexcept {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (number < least || number > most) return std::nullopt;
  return number;
}

}  // namespace

std::optional<PictureFormat> picture_format(std::string_view file) noexcept {
  if (hal::has_suffix(file, ".svg")) return PictureFormat::svg;
  if (hal::has_suffix(file, ".png")) return PictureFormat::png;
  return std::nullopt;
}

std::optional<PictureSize> picture_size(std::string_view text) noexcept {
  const std::size_t between = text.find('x');
  const auto width =
      number_in(text.substr(0, between), PictureSize::kLeastWidth, PictureSize::kMost);
  if (!width) return std::nullopt;
  if (between == std::string_view::npos) return PictureSize{*width, 0};
  const auto height =
      number_in(text.substr(between + 1), PictureSize::kLeastHeight, PictureSize::kMost);
  if (!height) return std::nullopt;
  return PictureSize{*width, *height};
}

}  // namespace softcnc::app
