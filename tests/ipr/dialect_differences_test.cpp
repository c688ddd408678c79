// SPDX-License-Identifier: MIT
// Lines that mean something else in the other dialect: each kind is reported where it stands, and
// only where both dialects go on, each to a place of its own.
#include "ipr/expressions/dialect_differences.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "ipr/interpret.hpp"
#include "support/property.hpp"

namespace softcnc::ipr {
namespace {

using C = DialectDifference;

/// Tool 1 has a length of 50 mm and a radius of 3 mm, tool 2 a radius of 4 mm.
MachineState state_with_tool() {
  MachineState state;
  state.tools[1].length[2] = 50;
  state.tools[1].radius = 3;
  state.tools[2].radius = 4;
  return state;
}

Interpreted run_compared(const std::string& text, Dialect dialect, bool compare = true) {
  InterpreterOptions options = in(dialect);
  options.compare_dialects = compare;
  return interpret(text, {}, options, state_with_tool());
}

struct Print {
  std::string operator()(const Move& move) const {
    std::string text = move.rapid ? "rapid" : "feed " + std::to_string(move.feed);
    if (move.path_mode == PathMode::stop) text += " stop";
    for (const double value : end(move.path)) text += ' ' + std::to_string(value);
    return text + ' ' + std::to_string(length(move.path)) + '\n';
  }
  std::string operator()(const Dwell& dwell) const {
    return "dwell " + std::to_string(dwell.duration) + '\n';
  }
  std::string operator()(const Action& action) const {
    return "action " + std::to_string(action.code) + ' ' + std::to_string(action.value) + '\n';
  }
};

/// What a program does.
std::string deeds(const Interpreted& result) {
  std::string all;
  for (const Block& block : result.blocks) all += std::visit(Print(), block.what);
  return all;
}

/// Or a dwell that by its looks is of the other dialect.
bool is_dialect_difference(const Diagnostic& diagnostic) {
  if (diagnostic.code == Code::SC2210) return true;
  const auto rows = dialect_difference_table();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const DialectDifferenceRow& row) { return row.code == diagnostic.code; });
}

bool has_errors(const Interpreted& result) {
  return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity() == Severity::error; });
}

struct Case {
  DialectDifference kind;
  std::string program;
  std::string place;   // "SC1032 1:5"
  std::string detail;  // after the words of the table, in linuxcnc
};

