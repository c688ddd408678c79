// SPDX-License-Identifier: MIT
// Every row of a run against the curves and limits it should keep.
#pragma once

#include <span>
#include <vector>

#include "ipo/queue/block_queue.hpp"
#include "motion/verification/programmed_path.hpp"
#include "motion/verification/verify.hpp"
#include "runtime/figures/surface_notes.hpp"
#include "runtime/sinks/row_observer.hpp"

namespace softcnc::runtime {

/// Hands rows to the verifier together with the paths between them.
class Verification {
 public:
  explicit Verification(const Machine& machine) : verifier_(machine), surface_(machine) {}

  /// Informs `observer` of each row and block from now on; null: nobody any longer.
  void inform(RowObserver* observer) noexcept { observer_ = observer; }

  /// Adds rows. Requires that `queue` still holds every block from that of the row before.
  void add(std::span<const Setpoint> rows, const ipo::BlockQueue& queue);
  /// A row of a stretch in which none can come near a limit, and those left out before it.
  void pass_over(const Setpoint& row) noexcept;
  void finish() noexcept;

  Measured measured() const noexcept { return verifier_.measured(); }
  /// Returns the path that sees every block as it is programmed.
  ProgrammedPath& programmed() noexcept { return programmed_; }
  const ProgrammedPath& programmed() const noexcept { return programmed_; }
  const SurfaceNotes& surface() const noexcept { return surface_; }

 private:
  void show(const ipo::TimedBlock& timed);

  Verifier verifier_;
  ProgrammedPath programmed_;
  SurfaceNotes surface_;
  RowObserver* observer_ = nullptr;
  int observed_ = 0;                            // number of the last block that it knows
  int block_before_ = 0;                        // number of the block of the row before
  std::vector<PathStretch> stretches_;          // of the blocks in the queue,
  std::vector<const ipo::TimedBlock*> blocks_;  // those blocks,
  struct Numbers {
    int first, last;
  };
  std::vector<Numbers> block_numbers_;  // and the numbers that each stands for
};

/// Reports where the rows have exceeded a limit of the machine: SC4002, or SC4003 for an
/// interpolation method that does not promise to keep it.
void report_excess(const Measured& measured, const ProgrammedPath::Deviation& worst,
                   const Machine& machine, Diagnostics& diagnostics);

/// Reports where what was sent has been faster than an axis: SC4002, or SC4003 likewise. `largest`
/// is hal::Backend::command_velocity_max().
void report_command_excess(const AxisVector& largest, const Machine& machine,
                           Diagnostics& diagnostics);

}  // namespace softcnc::runtime
