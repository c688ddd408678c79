// SPDX-License-Identifier: MIT
// The keys of a machine's M codes, outputs, inputs and contacts: [mcode.N], [output.NAME],
// [input.NAME], [contact.NAME].
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/machine/machine_value.hpp"
#include "motion/core/result.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// A row of the table. `of` is the number of an M code, or the name of an output, input or contact.
struct DeviceKey {
  std::string_view table;  // "mcode", "output", "input", "contact"
  std::string_view name;   // "do"
  std::string_view takes;
  std::string_view meaning;
  std::string_view unit;
  Status (*store)(Machine&, const std::string& of, const FileValue&);  // the text: what it takes
  std::string (*spell)(const Machine&, const std::string& of);         // as a file has it
};

std::span<const DeviceKey> device_keys() noexcept;

/// The parts of a path within one of these tables: "mcode.31.do".
struct DevicePath {
  std::string table, of, key;  // of and key may be empty
};

/// Returns whether a path names one of these tables or lies within one.
bool is_device_path(std::string_view path) noexcept;
/// Returns the parts of such a path; nothing if it names neither a table nor a known key.
std::optional<DevicePath> device_path(std::string_view path);
/// Returns the key of the table that reads most like `path`; empty if none does.
std::string nearest_device_key(std::string_view path);

/// Makes the M code, output, input or contact, with its defaults, unless it is there. Error:
/// SC7023, an M code that softcnc itself defines.
Status make_device(const DevicePath& path, Machine& machine);
/// Stores a value under a known key of a device that has been made. Errors: SC7004, SC7005, SC7006,
/// SC7027; their place is left to the caller.
Status assign_device(const DevicePath& path, const FileValue& value, Machine& machine);

/// A value of a device as a machine file spells it.
struct DeviceValue {
  std::string path;  // "mcode.31.do"
  std::string value;
  const DeviceKey* key;
};

/// Returns all values of a machine's devices that matter: for an M code those that go with what it
/// does.
std::vector<DeviceValue> device_values(const Machine& machine);

/// A contradiction between values of devices, and the keys of which the first that was given is
/// its place.
struct DeviceClash {
  Code code;
  std::vector<std::string> keys;
  std::string message;
};

/// Returns the contradictions of a machine; `is_given` says whether the file or a setting has a
/// key. Codes: SC7024 to SC7027.
std::vector<DeviceClash> device_clashes(const Machine& machine,
                                        const std::function<bool(const std::string&)>& is_given);

/// The table of keys in Markdown, as it stands in docs/machine.md.
std::string device_key_table();

}  // namespace softcnc::hal
