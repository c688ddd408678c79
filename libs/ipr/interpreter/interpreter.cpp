// SPDX-License-Identifier: MIT
// Reads a line, finds what it means by the modes in force, and lets its codes act.
#include "ipr/interpreter/interpreter.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ipr/codes/handlers.hpp"
#include "ipr/codes/lost_codes.hpp"

namespace softcnc::ipr {
namespace {

constexpr Letters kActing{"GM"};         // of codes that take words
constexpr Letters kOtherAxes{"ABCUVW"};  // which no machine of softcnc has

/// The first word of these letters on the line.
const Word* first_of(const Values& values, Letters letters) noexcept {
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
std::string used_by_none(Letters letters) {
  std::string names;
  int count = 0;
  for (char letter = 'Z'; letter >= 'A'; --letter) {
    if (!letters.has(letter)) continue;
    names.insert(0, count == 0 ? "" : count == 1 ? " and " : ", ").insert(0, 1, letter);
    ++count;
  }
  return names + (count > 1 ? " are" : " is") + " used by no code of this line";
}

/// Among parameters and their values there are no codes.
[[gnu::cold]] bool is_data(const Line& line) noexcept {
  return std::none_of(line.words.begin(), line.words.end(),
                      [](const Word& word) { return kActing.has(word.letter); });
}

/// Of one line, not of a row of them: G00 to G03, G05, G05.1.
bool leads_by_itself(const GCode& code) noexcept {
  constexpr int kG05 = 50, kG051 = 51;
  return is_line_or_arc(code) || code.number == kG05 || code.number == kG051;
}

/// By the codes that may be in force behind their line.
Letters taken_in_force() noexcept {
  Letters taken;
  for (const GCode& code : gcode_table())
    if (code.group == Group::motion && code.act != refuse_thread) taken |= Letters(code.words);
  return taken;
}

bool is_straight(const GCode& code) noexcept {
  constexpr int kG01 = 10;
  return code.letter == 'G' && code.number <= kG01;
}

/// `H21`, where G21 may have been meant.
[[gnu::cold]] void doubt_modes_meant(const Line& line, Letters unused, Modal& modal) noexcept {
  constexpr Groups kModes{Group::plane, Group::units, Group::distance, Group::arc_distance,
                          Group::feed_mode};
  const auto first = std::find_if(line.words.begin(), line.words.end(),
                                  [](const Word& word) { return word.letter != 'N'; });
  if (first == line.words.end() || !unused.has(first->letter)) return;
  const GCode* code = find_gcode('G', first->value);
  if (code != nullptr && kModes.has(code->group)) modal.doubt({code->group});
}

/// `B02 X1 I5`: another letter in the place of G, which is told, and whose code takes the others.
bool may_be_code_of(const Values& values, Letters unused, Letters told) noexcept {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (!unused.has(letter) || !told.has(letter)) continue;
    const GCode* code = find_gcode('G', values[letter]);
    if (code == nullptr) continue;
    return unused.without(told).without(code->words).empty();
  }
  return false;
}

/// M03 or M04 with another letter.
bool may_be_spindle(const Values& values, Letters unused) noexcept {
  constexpr double kM03 = 3, kM04 = 4;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (unused.has(letter) && (values[letter] == kM03 || values[letter] == kM04)) return true;
  return false;
}

/// Of a line of which some words could not be read.
bool may_name_knot(const Line& line, const Command& command) {
  return command.values().has('K') ||
         (line.lost.has('K') && line.text.find_first_of("Kk") != line.text.npos);
}

}  // namespace

Interpreter::Interpreter(Parser& parser, const Machine& machine, Diagnostics& diagnostics,
                         InterpreterOptions options, MachineState state)
    : parser_(parser),
      machine_(machine),
      diagnostics_(diagnostics),
      options_(options),
      contradictions_(diagnostics, options.dialect, options.compare_dialects),
      out_(diagnostics, contradictions_, options.refused_moves),
      variables_(modal_, machine, options.dialect),
      levels_(modal_),
      flow_(parser, diagnostics,
            {options_.folder, options_.called, machine.program.block_limit, &levels_,
             options_.unrun_too, options_.lines_run}) {
  modal_.state = std::move(state);
  modal_.update_coordinates();
  modal_.corner_tolerance = modal_.chord_tolerance = machine.control.corner_tolerance;
  parser_.reader().set_stop(options.stop);
  parser_.configure({options.dialect, options.block_skip, &contradictions_});
  parser_.parameters().set_system(&variables_);
  if (options.dialect == Dialect::linuxcnc) parser_.parameters().keep(modal_.state.parameters);
}

/// Before the first line: G-code is read here, commands by their own reader. False: what a pipe has
/// given so far does not tell which they are.
bool Interpreter::choose_format() {
  Reader& reader = parser_.reader();
  if (options_.format == Format::automatic) {
    reader.do_not_wait();
    const Format format = detect_format(reader);
    if (reader.waiting()) return false;
    options_.format = format;
  }
  if (options_.format == Format::commands) commands_.emplace(reader, machine_, diagnostics_);
  return true;
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
  if (commands_) return commands_->read_on();
  for (;;) {
    if (out_.has_block()) return true;
    if (modal_.ended) return false;
    if (next_)
      interpret(*std::exchange(next_, std::nullopt));
    else if (const auto line = flow_.next(); line && !tell_restored(*line))
      interpret(*line);
    else if (next_)
      continue;
    else if (waiting())
      return false;
    else
      finish();
  }
}

/// What the end of a call has restored, told as if on a line before `next`. A curve whose lines are
/// counted, or end by a code of their own, goes on; the spline of G06.1 ends here.
bool Interpreter::tell_restored(const Line& next) {
  if (!modal_.restored || modal_.curve) return false;
  Restored restored = *modal_.restored;
  Line line;
  line.number = restored.pos.line;
  out_.begin(line);
  if (modal_.points) {
    std::swap<Modes>(modal_, restored.before);
    end_pending_spline(modal_, out_);
    std::swap<Modes>(modal_, restored.before);
    if (modal_.points) return false;
  }
  modal_.restored.reset();
  follow_restored(restored.before, modal_, out_, restored.pos);
  out_.end();
  next_ = next;
  return true;
}

[[gnu::hot]] void Interpreter::interpret(const Line& line) {
  if (entering_data_) {
    entering_data_ = is_data(line);
    if (entering_data_) return;
  }
  out_.begin(line);
  command_.read(line, options_.dialect, out_);
  if (modal_.ended) return;  // it is only read
  if (command_.may_be_end()) flow_.expect_end();
  if (modal_.curve) check_pending_curve(command_, options_.dialect, modal_, out_);
  if (modal_.points) check_pending_points(command_, modal_, out_);
  if (!modal_.words_of_left_curve.empty()) excuse_left_curve();
  if (!command_.has(Group::motion)) find_motion();
  if (!modal_.curve && !modal_.points) command_.add_lone_letters(options_.dialect);
  check_axes();
  if (command_.has(Group::non_modal) || command_.has(Group::tool_length)) check_axis_codes();
  const bool unclear = line.broken || out_.failed();
  if (!command_.uncertain().has_any(kActing)) look_for_unused(line);
  if (unclear && !leads_all_the_same(line))
    out_.mute();
  else if (unclear || out_.failed())
    out_.hush(way_is_certain());
  if (unclear) out_.withhold();
  modal_.start_uncertain = modal_.uncertain.has_any(kAxisWords);
  execute();
  remember_uncertain(line);
  if (modal_.curve) note_faults(command_, modal_, out_, *modal_.curve);
  if (modal_.points) note_faults(command_, modal_, out_, *modal_.points);
  note_doubt(line);
  out_.end();
  if (line.broken && !line.may_count && means_end(line)) end_all_the_same(line);
  if (!modal_.ended) return;
  flow_.finish();
  read_unrun();
  contradictions_.tell();
}

void Interpreter::note_doubt(const Line& line) {
  if (options_.lines_in_doubt == nullptr || parser_.file() != 0) return;
  if (out_.failed() || modal_.start_uncertain || modal_.uncertain.has_any(kAxisWords))
    options_.lines_in_doubt->insert(line.number);
}

/// M3O: nobody doubts that the program ends there.
[[gnu::cold]] void Interpreter::end_all_the_same(const Line& line) {
  out_.begin(line);
  out_.stop_compensation();
  out_.emit(Action{Action::Kind::end, 30, 0});
  modal_.ended = true;
}

/// Whether what is wrong with a line has nothing to do with where its words lead.
bool Interpreter::leads_all_the_same(const Line& line) {
  const GCode* motion = command_.find(Group::motion);
  const bool known = motion != nullptr && line.lost != kAllLetters && leads_by_itself(*motion) &&
                     !command_.has(Group::non_modal) && !command_.has(Group::tool_length);
  const Letters lost = command_.uncertain();
  if (!known || lost.has('G') || lost.has_any(command_.values().letters())) return false;
  if (!is_straight(*motion)) return !lost.has_any(motion->words);
  for (const char letter : kAxisLetters)
    if (lost.has(letter)) modal_.uncertain.add(letter);
  return true;
}

/// Of a line that leads all the same: what is wrong is a word that has no part in it.
[[gnu::cold]] bool Interpreter::way_is_certain() const {
  constexpr Letters kBesideTheWay{"FMNST"};
  return command_.uncertain().without(kBesideTheWay).empty() && command_.doubted().empty() &&
         !command_.has_unknown_code() && command_.unused(options_.dialect).empty();
}

/// Blocks of a curve that was left too early: they end at a motion code that has none of their
/// words.
void Interpreter::excuse_left_curve() {
  const bool of_curve = command_.unused(options_.dialect).has_any(modal_.words_of_left_curve);
  if (of_curve) return out_.mute();
  const GCode* motion = command_.find(Group::motion);
  const bool leaves = out_.failed() || (motion != nullptr && motion->act == end_control_points);
  if (motion == nullptr || leaves) return;
  modal_.words_of_left_curve = {};
  if (motion->act != nurbs) modal_.left_curve_may_go_on = false;
}

/// `G682 P3 K0`: it may have been G06.2, whose blocks follow, with the code in each or without.
void Interpreter::excuse_curve_of_lost_code() {
  modal_.words_of_left_curve |= kWordsOfCurveBlocks;
  modal_.left_curve_may_go_on = true;
}

/// What an error leaves unknown. A motion code that could be read is known all the same.
void Interpreter::remember_uncertain(const Line& line) {
  Letters uncertain = command_.lastingly_uncertain();
  const bool within_curve = modal_.curve || modal_.points;  // whose code is the one in force
  if (command_.has(Group::motion) && (within_curve || !command_.contradicted().has(Group::motion)))
    uncertain.remove('G');
  if (uncertain.has('G')) modal_.motion = modal_.motion_below = nullptr;
  const bool code_lost = uncertain.has('G') || (command_.doubled() && !has_own_motion());
  if (code_lost && may_name_knot(line, command_)) excuse_curve_of_lost_code();
  modal_.uncertain |= uncertain;
  if (command_.has(Group::motion) && command_.doubted().has(Group::motion))
    modal_.centre_told = true;  // nobody knows whether lines behind it are arcs: `G6.G2 P3`
  const Letters unused = command_.missing().empty() ? Letters() : command_.unused(options_.dialect);
  if (!unused.empty()) doubt_modes_meant(line, unused, modal_);
  const GCode* motion = command_.find(Group::motion);
  const bool by_mode = motion != nullptr && is_line_or_arc(*motion) &&
                       command_.find_word(Group::motion).letter != 'G';
  if (by_mode &&
      unused.has_any(is_straight(*motion)
                         ? "IJKPR"
                         : "IJKR")) {  // the code of an arc, or a cycle, may be what is missing
    modal_.motion = modal_.motion_below = nullptr;
    modal_.uncertain |= "GXYZ";
  }
  const bool offsets = command_.has(Group::non_modal) && modal_.offsets_uncertain;
  if (offsets && out_.failed()) modal_.doubt_offsets();
  const bool restores = uncertain.has('M') && modal_.saved.back();
  if (restores) levels_.miss_call();
  if (uncertain.has('M') && flow_.in_subprogram() && may_save_modes(line)) levels_.lose_save();
  if (command_.lost_touch()) parser_.parameters().doubt_touch();
  const Groups doubted = command_.doubted();
  if (doubted.empty()) return;
  modal_.doubt(doubted);
  if (doubted.has_any({Group::cycle, Group::motion})) modal_.cycle.told |= Letters("PQRXYZ");
  if (!doubted.has(Group::cutter_compensation)) return;
  out_.stop_compensation();
  modal_.cutter.reset();
}

/// There G53 is a rapid, whatever motion is in force.
bool Interpreter::fanuc_goes_to_machine_point() const noexcept {
  constexpr int kG53 = 530;
  const GCode* code = command_.find(Group::non_modal);
  return options_.dialect == Dialect::fanuc && code != nullptr && code->number == kG53;
}

const GCode* Interpreter::behind_g80() const noexcept {
  return options_.dialect == Dialect::fanuc ? modal_.motion_below : nullptr;
}

/// Words that no code of the line takes may be meant for the motion in force.
void Interpreter::find_motion() {
  const Letters unused = command_.unused(options_.dialect);
  if (unused.empty()) return;
  if (command_.uncertain().has('G')) {
    for (const char axis : kAxisLetters)
      if (unused.has(axis)) modal_.uncertain.add(axis);
    return out_.mute();
  }
  const GCode* motion = command_.has(Group::cycle) ? behind_g80() : modal_.motion;
  if (motion == nullptr && fanuc_goes_to_machine_point()) motion = find_gcode('G', 0);
  if (motion != nullptr && unused.has_any(motion->words))
    return command_.add_modal_motion(*motion, *first_of(command_.values(), motion->words));
  if (motion != nullptr || !unused.has_any(kAxisWords)) return;
  const Word& word = *first_of(command_.values(), kAxisWords);
  const bool alone = unused.without(Letters({&word.letter, 1})).empty();
  if (alone && modal_.feed <= 0) modal_.uncertain.add('F');              // `X600`, for F600
  if (command_.uncertain().has(word.letter)) modal_.uncertain.add('G');  // `x0 X1`, for G0 X1
  if (tool_may_be_code()) modal_.uncertain.add('G');
  if (modal_.uncertain.has('G')) return out_.mute();
  out_.report(Code::SC2101, word.pos,
              std::string(1, word.letter) + " with no motion code in force");
  for (const char axis : kAxisLetters)
    if (unused.has(axis)) modal_.uncertain.add(axis);
  modal_.uncertain.add('G');
}

/// FANUC's G10 L50 and L52, which are refused: up to G11 lines hold parameters and their values.
bool Interpreter::begins_data_input() const noexcept {
  constexpr int kG10 = 100;
  const GCode* code = command_.find(Group::non_modal);
  const double what = command_.values().value_or('L', 0);
  const bool refused = what == 50 || what == 52;
  return refused && options_.dialect == Dialect::fanuc && code != nullptr && code->number == kG10;
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
    if (!Letters(code->words).has_any(kAxisWords)) continue;
    if (is_straight(*code) && fanuc_goes_home(command_, options_.dialect)) continue;
    if (user != nullptr) {
      out_.report(Code::SC2110, word->pos,
                  code_name(*code) + " beside " + code_name(*user) + ": both take the axes");
      modal_.doubt_offsets();
      command_.doubt_missing();
    }
    user = code;
  }
}

