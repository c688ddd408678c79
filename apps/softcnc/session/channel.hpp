// SPDX-License-Identifier: MIT
// THE PIPELINE: part program -> blocks -> timed blocks -> setpoints -> backend -> rows.
//
//   Reader -> Parser -> Interpreter -> Planner ==queue==> Interpolator -> run_cycle -> Backend
//   '---------------- Feeder -----------------'
//   '---------------------- Channel -----------------------'
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "commands/feed_script.hpp"
#include "hal/backends/backend.hpp"
#include "ipo/planner/planner.hpp"
#include "ipo/queue/interpolator.hpp"
#include "ipo/queue/quiet_stretch.hpp"
#include "ipr/interpreter/interpreter.hpp"
#include "motion/model/cycle.hpp"
#include "motion/verification/contour_report.hpp"
#include "motion/verification/programmed_path.hpp"
#include "motion/verification/verify.hpp"
#include "session/motion_limit.hpp"
#include "session/run_times.hpp"
#include "session/state_history.hpp"
#include "session/surface_notes.hpp"

namespace softcnc::app {

/// How a part program runs, beside the machine.
struct ChannelOptions {
  double feed_override = 1;  // of the programmed feed, as it begins
  ipr::InterpreterOptions interpreter;
  MachineState state;             // with which the program begins
  bool keeps_state = false;       // Outcome::state is asked for
  bool single_block = false;      // every move ends at rest, every line waits for a person
  std::vector<FeedEvent> events;  // in the order of time
  bool skims = false;             // rows that cannot come near a limit are not looked at one by one
  std::size_t worst_lines = 0;    // Outcome::worst_lines: so many are asked for
  /// Whether the program never ends as far as it is known; asked for where much has been read
  /// again. Such a program is not planned further. May be empty.
  std::function<bool()> is_endless = {};
};

/// Where the program waits for a person, and when that is passed.
struct Pause {
  Block block;
  double time = 0;      // s of the plan
  bool before = false;  // the block, which is the next one; or behind it: M00, M01 or M06
};

/// Reports where a move that is not planned would leave the travel.
class UnplannedTravel {
 public:
  UnplannedTravel(const Machine& machine, Diagnostics& diagnostics)
      : machine_(machine), diagnostics_(diagnostics) {}
  void check(const Move& move, SourcePos source);

 private:
  const Machine& machine_;
  Diagnostics& diagnostics_;
};

/// The planning side: reads, interprets and plans as far as the queue needs it.
class Feeder {
 public:
  /// What is referred to must outlive the feeder.
  Feeder(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
         Diagnostics& diagnostics);

  /// Times blocks until the queue reaches beyond `until`, or holds all there are. After an error
  /// the motion ends with the last good block, and the rest is read only to tell what else is
  /// wrong.
  void fill(ipo::BlockQueue& queue, double until);
  /// Times what there is of the path up to `s` mm, but no further than until `t`. What may
  /// still change when more of a program comes is left as it is.
  void look_ahead(ipo::BlockQueue& queue, double s, double t);
  /// Whether fill() has ended because the program's pipe has nothing more yet.
  bool waiting() const noexcept { return waiting_; }
  /// Whether the queue is to be filled further before anything is taken from it: where the rest of
  /// the way will be planned anew, as much of it is to be known as of a program in a file.
  bool is_behind() const noexcept { return waiting_ && patient_; }

  /// Plans the queue anew from the state `now` in its first block, at program time `t`; fill()
  /// gives it what follows. After a stop nothing more is read.
  void replan(ipo::BlockQueue& queue, const ipo::State& now, double t,
              const ipo::FeedControl& asked);

  /// Reads no further; the queue gets what has been read.
  void finish(ipo::BlockQueue& queue);

  /// Pauses on the way to the end of the queue; whoever waits at one takes it out.
  std::deque<Pause>& pauses() noexcept { return pauses_; }

  /// As far as has been read.
  StateHistory& states() noexcept { return states_; }

  /// Hands it every block before the planner gets it.
  void show(ProgrammedPath& programmed) noexcept { programmed_ = &programmed; }

  std::vector<std::string> called_files() const { return interpreter_.called_files(); }
  const std::set<std::string>& missing_files() const noexcept {
    return interpreter_.missing_files();
  }
  ipo::PlannerCounts counts() const noexcept { return planner_.counts(); }
  double cpu() const noexcept { return cpu_; }  // s

 private:
  bool read_block();
  void take(ipo::BlockQueue& queue, ipo::TimedPart part);
  void end_at_last_block();
  bool is_endless();
  void read_unplanned(std::optional<Block> block);
  void find_pauses(const ipo::TimedBlock& timed);
  std::optional<Block> wait_for_block();
  void read_on(std::optional<Block> block);

  int input_;  // where it reads
  const Machine& machine_;
  const ChannelOptions options_;
  Diagnostics& diagnostics_;
  UnplannedTravel unplanned_travel_;
  ipr::Parser parser_;
  ipr::Interpreter interpreter_;
  ipo::Planner planner_;
  ProgrammedPath* programmed_ = nullptr;
  std::deque<Pause> pauses_;
  std::optional<int> last_block_;  // the number of the last one in the queue
  StateHistory states_;
  bool ended_ = false, waiting_ = false;
  bool patient_;
  MotionLimit limit_;
  double planned_ = 0;               // s: the end of the queue
  std::int64_t read_again_ = 65536;  // bytes: where more have been, it is asked for an end
  double until_ = 0;                 // what fill() was asked for
  double cpu_ = 0;
};

/// A Source of setpoints for one thread: it plans whenever the queue runs low.
class Channel {
 public:
  Channel(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
          Diagnostics& diagnostics);

