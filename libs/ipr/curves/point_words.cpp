// SPDX-License-Identifier: MIT
// Curves by points, one a line: G05.2, a NURBS by its control points up to G05.3, and G06.1, a
// cubic spline through points up to another motion code.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kDefaultPointsOrder = 3;
constexpr int kControlPoints = 52;  // the number of G05.2 in the table

PendingPoints& begin_points(Task& task) {
  begin_motion(task);
  PendingPoints& curve = task.modal.points.emplace();
  curve.code = &task.code;
  curve.parameter = task.machine.program.spline_parameter;
  curve.points.push_back(task.modal.position);
  curve.head = curve_head(task);
  return curve;
}

void forget_points(Modal& modal) {
  modal.points.reset();
  modal.motion = nullptr;
}

std::string name_of(const PendingPoints& curve) { return code_name(*curve.code); }

/// The curve as it was read, or why it is none.
Result<Nurbs> make_curve(PendingPoints& curve) {
  if (curve.code->number != kControlPoints)
    return cubic_spline(curve.points, curve.parameter).and_then(&Nurbs::make);
  NurbsSpec spec;
  spec.degree = curve.order - 1;
  spec.control = std::move(curve.points);
  spec.weights = std::move(curve.weights);
  const int inner = static_cast<int>(spec.control.size()) - curve.order;
  const auto order = static_cast<std::size_t>(curve.order);
  spec.knots.assign(order, 0);
  for (int i = 1; i <= inner; ++i) spec.knots.push_back(i);
  spec.knots.insert(spec.knots.end(), order, inner + 1);
  return Nurbs::make(std::move(spec));
}

void emit_points(Modal& modal, Output& out, PendingPoints& curve) {
  Result<Nurbs> made = make_curve(curve);
  if (!made)
    return out.report(made.error().code, curve.head.word, std::move(made.error().message),
                      curve.head.line);
  Path path = std::move(*made);
  const PlacedWord at{curve.head.word, curve.head.line, name_of(curve)};
  if (modal.placement && !place_path(modal, out, at, path)) return;
  if (has_surface_speed(modal, out, curve.head.word, curve.head.line))
    out.emit_before(cutting_move(modal, std::move(path), curve.head.feed), curve.head.source);
}

/// Its block stands before those of the line at which the curve has ended.
void finish_points(Modal& modal, Output& out) {
  PendingPoints& curve = *modal.points;
  emit_points(modal, out, curve);
  forget_points(modal);
}

// G05.2

int read_control_order(Task& task) {
  if (!task.values.has('L')) return kDefaultPointsOrder;
  const Word& word = task.values.word('L');
  const bool legal = word.value == std::floor(word.value) && word.value >= kDefaultPointsOrder &&
                     word.value <= Nurbs::kMaxDegree + 1;
  if (legal) return static_cast<int>(word.value);
  report_word(task, 'L', Code::SC3001,
              "L, the order of the curve, is a whole number from 3 to " +
                  std::to_string(Nurbs::kMaxDegree + 1));
  return 0;
}

double read_control_weight(Task& task) {
  const Word& word = task.values.word('P');
  if (word.value > 0) return word.value;
  report_word(task, 'P', Code::SC3007, "P, the weight of a control point, must be above 0");
  return 1;
}

/// The first block of G05.2: the order, and the weight of the start if no point stands there.
void begin_control_points(Task& task) {
  PendingPoints& curve = begin_points(task);
  curve.order = read_control_order(task);
  const bool of_start = task.values.has('P') && !task.values.letters().has_any(kAxisWords);
  curve.weights.push_back(of_start ? read_control_weight(task) : 1);
}

bool has_control_words(Task& task) {
  const PlaneAxes axes = plane_axes(task.modal.plane);
  for (const int axis : {axes.first, axes.second}) {
    const char letter = axis_letter(axis);
    if (task.values.has(letter)) continue;
    task.out.report(Code::SC2005, task.word.pos,
                    std::string("a control point of G05.2 needs ") + letter);
    return false;
  }
  if (task.values.has('P')) return true;
  task.out.report(Code::SC2005, task.word.pos, "a control point of G05.2 needs P, its weight");
  return false;
}

