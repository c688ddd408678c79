// SPDX-License-Identifier: MIT
// The table of machine keys: name with unit, meaning, scale into internal units, place in Machine.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// The values a key takes, in the unit of its name; `or_0` takes 0 beside them.
struct ValueRange {
  double low, high;
  bool or_0 = false;
};

/// The conversion of a value whose unit is the internal one.
constexpr double unconverted(double value) noexcept { return value; }

struct NumberKey {
  double& (*place)(Machine&, int index);
  double (*to_internal)(double);  // from the unit of the name
  double (*to_file)(double);
  ValueRange range;
};

struct WholeKey {
  int& (*place)(Machine&, int index);
  ValueRange range;
};

struct ChoiceKey {
  std::span<const std::string_view> words;
  int (*get)(const Machine&);  // index into words
  void (*set)(Machine&, int);
};

struct TextKey {
  std::string& (*place)(Machine&, int index);
};

/// A point in the unit of the name: a number for each axis, or none.
struct PointKey {
  std::vector<double>& (*place)(Machine&, int index);
  ValueRange range;
};

/// Texts, none of them empty.
struct ListKey {
  std::vector<std::string>& (*place)(Machine&, int index);
};

/// A list of pairs: a position, mm, and a value in the unit of the name.
struct PairsKey {
  std::vector<PitchPoint>& (*place)(Machine&, int index);
  double (*to_internal)(double);  // of the second number
  double (*to_file)(double);
  ValueRange position, range;
  std::size_t most;  // pairs
  double steepest;   // change of the value over that of the position
};

/// A row of the table. A '*' in the name stands for an axis letter or a tool number, which is then
/// the `index` of the functions above; that of an axis of the plant is kAxes larger.
struct MachineKey {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  std::variant<NumberKey, WholeKey, ChoiceKey, TextKey, PointKey, ListKey, PairsKey> value;
};

std::span<const MachineKey> machine_keys() noexcept;

/// A key of one axis or tool: the row and what its '*' stands for.
struct KeyRef {
  const MachineKey* key;
  int index = 0;
};

/// Returns the parts of a path, between its dots.
std::vector<std::string_view> path_parts(std::string_view path);

/// The key with this full name, as in "axis.x.blu_um".
std::optional<KeyRef> find_key(std::string_view path);

/// Returns whether a path is the name of a table: "axis", "axis.x", "axis.x.motor".
bool is_section(std::string_view path);

bool is_axis_key(const MachineKey& key) noexcept;
/// Returns the axis of an index, of the machine or of its plant. Requires 0 <= index < 2 kAxes.
Axis& axis_at(Machine& machine, int index) noexcept;
const Axis& axis_at(const Machine& machine, int index) noexcept;
bool is_tool_key(const MachineKey& key) noexcept;

std::string path_of(const KeyRef& ref);

/// The known key that reads most like `path`, spelled for the same axis or tool; empty if none
/// does.
std::string nearest_key(std::string_view path);

/// The same for the name of a table.
std::string nearest_section(std::string_view path);

}  // namespace softcnc::hal
