// SPDX-License-Identifier: MIT
// The time of a program by its plan alone, without the rows of a run.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "motion/model/machine.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

struct PlannedTimes {
  double time = 0;         // s
  std::int64_t rests = 0;  // at corners
};

/// Plans the program, each block as `change` leaves it; events play no part. Nothing if the
/// watcher, which may be null, wants to stop, or the program or its plan has an error. `program`
/// must be one that can be read again.
std::optional<PlannedTimes> plan_times(
    Program& program, const Machine& machine, const ChannelOptions& options, Watcher* watcher,
    const std::function<void(Block&)>& change = [](Block&) {});

}  // namespace softcnc::runtime
