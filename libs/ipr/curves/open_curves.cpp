// SPDX-License-Identifier: MIT
// Curves over several lines that an error has spoiled: they give no block, but where they lead is
// looked at as far as it is certain.
#include "ipr/codes/handlers.hpp"

namespace softcnc::ipr {
namespace {

/// These say nothing of where a line leads.
constexpr Letters kBesideTheWay{"FMNST"};
constexpr Groups kCodesBesideTheWay{Group::feed,    Group::speed,   Group::tool,
                                    Group::spindle, Group::coolant, Group::override_,
                                    Group::signal,  Group::surface, Group::line_number};

/// As it would have been, if it were a block.
void show_path(const Modal& modal, const Output& out, const OpenCurve& curve, Path&& path) {
  Move move = cutting_move(modal, std::move(path), curve.head.feed);
  move.unknown_axes = axis_bits(curve.lost_axes);
  out.show(move, curve.head.source);
}

}  // namespace

void note_faults(const Command& command, const Modal& modal, const Output& out, OpenCurve& curve) {
  curve.lost_axes |= modal.unknown_axes();
  if (!out.failed()) return;
  curve.broken = true;
  Letters lost = command.uncertain();
  lost |= command.missing();
  lost = lost.without(kBesideTheWay);
  curve.lost_axes |= lost;
  if (!lost.without(kAxisWords).empty() || !command.doubted().empty()) curve.misshapen = true;
}

void note_stranger(const GCode& code, OpenCurve& curve) {
  if (!kCodesBesideTheWay.has(code.group)) curve.lost_axes |= kAxisWords;
}

void show_broken(const Modal& modal, const Output& out, const OpenCurve& curve, Result<Nurbs> made,
                 std::span<const AxisVector> certain) {
  if (made && !curve.misshapen) return show_path(modal, out, curve, std::move(*made));
  for (std::size_t i = 1; i < certain.size(); ++i)
    if ((certain[i] - certain[i - 1]).norm() >= kSplineSamePoint)
      show_path(modal, out, curve, softcnc::Line(certain[i - 1], certain[i]));
}

}  // namespace softcnc::ipr
