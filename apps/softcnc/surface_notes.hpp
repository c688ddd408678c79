// SPDX-License-Identifier: MIT
// What surface the blocks of a program leave, for a person: Rmax by block, and where edges leave
// more than is asked for.
#pragma once

#include <optional>
#include <vector>

#include "ipo/block_queue.hpp"
#include "motion/diagnostic.hpp"
#include "motion/machine.hpp"
#include "motion/setpoint.hpp"
#include "pass_directions.hpp"

namespace softcnc::app {

class SurfaceNotes {
 public:
  explicit SurfaceNotes(RoughnessModel model = RoughnessModel::guaranteed) : model_(model) {}

  /// A row of a block that asks for a roughness, and the Rmax, mm, that it leaves by the model of
  /// the machine.
  void add(const ipo::TimedBlock& timed, const Setpoint& row, double rmax);

  /// SC4010 for each block, of many for the first ones and the roughest.
  void tell_blocks(Diagnostics& diagnostics) const;
  /// SC4011 for the block that by simulated edges exceeds its target most; SC4012 where passes are
  /// not in phase, which no model knows.
  void warn(SpindlePhase phase, Diagnostics& diagnostics) const;

 private:
  struct Note {
    SourcePos source;
    int block = 0;
    double rmax = 0, target = 0;  // mm

    double part() const noexcept { return rmax / target; }
  };
  static constexpr std::size_t kTold = 100;  // blocks

  void warn_of_phase(SpindlePhase phase, Diagnostics& diagnostics) const;
  void begin(const ipo::TimedBlock& timed, const Setpoint& row, double target);
  static void tell(const Note& note, Diagnostics& diagnostics);

  RoughnessModel model_;
  std::vector<Note> notes_;   // of the first blocks
  std::optional<Note> last_;  // of the present block, if it is not among them
  Note roughest_;             // of those that are not
  std::size_t blocks_ = 0;
  Note worst_;             // by simulated edges
  std::size_t above_ = 0;  // blocks that exceed their target by them
  int above_block_ = 0;
  PassDirections directions_;
  std::optional<SourcePos> first_;        // block that asks for a roughness
  std::optional<SourcePos> turned_back_;  // first pass beside another one, the other way
};

}  // namespace softcnc::app
