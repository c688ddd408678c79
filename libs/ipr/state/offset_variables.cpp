// SPDX-License-Identifier: MIT
// RS274: ranges of one number per axis (X Y Z, then six axes that softcnc lacks, then a rotation).
#include "ipr/state/offset_variables.hpp"

#include <span>

namespace softcnc::ipr {
namespace {

constexpr int kHome = 5161, kSecondHome = 5181, kShift = 5211;
constexpr int kWork = 5221, kWorkStep = 20, kRotation = 9;

double& length(ToolOffset& tool) { return tool.length[2]; }
double& length_wear(ToolOffset& tool) { return tool.length_wear; }
double& radius(ToolOffset& tool) { return tool.radius; }
double& radius_wear(ToolOffset& tool) { return tool.radius_wear; }

/// Of tools 1 to `count`.
struct ToolRange {
  int first, count;
  double& (*of)(ToolOffset&);
  bool of_cutter = false;
};

/// FANUC's memory C.
constexpr ToolRange kToolRanges[] = {
    {2001, 200, length_wear}, {2201, 200, length},       {10001, 999, length_wear},
    {11001, 999, length},     {12001, 999, radius_wear}, {13001, 999, radius},
};
/// Haas' mill operator's manual, table of macro variables.
constexpr ToolRange kHaasToolRanges[] = {
    {2001, 200, length},
    {2201, 200, length_wear},
    {2401, 200, radius, true},
    {2601, 200, radius_wear, true},
};
// What outlives a program: of both, of Haas alone.
constexpr int kKept = 500, kKeptEnd = 1000;
constexpr int kCommonVariable = 100, kCommonEnd = 200, kGeneral = 10000, kGeneralEnd = 11000;

}  // namespace

std::optional<OffsetVariable> offset_variable(int number, MachineState& state, Dialect dialect) {
  if (const int axis = axis_in(number, kHome); axis >= 0) return OffsetVariable{&state.home[axis]};
  if (const int axis = axis_in(number, kSecondHome); axis >= 0)
    return OffsetVariable{&state.second_home[axis]};
  if (const int axis = axis_in(number, kShift); axis >= 0)
    return OffsetVariable{&state.shift[axis]};
  if (number < kWork || number >= kWork + kWorkSystems * kWorkStep) return std::nullopt;
  WorkOffset& work = state.work[static_cast<std::size_t>((number - kWork) / kWorkStep)];
  const int which = (number - kWork) % kWorkStep;
  if (which < kAxes) return OffsetVariable{&work.origin[which]};
  if (which != kRotation || is_fanuc_like(dialect)) return std::nullopt;
  return OffsetVariable{&work.rotation, kRadPerDegree, kMostTurned};
}

std::optional<FurtherSystemVariable> further_system_variable(int number) {
  constexpr int kFew = 7001, kMany = 14001, kCountOfFew = 48;
  const int first = number >= kMany ? kMany : kFew;
  const int count = number >= kMany ? kFurtherSystems : kCountOfFew;
  const int at = number - first;
  if (at < 0 || at >= count * kWorkStep || at % kWorkStep >= kAxes) return std::nullopt;
  return FurtherSystemVariable{kWorkSystems + at / kWorkStep, at % kWorkStep};
}

std::optional<ToolVariable> tool_variable(int number, Dialect dialect, CutterOffset offsets) {
  constexpr double kHalf = 0.5;
  const bool haas = dialect == Dialect::haas;
  const auto ranges = haas ? std::span<const ToolRange>(kHaasToolRanges) : kToolRanges;
  for (const ToolRange& range : ranges) {
    if (number < range.first || number >= range.first + range.count) continue;
    const bool halved = range.of_cutter && offsets != CutterOffset::radius;
    return ToolVariable{number - range.first + 1, range.of, halved ? kHalf : 1};
  }
  return std::nullopt;
}

bool is_kept_variable(int number, Dialect dialect) noexcept {
  if (number >= kKept && number < kKeptEnd) return is_fanuc_like(dialect);
  return dialect == Dialect::haas && ((number >= kCommonVariable && number < kCommonEnd) ||
                                      (number >= kGeneral && number < kGeneralEnd));
}

}  // namespace softcnc::ipr
