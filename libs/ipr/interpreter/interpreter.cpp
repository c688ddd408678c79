// SPDX-License-Identifier: MIT
// Reads a line, finds what it means by the modes in force, and lets its codes act.
#include "ipr/interpreter/interpreter.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/dialects/dialect_guess.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/lines/beyond_grbl.hpp"
#include "ipr/lines/operands.hpp"
#include "motion/model/subprogram_path.hpp"

namespace softcnc::ipr {
namespace {

constexpr LetterSet kActing{"GM"};         // of codes that take words
constexpr LetterSet kOtherAxes{"ABCUVW"};  // which no machine of softcnc has

/// The first word of these letters on the line.
const Word* first_of(const Values& values, LetterSet letters) noexcept {
  const Word* first = nullptr;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (!letters.has(letter) || !values.has(letter)) continue;
    const Word& word = values.word(letter);
    if (first == nullptr || word.pos.column < first->pos.column) first = &word;
  }
  return first;
}

std::string lacks_axis(char letter) {
  std::string message = "the machine has no axis ";
  message += letter;
  return message;
}

/// All of them in one: it may be their code that is missing.
std::string used_by_none(LetterSet letters) {
  std::string names;
  int count = 0;
  for (char letter = 'Z'; letter >= 'A'; --letter) {
    if (!letters.has(letter)) continue;
    names.insert(0, count == 0 ? "" : count == 1 ? " and " : ", ").insert(0, 1, letter);
    ++count;
  }
  return (count > 1 ? "unused words " : "unused word ") + names;
}

/// Among parameters and their values there are no codes.
[[gnu::cold]] bool is_data(const ProgramLine& line) noexcept {
  return std::none_of(line.words.begin(), line.words.end(),
                      [](const Word& word) { return kActing.has(word.letter); });
}

/// Along which points differ from the first.
Unknown axes_of(const std::vector<AxisVector>& points) noexcept {
  Unknown axes;
  for (const AxisVector& point : points)
    for (int axis = 0; axis < kAxes; ++axis)
      if (point[axis] != points.front()[axis]) axes.add(position_part(axis));
  return axes;
}

Folders folders_of(const InterpreterOptions& options, const ProgramReading& reading) {
  Folders folders{options.folder};
  const std::vector<std::string> of_machine = subprogram_path(reading);
  folders.insert(folders.end(), options.subprogram_folders.begin(),
                 options.subprogram_folders.end());
  folders.insert(folders.end(), of_machine.begin(), of_machine.end());
  return folders;
}

bool is_straight(const GCode& code) noexcept { return code.letter == 'G' && code.number <= kG01; }

}  // namespace

Interpreter::Interpreter(Parser& parser, const Machine& machine, Diagnostics& diagnostics,
                         InterpreterOptions options, MachineState state)
    : parser_(parser),
      machine_(machine),
      diagnostics_(diagnostics),
      options_(options),
      differences_(diagnostics, options.dialect, options.compare_dialects),
      out_(diagnostics, differences_),
      variables_(modal_, machine, options.dialect),
      levels_(modal_),
      flow_(parser, diagnostics,
            {folders_of(options_, machine.program), options_.called, machine.program.block_limit,
             &levels_, options_.unreachable_too}),
      machine_codes_(machine_codes(machine)),
      lengths_(machine.program.integers) {
  modal_.state = std::move(state);
  modal_.position = modal_.state.place();
  modal_.update_coordinates();
  modal_.corner_tolerance = modal_.chord_tolerance = machine.control.corner_tolerance;
  parser_.reader().set_stop(options.stop);
  command_.set_machine_codes(machine_codes_);
  use_dialect(options.memory != nullptr ? options.memory->dialect : options.dialect);
  if (options.memory != nullptr) begin_with(*options.memory);
  options_.memory = nullptr;
  remember();
}

void Interpreter::begin_with(const Memory& memory) {
  modal_ = memory.modal;
  parser_.parameters() = memory.parameters;
  parser_.parameters().set_system(&variables_);
  options_.format = memory.format;
  options_.guess_dialect = options_.guess_dialect && memory.format == Format::automatic;
}

void Interpreter::remember() {
  if (!options_.remembers || diagnostics_.errors() > 0 || modal_.awaited) return;
  const bool is_known = parser_.line() > 0 || commands_;
  memory_ = {modal_, parser_.parameters(), options_.dialect,
             is_known && !commands_ ? Format::gcode : options_.format};
}

