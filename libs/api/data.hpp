// SPDX-License-Identifier: MIT
// What stands behind the classes of the door, and how their options reach the runtime.
#pragma once

#include <memory>
#include <vector>

#include <softcnc/machine.hpp>
#include <softcnc/program.hpp>

#include "ipo/limits/constraint.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"

namespace softcnc::api {

struct Machine::Data {
  softcnc::Machine machine;
};

struct State::Data {
  MachineState state;
};

struct Program::Data {
  runtime::Program program;
};

/// The options of a run, with the constraints that they refer to.
class RunSetup {
 public:
  /// `program` may be null: a session has none.
  RunSetup(const RunOptions& options, runtime::Program* program);
  const runtime::ChannelOptions& channel() const noexcept { return channel_; }

 private:
  std::vector<std::unique_ptr<ipo::Constraint>> constraints_;
  runtime::ChannelOptions channel_;
};

}  // namespace softcnc::api