  /// Whether an event of the script is to be answered before the next step.
  bool event_due() const noexcept;
  /// Plans the rest of the way anew for what the events due ask for; right behind forget_passed().
  void answer_events() noexcept;

  /// The next setpoint; nothing at the end. When the panel asks for a stop the rest of the way is
  /// planned anew, to rest as soon as the limits allow; it must not ask between two calls of
  /// forget_passed().
  std::optional<Setpoint> step(const Panel& panel) noexcept;

  /// The pause that the next step passes, if there is one; resume() lets it pass.
  const Pause* pause_ahead() noexcept;
  void resume() noexcept { feeder_.pauses().pop_front(); }

  /// Whether there is no next setpoint until more of the program comes.
  bool waiting() const noexcept {
    return feeder_.is_behind() ||
           (feeder_.waiting() && queue_.t_end() <= interpolator_.needs_until());
  }

  /// Rows that follow the last one within a stretch where none can come near a limit, and how many
  /// of them there are to one that still draws the path.
  struct Quiet {
    std::int64_t rows = 0, to_next = 0;
  };
  Quiet quiet_ahead();
  /// The next step is `rows` later than it would be; they must be quiet.
  void pass_over(std::int64_t rows) noexcept { interpolator_.pass_over(rows); }

  /// Blocks from the one of the last forget_passed() to the present one.
  const ipo::BlockQueue& queue() const noexcept { return queue_; }
  void forget_passed();
  /// Fills the queue with the path up to `s` mm along the program, as far as that is known and the
  /// machine comes there within seconds.
  void see_path_to(double s) noexcept;

  /// Passes on what an exception has broken off.
  void rethrow() const;

  /// The instant of the plan that has been reached, s: at the end, its duration. Of methods that go
  /// their own way through the curves, the instant of the last row.
  double time() const noexcept;
  /// What it was spent on. Nothing may be run after that.
  const RunTimes& end_times();

  /// Events that the run has not reached.
  std::size_t events_left() const noexcept { return events_.size() - answered_; }

  Feeder& feeder() noexcept { return feeder_; }

 private:
  bool plan_ahead() noexcept;
  void replan() noexcept;
  void add_period(const Setpoint& next) noexcept;
  void add_present();

  const Machine& machine_;
  std::vector<FeedEvent> events_;
  std::size_t answered_ = 0;  // of the events
  ipo::FeedControl control_;
  Feeder feeder_;
  ipo::BlockQueue queue_;
  bool follows_plan_;  // the rows lie where the plan is at their instants
  ipo::Interpolator interpolator_;
  RunTimes times_;                    // of what has been forgotten
  Limit limit_before_ = Limit::stop;  // of the last row
  bool started_ = false, stopping_ = false;
  bool replanned_ = false;   // the interpolator does not know of it yet
  double quiet_start_ = -1;  // s: when that block begins
  ipo::QuietStretch quiet_;  // of the present block, from the instant on at which it was looked at
  std::exception_ptr broken_;
};

/// Takes the rows of a run, in order.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// False: no more rows are wanted.
  virtual bool row(const Setpoint& setpoint, std::span<const double> backend_values) = 0;
  /// The machine stands before the program waits for a person.
  virtual void rest() {}
  /// Hands on what there is: the next row may take long.
  virtual void flush() {}
};

/// Looks at a run from outside, every now and then.
class Watcher {
 public:
  virtual ~Watcher() = default;
  virtual bool wants_stop() = 0;
  virtual void sees(const Setpoint& latest) = 0;
  /// Before M00, M01, M06 or a single block is passed. Returns when the program may go on, or is to
  /// stop.
  virtual void pause(const Pause& pause) = 0;
  /// Returns when there is something to read, or the run is to stop.
  virtual void wait_for_input(int descriptor) = 0;
};

/// What a run leaves. CPU times are of this thread.
struct Outcome {
  enum class End : std::uint8_t { done, stopped, alarm, broken_off };
  struct Cpu {
    double planning = 0, cycle = 0, verification = 0, output = 0;  // s
  };

  End end = End::done;
  Setpoint last;
  Feedback feedback;
  std::int64_t setpoints = 0;
  double time = 0;  // s: Channel::time()
  std::array<double, kLimits> time_by_limit{};
  TimeSheet time_sheet;
  std::vector<WorstLine> worst_lines;  // as many as are asked for
  Measured measured;
  double corner_deviation = 0;          // mm: of rounded corners from the programmed path, largest;
  ProgrammedPath::Deviation deviation;  // and that which comes nearest to what is allowed
  std::optional<ContourReport> contour;  // where the backend knows where the axes are
  SurfaceNotes surface;
  std::size_t events_left = 0;  // of the script: their moments were never reached
  MachineState state;           // where the machine rests, if ChannelOptions::keeps_state
  ipo::PlannerCounts planner;
  std::vector<std::string> called_files;  // their names in the folder
  std::set<std::string> missing_files;    // names in the folder under which calls have found none
  Cpu cpu;
};

class PacedCycle;

/// A run as fast as the computer goes: the same rows every time. `rows` and `watcher` may be null.
/// `input` is where the reader reads. With `paced`, which writes the rows then, as fast as the
/// clock goes, and the same rows all the same.
Outcome simulate(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, hal::Backend& backend, Diagnostics& diagnostics,
                 RowSink* rows, Watcher* watcher, PacedCycle* paced = nullptr);

}  // namespace softcnc::app
