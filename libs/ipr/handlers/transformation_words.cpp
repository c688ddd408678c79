// SPDX-License-Identifier: MIT
// G50, G51, G50.1, G51.1, G68, G69: what is put in force, and what may not be done meanwhile.
#include <cmath>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/state/nearness.hpp"
#include "ipr/state/transformed_path.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kLeastFactor = 1e-5, kMostFactor = 1e4;
constexpr std::string_view kFactorLetters = "IJK";

/// The present position as these stages show it, mm: a centre that is not written.
AxisVector position_under(const Modal& modal, const Transformation& stages) {
  const AxisVector place = modal.coordinates.to_program(modal.machine_position());
  return stages.map().inverse()(place);
}

/// The places named, and the present position; always absolute.
AxisVector centre_under(const Task& task, const Transformation& stages) {
  AxisVector centre = position_under(task.modal, stages);
  for_named_axes(task, [&](int axis, double place) { centre[axis] = place; });
  return centre;
}

std::string in_force(const Transformation& transformation) {
  if (transformation.rotation) return "G68";
  return transformation.scaling ? "G51" : "G51.1";
}

bool refuse_order(Task& task) {
  task.out.report(
      Code::SC2254, task.word.pos,
      code_name(task.code) + " while " + in_force(task.modal.transformation) + " is in force");
  return false;
}

bool has_no_word_across(Task& task) {
  const char across = axis_letter(plane_axes(task.modal.plane).across);
  if (!task.values.has(across)) return true;
  report_word(task, across, Code::SC2004,
              std::string(1, across) + " is not used by G68 in this plane");
  return false;
}

bool turns_in_plane(Task& task) {
  if (task.values.letters().has_any(kFactorLetters)) {
    task.out.report(Code::SC2250, span_of(task.values, kFactorLetters),
                    "G68 with I, J or K turns in space, which is not supported");
    return false;
  }
  if (!has_no_word_across(task)) return false;
  if (task.values.has('R')) return true;
  task.out.report(Code::SC2005, task.word.pos, "G68 needs R, the angle");
  return false;
}

/// Whether the factor is written without a decimal point. What is computed has none.
bool is_whole(const Task& task, const Word& word) {
  const auto column = static_cast<std::size_t>(word.pos.column);
  const std::string_view value = task.out.text().substr(column);
  const std::size_t first = value.find_first_not_of(" \t+-");
  const bool computed =
      first != std::string_view::npos && (value[first] == '#' || value[first] == '[');
  return computed || !has_point(task, word);
}

/// Without a decimal point thousandths, as on FANUC's controls.
std::optional<double> read_factor(Task& task, char letter) {
  constexpr double kThousandth = 1e-3, kLikely = 10;
  const Word& word = task.values.word(letter);
  const bool whole = is_whole(task, word);
  const double factor = whole ? word.value * kThousandth : word.value;
  if (!(std::abs(factor) >= kLeastFactor && std::abs(factor) <= kMostFactor)) {
    report_word(task, letter, Code::SC2252,
                std::string(1, letter) + " is no factor from 0.00001 to 10000");
    return std::nullopt;
  }
  if (whole && std::abs(word.value) < kLikely)
    report_word(task, letter, Code::SC2253,
                std::string(1, letter) + number_text(word.value) +
                    " without a decimal point is a factor of " + number_text(factor));
  return factor;
}

bool has_factors(Task& task) {
  const bool each = task.values.letters().has_any(kFactorLetters);
  if (each != task.values.has('P')) return true;
  if (each)
    report_word(task, 'P', Code::SC2004, "P is not used beside I, J or K");
  else
    task.out.report(Code::SC2005, task.word.pos, "G51 needs P, or I, J and K: the factors");
  return false;
}

/// P for all axes, or I J K; an axis without its letter keeps its lengths.
std::optional<AxisVector> read_factors(Task& task) {
  if (!has_factors(task)) return std::nullopt;
  AxisVector factors = AxisVector::Ones();
  for (int axis = 0; axis < kAxes; ++axis) {
    const char letter = task.values.has('P') ? 'P' : offset_letter(axis);
    if (!task.values.has(letter)) continue;
    const auto factor = read_factor(task, letter);
    if (!factor) return std::nullopt;
    factors[axis] = *factor;
    if (letter != 'P') continue;
    factors.setConstant(*factor);
    break;
  }
  return factors;
}

bool selects_other_system(const Task& task) {
  const int number = task.code.number;
  const bool further_by_p = number == kG54 && is_fanuc(task) && task.values.has('P');
  const bool is_basic = number == kG54 || (number > kG54 && number <= kG593 && number != kG541);
  if (!is_basic || further_by_p) return true;
  return system_index(number) != task.modal.state.active;
}

bool selects_other_plane(const Task& task) {
  return task.modal.transformation.rotation && selected_plane(task.code) != task.modal.plane;
}

/// G10 of the work system in force, and those that go by the position.
bool moves_coordinates(const Task& task) {
  const double table = task.values.value_or('L', 0), which = task.values.value_or('P', 0);
  if (table == 2) return which == 0 || which == task.modal.state.active + 1;
  const bool by_position = table == 10 || table == 11 || table == 20;
  return by_position && task.values.letters().has_any(kAxisWords);
}