const std::vector<Case> kCases{
    {C::logic, "G0 X[6 AND 3]\nM30", "SC1032 1:5", " (1 here, 2 there)"},
    {C::logic, "o1 if [7 AND 1]\nG0 X1\no1 endif\nM30", "", ""},
    {C::modulo, "G0 X[-7 MOD 4]\nM30", "SC1032 1:5", " (1 here, -3 there)"},
    {C::equality, "IF [1 EQ 1.00001] THEN #1=5\nG0 X[#1+1]\nM30", "SC1032 1:4",
     " (1 here, 0 there)"},
    {C::angle, "G0 XATAN[-1]/[1]\nM30", "SC1033 1:5", " (-45 here, 315 there)"},
    {C::angle, "G0 X[SIN[ATAN[-1]/[1]]]\nM30", "", ""},
    {C::whole, "#1=FIX[-1.5]\nG0 X#1\nM30", "SC1033 1:4", " (-2 here, -1 there)"},
    {C::whole, "#1=FIX[1.5]\nG0 X#1\nM30", "", ""},
    {C::round, "G0 X[ROUND[1.2345]]\nM30", "SC1033 1:5", " (1 here, 1.235 there)"},
    {C::grouping, "G0 X[0 AND 0 + 1]\nM30", "SC1034 1:5", " (0 here, 1 there)"},
    {C::grouping, "G0 X[0 AND [0 + 1]]\nM30", "", ""},
    {C::vacant, "G0 X5 Y5\nX#7 Y1\nM30", "SC1035 2:2", " (0 here, vacant there)"},
    {C::vacant, "G0 X5 Y5\nX[#7+2]\nM30", "", ""},
    {C::assignment, "#1=3\n#1=5 G0 X#1\nM30", "SC1036 2:10", " (3 here, 5 there)"},
    {C::system_variable, "G0 X4\nG0 Y#5041\nM30", "SC1037 2:5", ""},
    {C::system_variable, "#2201=7\nG43 H1\nG0 Z0\nM30", "SC1037 1:1", ""},
    {C::local_variable, "#31=4\nG65 P2\nM30\nO2\nG0 X#31\nM99", "SC1038 5:5", ""},
    {C::vacant, "G0 X[1+EXISTS[#1]]\nM30", "SC1035 1:5", " (2 here, 1 there)"},
    {C::vacant, "#1=2\nG0 X[1+EXISTS[#1]]\nM30", "", ""},
    {C::assigned_offset, "#5221=10\nG0 X0\nM30", "SC1039 2:4", ""},
    {C::assigned_offset, "G92 X10\n#5211=2\nG0 X0\nM30", "SC1039 3:4", ""},
    {C::assigned_offset, "G55\nG0 X0\n#5242=3\nG0 X1 Y1\nM30", "SC1039 4:7", ""},
    {C::assigned_offset, "#5221=10\nG92 X0\nG0 X5\nM30", "SC1039 2:5", ""},
    {C::assigned_offset, "#5221=10\nG54\nG0 X0\nM30", "", ""},
    {C::assigned_offset, "#5241=10\nG0 X1 Y2\n#5222=1\nG91 X3 Y4\nM30", "", ""},
    {C::offset_unit, "G20\n#5221=1 G54\nG0 X0\nM30", "SC1040 2:1", ""},
    {C::offset_unit, "#5161=25.4\nG20\nG0 X[#5161+1]\nM30", "SC1040 3:5", " (26.4 here, 2 there)"},
    {C::offset_unit, "#5161=25.4\nG0 X[#5161+1]\nM30", "", ""},
    {C::dwell, "G4 P2\nM30", "SC2120 1:4", ""},
    {C::dwell, "G4 P0\nM30", "", ""},
    {C::cycle_dwell, "G0 Z5\nG99 G82 X1 Z-1 R2 P2 F100\nM30", "SC2121 2:19", ""},
    {C::work_system_in_g91, "G10 L2 P1 X5\nG91 G10 L2 P1 X5\nG90 G0 X0\nM30", "SC2122 2:5", ""},
    {C::further_system, "G10 L20 P1 X5\nG0 X0\nM30", "SC2269 1:1", ""},
    {C::further_system, "G10 L20 P2\nG0 X1\nM30", "", ""},
    {C::kept_height, "G0 Z5\nG99 G81 X1 Z-1 R2 F100\nG91 X1\nM30", "SC2385 3:5", ""},
    {C::kept_height, "G0 Z5\nG99 G81 X1 Z-1 R2 F100\nG91 X1 Z-3 R-3\nM30", "", ""},
    {C::tool_value, "G10 L1 P1 R5\nG43 H1\nG0 Z0\nM30", "SC2123 1:11", ""},
    {C::length_number, "T1 M6\nG43\nG0 Z1\nM30", "SC2124 2:1", ""},
    {C::length_number, "T1 M6\nG43 H1\nG43\nG0 Z1\nM30", "", ""},
    {C::zero_radius, "T1 M6\nG41 D0 G1 X10 F100\nX20\nG40 X30\nM30", "SC2125 2:5", ""},
    {C::radius_number, "T1 M6\nF100 G1 G41 D2 X20\nX40\nG40 Y20\nG41 X60\nX80\nG40 Y50\nM30",
     "SC2130 5:1", ""},
    {C::radius_number, "T2 M6\nF100 G1 G41 D2 X20\nX40\nG40 Y20\nG41 X60\nX80\nG40 Y50\nM30", "",
     ""},
    {C::named_shift, "G92 X5\nG0 X1\nG92.1 X0\nM30", "SC2134 3:1", ""},
    {C::named_shift, "G92 X5\nG0 X1\nG92.1\nX0\nM30", "", ""},
    {C::local_shift, "G92 X5\nG52 X2\nG0 X0\nM30", "SC2126 2:1", ""},
    {C::local_shift, "G52 X2\nG92.2\nG0 X0\nM30", "SC2126 2:1", ""},
    {C::local_shift, "G92 X5\nG52 Y2\nG0 X0\nY0\nG92 Y1\nG92.1\nX0\nM30", "", ""},
    {C::machine_point, "G1 F100\nG53 X5\nM30", "SC2127 2:1", ""},
    {C::machine_point, "G53 G0 X5\nM30", "", ""},
    {C::old_call, "M98 P10002\nM30\nO10002\nG0 X1\nM99\nO2\nG0 X2\nM99", "SC2128 1:5", ""},
    {C::retract, "G0 Z20\nG81 X1 Z-1 R2 F100\nM30", "SC2129 2:1", ""},
    {C::retract, "G0 Z2\nG81 X1 Z-1 R2 F100\nM30", "", ""},
    {C::feed_out, "S500 M3 G0 Z20\nG98 G84 X1 Z-1 R2 F100\nM30", "SC2131 2:5", ""},
    {C::entry, "T1 M6\nF100 G1 G41 D1 X20\nY20\nG40 X60\nM30", "SC2132 2:1", ""},
    {C::entry, "T1 M6\nF100 G1 G41 D1 X20\nX40\nG40 X60\nM30", "", ""},
    {C::exact_stop, "G61\nG0 X1\nM30", "SC2133 1:1", ""},
    {C::exact_stop, "G61.1\nG0 X1\nG64\nM30", "", ""},
    {C::feed_out, "S500 M4 G0 Z20\nG98 G74 X1 Z-1 R2 F100\nM30", "SC2131 2:5", ""},
    {C::feed_out, "S500 M3 G0 Z20\nG99 G84 X1 Z-1 R2 F100\nM30", "", ""},
};

