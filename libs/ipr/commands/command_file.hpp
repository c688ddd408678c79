// SPDX-License-Identifier: MIT
// The input of paper 003 (Table 6) to blocks: l, pcw, pccw, dcw, dcaw, s, all relative.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ipr/commands/command_line.hpp"
#include "ipr/text/reader.hpp"
#include "motion/model/block.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipr {

/// A command: what may stand at the beginning of a line.
struct CommandRow {
  enum class Kind : std::uint8_t { line, arc_by_center, arc_by_degrees, spline, tangents, feed };
  Kind kind;
  std::string_view name;
  std::size_t least, most;  // how many numbers it takes
  std::string_view numbers;
  std::string_view says;
};
std::span<const CommandRow> command_table() noexcept;

/// A spline whose points are still coming.
struct CommandSpline {
  CommandField head;
  SourcePos pos;          // of the head
  std::string text;       // of its line
  std::size_t count = 0;  // of its points
  std::size_t given = 0;  // so far, in numbers
  std::vector<AxisVector> points;
  double x = 0;  // of the point whose y is still to come
  SourcePos x_pos;
};

class CommandFile {
 public:
  /// Makes an interpreter of commands. Everything referred to must outlive it.
  CommandFile(Reader& reader, const Machine& machine, Diagnostics& diagnostics,
              const AxisVector& start)
      : reader_(reader), machine_(machine), diagnostics_(diagnostics), position_(start) {}

  /// Returns the next block; the last one is Action::Kind::end. As every place is relative to the
  /// one before, nothing moves after a line with an error; reading goes on to show further errors.
  std::optional<Block> next() { return read_on() ? take() : std::nullopt; }
  /// Reads until there is a block. Returns false at the end, and where a pipe has nothing more yet
  /// (the reader is then waiting()).
  bool read_on();
  /// Returns the next block. Requires that read_on() has found one.
  std::optional<Block> take();

 private:
  void read_line();
  bool is_readable();
  bool split();
  bool take(CommandField&& field);
  bool take_name(CommandField&& name);
  void report_stray(Code code, const CommandField& field, std::string message);
  bool stands_for_digit(const CommandField& name) const noexcept;
  bool is_known();
  void read_command();
  bool has_its_numbers(const CommandRow& row);
  void act(CommandRow::Kind kind);
  void line();
  void arc_by_center();
  void arc_by_degrees();
  void begin_spline();
  void set_tangents();
  void set_feed();

  void add_to_spline(std::span<const CommandField> numbers);
  void add_coordinate(const CommandField& number);
  void add_point(const AxisVector& step, SourcePos pos);
  void finish_spline();
  void leave_spline(const std::string& how);
  bool is_near_enough(const AxisVector& place, SourcePos pos);
  void finish();

  void arc(const AxisVector& to, const AxisVector& center, int turns);
  void move(Path path);
  double cutting_feed();
  bool has_axes(const AxisVector& step);

  double number(std::size_t i) const noexcept { return numbers_[i].value; }
  AxisVector step_at(std::size_t i) const noexcept { return {number(i), number(i + 1), 0}; }
  SourcePos pos_of(const CommandField& field) const noexcept;
  SourcePos whole() const noexcept;
  void report(Code code, SourcePos pos, std::string message);
  void report(Code code, SourcePos pos, std::string message, std::string_view text);

  Reader& reader_;
  const Machine& machine_;
  Diagnostics& diagnostics_;

  std::string_view text_;            // of the line
  CommandField head_;                // its name; Kind::end if it has none
  const CommandRow* row_ = nullptr;  // of the name
  std::vector<CommandField> numbers_;
  bool countable_ = true;  // nothing stands between them that is no number
  std::optional<CommandSpline> spline_;
  SplineEnds ends_;            // of the next spline
  bool pass_numbers_ = false;  // those of a command with an error, on lines of their own

  AxisVector position_;  // mm
  double feed_ = 0;      // mm/s; 0: not set
  bool feed_reported_ = false, limit_reported_ = false;
  bool lost_ = false;  // an error has left the position unknown
  bool ended_ = false;
  int line_ = 0, blocks_ = 0;
  std::optional<Block> block_;
};

}  // namespace softcnc::ipr
