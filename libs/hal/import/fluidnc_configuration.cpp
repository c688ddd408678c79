// SPDX-License-Identifier: MIT
#include "hal/import/fluidnc_configuration.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "hal/machine/toml_text.hpp"

namespace softcnc::hal {
namespace {

struct FluidSetting {
  std::string value;
  GivenAt at;  // its value
};
/// By their places in the tree: "axes/x/steps_per_mm".
using FluidSettings = std::map<std::string, FluidSetting>;

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// As FluidNC reads it: whatever is not true is false.
bool is_true(const FluidSetting& setting) { return lower_case(setting.value) == "true"; }

/// Takes down the values of a document with their places. Nothing is expanded: what an anchor
/// stands for is read where it is written, and an alias to it has no value.
class SettingsOfYaml final : public YAML::EventHandler {
 public:
  SettingsOfYaml(std::string_view text, const std::string& file, MachineDraft& draft)
      : lines_(setting_lines(text)), file_(file), draft_(draft) {
    while (lines_.size() > 1 && lines_.back().empty()) lines_.pop_back();
  }

  FluidSettings take() { return std::move(settings_); }

  GivenAt place(const YAML::Mark& mark, std::string_view part) const {
    const auto lines = static_cast<int>(lines_.size());
    if (mark.line < 0 || mark.line >= lines) return {file_, {lines, 0, 1}, lines_.back()};
    return {file_,
            {mark.line + 1, mark.column + 1, static_cast<int>(part.size())},
            lines_[static_cast<std::size_t>(mark.line)]};
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {
    if (!levels_.empty() && sequences_ == 0) settings_.insert({path_, {"", key_at_}});
    end_of_value();
  }
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override { end_of_value(); }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    ++sequences_;
  }
  void OnSequenceEnd() override {
    --sequences_;
    end_of_value();
  }
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    if (!path_.empty() && sequences_ == 0) settings_.insert({path_, {"", key_at_}});
    levels_.push_back({path_.size(), false});
  }
  void OnMapEnd() override {
    levels_.pop_back();
    end_of_value();
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                const std::string& value) override {
    if (levels_.empty() || sequences_ > 0) return;
    if (!levels_.back().has_key) return begin_value(value, mark);
    add({value, place(mark, value)});
    end_of_value();
  }

 private:
  struct Level {
    std::size_t length;  // of the path before its keys
    bool has_key;        // whose value comes next
  };

  /// FluidNC reads keys in any case.
  void begin_value(const std::string& key, const YAML::Mark& mark) {
    levels_.back().has_key = true;
    key_at_ = place(mark, key);
    path_ += (path_.empty() ? "" : "/") + lower_case(key);
  }

  void end_of_value() {
    if (levels_.empty() || sequences_ > 0) return;
    path_.resize(levels_.back().length);
    levels_.back().has_key = false;
  }

  void add(FluidSetting setting) {
    if (const auto known = settings_.find(path_);
        known != settings_.end() && !known->second.value.empty())
      draft_.warn(Code::SC7036, setting.at, path_ + " is given twice; the last line counts");
    settings_.insert_or_assign(path_, std::move(setting));
  }

  std::vector<std::string> lines_;
  const std::string& file_;
  MachineDraft& draft_;
  FluidSettings settings_;
  std::vector<Level> levels_;
  std::string path_;
  GivenAt key_at_;
  int sequences_ = 0;
};

/// The settings of a configuration, as those without a key are left over.
class FluidConfiguration {
 public:
  FluidConfiguration(FluidSettings settings, MachineDraft& draft)
      : settings_(std::move(settings)), draft_(draft) {}

  void take();

 private:
  std::optional<FluidSetting> find(const std::string& path);
  std::optional<double> number(const FluidSetting& setting, const std::string& path);
  void take_number(const std::string& path, const std::string& key, double factor);
  void take_positive(const std::string& path, const std::string& key,
                     const std::function<double(double)>& converted);
  void refuse_kinematics();
  void take_name();
  void take_axis(char letter);
  void take_travel(const std::string& path, const std::string& table);
  void take_speed();

