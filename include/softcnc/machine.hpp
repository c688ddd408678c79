// SPDX-License-Identifier: MIT
// A machine: its axes, limits, period and backend, as a machine file describes them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <softcnc/diagnostic.hpp>
#include <softcnc/export.hpp>

namespace softcnc::api {

/// A value: copies are independent of each other. One that has been moved from is the built-in
/// machine.
class SOFTCNC_API Machine {
 public:
  /// Makes the built-in machine: three axes, a period of 1 ms, a simulated mill.
  Machine();
  /// Loads a machine file (TOML). Errors: SC70xx, with line and column.
  static Expected<Machine> load(const std::string& file);
  /// Does the same for a text; `name` stands for the file in diagnostics.
  static Expected<Machine> parse(const std::string& text, const std::string& name);

  Machine(const Machine& other);
  Machine(Machine&& other) noexcept;
  Machine& operator=(Machine other) noexcept;
  ~Machine();

  /// Returns the machine with other values: "axis.x.velocity_mm_min=3000". docs/machine.md lists
  /// the keys. Errors: SC70xx, in a file called "--set".
  Expected<Machine> with(const std::vector<std::string>& settings) const;

  /// Returns the time from one setpoint to the next, s.
  double period() const noexcept;
  /// Returns a complete machine file that loads back to the same machine.
  std::string toml() const;

  struct Data;
  const Data& data() const noexcept;

 private:
  explicit Machine(std::unique_ptr<Data> data) noexcept;
  std::unique_ptr<Data> data_;
};

}  // namespace softcnc::api
