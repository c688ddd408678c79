// SPDX-License-Identifier: MIT
// The time that rests at corners cost, and the tolerance that would save it.
#pragma once

#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

/// Where rests at corners take more than a tenth of the time by what they lose against the feed,
/// the program is planned once more with its corners rounded, twice at most. If that wins a tenth
/// of the time back, it is kept in the time sheet of the outcome and reported: SC4030, or SC4031
/// where the program asks for the exact path itself. A text that has passed but once, and a program
/// whose feed is changed while it runs, are not planned again; what is reported is their loss
/// against the feed. Nothing is reported where every block is to end at rest, by --single-block or
/// a clock of pulses. The outcome is that of a run that came to its end without errors.
void report_corner_cost(Program& program, const Machine& machine, const ChannelOptions& options,
                        Outcome& outcome, Watcher* watcher, Diagnostics& diagnostics);

}  // namespace softcnc::runtime
