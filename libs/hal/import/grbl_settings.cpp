// SPDX-License-Identifier: MIT
#include "hal/import/grbl_settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "hal/files/number.hpp"

namespace softcnc::hal {
namespace {

struct GrblSetting {
  double value = 0;
  GivenAt at;  // its value
};
using Settings = std::map<int, GrblSetting>;

constexpr int kStepTime = 0, kJunctionDeviation = 11, kArcTolerance = 12, kSoftLimits = 20,
              kMostRpm = 30, kLeastRpm = 31;
constexpr int kStepsPerMm = 100, kRate = 110, kAcceleration = 120, kTravel = 130;
constexpr std::array<std::string_view, 3> kAxisNames{"x", "y", "z"};

/// FluidNC's names of what grbl numbers; the axis is added.
struct NamedSetting {
  std::string_view name;
  int number;
};
constexpr NamedSetting kNamed[] = {{"steps_per_mm", kStepsPerMm},
                                   {"max_rate_mm_per_min", kRate},
                                   {"acceleration_mm_per_sec2", kAcceleration},
                                   {"max_travel_mm", kTravel}};

/// What grbl and its senders write beside settings: answers, states, welcomes, and comments.
bool is_chatter(std::string_view line) {
  constexpr std::string_view kBegins[] = {"ok", "Grbl", "[", "<", ">", "#", ";", "("};
  return std::any_of(std::begin(kBegins), std::end(kBegins),
                     [&](std::string_view begin) { return line.starts_with(begin); });
}

/// A number of FluidNC's setting for an axis: 101 of "/axes/y/steps_per_mm".
std::optional<int> number_of_path(std::string_view path) {
  constexpr std::string_view kAxes = "/axes/";
  if (!path.starts_with(kAxes) || path.size() < kAxes.size() + 2) return std::nullopt;
  path.remove_prefix(kAxes.size());
  const auto axis = std::find(kAxisNames.begin(), kAxisNames.end(), path.substr(0, 1));
  for (const NamedSetting& named : kNamed)
    if (axis != kAxisNames.end() && path.substr(1) == "/" + std::string(named.name))
      return named.number + static_cast<int>(axis - kAxisNames.begin());
  return std::nullopt;
}

std::optional<int> grbl_number_of(std::string_view name) {
  if (name.starts_with('/')) return number_of_path(name);
  const auto number = setting_number(name);
  const bool whole = number && *number >= 0 && *number < 1e6 && *number == std::floor(*number);
  return whole ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

bool is_axis_setting(int number) {
  return number >= kStepsPerMm && number < kTravel + 10 && number % 10 < 3;
}

bool has_key(int number) {
  constexpr std::array<int, 6> kKnown{kStepTime,   kJunctionDeviation, kArcTolerance,
                                      kSoftLimits, kMostRpm,           kLeastRpm};
  return is_axis_setting(number) || std::find(kKnown.begin(), kKnown.end(), number) != kKnown.end();
}

/// Those that a machine has only above 0.
bool must_be_positive(int number) { return is_axis_setting(number); }

class GrblReader {
 public:
  GrblReader(const std::string& file, MachineDraft& draft) : file_(file), draft_(draft) {}

  Settings read(const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) take(lines[i], static_cast<int>(i) + 1);
    return std::move(settings_);
  }

 private:
  void take(const std::string& line, int number) {
    const std::string_view text = trimmed_setting(line);
    if (text.empty() || is_chatter(text)) return;
    const auto equals = text.find('=');
    if (!text.starts_with('$')) {
      draft_.warn(Code::SC7039, place_of(file_, number, line, text),
                  "this is no setting of grbl, as $100=80, and is passed over");
    } else if (equals != text.npos) {
      take(trimmed_setting(text.substr(1, equals - 1)), text.substr(equals + 1), line, number);
    }
  }

  /// The value ends where its description begins.
  void take(std::string_view name, std::string_view rest, const std::string& line, int number) {
    const std::string_view value = trimmed_setting(rest.substr(0, rest.find_first_of("(;#")));
    const GivenAt at = place_of(file_, number, line, value);
    const auto setting = grbl_number_of(name);
    if (!setting || !has_key(*setting)) return draft_.leave(at);
    const auto read = setting_number(value);
    if (!read || *read < 0 || (*read == 0 && must_be_positive(*setting)))
      return draft_.fail(Code::SC7035, at,
                         "$" + std::string(name) + " needs a number " +
                             (must_be_positive(*setting) ? "above 0" : "from 0 on") + ", not '" +
                             std::string(value) + "'");
    if (settings_.contains(*setting))
      draft_.warn(Code::SC7036, at,
                  "$" + std::string(name) + " is given twice; the last line counts");
    settings_.insert_or_assign(*setting, GrblSetting{*read, at});
  }

  const std::string& file_;
  MachineDraft& draft_;
  Settings settings_;
};

const GrblSetting* find(const Settings& settings, int number) {
  const auto found = settings.find(number);
  return found == settings.end() ? nullptr : &found->second;
}

void take_axis(const Settings& settings, int axis, MachineDraft& draft) {
  const std::string table = "axis." + std::string(kAxisNames[static_cast<std::size_t>(axis)]);
  if (const GrblSetting* rate = find(settings, kRate + axis))
    draft.set(table + ".velocity_mm_min", rate->value, rate->at);
  if (const GrblSetting* acceleration = find(settings, kAcceleration + axis))
    draft.set(table + ".acceleration_mm_s2", acceleration->value, acceleration->at);
  if (const GrblSetting* travel = find(settings, kTravel + axis)) {
    const GrblSetting* soft = find(settings, kSoftLimits);
    draft.set(table + ".min_mm", -travel->value, travel->at);
    draft.set(table + ".max_mm", soft && soft->value != 0 ? 0 : travel->value, travel->at);
  }
  if (const GrblSetting* steps = find(settings, kStepsPerMm + axis))
    draft.set(table + ".blu_um", 1000 / steps->value, steps->at);
}

}  // namespace

void take_grbl_settings(std::string_view text, const std::string& file, MachineDraft& draft) {
  const Settings settings = GrblReader(file, draft).read(setting_lines(text));
  const auto take = [&](int number, const char* key, double factor) {
    if (const GrblSetting* setting = find(settings, number))
      draft.set(key, setting->value * factor, setting->at);
  };
  draft.choose("control.backend", "\"none\"", "settings do not describe the motors");
  take(kJunctionDeviation, "control.corner_tolerance_um", 1000);
  take(kArcTolerance, "control.chord_tolerance_um", 1000);
  for (int axis = 0; axis < 3; ++axis) take_axis(settings, axis, draft);
  take(kMostRpm, "spindle.max_rpm", 1);
  take(kLeastRpm, "spindle.min_rpm", 1);
  if (const GrblSetting* time = find(settings, kStepTime); time && time->value > 0)
    take(kStepTime, "backend.stepdir.step_length_ns", 1000);
}

bool is_grbl_settings(std::string_view text) {
  for (const std::string& line : setting_lines(text)) {
    const std::string_view setting = trimmed_setting(line);
    const auto equals = setting.find('=');
    if (setting.starts_with('$') && equals != setting.npos &&
        grbl_number_of(trimmed_setting(setting.substr(1, equals - 1))))
      return true;
  }
  return false;
}

}  // namespace softcnc::hal
