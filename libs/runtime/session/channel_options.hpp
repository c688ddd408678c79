// SPDX-License-Identifier: MIT
// How a part program is run.
#pragma once

#include <functional>
#include <vector>

#include "ipo/limits/constraint_list.hpp"
#include "ipr/interpreter/interpreter.hpp"
#include "motion/model/machine_state.hpp"
#include "motion/model/outputs.hpp"
#include "runtime/session/feed_script.hpp"

namespace softcnc::runtime {

/// The options of the run of a part program, apart from the machine.
struct ChannelOptions {
  double feed_override = 1;     // of the programmed feed, as it begins
  double largest_override = 1;  // that may be asked for while it runs
  ipr::InterpreterOptions interpreter;
  MachineState state;                   // with which the program begins
  Outputs outputs;                      // that are on as it begins
  bool keeps_state = false;             // Outcome::state is asked for
  ipo::FurtherConstraints constraints;  // beyond those of the machine
  bool single_block = false;            // every move ends at rest, every line waits for a person
  /// Where a pipe pauses, the machine comes to rest instead of waiting there for the next line;
  /// without events only.
  bool rests_at_pauses = false;
  /// Where a pipe pauses, what is settled by now goes out; otherwise only what would be settled so
  /// however long it takes the next line to come, until come_to_rest().
  bool hurries = true;
  std::vector<FeedEvent> events;  // in the order of time
  /// s: so much later the first cutting move begins, see with_first_cut_delayed(), or the whole
  /// program, see DelayPlace; for programs that are not fed and without `keeps_state`.
  double first_cut_delay = 0;
  bool skims = false;           // rows that cannot come near a limit are not looked at one by one
  std::size_t worst_lines = 0;  // Outcome::worst_lines: so many are asked for
  bool line_times = false;      // Outcome::line_times is asked for
  /// Returns whether the program never ends as far as it is known; is called where much has been
  /// read again. Such a program is not planned further. May be empty.
  std::function<bool()> is_endless = {};
};

}  // namespace softcnc::runtime