/// Words that the motion in force does not take, whichever it is. In the fanuc dialect it may be
/// the call of a macro, which takes them all. True if one is told.
[[gnu::cold]] bool Interpreter::tell_never_used(Letters unused) {
  static const Letters taken = taken_in_force();
  const Letters never = unused.without(taken);
  if (never.empty() || options_.dialect == Dialect::fanuc) return false;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (never.has(letter) && kOtherAxes.has(letter))
      out_.report_by_itself(Code::SC2008, command_.values().word(letter).pos, lacks_axis(letter));
  const Letters others = never.without(kOtherAxes);
  if (const Word* first = first_of(command_.values(), others))
    out_.report_by_itself(Code::SC2004, first->pos, used_by_none(others));
  return true;
}

bool Interpreter::has_own_motion() const noexcept {
  return command_.has(Group::motion) && command_.find_word(Group::motion).letter == 'G';
}

/// `T6.2`, for G6.2.
bool Interpreter::tool_may_be_code() const noexcept {
  if (!command_.has(Group::tool)) return false;
  const double number = command_.find_word(Group::tool).value;
  return number != std::floor(number);
}

/// The code that takes them may be one of two words of a letter, or a tool that is no whole number;
/// or it is missing right before a line of values alone, which has been told of the same letters.
[[gnu::cold]] bool Interpreter::is_told_already(const Line& line, Letters unused) {
  if (has_own_motion()) return false;
  const bool told =
      command_.doubled() || tool_may_be_code() ||
      (is_data(line) && !told_unused_.empty() && unused.without(told_unused_).empty());
  told_unused_ |= unused;
  return told;
}

