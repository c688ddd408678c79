// SPDX-License-Identifier: MIT
// The lines of a program in the order in which they are executed: loops, branches, jumps and calls.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "ipr/flow/skipped_lines.hpp"
#include "ipr/parser/library.hpp"
#include "ipr/parser/parser.hpp"

namespace softcnc::ipr {

/// An observer that learns where calls begin and end.
class CallObserver {
 public:
  virtual ~CallObserver() = default;

  virtual void begin_call() = 0;
  /// Is called at the end of a call; `pos` is the place of what ends it.
  virtual void end_call(const SourcePos& pos) = 0;
  /// Is called where the called program is missing: nothing that it would have done is known.
  virtual void miss_call() = 0;
};

struct FlowOptions {
  Folders folders;                   // where called files lie
  CalledTexts* called = nullptr;     // where their texts are kept; must outlive the flow
  int block_limit = 2'000'000;       // lines that one loop, or one call with all it calls, may run
  CallObserver* observer = nullptr;  // must outlive the flow
  bool unreachable_too = false;      // remember which lines are not run
};

/// A jump that a code asks for. It is done after the line of the code.
struct Jump {
  enum class Kind : std::uint8_t { call, call_macro, call_lines, leave };
  Kind kind = Kind::call;
  int number = 0;                  // of the program called, or of its first line
  std::string name;                // the same of one that is called by name
  int times = 1;                   // how often it runs
  std::optional<int> line_number;  // N at which to go on
  std::vector<double> arguments;   // of a macro: #1 and up
  SourcePos pos;
};

class Flow {
 public:
  /// The largest number of calls within each other.
  static constexpr std::size_t kMaxDepth = 64;
  /// The largest number of loops and branches within each other, over all calls.
  static constexpr std::size_t kMostLevels = 10'000;

  /// Makes the flow of a program. Everything referred to must outlive it. Requires that the parser
  /// has not read a line.
  Flow(Parser& parser, Diagnostics& diagnostics, FlowOptions options);

  /// Returns the next line that has words or is broken; nothing at the end of the program, and
  /// while the parser waits for a pipe.
  std::optional<ProgramLine> next();
  /// Requests a jump before the next line; `text` is that of the line that asks for it.
  void jump(Jump jump, std::string_view text);
  /// Makes unknown what a called program might have changed that is missing, which has been
  /// reported. `has_level` says that it would have had variables of its own.
  void miss_call(bool has_level);
  /// Counts the blocks that a line has made in addition to its first: each counts as a line.
  void count_more_blocks(std::int64_t blocks) noexcept {
    executed_ += blocks;
    made_since_jump_ += blocks;
  }
  /// Reports what is still open at the end of the program.
  void finish();
  /// Begins to read the lines of the program's file that have not been run: first the subprograms
  /// that nothing has called, then the lines that have been skipped. Requires a call of finish()
  /// before, and FlowOptions::unreachable_too.
  void begin_unreachable();
  /// Returns the next unreachable line that has words or is broken; nothing at their end. The
  /// values of variables are unknown there.
  std::optional<ProgramLine> next_unreachable();

  /// Returns whether the flow is inside a subprogram.
  bool in_subprogram() const noexcept { return calls_.size() > 1; }
  /// Returns whether an error that has been reported ends the program.
  bool broke_off() const noexcept { return broken_ || parser_.broke_off(); }
  /// Records that an error has left open which lines are executed, or whether the program has
  /// ended.
  void lose_order() noexcept;
  bool order_unknown() const noexcept { return order_unknown_; }
  /// Returns whether the program has ended with an M99 that would start it again without end, which
  /// has been reported.
  bool ended_by_repeat() const noexcept { return ended_by_repeat_; }
  const Parameters& parameters() const noexcept { return parser_.parameters(); }
  /// Returns the files that have been called.
  std::vector<FoundFile> called_files() const { return library_.files(); }
  /// Returns the paths under which no called file has been found.
  const std::set<std::string>& missing_files() const noexcept { return library_.missing_files(); }

 private:
  using Kind = Statement::Kind;

  /// A loop or a branch that has begun and not ended.
  struct Open {
    Kind kind = Kind::none;
    std::string label;
    SourcePos pos;
    std::string text;         // of the line that began it
    Spot round;               // where a round begins
    std::optional<Spot> end;  // after it, once that is known
    std::int64_t rounds = 0;  // of a repeat: how many are left
    std::int64_t since = 0;   // executed_ at its beginning
    bool had_else = false;
  };
  /// The main program, or a call.
  struct Call {
    Subprogram sub;
    Spot back;                  // where to go on after it
    std::optional<Spot> entry;  // where it begins, if that is not its beginning
    SourcePos pos;              // of the call
    std::string text;
    std::size_t opens = 0;   // those of its callers
    int times = 1;           // how often it runs yet, this time included
    bool has_level = false;  // of variables
    std::vector<double> arguments;
    std::int64_t since = 0;
  };

  /// The target of a jump, and its origin.
  struct Landing {
    SourcePos pos;  // of the jump
    std::string text;
    Spot spot;
    std::size_t level = 0;  // of calls
  };
  static constexpr std::size_t kMostLandings = 32;

