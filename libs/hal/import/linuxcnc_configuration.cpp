// SPDX-License-Identifier: MIT
#include "hal/import/linuxcnc_configuration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "hal/import/ini_file.hpp"
#include "hal/import/linuxcnc_folders.hpp"
#include "hal/import/linuxcnc_parameters.hpp"
#include "hal/import/tool_table_file.hpp"
#include "hal/machine/toml_text.hpp"
#include "motion/core/axes.hpp"
#include "motion/core/units.hpp"
#include "motion/core/utf8.hpp"

namespace softcnc::hal {
namespace {

using IniNumber = IniFile::Number;
using Sections = std::vector<std::string>;

constexpr double kFarthestLimit = 1e5;  // mm: what lies beyond means no limit, such as 1e99
constexpr double kNoLimit = 1e9;        // units a second or a square second: likewise

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string in_lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), lower);
  return out;
}

class ConfigurationReader {
 public:
  ConfigurationReader(IniFile& ini, const std::string& file, const std::string& target_folder,
                      MachineDraft& draft)
      : ini_(ini), file_(file), target_folder_(target_folder), draft_(draft) {}

  void take();

 private:
  void take_unit();
  void take_name();
  void take_letters();
  void take_axis(int axis);
  void take_scale(const std::string& table, const Sections& sections);
  void take_path_limits();
  void take_periods();
  void take_step_times();
  void take_files();
  void leave_rest();

  /// The number of this name in these sections that `better` prefers.
  std::optional<IniNumber> best(const Sections& sections, std::string_view name,
                                const std::function<bool(double, double)>& better);
  void take_best(const std::string& key, const Sections& sections, std::string_view name,
                 const std::function<bool(double, double)>& better, double factor);
  void set_limit(const std::string& key, const IniNumber& number, double factor);
  void take_limit(const std::string& key, const Sections& sections, std::string_view name,
                  const std::function<bool(double, double)>& better);
  void take_first(const std::string& key, std::string_view section,
                  std::initializer_list<std::string_view> names, double factor);
  Sections sections_of(int axis) const;
  Sections joints_of(int axis) const;
  std::optional<std::string> text_beside(const IniVariable& variable);

  IniFile& ini_;
  const std::string& file_;
  const std::string& target_folder_;
  MachineDraft& draft_;
  double unit_ = 1;              // mm
  std::string letters_ = "xyz";  // of the joints
};

void ConfigurationReader::take() {
  take_unit();
  take_name();
  take_letters();
  draft_.choose("control.backend", "\"none\"", "settings do not describe the motors");
  take_periods();
  take_path_limits();
  for (int axis = 0; axis < kAxes; ++axis) take_axis(axis);
  take_first("spindle.max_rpm", "SPINDLE_0", {"MAX_FORWARD_VELOCITY"}, 1);
  take_first("spindle.min_rpm", "SPINDLE_0", {"MIN_FORWARD_VELOCITY"}, 1);
  take_step_times();
  take_subroutine_path(ini_, file_, target_folder_, draft_);
  take_files();
  leave_rest();
}

/// A number is that of units per mm.
void ConfigurationReader::take_unit() {
  const IniVariable* given = ini_.find("TRAJ", "LINEAR_UNITS");
  if (!given) return;
  const std::string word = in_lower_case(given->value);
  const auto number = setting_number(word);
  if (word == "mm" || word == "metric")
    unit_ = 1;
  else if (word == "inch" || word == "in" || word == "imperial")
    unit_ = kMmPerInch;
  else if (number && *number > 0)
    unit_ = 1 / *number;
  else
    draft_.fail(
        Code::SC7035, given->at,
        "LINEAR_UNITS is mm or inch, or a number of units per mm, not '" + given->value + "'");
}

void ConfigurationReader::take_name() {
  const IniVariable* name = ini_.find("EMC", "MACHINE");
  if (name && !name->value.empty()) draft_.set("name", toml_string(as_utf8(name->value)), name->at);
}

