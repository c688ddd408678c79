// SPDX-License-Identifier: MIT
// A recording that is run again.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "settings/options.hpp"

namespace softcnc::app {

enum class ReplayEnd : std::uint8_t { agrees, differs, blessed, error };
std::string_view name(ReplayEnd end) noexcept;

struct ReplayResult {
  std::string name;  // of the file; "<stdin>" for "-"
  ReplayEnd end = ReplayEnd::error;
  int status = 0;         // exit status
  std::int64_t rows = 0;  // that agree
  std::string code;       // of the diagnostic that ends it; empty: none
  std::string message;    // its text; of a blessed one, what has changed
  std::string table;      // of the first row that differs
  double seconds = 0;     // that it took
};

/// Runs a recording again and compares its rows as they come; with `options.bless` one that differs
/// is made again in place, after a second run, which must end without errors and without an alarm.
/// `label` is what the progress shows. Errors are shown.
ReplayResult replay_recording(const std::string& file, const std::string& label,
                              const Options& options);

}  // namespace softcnc::app