/// `H2`, for M2, alone on its line.
[[gnu::cold]] void Interpreter::excuse_end(const Line& line) {
  if (line.words.size() != 1 || !is_end(line.words.front().value)) return;
  flow_.expect_end();
}

void Interpreter::look_for_unused(const Line& line) {
  if (!check_unused(line)) {
    told_unused_ = {};
    return;
  }
  doubt_missing();
  excuse_end(line);
}

/// True if one is told.
bool Interpreter::check_unused(const Line& line) {
  const Letters unused = command_.unused(options_.dialect);
  if (unused.empty()) return false;
  if (modal_.uncertain.has('G') && !command_.has(Group::motion)) {
    const bool told = tell_never_used(unused);
    out_.mute();
    return told;
  }
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (unused.has(letter) && kOtherAxes.has(letter))
      out_.report(Code::SC2008, command_.values().word(letter).pos, lacks_axis(letter));
  if (may_be_code_of(command_.values(), unused, kOtherAxes)) return true;
  if (is_told_already(line, unused)) {
    out_.mute();
    return true;
  }
  if (const Word* first = first_of(command_.values(), unused.without(kOtherAxes)))
    out_.report(Code::SC2004, first->pos, used_by_none(unused.without(kOtherAxes)));
  return true;
}

/// For one of them a word that no code takes may stand.
[[gnu::cold]] void Interpreter::doubt_missing() {
  command_.doubt_missing();
  for (const char letter : kAxisLetters)
    if (command_.missing().has(letter)) modal_.uncertain.add(letter);
  const bool names_axis = command_.values().letters().has_any(kAxisWords);
  if (modal_.curve && !names_axis) modal_.curve->knots_uncertain = true;
  if (may_be_spindle(command_.values(), command_.unused(options_.dialect)))
    modal_.uncertain.add('M');
  const GCode* motion = command_.find(Group::motion);
  if (motion != nullptr && is_line_or_arc(*motion) && !is_straight(*motion)) out_.mute();
  if (!has_own_motion() && command_.unused(options_.dialect).has_any("IJKR"))
    out_.mute();  // of an arc whose code is missing
  const bool curve_by_mode = motion != nullptr && !is_line_or_arc(*motion) &&
                             leads_by_itself(*motion) &&
                             command_.find_word(Group::motion).letter != 'G';
  if (curve_by_mode) command_.doubt_motion();
}

