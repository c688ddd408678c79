// SPDX-License-Identifier: MIT
#include "runtime/figures/surface_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"
#include "motion/roughness/roughness.hpp"

namespace softcnc::runtime {
namespace {

/// What the table of simulated edges may be too high by, and what nobody can measure.
constexpr double kTolerance = 0.03;
/// Of a tooth: what passes in phase may differ by.
constexpr double kInPhase = 0.1;
/// Of the tangent along the tool axis: a path that is no steeper leaves a surface beside it.
constexpr double kPlunge = 0.9999;
/// rad, 0.3 degrees: what a slope may exceed the stated one by; it leaves some 3 % more.
constexpr double kLevelSlope = 0.0052;

bool is_plunge(const Path& path) noexcept {
  return std::holds_alternative<Line>(path) && inclination_sine(at(path, 0).dq) > kPlunge;
}

PathPoint point_at(const Move& move, double s) noexcept {
  return at(move.path, std::clamp(s, 0.0, length(move.path)));
}

double edge_rmax(const Move& move, const Surface& surface, double s, double v) noexcept {
  return rmax(RoughnessModel::guaranteed, surface, v / surface.tooth_rate(), point_at(move, s));
}

std::string of_target(double rmax, double target) {
  return fmt::format("{:.2f} um (target {:.4g} um)", um_from_mm(rmax), um_from_mm(target));
}

}  // namespace

void SurfaceNotes::add(const ipo::TimedBlock& timed, const Setpoint& row, double rmax) {
  const Move& move = *timed.move();
  if (is_plunge(move.path)) return;
  const double target = move.surface->rmax;
  const Note* present = last_ ? &*last_ : notes_.empty() ? nullptr : &notes_.back();
  if (present == nullptr || present->block != row.block) begin(timed, row, target);
  Note& note = last_ ? *last_ : notes_.back();
  note.rmax = std::max(note.rmax, rmax);
  look_beside(timed, row);
  if (last_ && (roughest_.block == 0 || note.part() > roughest_.part())) roughest_ = note;
  judge(timed, row, note.source, rmax);
}

/// By simulated edges.
void SurfaceNotes::judge(const ipo::TimedBlock& timed, const Setpoint& row, const SourcePos& source,
                         double rmax) {
  const Move& move = *timed.move();
  const double target = move.surface->rmax;
  const double left = surfacing_.model == RoughnessModel::guaranteed
                          ? rmax
                          : edge_rmax(move, *move.surface, row.s - timed.s_start, row.v);
  if (left <= target * (1 + kTolerance)) return;
  if (above_block_ != row.block) ++above_;
  above_block_ = row.block;
  if (worst_.block == 0 || left / target > worst_.part())
    worst_ = {source, row.block, left, target};
}

/// A slope that is stated stands for passes at any phase, too: there the feed is that of both.
void SurfaceNotes::look_beside(const ipo::TimedBlock& timed, const Setpoint& row) {
  const Move& move = *timed.move();
  const ipo::Mark mark = timed.at(row.s - timed.s_start);
  const auto beside = neighbours_.add(row, move.path, mark.s, *move.surface);
  const bool guaranteed = surfacing_.model == RoughnessModel::guaranteed;
  if (!beside) return;
  if (!guaranteed || move.surface->slope_across == 0) {
    if (!beside_) beside_ = mark.source;
    if (beside->opposite && !opposite_) opposite_ = mark.source;
    if (beside->lag > kInPhase && !lagging_) lagging_ = mark.source;
  }
  if (guaranteed && beside->slope > move.surface->slope_across + kLevelSlope)
    judge_slope(move, row, row.s - timed.s_start, *beside);
}

void SurfaceNotes::judge_slope(const Move& move, const Setpoint& row, double s,
                               const NeighbourPass& beside) {
  slope_ = std::max(slope_, beside.slope);
  Surface sloped = *move.surface;
  sloped.slope_across = beside.slope;
  const double left = edge_rmax(move, sloped, s, row.v), target = sloped.rmax;
  if (left <= target * (1 + kTolerance)) return;
  if (steepest_.block != 0 && left / target <= steepest_.part()) return;
  slope_there_ = beside.slope;
  steepest_ = {last_ ? last_->source : notes_.back().source, row.block, left, target};
}

void SurfaceNotes::begin(const ipo::TimedBlock& timed, const Setpoint& row, double target) {
  const Note note{timed.at(row.s - timed.s_start).source, row.block, 0, target};
  if (++blocks_ <= kReported)
    notes_.push_back(note);
  else
    last_ = note;
}

void SurfaceNotes::report(const Note& note, Diagnostics& diagnostics) {
  diagnostics.report(Code::SC4010, note.source, "an Rmax of " + of_target(note.rmax, note.target));
}

void SurfaceNotes::report_blocks(Diagnostics& diagnostics) const {
  for (const Note& note : notes_) report(note, diagnostics);
  if (blocks_ <= kReported) return;
  diagnostics.report(Code::SC4010, roughest_.source,
                     fmt::format("and {} blocks more, with at most an Rmax of {}",
                                 blocks_ - kReported, of_target(roughest_.rmax, roughest_.target)));
}

void SurfaceNotes::warn(Diagnostics& diagnostics) const {
  warn_of_phase(diagnostics);
  warn_of_slope(diagnostics);
  if (above_ == 0) return;
  diagnostics.report(
      Code::SC4011, worst_.source,
      fmt::format("cutting edges may leave an Rmax of up to {}{}",
                  of_target(worst_.rmax, worst_.target),
                  above_ == 1 ? "" : fmt::format("; other blocks of {} exceed theirs", above_)));
}

void SurfaceNotes::warn_of_phase(Diagnostics& diagnostics) const {
  const std::string more =
      std::string("cutting edges may leave half as much again as the target") +
      (surfacing_.model == RoughnessModel::guaranteed ? "; Q in G06.4 allows for that" : "");
  const auto report = [&](const std::optional<SourcePos>& where, const char* what) {
    diagnostics.report(Code::SC4012, *where, fmt::format("{}: {}", what, more));
  };
  if (surfacing_.phase == SpindlePhase::time && beside_)
    report(beside_, "the spindle begins passes at any phase");
  else if (opposite_)
    report(opposite_, "passes run back and forth, out of phase");
  else if (lagging_)
    report(lagging_, "this pass is out of phase with the one beside it");
}

void SurfaceNotes::warn_of_slope(Diagnostics& diagnostics) const {
  if (steepest_.block == 0) return;
  diagnostics.report(
      Code::SC4042, steepest_.source,
      fmt::format(
          "the surface slopes by {:.1f} degrees across the feed, which is not stated: "
          "cutting edges may leave an Rmax of up to {}; Q{:.0f} in G06.4 covers all of its slopes",
          deg_from_rad(slope_there_), of_target(steepest_.rmax, steepest_.target),
          std::ceil(deg_from_rad(slope_) - 0.1)));
}

}  // namespace softcnc::runtime