/// Before the first line.
void Interpreter::use_dialect(Dialect dialect) {
  options_.dialect = dialect;
  differences_.set_dialect(dialect);
  variables_.set_dialect(dialect);
  parser_.configure({dialect, options_.block_skip, &differences_});
  parser_.parameters().set_system(&variables_);
  if (is_linuxcnc_like(dialect)) parser_.parameters().keep(modal_.state.parameters);
  parser_.parameters().keep(modal_.state.globals);
  if (dialect == Dialect::grbl) modal_.motion = find_gcode('G', 0);
  if (options_.guess_dialect) return;  // it may be another one
  for (const Definition& definition : options_.definitions) define(definition);
}

/// By what the program shows of it. False: what a pipe has given so far is not enough.
bool Interpreter::choose_dialect() {
  Reader& reader = parser_.reader();
  reader.do_not_wait();
  const DialectGuess guess = guess_dialect(reader);
  if (reader.waiting()) return false;
  options_.guess_dialect = false;
  const auto dialect = guess.dialect();
  use_dialect(dialect.value_or(options_.dialect));
  const std::string chosen =
      "the program is read in the " + std::string(name(options_.dialect)) + " dialect; ";
  if (dialect)
    diagnostics_.report(Code::SC1058, {guess.line(), 0, 1}, chosen + guess.mark() + " shows it",
                        guess.text());
  else
    diagnostics_.report(Code::SC1058, {}, chosen + "its first lines show no other");
  diagnostics_.release();  // before what is reported of that line
  diagnostics_.hold();
  return true;
}

void Interpreter::define(const Definition& definition) {
  if (parser_.parameters().define(definition.name, definition.value)) return;
  const std::string shown = shown_name(definition);
  diagnostics_.report({.code = Code::SC2318,
                       .message = shown +
                                  " cannot be defined: it is no variable that outlives calls "
                                  "and belongs to programs",
                       .file = "--define"});
}

/// Before the first line: G-code is read here, commands by their own reader. False: what a pipe has
/// given so far does not show which they are.
bool Interpreter::choose_format() {
  Reader& reader = parser_.reader();
  if (options_.format == Format::automatic) {
    reader.do_not_wait();
    const Format format = detect_format(reader);
    if (reader.waiting()) return false;
    options_.format = format;
  }
  if (options_.format == Format::commands)
    commands_.emplace(reader, machine_, diagnostics_, modal_.state.place());
  return commands_ || !options_.guess_dialect || choose_dialect();
}

[[gnu::hot]] std::optional<Block> Interpreter::next() {
  diagnostics_.hold();
  const bool found = read_on();
  diagnostics_.release();
  if (!found) return std::nullopt;
  return commands_ ? commands_->take() : out_.pop();
}

/// Reads lines until one has made a block; false at the end, and where the next is still to come.
bool Interpreter::read_on() {
  if (!commands_ && parser_.line() == 0 && !choose_format()) return false;
  if (commands_) remember();
  if (commands_) return commands_->read_on();
  for (;;) {
    if (out_.has_block()) return true;
    remember();  // only now: what is made of the blocks before may be refused
    if (modal_.ended || modal_.awaited) return false;
    if (next_)
      interpret(*std::exchange(next_, std::nullopt));
    else if (const auto line = flow_.next(); line && !emit_restored(*line))
      interpret(*line);
    else if (next_)
      continue;
    else if (waiting())
      return false;
    else
      finish();
  }
}

/// Emits what the end of a call has restored, as if on a line before `next`. A curve whose lines
/// are counted, or end by a code of their own, goes on; the spline of G06.1 ends here.
bool Interpreter::emit_restored(const ProgramLine& next) {
  if (!modal_.restored || modal_.curve) return false;
  Restored restored = *modal_.restored;
  ProgramLine line;
  line.number = restored.pos.line;
  out_.begin(line);
  if (modal_.points) {
    std::swap<Modes>(modal_, restored.before);
    std::swap(modal_.placement, restored.placement);
    end_pending_spline(modal_, out_);
    std::swap(modal_.placement, restored.placement);
    std::swap<Modes>(modal_, restored.before);
    if (modal_.points) return false;
  }
  modal_.restored.reset();
  follow_restored(restored.before, modal_, out_, restored.pos);
  out_.end();
  next_ = next;
  return true;
}