/// What haas reads as linuxcnc does, and fanuc otherwise.
const std::vector<Case> kHaasCases{
    {C::dwell_with_point, "G4 P2.\nM30", "SC2384 1:4", ""},
    {C::dwell_with_point, "G0 Z5.\nG99 G82 X1. Z-1. R2. P.5 F100.\nM30", "SC2384 2:22", ""},
    {C::old_call, "M98 P10002\nM30\nO10002\nG0 X1\nM99\nO2\nG0 X2\nM99", "SC2128 1:5", ""},
};

/// What linuxcnc refuses, and haas and fanuc read each in its own way.
const std::vector<Case> kSiblingCases{
    {C::cutter_offset, "G10 L12 P2 R3.\nG13 D2 I9. Z-1. F100.\nM30", "SC2386 1:1", ""},
    {C::cutter_offset, "G10 L13 P2 R3.\nG13 D2 I9. Z-1. F100.\nM30", "SC2386 1:1", ""},
    {C::peck_limit, "G0 Z5.\nG99 G73 X1. Z-5. R1. Q2. K4 F100.\nM30", "SC2387 2:26", ""},
};

/// What haas reads otherwise than both others.
const std::vector<Case> kHaasAloneCases{
    {C::leave_to_line, "G0\nM98 P2\nM30\nN10 X9.\nM30\nO2\nM99 P10\nN10 X7.\nM99", "SC2387 7:5",
     ""},
};

std::string words_of(const DialectDifferenceRow& row, Dialect dialect) {
  const bool fanuc = dialect == Dialect::fanuc;
  return std::string(row.what) + ' ' + std::string(fanuc ? row.fanuc : row.linuxcnc) +
         (fanuc ? "; in the linuxcnc dialect: " : "; in the fanuc dialect: ") +
         std::string(fanuc ? row.linuxcnc : row.fanuc);
}

}  // namespace

TEST_CASE("what means something else in the other dialect is reported, and is something else",
          "[ipr][differences]") {
  for (const Case& example : kCases) {
    const DialectDifferenceRow& row =
        dialect_difference_table()[static_cast<std::size_t>(example.kind)];
    for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc}) {
      CAPTURE(name(dialect), example.program);
      const Interpreted result = run_compared(example.program, dialect);
      const Dialect other = dialect == Dialect::fanuc ? Dialect::linuxcnc : Dialect::fanuc;
      const Interpreted there = run_compared(example.program, other);
      REQUIRE_FALSE(has_errors(result));
      REQUIRE_FALSE(has_errors(there));
      CHECK((deeds(result) != deeds(there)) == !example.place.empty());
      if (example.place.empty()) {
        CHECK(places(result).empty());
        continue;
      }
      REQUIRE(places(result) == Places{example.place});
      const std::string& message = result.diagnostics[0].message;
      CHECK(message.starts_with(words_of(row, dialect)));
      if (dialect == Dialect::linuxcnc) CHECK(message == words_of(row, dialect) + example.detail);
      CHECK(result.diagnostics[0].source_line == [&] {
        std::istringstream lines(example.program);
        std::string line;
        for (int i = 0; i < result.diagnostics[0].pos.line; ++i) std::getline(lines, line);
        return line;
      }());
    }
  }
}