void ConfigurationReader::take_letters() {
  const IniVariable* coordinates = ini_.find("TRAJ", "COORDINATES");
  const IniVariable* kinematics = ini_.find("KINS", "KINEMATICS");
  std::string given = coordinates ? coordinates->value : "";
  if (kinematics) {
    const std::string text = in_lower_case(kinematics->value);
    constexpr std::string_view kOption = "coordinates=";
    if (const auto at = text.find(kOption); at != text.npos) {
      const auto begin = at + kOption.size();
      given = text.substr(begin, text.find_first_of(" \t", begin) - begin);
    }
  }
  given = in_lower_case(given);
  std::erase_if(given, [](char c) { return c < 'a' || c > 'z'; });
  if (!given.empty()) letters_ = given;
}

Sections ConfigurationReader::joints_of(int axis) const {
  const char letter = lower(kAxisLetters[static_cast<std::size_t>(axis)]);
  Sections sections;
  for (std::size_t joint = 0; joint < letters_.size(); ++joint)
    for (const char* kind : {"JOINT_", "AXIS_"})  // the second up to LinuxCNC 2.7
      if (const std::string section = kind + std::to_string(joint);
          letters_[joint] == letter && ini_.has_section(section))
        sections.push_back(section);
  return sections;
}

Sections ConfigurationReader::sections_of(int axis) const {
  Sections sections = joints_of(axis);
  const std::string section = std::string("AXIS_") + kAxisLetters[static_cast<std::size_t>(axis)];
  if (ini_.has_section(section)) sections.insert(sections.begin(), section);
  return sections;
}

std::optional<IniNumber> ConfigurationReader::best(
    const Sections& sections, std::string_view name,
    const std::function<bool(double, double)>& better) {
  std::optional<IniNumber> best;
  for (const std::string& section : sections)
    if (auto number = ini_.number(section, name);
        number && (!best || better(number->value, best->value)))
      best = std::move(number);
  return best;
}

void ConfigurationReader::take_best(const std::string& key, const Sections& sections,
                                    std::string_view name,
                                    const std::function<bool(double, double)>& better,
                                    double factor) {
  if (const auto number = best(sections, name, better)) set_limit(key, *number, factor);
}

void ConfigurationReader::set_limit(const std::string& key, const IniNumber& number,
                                    double factor) {
  if (std::abs(number.value) >= kNoLimit) return draft_.leave(number.at, "no limit");
  draft_.set(key, number.value * factor, number.at);
}

void ConfigurationReader::take_limit(const std::string& key, const Sections& sections,
                                     std::string_view name,
                                     const std::function<bool(double, double)>& better) {
  if (const auto number = best(sections, name, better))
    draft_.set(key, std::clamp(number->value * unit_, -kFarthestLimit, kFarthestLimit), number->at);
}

void ConfigurationReader::take_first(const std::string& key, std::string_view section,
                                     std::initializer_list<std::string_view> names, double factor) {
  for (const std::string_view name : names)
    if (const auto number = ini_.number(section, name); number && !draft_.has(key))
      set_limit(key, *number, factor);
}

void ConfigurationReader::take_axis(int axis) {
  const Sections sections = sections_of(axis);
  if (sections.empty()) return;
  const std::string table =
      std::string("axis.") + lower(kAxisLetters[static_cast<std::size_t>(axis)]);
  constexpr double kPerMin = 60;
  take_best(table + ".velocity_mm_min", sections, "MAX_VELOCITY", std::less<>(), unit_ * kPerMin);
  take_best(table + ".acceleration_mm_s2", sections, "MAX_ACCELERATION", std::less<>(), unit_);
  take_best(table + ".jerk_mm_s3", sections, "MAX_JERK", std::less<>(), unit_);
  take_limit(table + ".min_mm", sections, "MIN_LIMIT", std::greater<>());
  take_limit(table + ".max_mm", sections, "MAX_LIMIT", std::less<>());
  take_best(table + ".backlash_um", joints_of(axis), "BACKLASH", std::greater<>(),
            um_from_mm(unit_));
  take_scale(table, joints_of(axis));
}

/// Steps, or counts, per unit, in either direction.
void ConfigurationReader::take_scale(const std::string& table, const Sections& sections) {
  for (const std::string& section : sections)
    for (const char* name : {"STEP_SCALE", "SCALE", "INPUT_SCALE"}) {
      if (draft_.has(table + ".blu_um")) return;
      const auto scale = ini_.number(section, name);
      if (!scale) continue;
      if (scale->value == 0)
        draft_.fail(Code::SC7035, scale->at, std::string(name) + " cannot be 0");
      else
        draft_.set(table + ".blu_um", um_from_mm(unit_ / std::abs(scale->value)), scale->at);
    }
}