  FluidSettings settings_;
  MachineDraft& draft_;
};

void FluidConfiguration::take() {
  refuse_kinematics();
  take_name();
  draft_.choose("control.backend", "\"none\"", "settings do not describe the motors");
  take_number("junction_deviation_mm", "control.corner_tolerance_um", 1000);
  take_number("arc_tolerance_mm", "control.chord_tolerance_um", 1000);
  for (const char letter : {'x', 'y', 'z'}) take_axis(letter);
  take_speed();
  take_number("stepping/pulse_us", "backend.stepdir.step_length_ns", 1000);
  take_number("stepping/dir_delay_us", "backend.stepdir.direction_setup_ns", 1000);
  for (const auto& [path, setting] : settings_)
    if (!setting.value.empty()) draft_.leave(setting.at);
}

/// What is empty counts as not given.
std::optional<FluidSetting> FluidConfiguration::find(const std::string& path) {
  const auto node = settings_.extract(path);
  return node && !node.mapped().value.empty() ? std::optional(node.mapped()) : std::nullopt;
}

std::optional<double> FluidConfiguration::number(const FluidSetting& setting,
                                                 const std::string& path) {
  const auto read = setting_number(trimmed_setting(setting.value));
  if (!read)
    draft_.fail(Code::SC7035, setting.at, path + " needs a number, not '" + setting.value + "'");
  return read;
}

/// A tolerance or time of 0 is left to softcnc.
void FluidConfiguration::take_number(const std::string& path, const std::string& key,
                                     double factor) {
  const auto setting = find(path);
  if (!setting) return;
  const auto value = number(*setting, path);
  if (value && *value != 0) draft_.set(key, *value * factor, setting->at);
}

void FluidConfiguration::take_positive(const std::string& path, const std::string& key,
                                       const std::function<double(double)>& converted) {
  const auto setting = find(path);
  if (!setting) return;
  const auto value = number(*setting, path);
  if (value && *value > 0)
    draft_.set(key, converted(*value), setting->at);
  else if (value)
    draft_.fail(Code::SC7035, setting->at,
                path + " needs a number above 0, not '" + setting->value + "'");
}

void FluidConfiguration::refuse_kinematics() {
  constexpr std::string_view kKinematics = "kinematics/", kCartesian = "kinematics/cartesian";
  for (const auto& [path, setting] : settings_)
    if (path.starts_with(kKinematics) && !path.starts_with(kCartesian))
      return draft_.fail(Code::SC7034, setting.at,
                         "the axes of the machine are not those of its motors (" +
                             path.substr(0, path.find('/', kKinematics.size())) +
                             "); softcnc moves Cartesian machines");
}

void FluidConfiguration::take_name() {
  if (const auto name = find("name"); name && !name->value.empty())
    draft_.set("name", toml_string(name->value), name->at);
}

void FluidConfiguration::take_axis(char letter) {
  const std::string path = std::string("axes/") + letter, table = std::string("axis.") + letter;
  const auto as_given = [](double value) { return value; };
  take_positive(path + "/max_rate_mm_per_min", table + ".velocity_mm_min", as_given);
  take_positive(path + "/acceleration_mm_per_sec2", table + ".acceleration_mm_s2", as_given);
  take_travel(path, table);
  take_positive(path + "/steps_per_mm", table + ".blu_um", [](double n) { return 1000 / n; });
}

void FluidConfiguration::take_travel(const std::string& path, const std::string& table) {
  const auto travel = find(path + "/max_travel_mm");
  const bool homes = settings_.contains(path + "/homing");
  const auto place = find(path + "/homing/mpos_mm");
  const auto direction = find(path + "/homing/positive_direction");
  const auto soft = find(path + "/soft_limits");
  if (!travel) return;
  const auto length = number(*travel, path + "/max_travel_mm");
  const auto home = place ? number(*place, path + "/homing/mpos_mm") : std::optional(0.0);
  if (!length || !home) return;
  const bool bounded = homes || (soft && is_true(*soft));
  const bool upward = direction && !is_true(*direction);
  draft_.set(table + ".min_mm", upward ? *home : *home - *length, travel->at);
  draft_.set(table + ".max_mm", upward || !bounded ? *home + *length : *home, travel->at);
}

/// `0=0% 24000=100%`: the largest speed, of whatever spindles.
void FluidConfiguration::take_speed() {
  constexpr std::string_view kMap = "/speed_map";
  std::optional<double> most;
  GivenAt at;
  for (auto entry = settings_.begin(); entry != settings_.end();) {
    const std::string& path = entry->first;
    const bool is_map = path.ends_with(kMap) && path.find('/') == path.size() - kMap.size();
    std::istringstream points(is_map ? entry->second.value : std::string());
    for (std::string point; points >> point;) {
      const auto speed = setting_number(point.substr(0, point.find('=')));
      if (!speed || *speed <= most.value_or(0)) continue;
      most = speed;
      at = entry->second.at;
    }
    entry = is_map ? settings_.erase(entry) : std::next(entry);
  }
  if (most) draft_.set("spindle.max_rpm", *most, at);
}

}  // namespace

void take_fluidnc_configuration(const std::string& text, const std::string& file,
                                MachineDraft& draft) {
  SettingsOfYaml settings(text, file, draft);
  try {
    std::istringstream stream(text);
    YAML::Parser(stream).HandleNextDocument(settings);
  } catch (const YAML::Exception& error) {
    return draft.fail(Code::SC7034, settings.place(error.mark, " "),
                      "this is no YAML: " + error.msg);
  }
  FluidConfiguration(settings.take(), draft).take();
}

bool is_fluidnc_configuration(std::string_view text) {
  const auto lines = setting_lines(text);
  return std::any_of(lines.begin(), lines.end(),
                     [](std::string_view line) { return line.starts_with("axes:"); });
}

}  // namespace softcnc::hal
