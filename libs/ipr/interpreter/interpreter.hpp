// SPDX-License-Identifier: MIT
// Lines to blocks, one at a time.
#pragma once

#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "ipr/commands/command_file.hpp"
#include "ipr/commands/format.hpp"
#include "ipr/expressions/dialect.hpp"
#include "ipr/flow/flow.hpp"
#include "ipr/handlers/saved_modes.hpp"
#include "ipr/interpreter/memory.hpp"
#include "ipr/interpreter/stated_stock.hpp"
#include "ipr/lines/command.hpp"
#include "ipr/lines/integer_lengths.hpp"
#include "ipr/lines/options.hpp"
#include "ipr/lines/output.hpp"
#include "ipr/parser/parser.hpp"
#include "ipr/state/modal.hpp"
#include "ipr/state/modal_variables.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipr {

class Interpreter {
 public:
  /// Makes the interpreter of a program. Everything referred to must outlive it. `state` is what
  /// earlier programs have left behind.
  Interpreter(Parser& parser, const Machine& machine, Diagnostics& diagnostics,
              InterpreterOptions options = {}, MachineState state = {});
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// Returns the next block of the program; the last one is Action::Kind::end. A line with an error
  /// is reported once and gives no block. Reading goes on after it; what it leaves open is unknown
  /// (Modal::unknown), and what depends on that is not reported.
  std::optional<Block> next();

  /// Sets whether lines that begin with '/' are passed over, and M01 stops, of the lines that
  /// follow.
  void set_switches(bool block_skip, bool optional_stop) noexcept {
    options_.block_skip = block_skip;
    options_.optional_stop = optional_stop;
    parser_.set_block_skip(block_skip);
  }

  /// Returns the files that have been called so far.
  std::vector<FoundFile> called_files() const { return flow_.called_files(); }
  /// Returns the paths under which calls have found no file.
  const std::set<std::string>& missing_files() const noexcept { return flow_.missing_files(); }

  /// Returns whether next() has returned nothing because a pipe has nothing more yet, so that it
  /// may be called again when there is more; because a probing move waits for its answer; or
  /// because a stop has been requested.
  bool waiting() const noexcept { return parser_.waiting() || modal_.awaited; }
  /// Returns the probing move that waits for an answer; null: none. All blocks before it have been
  /// returned.
  const ProbeRequest* probe() const noexcept {
    return modal_.awaited && !out_.has_block() ? &modal_.awaited->request : nullptr;
  }
  /// Takes what the machine has found; lines that follow begin where it rests. A move that had to
  /// find something and has not is an error of its line: SC2393, SC2394.
  void probed(const ProbeAnswer& answer);

  /// Returns offsets, tools and parameters as the lines read so far leave them; at the end, what is
  /// to be kept.
  const MachineState& state() const noexcept { return modal_.state; }
  const Coordinates& coordinates() const noexcept { return modal_.coordinates; }

  /// Returns what the lines before the first one with an error have left, where the options ask
  /// for it.
  const Memory& memory() const noexcept { return memory_; }

  /// Returns the stocks that the lines read so far have stated.
  const std::vector<StockOutline>& stocks() const noexcept { return stated_stock_.outlines(); }

 private:
  bool read_on();
  void begin_with(const Memory& memory);
  void remember();
  bool choose_format();
  bool choose_dialect();
  void use_dialect(Dialect dialect);
  const ProgramLine& with_lengths(const ProgramLine& line);
  void report_at_end();
  void define(const Definition& definition);
  void interpret(const ProgramLine& line);
  /// Returns the motion in force on a line with G80.
  const GCode* after_g80() const noexcept;
  void find_motion();
  void check_axes();
  void check_axis_codes();
  bool fanuc_goes_to_machine_point() const noexcept;
  void check_unused();
  void execute();
  bool has_unknown_operand(const GCode& code) const noexcept;
  void act(Task& task);
  void skip(Task& task);
  void keep_input();
  void keep_probed_point();
  void state_stock(const ProgramLine& line);
  void leave_curve();
  void lose_motion() noexcept;
  void leave_contour();
  bool emit_restored(const ProgramLine& next);
  bool begins_data_input() const noexcept;
  void read_unreachable();
  void warn_of_refused();
  void finish();

  Parser& parser_;
  const Machine& machine_;
  Diagnostics& diagnostics_;
  InterpreterOptions options_;
  DialectDifferences differences_;
  Output out_;
  Modal modal_;
  ModalVariables variables_;
  SavedLevels levels_;
  Flow flow_;
  std::vector<GCode> machine_codes_;
  Command command_;
  IntegerLengths lengths_;
  std::optional<CommandFile> commands_;  // where the text is not G-code
  bool entering_data_ = false;           // up to G11 lines are passed over
  Memory memory_;
  StatedStock stated_stock_;
  std::optional<ProgramLine> next_;  // waits for what its blocks come after
};

}  // namespace softcnc::ipr
