// SPDX-License-Identifier: MIT
#include "hal/machine/device_keys.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

#include "hal/files/number.hpp"
#include "hal/machine/device_value.hpp"
#include "hal/machine/toml_text.hpp"
#include "motion/core/spelling.hpp"

namespace softcnc::hal {
namespace {

constexpr double kLongestTime = 1e9;  // s, as of G04
constexpr double kLargest = 1e9;      // values of outputs and inputs
constexpr int kLastPort = 999, kLastPin = 17;
constexpr double kFarthestContact = 1e5;  // mm, as axes

MachineCode& m_code(Machine& machine, const std::string& of) {
  return machine.m_codes[std::stoi(of)];
}
const MachineCode& m_code(const Machine& machine, const std::string& of) {
  return machine.m_codes.find(std::stoi(of))->second;
}
OutputPort& output(Machine& machine, const std::string& of) { return machine.outputs[of]; }
const OutputPort& output(const Machine& machine, const std::string& of) {
  return machine.outputs.find(of)->second;
}
InputPort& input(Machine& machine, const std::string& of) { return machine.inputs[of]; }
const InputPort& input(const Machine& machine, const std::string& of) {
  return machine.inputs.find(of)->second;
}

ContactBody& contact(Machine& machine, const std::string& of) { return machine.contacts[of]; }
const ContactBody& contact(const Machine& machine, const std::string& of) {
  return machine.contacts.find(of)->second;
}

using Of = const std::string&;
using GivenKey = const FileValue&;

// clang-format off
constexpr DeviceKey kDeviceKeys[] = {
    {"mcode", "do", "'ignore', 'stop', 'dwell', 'spindle', 'coolant', 'output'", "what the M code does", "",
     [](Machine& m, Of of, GivenKey v) { return take_word(m_code(m, of).act, v, kMachineCodeActs); },
     [](const Machine& m, Of of) { return word_text(m_code(m, of).act, kMachineCodeActs); }},
    {"mcode", "seconds", "at least 0 and at most 1e+09", "time of a dwell", "s",
     [](Machine& m, Of of, GivenKey v) { return take_number(m_code(m, of).seconds, v, 0, kLongestTime); },
     [](const Machine& m, Of of) { return number_text(m_code(m, of).seconds); }},
    {"mcode", "direction", "'cw', 'ccw', 'off'", "of the spindle: as M03, M04, M05, with the S in force", "",
     [](Machine& m, Of of, GivenKey v) { return take_word(m_code(m, of).direction, v, kSpindleTurns); },
     [](const Machine& m, Of of) { return word_text(m_code(m, of).direction, kSpindleTurns); }},
    {"mcode", "coolant", "'mist', 'flood', 'off'", "as M07, M08, M09", "",
     [](Machine& m, Of of, GivenKey v) { return take_word(m_code(m, of).coolant, v, kCoolantSwitches); },
     [](const Machine& m, Of of) { return word_text(m_code(m, of).coolant, kCoolantSwitches); }},
    {"mcode", "output", "a string, or an integer", "the output that is set: its name or its number", "",
     [](Machine& m, Of of, GivenKey v) { return take_output_name(m_code(m, of).output, v); },
     [](const Machine& m, Of of) { return quoted_text(m_code(m, of).output); }},
    {"mcode", "value", "at least -1e+09 and at most 1e+09", "what the output gets; 0 or 1 where it is digital", "",
     [](Machine& m, Of of, GivenKey v) { return take_number(m_code(m, of).value, v, -kLargest, kLargest); },
     [](const Machine& m, Of of) { return number_text(m_code(m, of).value); }},
    {"mcode", "words", "letters other than F G M N O S T X Y Z", "words that the M code takes, and that change nothing in softcnc", "",
     [](Machine& m, Of of, GivenKey v) { return take_letters(m_code(m, of).words, v); },
     [](const Machine& m, Of of) { return quoted_text(m_code(m, of).words); }},

    {"output", "number", "integer, at least 0 and at most 999", "P of M62 to M65, E of M67 and M68", "",
     [](Machine& m, Of of, GivenKey v) { return take_whole(output(m, of).number, v, 0, kLastPort); },
     [](const Machine& m, Of of) { return std::to_string(output(m, of).number); }},
    {"output", "kind", "'digital', 'analog'", "whether it is on or off, or has any value", "",
     [](Machine& m, Of of, GivenKey v) { return take_word(output(m, of).kind, v, kSignalKinds); },
     [](const Machine& m, Of of) { return word_text(output(m, of).kind, kSignalKinds); }},
    {"output", "pin", "integer, at least -17 and at most 17", "output pin of the parallel port, where it is digital; negative: inverted, 0: none", "",
     [](Machine& m, Of of, GivenKey v) { return take_whole(output(m, of).pin, v, -kLastPin, kLastPin); },
     [](const Machine& m, Of of) { return std::to_string(output(m, of).pin); }},

    {"input", "number", "integer, at least 0 and at most 999", "P or E of M66", "",
     [](Machine& m, Of of, GivenKey v) { return take_whole(input(m, of).number, v, 0, kLastPort); },
     [](const Machine& m, Of of) { return std::to_string(input(m, of).number); }},
    {"input", "kind", "'digital', 'analog'", "whether it is on or off, or has any value", "",
     [](Machine& m, Of of, GivenKey v) { return take_word(input(m, of).kind, v, kSignalKinds); },
     [](const Machine& m, Of of) { return word_text(input(m, of).kind, kSignalKinds); }},
    {"input", "value", "at least -1e+09 and at most 1e+09", "simulated value at the start", "",
     [](Machine& m, Of of, GivenKey v) { return take_number(input(m, of).value, v, -kLargest, kLargest); },
     [](const Machine& m, Of of) { return number_text(input(m, of).value); }},
    {"input", "lines", "an array of whole numbers, at least 1", "lines on which an M66 takes the next value", "",
     [](Machine& m, Of of, GivenKey v) { return take_lines(input(m, of).lines, v); },
     [](const Machine& m, Of of) { return numbers_text(input(m, of).lines); }},
    {"input", "values", "an array of as many numbers", "the values, one for each of `lines`", "",
     [](Machine& m, Of of, GivenKey v) { return take_numbers(input(m, of).values, v, -kLargest, kLargest); },
     [](const Machine& m, Of of) { return numbers_text(input(m, of).values); }},
    {"input", "after_s", "an array of as many numbers, at least 0, or of none", "how long after the M66 begins the value comes; []: at once", "s",
     [](Machine& m, Of of, GivenKey v) { return take_numbers(input(m, of).after, v, 0, kLongestTime); },
     [](const Machine& m, Of of) { return numbers_text(input(m, of).after); }},

    {"contact", "min_mm", "[X, Y, Z], at least -1e+05 and at most 1e+05", "corner with the smallest coordinates of a body that a probe touches in simulation, in machine coordinates", "mm",
     [](Machine& m, Of of, GivenKey v) { return take_point(contact(m, of).min, v, kFarthestContact); },
     [](const Machine& m, Of of) { return point_text(contact(m, of).min); }},
    {"contact", "max_mm", "[X, Y, Z], at least -1e+05 and at most 1e+05", "the opposite corner", "mm",
     [](Machine& m, Of of, GivenKey v) { return take_point(contact(m, of).max, v, kFarthestContact); },
     [](const Machine& m, Of of) { return point_text(contact(m, of).max); }},
};
// clang-format on

constexpr std::array<std::string_view, 4> kDeviceTables{"mcode", "output", "input", "contact"};

bool is_m_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  const bool plain = text == "0" || text[0] != '0';
  return plain && number >= 0 && number <= kLastMachineCode;
}

const DeviceKey* find_device_key(std::string_view table, std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kDeviceKeys), std::end(kDeviceKeys),
                   [&](const DeviceKey& key) { return key.table == table && key.name == name; });
  return found == std::end(kDeviceKeys) ? nullptr : found;
}

