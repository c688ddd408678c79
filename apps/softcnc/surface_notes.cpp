// SPDX-License-Identifier: MIT
#include "surface_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "motion/roughness.hpp"
#include "motion/units.hpp"

namespace softcnc::app {
namespace {

/// What the table of simulated edges may be too high by, and what nobody can measure.
constexpr double kTolerance = 0.03;

double edge_rmax(const Move& move, double s, double v) noexcept {
  const PathPoint point = at(move.path, std::clamp(s, 0.0, length(move.path)));
  return rmax(RoughnessModel::guaranteed, *move.surface, v / move.surface->tooth_rate(), point);
}

std::string of_target(double rmax, double target) {
  return fmt::format("{:.2f} um, where {:.4g} um are asked for", um_from_mm(rmax),
                     um_from_mm(target));
}

}  // namespace

void SurfaceNotes::add(const ipo::TimedBlock& timed, const Setpoint& row, double rmax) {
  const Move& move = *timed.move();
  const double target = move.surface->rmax;
  const Note* present = last_ ? &*last_ : notes_.empty() ? nullptr : &notes_.back();
  if (present == nullptr || present->block != row.block) begin(timed, row, target);
  Note& note = last_ ? *last_ : notes_.back();
  note.rmax = std::max(note.rmax, rmax);
  if (!first_) first_ = note.source;
  if (directions_.turns_back(row, move.surface->pick_feed) && !turned_back_)
    turned_back_ = note.source;
  if (last_ && (roughest_.block == 0 || note.part() > roughest_.part())) roughest_ = note;

  const double left =
      model_ == RoughnessModel::guaranteed ? rmax : edge_rmax(move, row.s - timed.s_start, row.v);
  if (left <= target * (1 + kTolerance)) return;
  if (above_block_ != row.block) ++above_;
  above_block_ = row.block;
  if (worst_.block == 0 || left / target > worst_.part())
    worst_ = {note.source, row.block, left, target};
}

void SurfaceNotes::begin(const ipo::TimedBlock& timed, const Setpoint& row, double target) {
  const Note note{timed.at(row.s - timed.s_start).source, row.block, 0, target};
  if (++blocks_ <= kTold)
    notes_.push_back(note);
  else
    last_ = note;
}

void SurfaceNotes::tell(const Note& note, Diagnostics& diagnostics) {
  diagnostics.report(Code::SC4010, note.source, "an Rmax of " + of_target(note.rmax, note.target));
}

void SurfaceNotes::tell_blocks(Diagnostics& diagnostics) const {
  for (const Note& note : notes_) tell(note, diagnostics);
  if (blocks_ <= kTold) return;
  diagnostics.report(Code::SC4010, roughest_.source,
                     fmt::format("and {} blocks more, with at most an Rmax of {}", blocks_ - kTold,
                                 of_target(roughest_.rmax, roughest_.target)));
}

void SurfaceNotes::warn(SpindlePhase phase, Diagnostics& diagnostics) const {
  warn_of_phase(phase, diagnostics);
  if (above_ == 0) return;
  diagnostics.report(
      Code::SC4011, worst_.source,
      fmt::format("edges leave an Rmax of {}{}", of_target(worst_.rmax, worst_.target),
                  above_ == 1 ? "" : fmt::format("; so do others of {} blocks", above_)));
}

void SurfaceNotes::warn_of_phase(SpindlePhase phase, Diagnostics& diagnostics) const {
  constexpr const char* kMore = "edges may leave half as much again as is asked for";
  if (phase == SpindlePhase::time && first_)
    diagnostics.report(Code::SC4012, *first_,
                       fmt::format("the spindle begins passes at any phase: {}", kMore));
  else if (turned_back_)
    diagnostics.report(Code::SC4012, *turned_back_,
                       fmt::format("passes run to and fro, out of phase: {}", kMore));
}

}  // namespace softcnc::app
