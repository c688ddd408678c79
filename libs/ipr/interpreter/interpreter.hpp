// SPDX-License-Identifier: MIT
// Lines to blocks, one at a time.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "ipr/codes/command.hpp"
#include "ipr/commands/command_file.hpp"
#include "ipr/commands/format.hpp"
#include "ipr/expressions/dialect.hpp"
#include "ipr/flow/flow.hpp"
#include "ipr/interpreter/modal.hpp"
#include "ipr/interpreter/modal_variables.hpp"
#include "ipr/interpreter/output.hpp"
#include "ipr/interpreter/saved_modes.hpp"
#include "ipr/parser/parser.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipr {

struct InterpreterOptions {
  bool block_skip = false;     // leave out lines that begin with '/'
  bool optional_stop = false;  // M01 stops
  Dialect dialect = Dialect::linuxcnc;
  Format format = Format::automatic;
  bool compare_dialects = false;  // warn where a line means something else in the other one
  bool unrun_too = false;         // read lines that are never run as well, for their errors
  std::string folder = {};        // where files lie that the program calls; empty: it can call none
  CalledTexts* called = nullptr;  // where their texts are kept; must outlive the interpreter
  std::stop_token stop = {};      // to read no further: waiting() then
  RefusedMoves* refused_moves = nullptr;    // is shown them
  std::map<int, int>* lines_run = nullptr;  // takes how often each of the program itself is
  std::set<int>* lines_in_doubt = nullptr;  // and those of them of which something is not known
};

class Interpreter {
 public:
  /// What is referred to must outlive the interpreter. `state`: what earlier programs left behind.
  Interpreter(Parser& parser, const Machine& machine, Diagnostics& diagnostics,
              InterpreterOptions options = {}, MachineState state = {});
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// The next block of the program, the last being Action::Kind::end. Lines with an error are
  /// reported and give no block; reading goes on behind them, and what is wrong only as a
  /// consequence is not reported.
  std::optional<Block> next();

  /// Files that have been called so far: their names in the folder.
  std::vector<std::string> called_files() const { return flow_.called_files(); }
  /// Names in the folder under which calls have found none.
  const std::set<std::string>& missing_files() const noexcept { return flow_.missing_files(); }

  /// Whether next() has given nothing because a pipe has nothing more yet, and may be asked again
  /// when it has; or because a stop has been requested.
  bool waiting() const noexcept { return parser_.waiting(); }

  /// Offsets and the like as the lines read so far leave them; at the end, what is to be kept.
  const MachineState& state() const noexcept { return modal_.state; }

 private:
  bool read_on();
  bool choose_format();
  void interpret(const Line& line);
  /// The motion in force on a line with G80.
  const GCode* behind_g80() const noexcept;
  void end_all_the_same(const Line& line);
  void find_motion();
  void check_axes();
  void check_axis_codes();
  bool fanuc_goes_to_machine_point() const noexcept;
  bool tell_never_used(Letters unused);
  void look_for_unused(const Line& line);
  bool check_unused(const Line& line);
  bool is_told_already(const Line& line, Letters unused);
  bool tool_may_be_code() const noexcept;
  bool has_own_motion() const noexcept;
  void excuse_end(const Line& line);
  void doubt_missing();
  bool stands_for_word() const noexcept;
  void execute();
  void excuse_left_curve();
  void excuse_curve_of_lost_code();
  void note_doubt(const Line& line);
  void remember_uncertain(const Line& line);
  bool tell_restored(const Line& next);
  bool leads_all_the_same(const Line& line);
  bool way_is_certain() const;
  bool begins_data_input() const noexcept;
  void read_unrun();
  void finish();

  Parser& parser_;
  const Machine& machine_;
  Diagnostics& diagnostics_;
  InterpreterOptions options_;
  Contradictions contradictions_;
  Output out_;
  Modal modal_;
  ModalVariables variables_;
  SavedLevels levels_;
  Flow flow_;
  Command command_;
  std::optional<CommandFile> commands_;  // where the text is not G-code
  Letters told_unused_;                  // by the motion in force, on lines before
  bool entering_data_ = false;           // up to G11 lines are passed over
  std::optional<Line> next_;             // waits for what its blocks come behind
};

}  // namespace softcnc::ipr
