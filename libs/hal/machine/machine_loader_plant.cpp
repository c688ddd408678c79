// SPDX-License-Identifier: MIT
// The plant of a machine: from its own file, or from the tables [plant.axis.*]; and what of screws
// does not go with the rest of the machine.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "hal/files/text_file.hpp"
#include "hal/machine/machine_loader.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr std::string_view kPlantTable = "plant";
constexpr std::string_view kPlantAxis = "plant.axis.";

bool names_axis_of_plant(const TomlEntry& entry) {
  return entry.table && entry.path.starts_with(kPlantAxis) &&
         entry.path.size() == kPlantAxis.size() + 1 && is_section(entry.path);
}

std::string blu_text(const Axis& axis) { return scaled_text(axis.blu, mm_from_um, um_from_mm); }

}  // namespace

void MachineLoader::keep_named_axes_of_plant(const std::vector<TomlEntry>& entries,
                                             const TextLines& lines) {
  Plant& plant = loaded_.machine.plant;
  for (Axis& axis : plant.axes) axis.present = false;
  for (const TomlEntry& entry : entries) {
    if (!names_axis_of_plant(entry)) continue;
    const int axis = axis_index(entry.path.back());
    plant.axes[static_cast<std::size_t>(axis)].present = plant.given = true;
    loaded_.given.try_emplace(
        std::string(kPlantTable),
        GivenAt{file_, entry.key_pos, std::string(lines[entry.key_pos.line])});
  }
}

/// Returns the name of the file; nothing where there is none to be read.
std::optional<std::string> MachineLoader::plant_to_read(MachineOrigin origin) {
  Machine& machine = loaded_.machine;
  const auto named = loaded_.given.find(kPlantKey);
  if (named == loaded_.given.end() || refused_.contains(std::string(kPlantKey)))
    return std::nullopt;
  const GivenAt place = named->second;
  const std::filesystem::path plant = machine.plant.file;
  const bool is_set = place.file == kSettingFile;
  if (plant.empty()) {
    if (is_set) machine.plant = {};
    return std::nullopt;
  }
  if (is_set) return plant.string();
  if (machine.plant.given) return std::nullopt;
  if (origin == MachineOrigin::memory) {
    fail(Code::SC7003, place,
         "'" + plant.string() +
             "' is not read for a machine that is no file: [plant.axis.*] must "
             "stand in it");
    return std::nullopt;
  }
  const auto file = std::filesystem::path(file_).parent_path() / plant;
  std::error_code error;
  if (origin != MachineOrigin::confined ||
      (plant == plant.filename() && std::filesystem::is_regular_file(file, error)))
    return file.string();
  loaded_.ignored.push_back(
      {.code = Code::SC7021,
       .pos = place.pos,
       .message = std::string(kPlantKey) +
                  " is ignored unless --machine names the file: it is no file in the same folder",
       .file = place.file,
       .source_line = place.line});
  loaded_.given.erase(loaded_.given.find(kPlantKey));
  machine.plant = {};
  return std::nullopt;
}

void MachineLoader::read_plant(MachineOrigin origin) {
  const auto file = plant_to_read(origin);
  if (!file) return;
  const auto text = read_text(*file, Code::SC7003);
  if (!text || text->size() > kLongestMachine) {
    is_doubtful_ = true;
    errors_.push_back(!text ? text.error()
                            : Diagnostic{.code = Code::SC7003,
                                         .message = "cannot be read: longer than 1 MiB",
                                         .file = *file});
    return;
  }
  MachineLoader plant;
  plant.read(*text, *file);
  take_plant(std::move(plant));
}

/// Takes the axes of a machine that has been read, or its errors.
void MachineLoader::take_plant(MachineLoader&& plant) {
  Machine& other = plant.loaded_.machine;
  const auto own = plant.loaded_.given.find(kPlantKey);
  if (own != plant.loaded_.given.end() && !other.plant.file.empty())
    plant.fail(Code::SC7054, own->second,
               std::string(kPlantKey) + " = '" + other.plant.file + "' in a plant");
  else if (other.plant.given)
    plant.fail(Code::SC7054, plant.loaded_.given.find(kPlantTable)->second,
               "[plant.axis.*] in a plant");
  other.plant = {};
  plant.loaded_.given.erase(std::string(kPlantKey));
  auto loaded = plant.finish();
  if (!loaded) {
    is_doubtful_ = true;
    errors_.insert(errors_.end(), std::make_move_iterator(loaded.error().begin()),
                   std::make_move_iterator(loaded.error().end()));
    return;
  }
  std::erase_if(loaded_.given, [](const auto& given) {
    return given.first.starts_with(kPlantAxis);  // of the tables that the file takes the place of
  });
  Plant& taken = loaded_.machine.plant;
  taken.given = true;
  taken.axes = loaded->machine.axes;
  taken.screws = loaded->machine.screws;
  for (auto& [key, place] : loaded->given)
    if (key.starts_with("axis."))
      loaded_.given.insert_or_assign(std::string(kPlantTable) + '.' + key, std::move(place));
}

/// The plant counts the same pulses on the same axes.
void MachineLoader::check_plant(int index) {
  const Plant& plant = loaded_.machine.plant;
  const Axis& own = loaded_.machine.axes[static_cast<std::size_t>(index)];
  const Axis& other = plant.axes[static_cast<std::size_t>(index)];
  if (!plant.given || !own.present) return;
  const std::string axis = axis_name(index), key = "axis." + axis + ".blu_um";
  const std::string of_plant(kPlantTable), named(kPlantKey);
  if (!other.present)
    clash(Code::SC7051, {named, of_plant}, "the plant has no axis " + axis);
  else if (other.blu != own.blu)
    clash(
        Code::SC7051, {of_plant + '.' + key, key, named, of_plant},
        of_plant + '.' + key + " = " + blu_text(other) + " is not " + key + " = " + blu_text(own));
}

/// Methods by pulses make the pulses of the path alone.
void MachineLoader::check_compensation() {
  const Machine& machine = loaded_.machine;
  if (!is_by_pulses(machine.control.interpolation)) return;
  const std::string method(name(machine.control.interpolation));
  if (machine.control.follow != Follow::off)
    clash(Code::SC7053, {"control.follow", "control.interpolation"},
          "control.follow leads no commands by control.interpolation = " + method);
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (!machine.axes[i].present || !has_errors(machine.screws[i])) continue;
    const std::string key = "axis." + axis_name(axis);
    const bool backlash = machine.screws[i].backlash > 0;
    clash(Code::SC7053,
          {backlash ? key + ".backlash_um" : key + ".pitch_table", "control.interpolation"},
          key + (backlash ? ".backlash_um" : ".pitch_table") +
              " cannot be compensated by control.interpolation = " + method);
  }
}

}  // namespace softcnc::hal