/// Whether a value of an M code goes with what it does.
bool matters(const DeviceKey& key, const MachineCode& code) {
  switch (code.act) {
    case MachineCodeAct::dwell:
      if (key.name == "seconds") return true;
      break;
    case MachineCodeAct::spindle:
      if (key.name == "direction") return true;
      break;
    case MachineCodeAct::coolant:
      if (key.name == "coolant") return true;
      break;
    case MachineCodeAct::output:
      if (key.name == "output" || key.name == "value") return true;
      break;
    default:
      break;
  }
  return key.name == "do" || key.name == "words";
}

}  // namespace

std::span<const DeviceKey> device_keys() noexcept { return kDeviceKeys; }

bool is_device_path(std::string_view path) noexcept {
  return std::any_of(kDeviceTables.begin(), kDeviceTables.end(), [&](std::string_view table) {
    return path.starts_with(table) && (path.size() == table.size() || path[table.size()] == '.');
  });
}

std::optional<DevicePath> device_path(std::string_view path) {
  const auto parts = path_parts(path);
  constexpr std::size_t kMostParts = 3;
  if (!is_device_path(path) || parts.size() > kMostParts) return std::nullopt;
  const auto part = [&](std::size_t i) { return std::string(i < parts.size() ? parts[i] : ""); };
  DevicePath found{part(0), part(1), part(2)};
  if (parts.size() > 1 && !(found.table == "mcode" ? is_m_number(found.of) : is_bare_key(found.of)))
    return std::nullopt;
  if (parts.size() > 2 && find_device_key(found.table, found.key) == nullptr) return std::nullopt;
  return found;
}

