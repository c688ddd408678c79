// SPDX-License-Identifier: MIT
// A program before anything moves: all that is wrong with it.
#pragma once

#include <cstdint>

#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

enum class CheckNotes : std::uint8_t { errors, surface_too };

/// Runs the program without a backend, reports all that is wrong with it and where its rows exceed
/// a limit, and returns what is known after the run; with `surface_too` also what surface it
/// leaves, where it asks for one. `watcher` may be null.
Outcome check(Program& program, const Machine& machine, const ChannelOptions& options,
              Diagnostics& diagnostics, Watcher* watcher = nullptr,
              CheckNotes notes = CheckNotes::errors);

/// Returns the machine with a backend that goes nowhere.
Machine without_backend(Machine machine);

}  // namespace softcnc::runtime
