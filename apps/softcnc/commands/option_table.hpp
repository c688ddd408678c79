// SPDX-License-Identifier: MIT
// The commands and the options that each of them takes, as two tables.
#pragma once

#include <span>

#include "settings/options.hpp"

namespace CLI {
class App;
}

namespace softcnc::app {

struct CommandEntry {
  CommandName id;
  const char* name;
  const char* help;
};

/// The commands, in the order in which the help lists them.
std::span<const CommandEntry> command_table() noexcept;

/// Adds all options of a command, which parsing then writes into `options`.
void add_options(CLI::App& app, CommandName command, Options& options);

}  // namespace softcnc::app
