// SPDX-License-Identifier: MIT
// A program that a command reads once, without motion.
#pragma once

#include <functional>

#include "ipr/interpreter/interpreter.hpp"
#include "messages/messages.hpp"
#include "runtime/program/program.hpp"
#include "runtime/run/repeated_errors.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

struct ReadProgram {
  runtime::Program& program;
  const Machine& machine;
  Messages& messages;
  Diagnostics& diagnostics;
  runtime::ShownOnce& shown;
  ipr::Interpreter& interpreter;
};

/// Opens PART with its machine and its state, and returns what use() returns, or the status of the
/// first error, which is shown.
int read_once(const Options& options, const std::function<int(const ReadProgram&)>& use);

}  // namespace softcnc::app
