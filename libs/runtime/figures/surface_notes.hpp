// SPDX-License-Identifier: MIT
// What surface the blocks of a program leave, for a person: Rmax by block, and where edges leave
// more than is asked for.
#pragma once

#include <optional>
#include <vector>

#include "ipo/queue/block_queue.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"
#include "runtime/figures/pass_neighbours.hpp"

namespace softcnc::runtime {

class SurfaceNotes {
 public:
  explicit SurfaceNotes(const Machine& machine = {})
      : surfacing_(machine.surfacing), neighbours_(machine.control.period) {}

  /// A row of a block that asks for a roughness, and the Rmax, mm, that it leaves by the model of
  /// the machine.
  void add(const ipo::TimedBlock& timed, const Setpoint& row, double rmax);

  /// Reports SC4010 for each block; of many, for the first ones and the roughest.
  void report_blocks(Diagnostics& diagnostics) const;
  /// Reports SC4011 for the block that by simulated edges may exceed its target most; SC4012 where
  /// passes side by side are not in phase, and SC4042 where the surface slopes from one to the
  /// next, if the feed knows of neither.
  void warn(Diagnostics& diagnostics) const;

 private:
  struct Note {
    SourcePos source;
    int block = 0;
    double rmax = 0, target = 0;  // mm

    double part() const noexcept { return rmax / target; }
  };
  static constexpr std::size_t kReported = 100;  // blocks

  void judge(const ipo::TimedBlock& timed, const Setpoint& row, const SourcePos& source,
             double rmax);
  void look_beside(const ipo::TimedBlock& timed, const Setpoint& row);
  void judge_slope(const Move& move, const Setpoint& row, double s, const NeighbourPass& beside);
  void warn_of_phase(Diagnostics& diagnostics) const;
  void warn_of_slope(Diagnostics& diagnostics) const;
  void begin(const ipo::TimedBlock& timed, const Setpoint& row, double target);
  static void report(const Note& note, Diagnostics& diagnostics);

  Surfacing surfacing_;
  std::vector<Note> notes_;   // of the first blocks
  std::optional<Note> last_;  // of the present block, if it is not among them
  Note roughest_;             // of those that are not
  std::size_t blocks_ = 0;
  Note worst_;             // by simulated edges
  std::size_t above_ = 0;  // blocks that exceed their target by them
  int above_block_ = 0;
  PassNeighbours neighbours_;
  std::optional<SourcePos> beside_;     // first pass beside another one,
  std::optional<SourcePos> opposite_;   // the other way,
  std::optional<SourcePos> lagging_;    // or out of phase with it
  Note steepest_;                       // where a slope that is not stated leaves most
  double slope_ = 0, slope_there_ = 0;  // rad: the largest that is not stated; that there
};

}  // namespace softcnc::runtime
