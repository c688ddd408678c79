// SPDX-License-Identifier: MIT
// What can be chosen of a picture of runs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace softcnc::app {

enum class Plot : std::uint8_t { path, feed, limits, axes, error, worst };
/// In the order of the enumeration: the names of --plot.
inline constexpr auto kPlotNames =
    std::to_array<std::string_view>({"path", "feed", "limits", "axes", "error", "worst"});

/// What colours the path.
enum class Colouring : std::uint8_t {
  feed,
  speed,
  limit,
  acceleration,
  jerk,
  contour,
  deviation,
  chord,
  rmax,
  tool
};
/// In the order of the enumeration: the names of --colour.
inline constexpr auto kColouringNames =
    std::to_array<std::string_view>({"feed", "speed", "limit", "acceleration", "jerk", "contour",
                                     "deviation", "chord", "rmax", "tool"});

enum class PictureFormat : std::uint8_t { svg, png };

/// Returns the format that the suffix of a file stands for, in capitals too; none: no picture.
std::optional<PictureFormat> picture_format(std::string_view file) noexcept;

struct PictureSize {
  int width = 900, height = 0;  // px; height 0: what the plots need

  bool operator==(const PictureSize&) const = default;

  static constexpr int kLeastWidth = 400, kLeastHeight = 200, kMost = 10'000;
};

/// Reads WIDTHxHEIGHT, or WIDTH alone; none: it is neither, or out of the range of PictureSize.
std::optional<PictureSize> picture_size(std::string_view text) noexcept;

struct PictureOptions {
  std::vector<Plot> plots;  // from above to below; empty: path, feed and limits
  Colouring colour = Colouring::feed;
  PictureSize size;

  bool operator==(const PictureOptions&) const = default;
};

}  // namespace softcnc::app