/// As the fanuc and haas dialects count them.
const ProgramLine& Interpreter::with_lengths(const ProgramLine& line) {
  const bool in_cycle = modal_.motion != nullptr && is_canned_cycle(*modal_.motion);
  const char angle = axis_letter(plane_axes(modal_.plane).second);
  const bool haas = options_.dialect == Dialect::haas;
  return lengths_.read(
      line, {modal_.mm_per_unit, in_cycle, modal_.curve.has_value(), modal_.polar, angle, haas});
}

[[gnu::hot]] void Interpreter::interpret(const ProgramLine& line) {
  if (entering_data_) {
    entering_data_ = is_data(line);
    if (entering_data_) return;
  }
  out_.begin(line);
  if (!line.stock.empty()) state_stock(line);
  command_.read(is_fanuc_like(options_.dialect) ? with_lengths(line) : line, options_.dialect,
                out_);
  if (options_.dialect == Dialect::grbl) note_beyond_grbl(line, out_);
  if (modal_.ended) return warn_of_refused();  // it is only read
  modal_.unknown |= command_.unknown();
  if (command_.unknown().has(Part::end)) flow_.lose_order();
  const bool in_curve = modal_.curve || modal_.points;
  if (command_.probes()) parser_.parameters().lose_probed_point();
  if (line.broken) out_.fail();
  if (out_.failed()) leave_curve();
  if (modal_.curve) check_pending_curve(command_, options_.dialect, modal_, out_);
  if (modal_.points) check_pending_points(command_, modal_, out_);
  if (out_.failed()) leave_curve();
  if (command_.has_polar_words()) begin_polar_words(command_, modal_, out_);
  if (!command_.has(Group::motion)) find_motion();
  if (!modal_.curve && !modal_.points) command_.add_lone_letters(options_.dialect);
  check_axes();
  if (command_.has(Group::non_modal) || command_.has(Group::tool_length) ||
      command_.has(Group::scaling) || command_.has(Group::rotation))
    check_axis_codes();
  check_unused();
  if (out_.in_corner() && !out_.failed()) check_pending_corner(command_, modal_, out_);
  execute();
  if (command_.corner() != nullptr) ask_for_corner(command_, modal_, out_);
  modal_.unknown |= command_.unknown();
  if (out_.failed()) {
    leave_curve();
    if (in_curve) lose_motion();
    if (command_.has(Group::motion)) leave_contour();
  }
  out_.end();
  if (!modal_.ended) return;
  flow_.finish();
  read_unreachable();
  report_at_end();
}

/// Before what else the line says: comments mostly stand alone.
[[gnu::cold]] void Interpreter::state_stock(const ProgramLine& line) {
  if (line.broken || modal_.ended) return;
  const int column = static_cast<int>(line.stock.data() - line.text.data());
  const int length = static_cast<int>(line.stock.size()) + 2;
  stated_stock_.add(line.stock, {line.number, column, length, parser_.file()}, modal_, machine_,
                    out_);
}

/// A curve over several lines of which one has an error: whether it goes on is not known.
[[gnu::cold]] void Interpreter::leave_curve() {
  if (!modal_.curve && !modal_.points) return;
  modal_.unknown |= axes_of(modal_.curve ? modal_.curve->spec.control : modal_.points->points);
  modal_.unknown |= set_by(command_.values().letters());
  modal_.curve.reset();
  modal_.points.reset();
  lose_motion();
}

void Interpreter::lose_motion() noexcept {
  modal_.motion = nullptr;
  modal_.unknown.add(Part::motion);
}

/// A contour of which a move is missing.
[[gnu::cold]] void Interpreter::leave_contour() {
  if (!out_.compensating()) return;
  out_.stop_compensation();
  modal_.cutter.reset();
  modal_.unknown.add(Part::cutter);
}

/// There G53 is a rapid, whatever motion is in force.
bool Interpreter::fanuc_goes_to_machine_point() const noexcept {
  const GCode* code = command_.find(Group::non_modal);
  return is_fanuc_like(options_.dialect) && code != nullptr && code->number == kG53;
}

const GCode* Interpreter::after_g80() const noexcept {
  return is_fanuc_like(options_.dialect) ? modal_.motion_below : nullptr;
}