void ConfigurationReader::take_path_limits() {
  constexpr double kPerMin = 60;
  take_first("limits.feed_mm_min", "TRAJ", {"MAX_LINEAR_VELOCITY", "MAX_VELOCITY"},
             unit_ * kPerMin);
  take_first("limits.tangential_mm_s2", "TRAJ", {"MAX_LINEAR_ACCELERATION", "MAX_ACCELERATION"},
             unit_);
}

/// In ns. A period of 0 is that of a thread that there is not.
void ConfigurationReader::take_periods() {
  const auto take = [&](const char* key, const char* name, double factor) {
    const auto ns = ini_.number("EMCMOT", name);
    if (ns && ns->value != 0) draft_.set(key, ns->value * factor, ns->at);
  };
  take("control.period_ms", "SERVO_PERIOD", 1e-6);
  take("backend.parport.base_period_us", "BASE_PERIOD", 1e-3);
}

/// In ns; every axis gets the longest.
void ConfigurationReader::take_step_times() {
  struct StepTime {
    const char *name, *key;
  };
  constexpr StepTime kTimes[] = {{"STEPLEN", "backend.stepdir.step_length_ns"},
                                 {"STEPSPACE", "backend.stepdir.step_space_ns"},
                                 {"DIRSETUP", "backend.stepdir.direction_setup_ns"},
                                 {"DIRHOLD", "backend.stepdir.direction_hold_ns"}};
  Sections joints;
  for (int axis = 0; axis < kAxes; ++axis)
    for (const std::string& section : joints_of(axis)) joints.push_back(section);
  for (const StepTime& time : kTimes)
    if (const auto ns = best(joints, time.name, std::greater<>()); ns && ns->value > 0)
      draft_.set(time.key, ns->value, ns->at);
}

std::optional<std::string> ConfigurationReader::text_beside(const IniVariable& variable) {
  const std::string file = beside_file(file_, variable.value);
  auto text = draft_.read_named_file(file);
  if (text) return std::move(*text);
  draft_.warn(Code::SC7037, variable.at, "the file " + file + " " + text.error().message);
  draft_.leave(variable.at);
  return std::nullopt;
}

void ConfigurationReader::take_files() {
  if (const IniVariable* table = ini_.find("EMCIO", "TOOL_TABLE"))
    if (const auto text = text_beside(*table))
      take_tool_table(*text, beside_file(file_, table->value), unit_, draft_);
  if (const IniVariable* parameters = ini_.find("RS274NGC", "PARAMETER_FILE"))
    if (const auto text = text_beside(*parameters))
      take_parameters(*text, beside_file(file_, parameters->value), unit_, draft_);
}

/// Those of the machine one by one, the sections of displays and programs as a whole.
void ConfigurationReader::leave_rest() {
  constexpr std::array<std::string_view, 10> kOfMachine{
      "TRAJ", "KINS", "AXIS_", "JOINT_", "SPINDLE_", "EMCMOT", "EMCIO", "RS274NGC", "EMC", "TASK"};
  std::vector<std::string> others;
  for (const IniVariable& variable : ini_.variables()) {
    if (variable.used) continue;
    const bool of_machine =
        std::any_of(kOfMachine.begin(), kOfMachine.end(),
                    [&](std::string_view begin) { return variable.section.starts_with(begin); });
    if (of_machine)
      draft_.leave(variable.at, "[" + variable.section + "]");
    else if (std::find(others.begin(), others.end(), variable.section) == others.end())
      others.push_back(variable.section);
  }
  for (const std::string& section : others)
    draft_.leave("the variables of [" + comment_text(section) + "]");
}

}  // namespace

void take_configuration(std::string_view text, const std::string& file,
                        const std::string& target_folder, MachineDraft& draft) {
  IniFile ini(text, file, draft);
  ConfigurationReader(ini, file, target_folder, draft).take();
}

}  // namespace softcnc::hal
