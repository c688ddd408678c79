// SPDX-License-Identifier: MIT
#include "pictures/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace softcnc::app {
namespace {

/// L* 20, 30, ... 80.
constexpr std::array<Colour, 7> kShades{{{46, 34, 116},
                                         {29, 68, 136},
                                         {36, 99, 140},
                                         {38, 131, 132},
                                         {76, 161, 108},
                                         {144, 184, 79},
                                         {237, 194, 50}}};

struct LimitLook {
  std::string_view label;
  Colour colour;
};

/// In the order of the enumeration.
constexpr std::array<LimitLook, kLimits> kLooks{{{"programmed feed", {0, 158, 115}},
                                                 {"rapid", {140, 140, 140}},
                                                 {"chord error", {86, 180, 233}},
                                                 {"contour error", {153, 153, 51}},
                                                 {"corner", {230, 159, 0}},
                                                 {"roughness", {240, 228, 66}},
                                                 {"axis velocity", {0, 114, 178}},
                                                 {"acceleration", {213, 94, 0}},
                                                 {"drive", {221, 204, 119}},
                                                 {"jerk", {204, 121, 167}},
                                                 {"pulse rate", {51, 34, 136}},
                                                 {"tangential acceleration", {136, 34, 85}},
                                                 {"normal acceleration", {68, 170, 153}},
                                                 {"custom", {170, 68, 153}},
                                                 {"feed override", {17, 119, 51}},
                                                 {"feed hold", {102, 17, 0}},
                                                 {"standstill", {85, 85, 85}}}};

constexpr std::array<Colour, 8> kCategories{{{0, 114, 178},
                                             {230, 159, 0},
                                             {0, 158, 115},
                                             {204, 121, 167},
                                             {86, 180, 233},
                                             {213, 94, 0},
                                             {240, 228, 66},
                                             {0, 0, 0}}};

std::uint8_t rounded(double value) noexcept {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// `part` of b, the rest of a.
Colour mixed(Colour a, Colour b, double part) noexcept {
  const auto mix = [part](std::uint8_t from, std::uint8_t to) {
    return rounded(from + part * (to - from));
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

}  // namespace

Colour shade(double part) noexcept {
  const double place = std::clamp(part, 0.0, 1.0) * (kShades.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kShades.size() - 2);
  return mixed(kShades[below], kShades[below + 1], place - static_cast<double>(below));
}

Colour faded(Colour colour, double part) noexcept { return mixed({255, 255, 255}, colour, part); }

Colour lit_colour(Colour colour, double light) noexcept {
  return {rounded(light * colour.red), rounded(light * colour.green), rounded(light * colour.blue)};
}

Colour limit_colour(Limit limit) noexcept { return kLooks[static_cast<std::size_t>(limit)].colour; }

std::string_view limit_label(Limit limit) noexcept {
  return kLooks[static_cast<std::size_t>(limit)].label;
}

Colour category_colour(std::size_t n) noexcept { return kCategories[n % kCategories.size()]; }

}  // namespace softcnc::app