  // flow.cpp
  void remember(const ProgramLine& line);
  void remember_end();
  void note_unread(const ProgramLine& line);
  bool is_stopped() const noexcept;
  bool obey(const ProgramLine& line);
  void take(const ProgramLine& line);
  void obey();
  bool go(const Spot& spot);
  void end_text();
  void report(Code code, SourcePos pos, std::string message);
  bool repeats_endlessly() const noexcept;
  void report_structure(const std::string& label, Code code, SourcePos pos, std::string message,
                        std::string_view text);
  void break_off(Code code, SourcePos pos, std::string message, std::string_view text);
  void sought_in_vain(const Spot& from, const SourcePos& pos);
  bool runs_too_long(std::int64_t lines, const std::string& what, SourcePos pos,
                     std::string_view text);

  // flow_calls.cpp
  void report_sub_again(const std::string& label, SourcePos pos, std::string_view text);
  void pass_definition();
  void end_definition(const Spot& from, const std::optional<Spot>& next);
  void begin_program();
  void call();
  std::optional<Subprogram> find(const std::string& label, bool program, const SourcePos& call);
  void jump_now();
  void enter_lines(Jump jump);
  bool begin_at(int number, const SourcePos& pos);
  std::string program_in_work() const;
  void enter(Subprogram sub, Jump jump, bool has_level);
  void start(bool keeps_variables = false);
  void leave_by_statement();
  void leave_by_code(const Jump& jump);
  void leave(std::optional<double> value, const SourcePos& pos);
  bool go_to_line(int number, const SourcePos& pos);
  bool find_line(int number, int last);
  void land(const SourcePos& pos);
  std::vector<Landing>::iterator landing_of(const SourcePos& pos);
  void go_back(const Spot& from, const Spot& to, const SourcePos& pos);

  // unreachable_lines.cpp
  std::optional<ProgramLine> next_uncalled();
  bool go_to_uncalled(const Subprogram& sub);
  bool ends_uncalled(const ProgramLine& line) const;
  void check_order(const ProgramLine& line);
  void close(Kind begin);
  std::optional<ProgramLine> read_unreachable();
  std::optional<ProgramLine> next_skipped();
  bool go_to(const SkippedLines::Stretch& stretch);

  // flow_loops.cpp
  static bool ends(const Statement& statement, const Open& open);
  void open(Kind kind, Spot round);
  Open* opened(Kind begin);
  void close_within(const Open& open, bool reports);
  void report_open(const Open& open);
  void report_open_from(std::size_t first);
  void report_crossed(std::size_t first);
  void report_after_else(const Statement& branch, std::string_view text);
  void report_not_begun();
  const Landing* jump_into(Kind begin);
  bool leads_into(const Landing& landing, Kind begin, const Spot& here);
  bool is_open_already();
  bool is_too_deep();
  void pass_top();
  bool pass_to_end(const Open& open);
  void begin_branch();
  void find_branch();
  void next_branch();
  void end_branch();
  bool holds() const;
  void begin_or_repeat();
  bool has_loop_number();
  void begin_loop();
  void end_loop();
  void begin_round();
  void next_round_or_leave();

  // flow_search.hpp
  template <typename Wanted>
  bool pass_to(Wanted wanted);

  static constexpr std::size_t kMostTargets = 1000;

  Parser& parser_;
  Diagnostics& diagnostics_;
  FlowOptions options_;
  Library library_;
  std::vector<Call> calls_;  // the main program first
  std::vector<Open> opens_;  // of all calls
  std::optional<Jump> jump_;
  std::vector<Landing> landings_;   // of the last jumps, the latest last
  Statement statement_;             // in work
  std::string text_;                // of its line, or of the one that asked for a jump
  Spot head_;                       // before it
  bool order_unknown_ = false;      // after an error: which lines are executed
  bool structure_unknown_ = false;  // nor what is open
  bool line_numbers_unknown_ = false;
  int errors_before_ = 0;                    // reported before the line in work was read
  std::set<std::pair<int, int>> erroneous_;  // file and line of statements with errors
  std::set<std::string> unknown_labels_;  // of which something is missing, which is reported once
  std::set<std::string> missing_;         // labels of subprograms that are, which is reported once
  Spot before_;                           // before the line that pass_to() has found
  bool new_round_ = false;                // the next line is the head of the loop on top
  bool ended_ = false, broken_ = false;
  std::set<int> entered_;             // after which lines of the program calls have begun
  std::vector<Subprogram> uncalled_;  // still to be read, the first in work
  bool reading_uncalled_ = false;
  bool moved_ = false;    // the next line is not the one after the last
  SkippedLines skipped_;  // of the program's own file
  std::set<int> leaves_;  // lines of the file that end it, or a subprogram, by a code
  std::deque<SkippedLines::Stretch> unread_;  // still to be read, the first in work
  bool reading_stretch_ = false;
  bool rest_is_program_ = false;  // what follows the end may be of the program
  bool decided_ = false;          // since the program began: its order depends on values
  bool ended_by_repeat_ = false;
  int program_line_ = 0;                                // of the main program's own O
  std::int64_t executed_ = 0;                           // lines
  std::int64_t jumped_back_ = 0;                        // lines, by GOTO
  std::int64_t made_since_jump_ = 0;                    // blocks of cycles, since the last one back
  std::int64_t vain_ = 0;                               // lines passed to find what is missing
  std::map<std::tuple<int, int, int>, Spot> backward_;  // targets of GOTO: by file, line and number
  std::map<std::tuple<int, int, int>, Spot> called_lines_;  // of M97, likewise
};

}  // namespace softcnc::ipr