/// What FANUC's manual forbids meanwhile.
bool is_refused_while_transformed(const Task& task) {
  const int number = task.code.number;
  if (task.code.letter != 'G') return false;
  if (number >= kG17 && number <= kG19) return selects_other_plane(task);
  if (task.code.group == Group::work_offset) return selects_other_system(task);
  if (number == kG10) return moves_coordinates(task);
  if (number == kG53) return !is_haas(task);
  return is_probing_move(task.code) || number == kG28 || number == kG30 || number == kG52 ||
         (number >= kG92 && number <= kG923);
}

/// Reports why a path cannot be followed where it lies.
bool refuse_path(Output& out, const PlacedWord& at, Code code, std::string message) {
  if (at.line.empty())
    out.report(code, at.pos, std::move(message));
  else
    out.report(code, at.pos, std::move(message), at.line);
  return false;
}

/// A line may shrink to nothing.
bool has_no_length(const Path& path, const AffineMap& map) {
  const auto* line = std::get_if<softcnc::Line>(&path);
  return line != nullptr &&
         (map.linear * (line->to() - line->from())).lpNorm<Eigen::Infinity>() < kShortestMove;
}

}  // namespace

/// G68.
void rotate(Task& task) {
  if (!turns_in_plane(task)) return;
  Transformation wanted = task.modal.transformation;
  const double before = wanted.rotation ? wanted.rotation->degrees : 0;
  wanted.rotation.reset();
  const double given = task.values['R'];
  wanted.rotation =
      PlaneRotation{centre_under(task, wanted), task.modal.incremental ? before + given : given,
                    task.modal.plane};
  task.modal.transform(wanted);
}

/// G69.
void end_rotation(Task& task) {
  Transformation wanted = task.modal.transformation;
  wanted.rotation.reset();
  task.modal.transform(wanted);
}

/// G51.
void scale(Task& task) {
  Transformation wanted = task.modal.transformation;
  if (wanted.rotation && !refuse_order(task)) return;
  const auto factors = read_factors(task);
  if (!factors) return;
  wanted.scaling.reset();
  wanted.scaling = AxisScaling{centre_under(task, wanted), *factors};
  task.modal.transform(wanted);
}

/// G50.
void end_scaling(Task& task) {
  Transformation wanted = task.modal.transformation;
  wanted.scaling.reset();
  task.modal.transform(wanted);
}

/// G51.1.
void mirror(Task& task) {
  Transformation wanted = task.modal.transformation;
  if ((wanted.rotation || wanted.scaling) && !refuse_order(task)) return;
  if (!task.values.letters().has_any(kAxisWords))
    return task.out.report(Code::SC2005, task.word.pos, "G51.1 needs X, Y or Z: the mirror");
  for_named_axes(
      task, [&](int axis, double place) { wanted.mirror[static_cast<std::size_t>(axis)] = place; });
  task.modal.transform(wanted);
}

/// G50.1: of the axes named, whatever their values; of all of them if none is.
void end_mirror(Task& task) {
  Transformation wanted = task.modal.transformation;
  if (wanted.mirrors() && (wanted.rotation || wanted.scaling) && !refuse_order(task)) return;
  const bool named = task.values.letters().has_any(kAxisWords);
  for (int axis = 0; axis < kAxes; ++axis)
    if (!named || task.values.has(axis_letter(axis)))
      wanted.mirror[static_cast<std::size_t>(axis)].reset();
  task.modal.transform(wanted);
}

bool may_be_transformed(Task& task) {
  if (!is_refused_while_transformed(task)) return true;
  if (task.code.number == kG53) task.modal.machine_coordinates = true;
  task.out.report(
      Code::SC2251, task.word.pos,
      code_name(task.code) + " while " + in_force(task.modal.transformation) + " is in force");
  return false;
}

CutterSide placed_cutter(const Modal& modal) {
  CutterSide cutter = *modal.cutter;
  if (modal.placement && mirrors_plane(modal.placement->map, plane_axes(cutter.plane)))
    cutter.side = -cutter.side;
  return cutter;
}

bool place_path(Modal& modal, Output& out, const PlacedWord& at, Path& path) {
  Placement& placement = *modal.placement;
  if (has_no_length(path, placement.map)) return false;
  Result<Path> placed = transformed(path, placement.map, placement.reached);
  if (!placed)
    return refuse_path(out, at, placed.error().code,
                       at.code + " under G51: " + placed.error().message);
  const bool off_circle =
      std::holds_alternative<Arc>(path) && !std::holds_alternative<Arc>(*placed);
  if (off_circle && out.compensating() && modal.cutter->radius > 0)
    return refuse_path(out, at, Code::SC2256,
                       at.code +
                           " is no arc under these scales, and cutter compensation follows "
                           "lines and arcs only");
  path = std::move(*placed);
  placement.reached = end(path);
  if (is_near(placement.reached)) return true;
  return refuse_path(out, at, Code::SC3008, leads_far(at.code));
}

}  // namespace softcnc::ipr
