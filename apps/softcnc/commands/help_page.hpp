// SPDX-License-Identifier: MIT
// The pages of --help: options in groups, lines as wide as the terminal, examples.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "settings/options.hpp"

namespace softcnc::app {

/// Returns a formatter of CLI11 that breaks long lines on a terminal, and only there.
std::shared_ptr<CLI::Formatter> wrapping_formatter();

/// Puts the options of a command into groups, and examples below them.
void arrange_help(CLI::App& app, CommandName command);

}  // namespace softcnc::app