/// In G91 a distance from the start of the curve, as in LinuxCNC, whose position stays there.
void add_control_point(Task& task, PendingPoints& curve) {
  const bool given = has_control_words(task);
  if (task.modal.incremental) task.modal.position = curve.points.front();
  task.modal.position = end_point(task);
  const double weight = given ? read_control_weight(task) : 1;
  if (curve.points.size() == kMostCurvePoints) return report_too_many(task);
  curve.points.push_back(task.modal.position);
  curve.weights.push_back(weight);
}

// G06.1

/// A first point in the position is the position: the curve begins there anyway.
bool is_start(const Task& task, const PendingPoints& curve, const AxisVector& point) {
  return curve.blocks == 0 &&
         (point - curve.points.front()).norm() <= start_tolerance(task.machine);
}

void add_spline_point(Task& task, PendingPoints& curve) {
  const AxisVector point = end_point(task);
  const bool start = is_start(task, curve, point);
  ++curve.blocks;
  if (start) return;
  const bool same = (point - curve.points.back()).norm() < kSplineSamePoint;
  task.modal.position = point;
  if (same)
    task.out.report(Code::SC2351, span_of(task.values, "XYZ"),
                    "the spline repeats its previous point");
  if (curve.points.size() < kMaxSplinePoints) return curve.points.push_back(point);
  task.out.report(Code::SC3120, span_of(task.values, "XYZ"),
                  "a spline goes through " + std::to_string(kMaxSplinePoints) +
                      " points at most, its start among them");
}

/// A code that the pending curve can take in its lines.
bool belongs(const GCode& code, const PendingPoints& curve) {
  return code.group == Group::line_number || &code == curve.code ||
         (curve.code->number == kControlPoints && code.act == end_control_points);
}

void report_stranger(const PendingPoints& curve, const GCode& code, const Word& word, Output& out) {
  if (code.group == Group::feed)
    return out.report(Code::SC3110, word.pos, "F belongs to the first block of the curve");
  out.report(Code::SC3105, word.pos, code_name(code) + " within a curve of " + name_of(curve));
}

}  // namespace

void control_points(Task& task) {
  const bool begins = !task.modal.points;
  if (begins) begin_control_points(task);
  PendingPoints& curve = *task.modal.points;
  if (!begins && task.values.has('L'))
    report_word(task, 'L', Code::SC3110, "L belongs to the first block of the curve");
  if (!begins || task.values.letters().has_any(kAxisWords)) add_control_point(task, curve);
}

void end_control_points(Task& task) {
  if (task.modal.points) return finish_points(task.modal, task.out);
  task.out.report(Code::SC3121, task.word.pos, "G05.3 ends no curve: G05.2 does not stand before");
  task.modal.motion = nullptr;
}

void spline(Task& task) {
  if (!task.modal.points) begin_points(task);
  if (task.values.letters().has_any(kAxisWords)) add_spline_point(task, *task.modal.points);
}

void check_pending_points(const Command& command, Modal& modal, Output& out) {
  PendingPoints& curve = *modal.points;
  const bool by_control = curve.code->number == kControlPoints;
  const bool closed = std::any_of(
      command.codes().begin(), command.codes().end(),
      [](const Command::CodeWord& code) { return code.code->act == end_control_points; });
  const bool ends = ends_curve(command, *curve.code) && !(by_control && closed);
  if (ends && !by_control) return finish_points(modal, out);
  for (const auto& [code, word] : command.codes()) {
    if (belongs(*code, curve)) continue;
    report_stranger(curve, *code, *word, out);
  }
}

void end_pending_spline(Modal& modal, Output& out) {
  if (modal.points->code->number != kControlPoints) finish_points(modal, out);
}

void end_pending_points(Modal& modal, Output& out) {
  PendingPoints& curve = *modal.points;
  if (curve.code->number != kControlPoints) return finish_points(modal, out);
  out.report(Code::SC3122, curve.head.word, "the program ends, and the curve has no G05.3",
             curve.head.line);
  forget_points(modal);
}

}  // namespace softcnc::ipr
