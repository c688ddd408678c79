// SPDX-License-Identifier: MIT
// What the tests of hal share: files, machines out of files, and setpoints.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "hal/machine/machine_file.hpp"
#include "hal/signals/step_edges.hpp"
#include "motion/model/setpoint.hpp"
#include "support/folder.hpp"
#include "support/period.hpp"

namespace softcnc::hal::test {

using softcnc::test::Folder;
using softcnc::test::kPeriod;

inline const std::string kSource = SOFTCNC_SOURCE_DIR;

inline std::string read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  REQUIRE(stream);
}

/// What is in a folder, sorted.
using Names = std::vector<std::string>;
inline Names names_in(const std::string& folder) {
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// KEY=VALUE, as by --set.
using Settings = std::vector<std::string>;

/// Diagnostics as softcnc shows them, one after the other.
inline std::string all_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += render(diagnostic);
  return text;
}

/// The machine of a text that has to be without any error.
inline Machine parsed(const std::string& text, const Settings& settings = {}) {
  const auto machine = parse_machine(text, "mill.toml", settings);
  INFO((machine ? std::string() : all_of(machine.error())));
  REQUIRE(machine);
  return *machine;
}

/// The same of a file.
inline Machine loaded(const std::string& file, const Settings& settings = {}) {
  const auto machine = load_machine(file, settings);
  INFO((machine ? std::string() : all_of(machine.error())));
  REQUIRE(machine);
  return *machine;
}

inline Setpoint setpoint_at(const AxisVector& position) {
  Setpoint setpoint;
  setpoint.position = position;
  return setpoint;
}
inline Setpoint setpoint_at(double x, double y = 0, double z = 0) {
  return setpoint_at(AxisVector(x, y, z));
}

/// An edge of the step line of an axis.
inline SignalEdge step(std::int64_t time, bool high, std::uint8_t axis = 0) {
  return {time, axis, Wire::step, high};
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The same properties are tried each time, whoever starts the tests.
inline const bool kSeeded = ::setenv("RC_PARAMS", "seed=20261121", 0) == 0;

}  // namespace softcnc::hal::test
