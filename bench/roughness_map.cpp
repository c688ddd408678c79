// SPDX-License-Identifier: MIT
// Maps of Rmax over inclination and feed per tooth (figures 3, 6 and 7 of paper 004), as CSV; see
// scripts/generate roughness_map.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>

#include "motion/roughness/roughness.hpp"
#include "support/milled.hpp"

namespace softcnc {
namespace {

/// What a map is of: a tool, its passes, and which inclinations and feeds. Lengths in mm.
struct Map {
  double radius = 5, pick = 0.5, teeth = 2;
  double grid_um = 2.5;                                   // of the Z-map
  double incline_to = 12, incline_step = 0.5;             // degrees, from 0
  double feed_from = 0.2, feed_to = 1, feed_step = 0.05;  // parts of the pick-feed

  /// Returns the value with this name; null if there is none.
  double* named(std::string_view name) {
    const std::pair<std::string_view, double*> names[] = {
        {"radius", &radius},         {"pick", &pick},
        {"teeth", &teeth},           {"grid_um", &grid_um},
        {"incline_to", &incline_to}, {"incline_step", &incline_step},
        {"feed_from", &feed_from},   {"feed_to", &feed_to},
        {"feed_step", &feed_step}};
    for (const auto& [known, place] : names)
      if (name == known) return place;
    return nullptr;
  }

  int inclinations() const { return static_cast<int>(std::lround(incline_to / incline_step)) + 1; }
  int feeds() const { return static_cast<int>(std::lround((feed_to - feed_from) / feed_step)) + 1; }
  double inclination(int i) const { return i * incline_step; }
  double feed(int i) const { return (feed_from + i * feed_step) * pick; }

  Surface surface() const {
    return {.tool_radius = radius, .pick_feed = pick, .teeth = static_cast<int>(teeth)};
  }
};

/// Reads NAME=VALUE with a value above 0; false if it is neither.
bool read(Map& map, std::string_view argument) {
  const auto equals = argument.find('=');
  if (equals == std::string_view::npos) return false;
  double* place = map.named(argument.substr(0, equals));
  const std::string_view value = argument.substr(equals + 1);
  if (!place) return false;
  const auto [end, error] = std::from_chars(value.begin(), value.end(), *place);
  return error == std::errc{} && end == value.end() && *place > 0;
}

void print_roughness(const Map& map) {
  const Surface surface = map.surface();
  std::puts("inclination_deg,feed_mm,feed_per_pick,zmap_um,paper_um,guaranteed_um");
  for (int i = 0; i < map.inclinations(); ++i)
    for (int j = 0; j < map.feeds(); ++j) {
      const double incline = map.inclination(i), feed = map.feed(j);
      const double sine = std::sin(test::radians(incline));
      const double cut = test::rmax({.radius = map.radius,
                                     .teeth = surface.teeth,
                                     .feed = feed,
                                     .pick = map.pick,
                                     .incline = incline},
                                    map.grid_um / 1000);
      std::printf("%g,%g,%g,%.3f,%.3f,%.3f\n", incline, feed, feed / map.pick, 1000 * cut,
                  1000 * rmax(RoughnessModel::paper, surface, feed, sine),
                  1000 * rmax(RoughnessModel::guaranteed, surface, feed, sine));
    }
}

void print_critical(const Map& map) {
  std::puts("feed_mm,feed_per_pick,critical_deg");
  for (int j = 0; j < map.feeds(); ++j) {
    const double feed = map.feed(j);
    std::printf("%g,%g,%.4f\n", feed, feed / map.pick,
                critical_inclination(map.surface(), feed) * 180 / std::numbers::pi);
  }
}

int usage() {
  std::fputs("usage: roughness_map rmax | critical [NAME=VALUE...]\n", stderr);
  return 2;
}

}  // namespace
}  // namespace softcnc

int main(int count, char** arguments) {
  softcnc::Map map;
  for (int i = 2; i < count; ++i)
    if (!softcnc::read(map, arguments[i])) return softcnc::usage();
  if (count >= 2 && std::strcmp(arguments[1], "rmax") == 0) {
    softcnc::print_roughness(map);
  } else if (count >= 2 && std::strcmp(arguments[1], "critical") == 0) {
    softcnc::print_critical(map);
  } else {
    return softcnc::usage();
  }
  return 0;
}
