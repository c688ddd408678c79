// SPDX-License-Identifier: MIT
#include "hal/machine/foreign_keys.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "hal/files/number.hpp"

namespace softcnc::hal {
namespace {

double um_from_steps_per_mm(double steps) { return 1000 / steps; }
double thousandfold(double value) { return 1000 * value; }
double per_min_from_per_s(double value) { return 60 * value; }

/// What a key becomes. In `key` a '*' stands for the axis.
struct Counterpart {
  std::string_view key;
  std::string_view unit;       // of the foreign value, in words
  double (*convert)(double);   // into the unit of `key`; null: it takes more than this value
  std::string_view otherwise;  // how `key` follows from what its value is about
};

/// The names, in lower case and with '_' between words, of keys that mean the same.
struct ForeignKey {
  std::initializer_list<std::string_view> names;
  Counterpart is;
};

// Sources: grbl 1.1 and FluidNC, settings; Marlin, M92, M201 and M203; Mach3, motor tuning;
// LinuxCNC, INI configuration.
const ForeignKey kForeignKeys[] = {
    {{"steps_per_mm", "step_per_mm", "steps_mm", "steps_per_unit", "step_scale", "scale",
      "steps_per"},
     {"axis.*.blu_um", "steps per mm", um_from_steps_per_mm, "1000 over the steps per mm"}},
    {{"steps_per_rev", "steps_per_revolution", "steps_per_turn", "pulses_per_rev", "microsteps",
      "microstepping"},
     {"axis.*.blu_um", "", nullptr,
      "the travel per turn in um over the steps per turn (5 mm at 2000 steps: 2.5)"}},
    {{"pulley", "pulley_teeth", "belt_pitch", "belt", "teeth_per_rev"},
     {"axis.*.blu_um", "", nullptr,
      "teeth of the pulley times pitch of the belt in um over the steps per turn (20 teeth of 2 mm "
      "at 3200 steps: 12.5)"}},
    {{"max_rate", "max_rate_mm_per_min", "max_rate_mm_min"},
     {"axis.*.velocity_mm_min", "mm/min", unconverted, "in mm/min"}},
    {{"max_velocity", "max_feedrate", "velocity_mm_s", "max_velocity_mm_s", "max_speed_mm_s"},
     {"axis.*.velocity_mm_min", "mm/s", per_min_from_per_s, "60 times the mm/s"}},
    {{"max_acceleration", "acceleration_mm_per_sec2"},
     {"axis.*.acceleration_mm_s2", "mm/s2", unconverted, "in mm/s2"}},
    {{"max_travel", "max_travel_mm", "travel", "travel_mm"},
     {"axis.*.min_mm and axis.*.max_mm", "", nullptr,
      "the ends of the travel in machine coordinates"}},
    {{"min_limit", "soft_limit_min"}, {"axis.*.min_mm", "mm", unconverted, "in mm"}},
    {{"max_limit", "soft_limit_max"}, {"axis.*.max_mm", "mm", unconverted, "in mm"}},
    {{"junction_deviation", "junction_deviation_mm"},
     {"control.corner_tolerance_um", "mm", thousandfold, "in um"}},
    {{"arc_tolerance", "arc_tolerance_mm"},
     {"control.chord_tolerance_um", "mm", thousandfold, "in um"}},
    {{"max_spindle_speed", "max_forward_velocity"},
     {"spindle.max_rpm", "turns per minute", unconverted, "in turns per minute"}},
    {{"min_spindle_speed", "min_forward_velocity"},
     {"spindle.min_rpm", "turns per minute", unconverted, "in turns per minute"}},
};

/// In lower case, with '_' between words.
std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool between = c == '-' || c == '/' || c == ' ';
    text += between ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

const ForeignKey* find_foreign_key(std::string_view name) {
  const auto found =
      std::find_if(std::begin(kForeignKeys), std::end(kForeignKeys), [&](const ForeignKey& key) {
        return std::find(key.names.begin(), key.names.end(), name) != key.names.end();
      });
  return found == std::end(kForeignKeys) ? nullptr : found;
}

/// The axis letter among the parts before the last; '*' where there is none.
char axis_letter_in(std::string_view path) {
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t end = std::min(path.find('.', at), path.size());
    if (end < path.size() && end == at + 1) {
      const char c = plain(path.substr(at, 1)).front();
      if (c == 'x' || c == 'y' || c == 'z') return c;
    }
    at = end + 1;
  }
  return '*';
}

}  // namespace

std::string counterpart_of(std::string_view path, const FileValue& value) {
  const auto dot = path.rfind('.');
  const ForeignKey* foreign =
      find_foreign_key(plain(dot == path.npos ? path : path.substr(dot + 1)));
  if (!foreign) return {};
  const Counterpart& is = foreign->is;
  std::string key(is.key);
  std::replace(key.begin(), key.end(), '*', axis_letter_in(path));
  const auto number = is.convert ? as_number(value) : std::nullopt;
  const double converted = number ? is.convert(*number) : 0;
  if (!number || !std::isfinite(converted))
    return "here it is " + key + ", " + std::string(is.otherwise);
  return number_text(*number) + ' ' + std::string(is.unit) + " are " + key + " = " +
         number_text(converted);
}

}  // namespace softcnc::hal