/// Words that no code of the line takes may be meant for the motion in force.
void Interpreter::find_motion() {
  const LetterSet unused = command_.unused(options_.dialect);
  if (unused.empty() || has_hole_pattern(command_)) return;
  if (modal_.unknown.has(Part::motion)) return follow_axes(command_, modal_, unused);
  const GCode* motion = command_.has(Group::cycle) ? after_g80() : modal_.motion;
  if (motion == nullptr && fanuc_goes_to_machine_point()) motion = find_gcode('G', 0);
  if (motion != nullptr && unused.has_any(motion->words))
    return command_.add_modal_motion(*motion, *first_of(command_.values(), motion->words));
  if (motion != nullptr || !unused.has_any(kAxisWords)) return;
  const Word& word = *first_of(command_.values(), kAxisWords);
  out_.report(Code::SC2101, word.pos,
              std::string(1, word.letter) + " with no motion code in force");
  modal_.unknown.add(Part::motion);
  modal_.unknown |= set_by(unused);
}

/// FANUC's G10 L50 and L52, which are refused: up to G11 lines hold parameters and their values.
bool Interpreter::begins_data_input() const noexcept {
  const GCode* code = command_.find(Group::non_modal);
  const double what = command_.values().value_or('L', 0);
  const bool refused = what == 50 || what == 52;
  return refused && is_fanuc_like(options_.dialect) && code != nullptr && code->number == kG10;
}

void Interpreter::check_axes() {
  const Values& values = command_.values();
  for (std::size_t i = 0; i < kAxes; ++i) {
    const char letter = kAxisLetters[i];
    if (machine_.axes[i].present || !values.has(letter)) continue;
    out_.report(Code::SC2008, values.word(letter).pos, lacks_axis(letter));
  }
}

/// A coordinate is a place to go to, or the value of an offset.
void Interpreter::check_axis_codes() {
  entering_data_ = begins_data_input();
  const GCode* user = nullptr;
  for (const auto& [code, word] : command_.codes()) {
    if (!LetterSet(code->words).has_any(kAxisWords)) continue;
    if (is_straight(*code) && fanuc_goes_home(command_, options_.dialect)) continue;
    if (is_canned_cycle(*code) && has_hole_pattern(command_)) continue;
    if (user != nullptr) {
      out_.report(Code::SC2110, word->pos,
                  code_name(*code) + " beside " + code_name(*user) + ": both take the axes");
      modal_.unknown |= results(*user, command_);
      modal_.unknown |= results(*code, command_);
    }
    user = code;
  }
}

/// Where a line has failed, or the motion in force is not known, other codes might take them.
void Interpreter::check_unused() {
  const LetterSet unused = command_.unused(options_.dialect);
  if (unused.empty() || out_.failed()) return;
  if (modal_.unknown.has(Part::motion) && !command_.has(Group::motion)) return;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (unused.has(letter) && kOtherAxes.has(letter))
      out_.report(Code::SC2008, command_.values().word(letter).pos, lacks_axis(letter));
  if (const Word* first = first_of(command_.values(), unused.without(kOtherAxes)))
    out_.report(Code::SC2004, first->pos, used_by_none(unused.without(kOtherAxes)));
}

void Interpreter::execute() {
  for (const auto& [code, word] : command_.codes()) {
    Task task{*code, *word, command_, command_.values(), machine_, options_, modal_, out_, flow_};
    if ((out_.compensating() || modal_.beside) && !may_act(task)) continue;
    if (modal_.placement && !may_be_transformed(task)) {
      skip(task);
      continue;
    }
    act(task);
  }
  modal_.machine_coordinates = modal_.stops_once = false;
  if (modal_.input_value) keep_input();
  if (modal_.probed) keep_probed_point();
}

/// In the work system in force, in units of the program.
void Interpreter::keep_probed_point() {
  const ProbedPoint probed = *std::exchange(modal_.probed, std::nullopt);
  const AxisVector place = modal_.coordinates.to_program(probed.place) / modal_.mm_per_unit;
  parser_.parameters().keep_probed_point({place[0], place[1], place[2]}, probed.contact);
}