TEST_CASE("every dialect difference has an example", "[ipr][differences]") {
  std::set<DialectDifference> seen;
  for (const Case& example : kCases)
    if (!example.place.empty()) seen.insert(example.kind);
  for (const Case& example : kHaasCases) seen.insert(example.kind);
  for (const Case& example : kSiblingCases) seen.insert(example.kind);
  for (const Case& example : kHaasAloneCases) seen.insert(example.kind);
  CHECK(seen.size() == dialect_difference_table().size());
}

TEST_CASE("what haas reads as linuxcnc does is reported beside fanuc", "[ipr][differences]") {
  for (const Case& example : kHaasCases) {
    CAPTURE(example.program);
    const Interpreted haas = run_compared(example.program, Dialect::haas);
    REQUIRE(places(haas) == Places{example.place});
    CHECK(deeds(haas) == deeds(run_compared(example.program, Dialect::linuxcnc)));
    CHECK(deeds(haas) != deeds(run_compared(example.program, Dialect::fanuc)));
    const DialectDifferenceRow& row =
        dialect_difference_table()[static_cast<std::size_t>(example.kind)];
    CHECK(haas.diagnostics[0].message == std::string(row.what) + ' ' + std::string(row.haas) +
                                             "; in the fanuc dialect: " + std::string(row.fanuc));
  }
}

TEST_CASE("what fanuc and haas read each in its own way is reported in fanuc",
          "[ipr][differences]") {
  for (const Case& example : kSiblingCases) {
    CAPTURE(example.program);
    const Interpreted fanuc = run_compared(example.program, Dialect::fanuc);
    REQUIRE(places(fanuc) == Places{example.place});
    CHECK(deeds(fanuc) != deeds(run_compared(example.program, Dialect::haas)));
    CHECK(has_errors(run_compared(example.program, Dialect::linuxcnc)));
    const DialectDifferenceRow& row =
        dialect_difference_table()[static_cast<std::size_t>(example.kind)];
    CHECK(fanuc.diagnostics[0].message == std::string(row.what) + ' ' + std::string(row.fanuc) +
                                              "; in the haas dialect: " + std::string(row.haas));
  }
}

TEST_CASE("what haas alone reads otherwise is reported in every dialect", "[ipr][differences]") {
  for (const Case& example : kHaasAloneCases) {
    CAPTURE(example.program);
    const DialectDifferenceRow& row =
        dialect_difference_table()[static_cast<std::size_t>(example.kind)];
    const Interpreted haas = run_compared(example.program, Dialect::haas);
    REQUIRE(places(haas) == Places{example.place});
    CHECK(haas.diagnostics[0].message ==
          std::string(row.what) + ' ' + std::string(row.haas) +
              "; in the linuxcnc dialect: " + std::string(row.linuxcnc));
    for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc}) {
      const Interpreted other = run_compared(example.program, dialect);
      REQUIRE(places(other) == Places{example.place});
      CHECK(deeds(other) != deeds(haas));
      CHECK(other.diagnostics[0].message == std::string(row.what) + ' ' + std::string(row.fanuc) +
                                                "; in the haas dialect: " + std::string(row.haas));
    }
  }
}

TEST_CASE("haas reads what its rows leave out as fanuc does, and grbl as linuxcnc",
          "[ipr][differences]") {
  for (const Case& example : kCases) {
    const bool own =
        !dialect_difference_table()[static_cast<std::size_t>(example.kind)].haas.empty();
    if (own) continue;
    CAPTURE(example.program);
    CHECK(deeds(run_compared(example.program, Dialect::haas)) ==
          deeds(run_compared(example.program, Dialect::fanuc)));
    CHECK(deeds(run_compared(example.program, Dialect::grbl)) ==
          deeds(run_compared(example.program, Dialect::linuxcnc)));
  }
}

TEST_CASE("in haas a dwell without a decimal point is reported beside linuxcnc",
          "[ipr][differences]") {
  const Interpreted haas = run_compared("G4 P2\nM30", Dialect::haas);
  REQUIRE(places(haas) == Places{"SC2120 1:4"});
  CHECK(haas.diagnostics[0].message ==
        "G04 P counts milliseconds, with a decimal point seconds; in the linuxcnc dialect: counts "
        "seconds");
}

