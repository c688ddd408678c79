// SPDX-License-Identifier: MIT
// The table of differences, and how they are reported.
#include "ipr/expressions/dialect_differences.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

namespace softcnc::ipr {
namespace {

using C = DialectDifference;

constexpr std::array<DialectDifferenceRow, kDialectDifferences> kDifferenceTable{{
    {C::logic, Code::SC1032, "AND, OR, XOR", "ask whether numbers are 0",
     "join the bits of whole numbers", "", "custom macro, arithmetic and logic operation"},
    {C::modulo, Code::SC1032, "MOD", "is never negative",
     "rounds its operands and has the sign of the first", "",
     "custom macro, arithmetic and logic operation"},
    {C::equality, Code::SC1032, "EQ, NE", "take numbers less than 0.0001 apart as equal",
     "are exact", "", "custom macro, branch and repetition"},
    {C::angle, Code::SC1033, "ATAN, ASIN", "give -180 to 180 degrees, -90 to 90",
     "give 0 to 360 degrees, ASIN of a negative number 270 to 360", "",
     "custom macro, arithmetic and logic operation"},
    {C::whole, Code::SC1033, "FIX, FUP of a negative number", "round down, up",
     "round towards 0, away from 0", "", "custom macro, arithmetic and logic operation"},
    {C::round, Code::SC1033, "ROUND in a length or an angle", "gives a whole number",
     "gives a multiple of 0.001 mm or 0.0001 inch", "",
     "custom macro, arithmetic and logic operation"},
    {C::grouping, Code::SC1034, "AND, OR, XOR beside other operators",
     "bind looser than all others", "AND binds as *, OR and XOR as +", "",
     "custom macro, arithmetic and logic operation"},
    {C::vacant, Code::SC1035, "a variable without a value", "is 0",
     "is vacant: a word with it counts as not written", "", "custom macro, variables"},
    {C::assignment, Code::SC1036, "a variable read on the line that assigns to it",
     "has its value from before", "has the value assigned, if that stands before", "",
     "custom macro, processing macro statements"},
    {C::system_variable, Code::SC1037,
     "#2001 to #2400, #3000, #3006, #4001 to #4120, #5001 to #5203", "are variables like others",
     "are those of the system: tools, alarm, stop, modes, positions",
     "are those of the system, with the lengths of tools before their wear",
     "custom macro, system variables; Haas: macro variables"},
    {C::local_variable, Code::SC1038, "#31 to #33 in a called program", "belong to all programs",
     "belong to the call", "", "custom macro, macro call"},
    {C::assigned_offset, Code::SC1039, "an offset assigned to (#5211 to #5382)",
     "counts from the next code that selects or changes one", "counts at once", "",
     "custom macro, system variables"},
    {C::offset_unit, Code::SC1040, "the variable of an offset (#5161 to #5382) in G20", "counts mm",
     "counts inches", "", "custom macro, system variables"},
    {C::dwell, Code::SC2120, "G04 P", "counts seconds", "counts milliseconds",
     "counts milliseconds, with a decimal point seconds", "dwell (G04); Haas: G04"},
    {C::cycle_dwell, Code::SC2121, "P of a canned cycle", "counts seconds", "counts milliseconds",
     "counts milliseconds, with a decimal point seconds",
     "canned cycles for drilling; Haas: G82, G04"},
    {C::dwell_with_point, Code::SC2384, "P of a dwell with a decimal point", "counts seconds",
     "counts milliseconds", "counts seconds", "Haas: G04"},
    {C::work_system_in_g91, Code::SC2122, "G10 L2 in G91", "sets the origin to the values",
     "adds the values to the origin", "", "changing work coordinate systems"},
    {C::tool_value, Code::SC2123, "G10 L1, L10, L11 with R alone", "sets the radius of tool P",
     "sets the length of offset P (L10) or its wear (L1, L11)", "", "tool compensation values"},
    {C::length_number, Code::SC2124, "G43 without H", "takes the length of the tool in the spindle",
     "takes the last H", "", "tool length compensation"},
    {C::zero_radius, Code::SC2125, "G41, G42 with D0",
     "takes the radius of the tool in the spindle", "takes a radius of 0", "",
     "tool compensation values"},
    {C::radius_number, Code::SC2130, "G41, G42 without D",
     "take the radius of the tool in the spindle", "take the last D", "", "cutter compensation"},
    {C::local_shift, Code::SC2126, "G52 beside G92", "is one and the same shift",
     "is a shift of its own, which adds to that of G92", "", "local coordinate system (G52)"},
    {C::machine_point, Code::SC2127, "G53 with G01", "moves at the feed", "moves as a rapid", "",
     "machine coordinate system (G53)"},
    {C::old_call, Code::SC2128, "M98 P of five digits or more without L", "calls the program O P",
     "calls the program of the last four digits, as often as those before them say",
     "calls the program O P", "subprogram call; Haas: M98"},
    {C::retract, Code::SC2129, "a canned cycle before any G98 or G99", "goes out to R",
     "goes out to the height at which the first of the series started", "",
     "canned cycles for drilling"},
    {C::feed_out, Code::SC2131, "G74, G84, G89 with G98", "go out at the feed all the way",
     "go out at the feed to R, where the spindle of a tap turns back, and on as a rapid", "",
     "canned cycles for drilling"},
    {C::entry, Code::SC2132, "the line on which cutter compensation begins",
     "ends offset from its programmed end", "ends perpendicular to the next move", "",
     "details of cutter compensation"},
    {C::exact_stop, Code::SC2133, "G61", "follows the path exactly, without a stop",
     "stops at the end of every block", "", "exact stop (G09, G61)"},
    {C::named_shift, Code::SC2134, "G92.1 with axes",
     "forgets the shift of all axes, and moves where a motion is in force",
     "forgets the shift of the axes named, and moves nothing", "",
     "workpiece coordinate system preset (G92.1)"},
    {C::further_system, Code::SC2269, "G10 L20 P1 to P9",
     "sets the origin of work system P by the position",
     "sets the origin of the further work system G54.1 P to the values", "",
     "additional workpiece coordinate systems"},
    {C::kept_height, Code::SC2385,
     "R and the depth of a canned cycle, kept where G90 or G91 changes",
     "are read again, by the mode of the line", "stay the heights that they were", "",
     "canned cycles for drilling; polar coordinate command, example with incremental angles"},
    {C::cutter_offset, Code::SC2386, "G10 L12, L13", "are errors", "set the radius and its wear",
     "set the diameter and its wear, or by `program.cutter_offsets` the radius",
     "tool compensation values; Haas: G10, setting 40"},
    {C::leave_to_line, Code::SC2387, "M99 P in a called program",
     "goes back, and on at line N P of the caller", "goes back, and on at line N P of the caller",
     "goes on at line N P of the called program",
     "subprogram call; Haas: M99, conditional expressions"},
    {C::peck_limit, Code::SC2387, "K of G73 beside Q", "is an error", "repeats the line",
     "is the depth after which the tool goes out to R", "canned cycles for drilling; Haas: G73"},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kDifferenceTable.size(); ++i)
    if (static_cast<std::size_t>(kDifferenceTable[i].kind) != i) return false;
  return true;
}
static_assert(in_order());

constexpr std::string_view kNo = "an error", kAsFanuc = "as fanuc", kAsLinuxcnc = "as linuxcnc";

constexpr DialectTraitRow kTraits[] = {
    {"motion in force at the start",
     {"none", "none", "none", "G00"},
     "grbl: gcode.c, gc_init: all modes at 0, G0 among them"},
    {"`$H`, `$X`, `$$`, `$J=`, `?`, `!`, `~` on lines of their own; `*57` at the end of a line",
     {kNo, kNo, kNo, "skipped, with one note"},
     "grbl: Grbl v1.1 Commands; RepRap: G-code, checking"},
    {"X Y Z I J K R Q without a decimal point",
     {"units", "units, or by `program.integers` increments", kAsFanuc, "units"},
     "FANUC: decimal point programming; Haas: setting 162"},
    {"A B C I J K Q R U to Z of G65 without a decimal point",
     {"units", "increments, or by `program.integers` units", kAsFanuc, "units"},
     "FANUC: custom macro, position of the decimal point; Haas: integer argument passing"},
    {"F without a decimal point",
     {"units", "units", "units, with a warning", "units"},
     "Haas: setting 77"},
    {"L of G65",
     {"sets the arguments each time", kAsLinuxcnc, "sets them the first time", kAsLinuxcnc},
     "Haas: macro variables, local variables"},
    {"G10 L2 P0",
     {"sets the work system in force", kNo, "sets the shift of G52", kAsLinuxcnc},
     "Haas: G10"},
    {"G53 in G91, under G51, G51.1 and G68, and without axes",
     {kNo, kNo, "leaves them for its line; without axes it moves nothing", kNo},
     "Haas: G53"},
    {"R of a canned cycle that has none in force",
     {kNo, kNo, "is the height at which the series began", kNo},
     "Haas: G81"},
    {"G74, G84 while the spindle does not turn",
     {kNo, kNo, "start it, and stop it after each hole", kNo},
     "Haas: G84"},
    {"I J K of G73 and G83",
     {kNo, kNo, "the first peck, by how much each next one is less, the least", kNo},
     "Haas: G73, G83"},
    {"G70, G71, G72",
     {kNo, kNo, "holes on a circle, on an arc, along a line", kNo},
     "Haas: G70, G71, G72"},
    {"`[..] M99`",
     {kNo, kNo, "M99 if the condition is true", kNo},
     "Haas: conditional expressions"},
    {"GOTO and IF GOTO after the words of a line",
     {kNo, kNo, "jump after the line has acted", kNo},
     "Haas: GOTO"},
    {"#100 to #199",
     {"variables like others", "end with the program", "outlive the program", kAsLinuxcnc},
     "custom macro, variables; Haas: macro variables"},
    {"#2001 to #2200; #2201 to #2400",
     {"variables like others", "wear of lengths; lengths", "lengths; their wear", kAsLinuxcnc},
     "custom macro, system variables; Haas: macro variables"},
    {"#2401 to #2600; #2601 to #2800",
     {"variables like others", kNo, "as G10 L12; as G10 L13", kAsLinuxcnc},
     "Haas: macro variables, setting 40"},
    {"#5201 to #5203",
     {"variables like others", "the offset of all work systems, always 0", "the shift of G52",
      kAsLinuxcnc},
     "custom macro, system variables; Haas: macro variables"},
    {"#10000 to #10999",
     {kNo, "wear of lengths, from #10001 on", "outlive the program; #10100 is #100", kNo},
     "custom macro, system variables; Haas: macro variables"},
    {"#11001 to #13999",
     {kNo, "lengths, wear of radii, radii", kNo, kNo},
     "custom macro, system variables; Haas: macro variables"},
    {"E right after a number, as in `F600E41`",
     {"an exponent, an error", "a word", kAsFanuc, kAsLinuxcnc},
     "FANUC: custom macro, argument specification I"},
    {"`WH` `EN` `GO` `TH`, and functions by two letters, as in `SI[30]`",
     {kNo, "the keyword, the function", kAsFanuc, kNo},
     "FANUC: custom macro, abbreviation of functions and of control statements"},
    {"K of a canned cycle",
     {kNo, "number of repetitions", "of G73 and G83 a peck, otherwise an error", kNo},
     "FANUC: canned cycles for drilling; Haas: G81, G73"},
    {"L of a canned cycle; L0",
     {"repetitions; an error", "as K; only keeps the words", "repetitions; only keeps the words",
      kAsLinuxcnc},
     "Haas: G81"},
    {"P of G81 and G85, which do not dwell",
     {kNo, "no effect, with one note", kAsFanuc, kNo},
     "FANUC: canned cycles for drilling"},
    {"H beside G41 or G42 without D",
     {kNo, "an error that asks for D", kAsFanuc, kNo},
     "FANUC: Series 0-M, tool compensation memory A: H and D are one table"},
    {"outside corners within cutter compensation",
     {"an arc", "an arc", "an arc", "an arc"},
     "LinuxCNC: cutter compensation; FANUC: details of cutter compensation"},
};

}  // namespace

std::string_view DialectDifferenceRow::meaning(Dialect dialect) const noexcept {
  if (is_linuxcnc_like(dialect)) return linuxcnc;
  return dialect == Dialect::haas && !haas.empty() ? haas : fanuc;
}

std::span<const DialectTraitRow> dialect_trait_table() noexcept { return kTraits; }

std::span<const DialectDifferenceRow> dialect_difference_table() noexcept {
  return kDifferenceTable;
}

void DialectDifferences::note(DialectDifference kind, SourcePos pos, std::string_view line,
                              const std::string& detail) {
  if (!watching_) return;
  Met& met = met_[static_cast<std::size_t>(kind)];
  if (met.lines.empty()) {
    met.pos = diagnostics_.in_calls(pos);
    met.line = line;
    met.detail = detail;
  }
  if (met.lines.size() < kMostLines) met.lines.emplace(pos.file, pos.line);
}

/// "G04 P counts seconds; in the fanuc dialect: counts milliseconds (here and on 2 more lines)"
std::string DialectDifferences::text_of(const DialectDifferenceRow& row, const Met& met) const {
  const std::string_view own = row.meaning(dialect_);
  const Dialect main = other_family(dialect_);
  const Dialect sibling = dialect_ == Dialect::haas ? Dialect::fanuc : Dialect::haas;
  const bool refused = row.kind == C::cutter_offset || row.kind == C::peck_limit;  // by linuxcnc
  const bool linuxcnc_differs = row.meaning(main) != own && !refused;
  const Dialect other = linuxcnc_differs ? main : sibling;
  std::string text = std::string(row.what) + ' ';
  text += own;
  text += "; in the " + std::string(name(other)) + " dialect: ";
  text += row.meaning(other);
  text += met.detail;
  const std::size_t more = met.lines.size() - 1;
  if (more > 0)
    text += " (here and on " + std::to_string(more) + " more line" + (more == 1 ? ")" : "s)");
  return text;
}

void DialectDifferences::report() {
  std::vector<const DialectDifferenceRow*> found;
  const auto met_by = [this](const DialectDifferenceRow& row) -> Met& {
    return met_[static_cast<std::size_t>(row.kind)];
  };
  for (const DialectDifferenceRow& row : kDifferenceTable)
    if (!met_by(row).lines.empty()) found.push_back(&row);
  const auto place = [&](const DialectDifferenceRow* row) {
    const SourcePos& pos = met_by(*row).pos;
    return std::tuple(pos.file, pos.line, pos.column);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const auto* a, const auto* b) { return place(a) < place(b); });
  for (const DialectDifferenceRow* row : found) {
    Met& met = met_by(*row);
    diagnostics_.report(row->code, met.pos, text_of(*row, met), met.line);
    met = {};
  }
}

}  // namespace softcnc::ipr