/// `G10 M2 P1`, where L2 is missing: M02 may be another word, if its line has others.
bool Interpreter::stands_for_word() const noexcept { return !command_.values().letters().empty(); }

void Interpreter::execute() {
  const int errors = diagnostics_.errors();
  if (!modal_.doubted.empty())
    for (const auto& [code, word] : command_.codes()) modal_.doubted.remove(code->group);
  for (const auto& [code, word] : command_.codes()) {
    Task task{*code, *word, command_, command_.values(), machine_, options_, modal_, out_, flow_};
    if ((out_.compensating() || modal_.beside) && !may_act(task)) continue;
    if (code->act == end_program && diagnostics_.errors() > errors && stands_for_word())
      flow_.doubt_end();
    else if (code->act != nullptr)
      code->act(task);
  }
  modal_.machine_coordinates = modal_.stops_once = false;
}

/// What reading alone tells of lines that are never run.
[[gnu::cold]] void Interpreter::read_unrun() {
  if (!options_.unrun_too) return;
  out_.close();
  flow_.begin_unrun();
  while (const auto line = flow_.next_unrun()) interpret(*line);
}

/// The text has ended without M02 or M30.
void Interpreter::finish() {
  flow_.finish();
  Line line;
  line.number = parser_.line();
  out_.begin(line);
  const bool broke_off = flow_.broke_off();
  if (modal_.curve && !broke_off) end_pending_curve(modal_, out_);
  if (modal_.points && !broke_off) end_pending_points(modal_, out_);
  if (!broke_off && !flow_.end_lost())
    out_.report(Code::SC2205, {line.number, 0, 1}, "the program ends without M02 or M30");
  out_.end();
  out_.begin(line);
  out_.stop_compensation();
  out_.emit(Action{Action::Kind::end, 30, 0});
  modal_.ended = true;
  read_unrun();
  contradictions_.tell();
}

}  // namespace softcnc::ipr
