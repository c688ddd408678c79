// SPDX-License-Identifier: MIT
// What programs leave on a machine: where it stands, work offsets, reference points, tools,
// variables.
#pragma once

#include <memory>
#include <string>

#include <softcnc/diagnostic.hpp>
#include <softcnc/export.hpp>

namespace softcnc::api {

/// A value: what a state file holds, as `softcnc run --state` reads and writes it.
class SOFTCNC_API State {
 public:
  /// Makes the state of a machine on which nothing has been set.
  State();
  /// Reads a state file (TOML), or its text; `name` stands for the file in diagnostics. Errors:
  /// SC70xx, with line and column.
  static Expected<State> load(const std::string& file);
  static Expected<State> parse(const std::string& text, const std::string& name);

  State(const State& other);
  State(State&& other) noexcept;
  State& operator=(State other) noexcept;
  ~State();

  /// Returns the text of a state file that reads back to the same state.
  std::string toml() const;

  struct Data;
  const Data& data() const noexcept;
  explicit State(std::unique_ptr<Data> data) noexcept;

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace softcnc::api