void Interpreter::probed(const ProbeAnswer& answer) {
  const AwaitedProbe awaited = *std::exchange(modal_.awaited, std::nullopt);
  modal_.position = answer.rest;
  if (answer.refusal)
    return diagnostics_.report(answer.refusal->code, awaited.word, answer.refusal->message,
                               awaited.line);
  if (auto refused = refusal_of(*awaited.code, answer.found, options_.dialect)) {
    diagnostics_.report(refused->code, awaited.word, std::move(refused->message), awaited.line);
    return;
  }
  const bool contact = answer.found != ProbeFound::nothing;
  modal_.probed = ProbedPoint{contact ? answer.place : answer.rest, contact};
  keep_probed_point();
  remember();
}

/// What M66 has read is in #5399 of the linuxcnc dialect; fanuc has no such variable.
void Interpreter::keep_input() {
  const double value = *std::exchange(modal_.input_value, std::nullopt);
  constexpr int kInput = 5399;
  if (is_linuxcnc_like(options_.dialect)) parser_.parameters().write(kInput, value);
}

/// A code that is refused is so whatever its words.
bool Interpreter::has_unknown_operand(const GCode& code) const noexcept {
  if (command_.unread().empty() && modal_.unknown.empty()) return false;
  if (is_refused(code)) return false;
  return command_.unread().has_any(code.words) ||
         modal_.unknown.has_any(operands(code, command_, modal_));
}

/// The one rule of errors: see Unknown.
void Interpreter::act(Task& task) {
  const GCode& code = task.code;
  if (has_unknown_operand(code)) {
    const bool begins = code.group == Group::motion && !is_curve_of_lines(code);
    if (begins) begin_motion(task);
    if (begins) modal_.unknown = modal_.unknown.without(settled(code));
    return skip(task);
  }
  if (!modal_.unknown.empty()) modal_.unknown = modal_.unknown.without(settled(code));
  if (code.act == nullptr) return;
  const int errors = out_.errors();
  const AxisVector position = modal_.position;
  const bool polar = modal_.polar || command_.has_polar_words();
  if (polar && code.group == Group::motion && !resolve_polar_words(task, command_))
    begin_motion(task);
  else
    code.act(task);
  if (out_.errors() == errors) return;
  modal_.position = position;
  skip(task);
}

/// A code that cannot act, or has reported an error; of a move it may be known where it ends.
[[gnu::cold]] void Interpreter::skip(Task& task) {
  if (task.code.act == read_input) modal_.input_value = kUnknown;
  Unknown parts = results(task.code, command_);
  if (task.code.group == Group::motion && follow_unmade_move(task))
    parts = parts.without(kPosition);
  modal_.unknown |= parts;
}

/// Reports what reading alone finds in lines that are never run.
[[gnu::cold]] void Interpreter::read_unreachable() {
  if (!options_.unreachable_too) return;
  out_.close();
  flow_.begin_unreachable();
  while (const auto line = flow_.next_unreachable()) interpret(*line);
}

/// On a line that is only read: another program or another value may lead there.
[[gnu::cold]] void Interpreter::warn_of_refused() {
  if (out_.failed()) return;
  out_.set_unreachable(true);
  for (const auto& [code, word] : command_.codes()) {
    if (!is_refused(*code)) continue;
    Task task{*code, *word, command_, command_.values(), machine_, options_, modal_, out_, flow_};
    code->act(task);
  }
  out_.set_unreachable(false);
}

/// The text has ended without M02 or M30.
void Interpreter::finish() {
  flow_.finish();
  ProgramLine line;
  line.number = parser_.line();
  out_.begin(line);
  const bool broke_off = flow_.broke_off();
  if (modal_.curve && !broke_off) end_pending_curve(modal_, out_);
  if (modal_.points && !broke_off) end_pending_points(modal_, out_);
  const bool ends_here = !broke_off && !modal_.unknown.has(Part::end) && !flow_.order_unknown();
  if (ends_here && flow_.ended_by_repeat())
    out_.leave_corner();
  else if (ends_here && out_.in_corner())
    out_.leave_corner(Code::SC2263, "the program ends");
  if (ends_here && !flow_.ended_by_repeat())
    out_.report(Code::SC2205, {line.number, 0, 1}, "the program ends without M02 or M30");
  out_.end();
  out_.begin(line);
  out_.stop_compensation();
  out_.emit(Action{Action::Kind::end, 30, 0});
  modal_.ended = true;
  read_unreachable();
  report_at_end();
}

/// What is reported once, with the number of its lines.
void Interpreter::report_at_end() {
  parser_.report_sender_lines();
  lengths_.report(diagnostics_);
  differences_.report();
}

}  // namespace softcnc::ipr