TEST_CASE("a dialect difference is reported once, with the number of its lines",
          "[ipr][differences]") {
  const Interpreted result = run_compared(
      "G4 P1\nG53 G1 X1 F100\nG4 P2\no1 repeat [3]\nG4 P3\no1 endrepeat\nM30", Dialect::linuxcnc);
  CHECK(places(result) == Places{"SC2120 1:4", "SC2127 2:1"});
  CHECK(result.diagnostics[0].message ==
        "G04 P counts seconds; in the fanuc dialect: counts milliseconds "
        "(here and on 2 more lines)");
}

TEST_CASE("nothing is compared unless it is asked for", "[ipr][differences]") {
  for (const Case& example : kCases) {
    CAPTURE(example.program);
    CHECK(places(run_compared(example.program, Dialect::linuxcnc, false)) == Places{});
  }
}

TEST_CASE("what one dialect refuses is no dialect difference", "[ipr][differences]") {
  for (const char* text :
       {"G04 X1\nM30", "#1=1+1\nM30", "G30 P2 X0\nM30", "G54 P2\nM30", "G10 L20 P0 X0\nM30",
        "G1 F100 X[#0+1]\nM30", "G0 X[1 EQ 1 AND 2 EQ 2]\nM30", "G0 X[1.5 AND 1]\nM30",
        "G0 X1 H1\nM30", "G0 X1 D1\nM30", "G0 G28 X0\nM30", "G0 X1\nG80 X2\nM30",
        "F9 G0 Z3\nG99 G81 X1 Z0 R1\nG83 X2 Q1\nM30", "F9 G0 Z3\nG99 G83 X1 Z0 R1 Q1 P1\nM30",
        "T1 M6\nF9 G1 G41 D1 X20\nX40\nG41 D1 X50\nG40 X60\nM30"}) {
    CAPTURE(text);
    const Interpreted linuxcnc = run_compared(text, Dialect::linuxcnc),
                      fanuc = run_compared(text, Dialect::fanuc);
    CHECK(has_errors(linuxcnc) != has_errors(fanuc));
    for (const Interpreted* result : {&linuxcnc, &fanuc})
      if (!has_errors(*result)) CHECK(places(*result).empty());
  }
}

TEST_CASE("a program that the dialects read otherwise is reported", "[ipr][differences][good]") {
  int differ = 0, programs = 0;
  for (const char* folder : {"/tests/good", "/tests/dialects", "/tests/bad", "/programs"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(SOFTCNC_SOURCE_DIR) + folder)) {
      if (entry.path().extension() != ".nc" || ++programs % test::kPart != 0) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      const Interpreted linuxcnc = run_compared(text, Dialect::linuxcnc),
                        fanuc = run_compared(text, Dialect::fanuc);
      if (has_errors(linuxcnc) || has_errors(fanuc) || deeds(linuxcnc) == deeds(fanuc)) continue;
      CAPTURE(entry.path().string());
      ++differ;
      for (const Interpreted* result : {&linuxcnc, &fanuc})
        CHECK(std::any_of(result->diagnostics.begin(), result->diagnostics.end(),
                          is_dialect_difference));
    }
  CHECK(differ > 0);
}

TEST_CASE("docs/gcode.md shows the table of differences as it is", "[ipr][differences][docs]") {
  std::ifstream stream(std::string(SOFTCNC_SOURCE_DIR) + "/docs/gcode.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  std::string table =
      "| what | linuxcnc, grbl | fanuc | haas | code | source |\n|---|---|---|---|---|---|\n";
  for (const DialectDifferenceRow& row : dialect_difference_table())
    table += "| " + std::string(row.what) + " | " + std::string(row.linuxcnc) + " | " +
             std::string(row.fanuc) + " | " +
             (row.haas.empty() ? "as fanuc" : std::string(row.haas)) + " | " + code_name(row.code) +
             " | " + std::string(row.source) + " |\n";
  INFO("expected in docs/gcode.md:\n" << table);
  CHECK(page.find(table) != std::string::npos);
  std::string traits =
      "| what | linuxcnc | fanuc | haas | grbl | source |\n|---|---|---|---|---|---|\n";
  for (const DialectTraitRow& row : dialect_trait_table()) {
    traits += "| " + std::string(row.what);
    for (const std::string_view does : row.does) traits += " | " + std::string(does);
    traits += " | " + std::string(row.source) + " |\n";
  }
  INFO("expected in docs/gcode.md:\n" << traits);
  CHECK(page.find(traits) != std::string::npos);
}

}  // namespace softcnc::ipr
