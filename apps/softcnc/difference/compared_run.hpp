// SPDX-License-Identifier: MIT
// A run that is compared with another: a program, a trace or a recording.
#pragma once

#include <optional>
#include <string>

#include "input/reported_run.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "recording/recording.hpp"
#include "runtime/difference/row_store.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

struct ComparedRun {
  std::string name;  // of the file; "<stdin>" for "-"
  InputKind kind = InputKind::program;
  runtime::RowStore rows = {};
  std::optional<Machine> machine = {};  // of a program or a recording
  int status = 0;  // exit status; other than 0: what is wrong has been shown, and nothing compared
};

/// Reads the rows of a recording, and ends them; `name` stands for its file. Errors: SC6003, SC60xx
/// of reading.
Status read_rows(const Recording& recording, const std::string& name, runtime::RowStore& rows);

/// Reads a trace, or that of a recording, or runs a program as `report` does. What is wrong
/// with a program is shown, and is in the status. Errors: those of reading, SC60xx and SC70xx.
Result<ComparedRun> read_compared(const std::string& file, const Options& options,
                                  Messages& messages, Terminal& terminal);

}  // namespace softcnc::app