std::string nearest_device_key(std::string_view path) {
  const auto parts = path_parts(path);
  if (parts.size() != 3) return {};
  std::vector<std::string> all;
  for (const DeviceKey& key : kDeviceKeys)
    if (key.table == parts[0])
      all.push_back(std::string(key.table) + '.' + std::string(parts[1]) + '.' +
                    std::string(key.name));
  return nearest_name(path, std::vector<std::string_view>(all.begin(), all.end()));
}

Status make_device(const DevicePath& path, Machine& machine) {
  if (path.table == "output") {
    machine.outputs.try_emplace(path.of);
  } else if (path.table == "input") {
    machine.inputs.try_emplace(path.of);
  } else if (path.table == "contact") {
    machine.contacts.try_emplace(path.of);
  } else {
    const int number = std::stoi(path.of);
    if (is_own_m_code(number))
      return value_failure(Code::SC7023,
                           (number < 10 ? "M0" : "M") + path.of +
                               " is a code of softcnc itself, which a machine cannot define");
    machine.m_codes.try_emplace(number);
  }
  return {};
}

Status assign_device(const DevicePath& path, const FileValue& value, Machine& machine) {
  auto stored = find_device_key(path.table, path.key)->store(machine, path.of, value);
  if (!stored)
    stored.error().message =
        path.table + '.' + path.of + '.' + path.key + ' ' + stored.error().message;
  return stored;
}

std::vector<DeviceValue> device_values(const Machine& machine) {
  std::vector<DeviceValue> values;
  const auto add = [&](const DeviceKey& key, const std::string& of) {
    values.push_back({std::string(key.table) + '.' + of + '.' + std::string(key.name),
                      key.spell(machine, of), &key});
  };
  const auto add_all = [&](std::string_view table, const std::string& of) {
    for (const DeviceKey& key : kDeviceKeys)
      if (key.table == table) add(key, of);
  };
  for (const auto& [number, code] : machine.m_codes)
    for (const DeviceKey& key : kDeviceKeys)
      if (key.table == "mcode" && matters(key, code)) add(key, std::to_string(number));
  for (const auto& [name, port] : machine.outputs) add_all("output", name);
  for (const auto& [name, port] : machine.inputs) add_all("input", name);
  for (const auto& [name, body] : machine.contacts) add_all("contact", name);
  return values;
}

std::string device_key_table() {
  Machine machine;
  machine.m_codes[31];
  machine.outputs["o"];
  machine.inputs["i"];
  machine.contacts["c"];
  std::string text = "| key | default | takes | meaning |\n|---|---|---|---|\n";
  for (const DeviceKey& key : kDeviceKeys) {
    const std::string of = key.table == "mcode" ? "31" : std::string(key.table.substr(0, 1));
    text += "| `" + std::string(key.table) + ".*." + std::string(key.name) + "` | `" +
            key.spell(machine, of) + "` | " + std::string(key.takes) + " | " +
            std::string(key.meaning) + " |\n";
  }
  return text;
}

}  // namespace softcnc::hal
