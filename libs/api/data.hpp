// SPDX-License-Identifier: MIT
// What stands behind the classes of the door, and how their options reach the runtime.
#pragma once

#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include <softcnc/machine.hpp>
#include <softcnc/program.hpp>

#include "ipo/limits/constraint.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/watcher.hpp"

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

/// Passes requests to stop on to a run, which otherwise nobody observes.
class StopRequests final : public runtime::Watcher {
 public:
  explicit StopRequests(std::stop_token stop) : stop_(std::move(stop)) {}
  bool wants_stop() override { return stop_.stop_requested(); }
  void sees(const softcnc::Setpoint&) override {}
  void pause(const runtime::Pause&) override {}
  void wait_for_input(int) override {}

 private:
  std::stop_token stop_;
};

/// Does what the public check() does until a stop is requested, and returns what it has found so
/// far.
std::vector<Diagnostic> check(const Program& program, const Machine& machine,
                              const RunOptions& options, std::stop_token stop);

}  // namespace softcnc::api
