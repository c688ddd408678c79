// SPDX-License-Identifier: MIT
// Lengths without a decimal point, which a parameter of FANUC's and Haas' controls makes
// increments.
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
};

/// Reads the lengths of lines: those without a decimal point as increments, if that is asked for;
/// otherwise they are counted, since another control may take them for increments. Zero is the same
/// in both, and a computed value has a decimal point on these controls.
class IntegerLengths {
 public:
  explicit IntegerLengths(IntegerUnit unit) : unit_(unit) {}

  /// Returns the line as it counts; it is valid until the next call. Increments are 0.001 mm or
  /// 0.0001 inch, as FANUC's IS-B and Haas' controls have them.
  const ProgramLine& read(const ProgramLine& line, const LengthContext& context);

  /// Reports what has been counted in one warning (SC1057), if the program seems to count
  /// increments: it has lengths with a decimal point too, or none of its lengths without one is
  /// below 100 units. To be called at the end of the program.
  void report(Diagnostics& diagnostics);

 private:
  const ProgramLine& scaled(const ProgramLine& line, const LengthContext& context);
  bool is_new(const ProgramLine& line);
  void see(const ProgramLine& line, const Word& word, const LengthContext& context);

  IntegerUnit unit_;
  ProgramLine line_;
  Word corner_;
  std::vector<Word> words_;
  std::map<int, std::vector<bool>> seen_;  // by file: which lines have been counted
  std::int64_t lines_ = 0;                 // with lengths without a point
  std::pair<int, int> last_counted_;       // the last of them: file and line
  bool points_ = false;                    // a length with one
  double smallest_ = 0;
  SourcePos first_;
  std::string text_, unit_name_, word_;
  double value_ = 0, increment_ = 0;
};

}  // namespace softcnc::ipr
