// SPDX-License-Identifier: MIT
#include "runtime/history/run_rows.hpp"

#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

MotionKind kind_of(const Move* move) noexcept {
  if (move == nullptr) return MotionKind::rest;
  return move->rapid ? MotionKind::rapid : MotionKind::cutting;
}

float um(double mm) noexcept { return static_cast<float>(um_from_mm(mm)); }

}  // namespace

void RunRows::add_change(const SourcePos& source, int number, MotionKind motion) {
  changes_.push_back({number, source.file, tool_, motion});
}

void RunRows::block(const ipo::TimedBlock& timed) {
  const auto* action = std::get_if<Action>(&timed.block.what);
  if (action != nullptr && action->kind == Action::Kind::tool)
    tool_ = static_cast<int>(action->value);
  const MotionKind motion = kind_of(timed.move());
  add_change(timed.block.source, timed.block.number, motion);
  for (const ipo::Mark& mark : timed.marks) add_change(mark.source, mark.number, motion);
}

void RunRows::observe(const ObservedRow& observed) {
  RunRow& row = observed_.emplace_back();
  if (observed.stretches.empty()) return;
  row.chord_error = um(observed.period.chord_error);
  row.deviation = um(observed.deviation);
  const PathStretch& here = stretch_at(observed.stretches, observed.row.s);
  if (here.surface == nullptr || !(observed.period.rmax > 0)) return;
  row.rmax = um(observed.period.rmax);
  row.rmax_target = um(here.surface->rmax);
}

void RunRows::change_until(int block) {
  while (!changes_.empty() && changes_.front().block <= block) {
    present_ = changes_.front();
    changes_.pop_front();
  }
}

bool RunRows::row(const Setpoint& setpoint, std::span<const double> backend_values) {
  change_until(setpoint.block);
  RunRow row = observed_.front();
  observed_.pop_front();
  row.period = setpoint.period;
  row.line = setpoint.line;
  row.block = setpoint.block;
  row.file = present_.file;
  row.tool = present_.tool;
  row.motion = setpoint.advance > 0 ? present_.motion : MotionKind::rest;
  row.limit = setpoint.limit;
  row.s = setpoint.s;
  row.v = setpoint.v;
  row.feed = setpoint.feed;
  row.position = setpoint.position;
  if (knows_contour_) row.contour = static_cast<float>(backend_values.back());
  sink_.take(row);
  return true;
}

}  // namespace softcnc::runtime
