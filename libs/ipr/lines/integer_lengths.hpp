// SPDX-License-Identifier: MIT
// Lengths, arguments of G65 and feeds without a decimal point, which parameters of FANUC's and
// Haas' controls make increments.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ipr/parser/parser.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipr {

/// What a line is read by.
struct LengthContext {
  double mm_per_unit = 1;  // before the line; G20 and G21 on it come first
  bool in_cycle = false;   // a canned cycle is in force before the line
  bool in_curve = false;   // the line may be one of a NURBS: K is a knot, R a weight
  bool polar = false;      // G16 is in force before the line: the letter below is an angle
  char angle = 'Y';        // the second axis of the plane
  bool of_haas = false;    // whose F counts by setting 77, and K of a cycle is a length
};

/// Words without a decimal point, as one warning reports them.
struct IntegerWords {
  std::int64_t lines = 0;            // that have them
  std::pair<int, int> last{-1, -1};  // of these: file and line
  SourcePos first;
  std::string text, word;  // of the first: its line, and as it is written
  double value = 0, increment = 0;
};

/// Reads the lengths of lines: those without a decimal point as increments, if that is asked for;
/// otherwise they are counted, since another control may take them for increments. Arguments of G65
/// are increments unless units are asked for; D E F H M S T are whole. Zero is the same in both,
/// and a computed value has a decimal point on these controls.
class IntegerLengths {
 public:
  explicit IntegerLengths(IntegerUnit unit) : unit_(unit) {}

  /// Returns the line as it counts; it is valid until the next call. Increments are 0.001 mm or
  /// 0.0001 inch, as FANUC's IS-B and Haas' controls have them.
  const ProgramLine& read(const ProgramLine& line, const LengthContext& context);

  /// Reports what has been counted, each kind in one warning (SC1057): arguments of G65 and, in
  /// haas, F; lengths if the program seems to count increments: it has lengths with a decimal point
  /// too, or none of its lengths without one is below 100 units. What the machine file states is
  /// not reported. To be called at the end of the program.
  void report(Diagnostics& diagnostics);

 private:
  const ProgramLine& scaled(const ProgramLine& line, LetterSet letters, double increment);
  const ProgramLine& with_arguments(const ProgramLine& line, const LengthContext& context);
  void see_lengths(const ProgramLine& line, const LengthContext& context);
  bool is_new(const ProgramLine& line);
  void report_lengths(Diagnostics& diagnostics);

  IntegerUnit unit_;
  ProgramLine line_;
  Word corner_;
  std::vector<Word> words_;
  std::map<int, std::vector<bool>> seen_;  // by file: which lines have been counted
  IntegerWords lengths_, arguments_, feeds_;
  bool points_ = false;  // a length with one
  double smallest_ = 0;
};

}  // namespace softcnc::ipr
