// SPDX-License-Identifier: MIT
// The time sheet of a run: what each tool did with its time, and why the machine came to rest.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipo/queue/block_queue.hpp"

namespace softcnc::runtime {

/// The reason why the machine came to a rest between its start and its end.
enum class RestCause : std::uint8_t {
  corner,    // the path turns, or every block ends at rest (G61.1)
  dwell,     // G04
  tool,      // M06, M61
  spindle,   // M03, M04, M05, and S while it turns
  coolant,   // M07, M08, M09
  stop,      // M00, M01, M60
  output,    // M62 to M65, M67, M68
  hold,      // a feed hold, or an override of 0
  planning,  // no faster plan was found: planner_fallbacks
};
inline constexpr std::size_t kRestCauses = 9;

/// Later events are counted only, so that memory stays bounded.
inline constexpr std::size_t kMostOutputEvents = 10'000;

/// Returns the report's word: "corner", "dwell", ...
std::string_view name(RestCause cause) noexcept;

/// The seconds of one tool.
struct ToolTime {
  int tool = 0;  // its number; 0: none
  double cutting = 0, rapid = 0, dwell = 0, rest = 0;

  double all() const noexcept { return cutting + rapid + dwell + rest; }
};

/// The time that rests at corners take: their ramps, and the wait for the next row, in s beyond the
/// time that the same path takes at the programmed feed; in rapids at the speed where the ramp
/// ends.
struct CornerRests {
  std::int64_t count = 0;
  double seconds = 0;
  double roundable_seconds = 0;  // of them in moves that have no tolerance for rounding
  double exact_seconds = 0;      // of those where the program itself asks for the exact path
};

/// The same against a second plan of the program, with its corners rounded.
struct CornerCost {
  std::int64_t rests = 0;  // at corners that are passed at speed then
  double seconds = 0;      // that are won back
  double tolerance = 0;    // mm: P and Q of the G64 that does it
};

/// An output that the program has set.
struct OutputEvent {
  double t = 0;  // s from the start of the motion, of the plan
  SourcePos source;
  OutputPort port;
  double value = 0;
  std::string file{};  // empty: the program itself
};

struct TimeSheet {
  std::vector<ToolTime> tools;  // in the order in which they come
  std::array<std::int64_t, kRestCauses> rests{};
  CornerRests corners;
  std::vector<OutputEvent> outputs;  // the first kMostOutputEvents
  std::int64_t outputs_left_out = 0;
  std::optional<CornerCost> corner_cost{};  // where corner_cost.hpp has planned the program again

  std::int64_t rests_by(RestCause cause) const noexcept {
    return rests[static_cast<std::size_t>(cause)];
  }
};

/// Keeps the time sheet of blocks that come in the order in which they are run.
class TimeKeeper {
 public:
  /// The first `until` s of a block; `feed_override` is what counts in it.
  void add(const ipo::TimedBlock& timed, double until, double feed_override);

  const TimeSheet& sheet() const noexcept { return sheet_; }

 private:
  ToolTime& tool();
  void pass(const ipo::TimedBlock& timed);
  void keep_output(const Action& action, const ipo::TimedBlock& timed);
  void add(const Move& move, const ipo::Profile::Span& span, double feed_override);
  void add_lost(const Move& move, double seconds);
  void come_to_rest(const ipo::Profile::Span& span);
  void rest_for(RestCause cause);

  TimeSheet sheet_;
  int tool_ = 0;
  bool rests_ = false;            // for a reason that the next block gives
  bool rests_at_corner_ = false;  // since the last motion
};

}  // namespace softcnc::runtime
