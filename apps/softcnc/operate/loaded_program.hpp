// SPDX-License-Identifier: MIT
// The part program that an operator has loaded, and what is known of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/messages.hpp"
#include "motion/model/machine_state.hpp"
#include "runtime/check/travel_survey.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"

namespace softcnc::app {

/// What a check has found.
struct CheckedProgram {
  MachineState state;  // from which,
  Outputs outputs;
  bool block_skip = false, optional_stop = false;  // and with which switches
  bool passed = false;
  std::string found;  // errors, warnings and notes, as text
  int errors = 0, warnings = 0;
  double time = 0;           // s of motion
  runtime::TravelSpan span;  // mm, machine coordinates
};

class LoadedProgram {
 public:
  /// A regular file of at most kLargest bytes. Errors: SC6001 otherwise, and those of
  /// runtime::Program::open().
  static Result<LoadedProgram> open(const std::string& file);
  /// Returns whether the file is another one by now.
  bool has_changed() const;

  const std::string& name() const noexcept { return program_.name(); }
  const std::string& folder() const noexcept { return program_.folder(); }
  const std::string& text() const noexcept { return text_; }
  int lines() const noexcept { return static_cast<int>(begins_.size()); }
  /// Returns a line, from 1; empty where there is none.
  std::string_view line(int number) const noexcept;

  /// Returns what the check with these options has found; null where there was none.
  const CheckedProgram* checked(const runtime::ChannelOptions& options) const noexcept;
  const CheckedProgram* checked() const noexcept { return checked_ ? &*checked_ : nullptr; }
  /// Checks the program without motion. `is_stopped` is asked now and then whether to stop; then
  /// nothing is known.
  void check(const Machine& machine, runtime::ChannelOptions options,
             const std::function<bool()>& is_stopped);

 private:
  static constexpr std::uintmax_t kLargest = std::uintmax_t{1} << 28U;

  LoadedProgram(runtime::Program program, std::string text);

  runtime::Program program_;
  std::string text_;
  std::vector<std::size_t> begins_;  // of lines
  std::filesystem::file_time_type written_;
  std::optional<CheckedProgram> checked_;
};

}  // namespace softcnc::app
