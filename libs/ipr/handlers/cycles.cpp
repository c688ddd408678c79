// SPDX-License-Identifier: MIT
// Canned cycles: a hole, or a row of them, as moves, dwells and actions of the spindle.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/state/nearness.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kChipClearance = 0.254;  // mm (0.01 inch): over the last peck, as in RS274
constexpr double kMostPecks = 1e4;        // of one line: its moves are made at once

bool pecks(const GCode& code) { return code.number == kG73 || code.number == kG83; }
bool taps(const GCode& code) { return code.number == kG74 || code.number == kG84; }
bool dwells(const GCode& code) {
  return code.number == kG82 || code.number == kG86 || code.number == kG89;
}

bool never_dwells(const GCode& code) { return code.number == kG81 || code.number == kG85; }

bool feeds_out(const GCode& code) { return taps(code) || code.number == kG89; }

/// Of a tap: 1 clockwise (M03), -1 counter-clockwise.
int tapping_direction(const GCode& code) { return code.number == kG84 ? 1 : -1; }

/// What one line asks for, in mm and programmed coordinates.
struct Holes {
  PlaneAxes axes;
  double retract, bottom, clear;  // across the plane; `clear` is where each hole is left
  double feed_end;                // as far out go those at the feed that do
  double dwell;                   // s
  Pecks pecks;                    // mm
  int count;
  AxisVector first, step;
  double clearance = kChipClearance;  // mm
};

char across_letter(const PlaneAxes& axes) { return axis_letter(axes.across); }

void keep(Task& task, char letter, std::optional<double>& value, double scale) {
  if (!task.values.has(letter)) return;
  value = task.values[letter] * scale;
}

/// `relative`: whether the height is a distance from another one.
void keep_height(Task& task, char letter, std::optional<double>& height, bool& relative) {
  const bool incremental = task.modal.incremental;
  if (!task.values.has(letter) && height && relative != incremental)
    task.out.note_difference(DialectDifference::kept_height, task.word.pos);
  if (task.values.has(letter) || !is_fanuc(task)) relative = incremental;
  keep(task, letter, height, task.modal.mm_per_unit);
}

bool in_row(const Modal& modal) {
  return modal.motion != nullptr && is_canned_cycle(*modal.motion);
}

/// FANUC passes over the dwell of a cycle that has none.
void report_idle_dwell(Task& task, const Word& word) {
  if (std::exchange(task.modal.idle_dwell_reported, true)) return;
  task.out.report(Code::SC2230, word.pos,
                  code_name(task.code) + " does not dwell; its P has no effect");
}

void keep_dwell(Task& task, CycleWords& words) {
  if (!task.values.has('P')) return;
  const Word& word = task.values.word('P');
  const bool milliseconds = counts_milliseconds(task, word);
  words.dwell = milliseconds ? s_from_ms(word.value) : word.value;
  if (never_dwells(task.code)) return is_fanuc(task) ? report_idle_dwell(task, word) : void();
  if (word.value == 0 || pecks(task.code)) return;
  task.out.note_difference(is_fanuc(task) && !milliseconds ? DialectDifference::dwell_with_point
                                                           : DialectDifference::cycle_dwell,
                           word.pos);
}

/// Haas: R may be missing, and is then the height from which the row of holes began.
void keep_height_of_start(const Task& task, CycleWords& words) {
  if (words.retract || !is_haas(task)) return;
  words.retract_from_start = task.modal.incremental;
  words.retract = words.retract_from_start ? 0 : words.start;
}

/// Q, or Haas' I, J and K: the first peck, by how much each next one is less, and the least. Haas'
/// K beside Q: the depth after which G73 goes out to R.
void keep_pecks(Task& task, CycleWords& words) {
  if (!pecks(task.code)) return;
  const auto length = [&](char letter) {
    return task.values.value_or(letter, 0) * task.modal.mm_per_unit;
  };
  const bool of_pattern = has_hole_pattern(task.command);  // I, J and K
  const bool own = is_haas(task) && !of_pattern;
  if (task.values.has('Q')) {
    const double kept = own && words.pecks ? words.pecks->out_after : 0;
    words.pecks = Pecks{length('Q'), 0, 0, task.values.has('K') && own ? length('K') : kept};
  }
  if (own && task.values.has('I')) words.pecks = Pecks{length('I'), length('J'), length('K'), 0};
  const bool differs = task.code.number == kG73 && task.values.has('K') && task.values.has('Q');
  if (differs && !of_pattern)
    task.out.note_difference(DialectDifference::peck_limit, task.values.word('K').pos);
}

/// Words stay in force from hole to hole as long as the cycle does, in the fanuc dialect as long
/// as any cycle does. After a code that is not known they may.
void keep_words(Task& task, const PlaneAxes& axes) {
  CycleWords& words = task.modal.cycle;
  const Modal& modal = task.modal;
  const bool stay = is_fanuc(task) ? in_row(modal) : modal.motion == &task.code;
  if (!stay) words = {{}, {}, {}, {}, words.start};
  keep_height(task, 'R', words.retract, words.retract_from_start);
  keep_height(task, across_letter(axes), words.bottom, words.bottom_from_retract);
  keep_height_of_start(task, words);
  keep_pecks(task, words);
  keep_dwell(task, words);
}

template <typename Value>
bool has(Task& task, const std::optional<Value>& value, char letter, std::string_view what) {
  if (value) return true;
  task.out.report(Code::SC2005, task.word.pos,
                  code_name(task.code) + " needs " + letter + ", " + std::string(what));
  return false;
}

/// Those that stay in force.
bool has_kept_words(Task& task, const PlaneAxes& axes) {
  const CycleWords& words = task.modal.cycle;
  const bool must_dwell = dwells(task.code) && !is_fanuc(task);
  bool all = has(task, words.retract, 'R', "the height to which it retracts");
  all = has(task, words.bottom, across_letter(axes), "the bottom of the hole") && all;
  if (must_dwell) all = has(task, words.dwell, 'P', "the time at the bottom") && all;
  if (pecks(task.code)) all = has(task, words.pecks, 'Q', "the depth of a peck") && all;
  return all;
}

bool has_cycle_words(Task& task, const PlaneAxes& axes) {
  if (task.values.letters().has_any(kAxisWords)) return has_kept_words(task, axes);
  task.out.report(Code::SC2160, task.word.pos,
                  code_name(task.code) + " without a position: X, Y or Z");
  return false;
}

bool refuse_at(Task& task, SourcePos pos, Code code, std::string message) {
  task.out.report(code, pos, std::move(message));
  return false;
}

bool refuse(Task& task, char letter, Code code, std::string message) {
  report_word(task, letter, code, std::move(message));
  return false;
}

bool lies_near(const Task& task, const Holes& holes, AxisVector at, double height) {
  at[holes.axes.across] = height;
  return is_near(task.modal.coordinates.to_machine(at));
}

/// The first and the last hole of the line, from R to the bottom.
bool are_near(Task& task, const Holes& holes) {
  const char across = across_letter(holes.axes);
  const AxisVector last = holes.first + std::max(0, holes.count - 1) * holes.step;
  for (const char letter : {'R', across}) {
    const double height = letter == 'R' ? holes.retract : holes.bottom;
    if (is_near(height)) continue;
    return refuse_at(task, place_of(task, letter), Code::SC3008, leads_far({letter}));
  }
  bool near = true;
  for (const AxisVector& hole : {holes.first, last})
    for (const double height : {holes.retract, holes.bottom})
      near = near && lies_near(task, holes, hole, height);
  const bool named = task.values.letters().has_any(kAxisWords);
  if (!near)
    task.out.report(Code::SC3008, named ? span_of(task.values, "XYZ") : task.word.pos,
                    leads_far(code_name(task.code)));
  return near;
}

bool has_possible_dwell(Task& task, const Holes& holes) {
  if (holes.dwell >= 0 && holes.dwell <= kLongestDwell) return true;
  return refuse_at(task, place_of(task, 'P'), Code::SC2007,
                   std::string("P, the time at the bottom, must ") +
                       (holes.dwell < 0 ? "not be negative" : "be 1000000000 s at most"));
}

bool has_lessening_pecks(Task& task) {
  const Values& given = task.values;
  const SourcePos span = span_of(given, "IJK");
  if (!given.has('I') || !given.has('J') || !given.has('K'))
    return refuse_at(task, span, Code::SC2005,
                     code_name(task.code) +
                         " with pecks that lessen needs I, J and K: the first peck, what each "
                         "next one is less by, and the least");
  if (given['I'] <= 0 || given['J'] < 0 || given['K'] <= 0)
    return refuse_at(task, span, Code::SC2007,
                     "I and K, the first and the least peck, must be above 0, and J not negative");
  return !given.has('Q') ||
         refuse(task, 'Q', Code::SC2007,
                "Q beside I, J and K: pecks are alike, by Q, or lessen, by I, J and K");
}

/// Haas' I, J and K; beside a pattern of holes they are its own.
bool has_fitting_peck_words(Task& task) {
  if (!pecks(task.code) || !is_haas(task) || has_hole_pattern(task.command)) return true;
  if (task.values.letters().has_any("IJ")) return has_lessening_pecks(task);
  if (!task.values.has('K')) return true;
  if (task.code.number != kG73 || !task.values.has('Q'))
    return refuse(task, 'K', Code::SC2007,
                  "K of " + code_name(task.code) + " counts beside I and J" +
                      (task.code.number == kG73 ? ", or beside Q" : ""));
  return task.values['K'] > 0 ||
         refuse(task, 'K', Code::SC2007, "K, the depth after which G73 goes out, must be above 0");
}

bool has_possible_pecks(Task& task, const Holes& holes) {
  if (pecks(task.code) && holes.pecks.first <= 0)
    return refuse_at(task, place_of(task, 'Q'), Code::SC2007,
                     "Q, the depth of a peck, must be above 0");
  if (taps(task.code) && task.values.value_or('Q', 0) != 0)
    return refuse(task, 'Q', Code::SC2114,
                  code_name(task.code) +
                      " with Q is refused: tapping in pecks needs a spindle in step with the axis");
  return true;
}

/// Of FANUC's controls, where a number without a point may count thousandths.
void check_peck_unit(Task& task, const Holes& holes) {
  constexpr double kLargePeck = 100;
  if (task.modal.peck_warned || !pecks(task.code) || !task.values.has('Q')) return;
  const Word& word = task.values.word('Q');
  const bool fits = holes.pecks.first <= holes.retract - holes.bottom;
  if (has_point(task, word) || word.value < kLargePeck || fits) return;
  task.modal.peck_warned = true;
  task.out.report(Code::SC2211, word.pos,
                  "Q, the depth of a peck, is " + number_text(word.value) +
                      (task.modal.mm_per_unit == 1 ? " mm" : " inches") +
                      ", more than the whole hole");
}

bool lies_above_bottom(Task& task, const Holes& holes) {
  if (holes.retract >= holes.bottom) return true;
  return refuse_at(task, place_of(task, 'R'), Code::SC2162,
                   "R lies below the bottom of the hole, " + number_text(holes.retract) +
                       " mm below " + number_text(holes.bottom) + " mm");
}

bool refuse_count(Task& task) {
  return refuse_at(task, task.word.pos, Code::SC2007,
                   code_name(task.code) + " on this line would take more than 10000 " +
                       (pecks(task.code) ? "pecks" : "holes"));
}

bool is_possible(Task& task, const Holes& holes) {
  if (!are_near(task, holes)) return false;
  bool possible = has_possible_dwell(task, holes);
  possible = has_possible_pecks(task, holes) && possible;
  possible = lies_above_bottom(task, holes) && possible;
  if (!possible) return false;
  const double each =
      pecks(task.code) ? (holes.retract - holes.bottom) / holes.pecks.at_least() : 1;
  check_peck_unit(task, holes);
  if (each * holes.count <= kMostPecks) return true;
  return refuse_count(task);
}

/// Haas' mill operator's manual, "G84 Tapping Canned Cycle": the cycle starts and stops the
/// spindle.
bool can_start_spindle(Task& task) {
  if (task.modal.spindle_speed.value_or(0) > 0) return true;
  return refuse_at(task, task.word.pos, Code::SC2163,
                   code_name(task.code) + " needs S, the speed at which it starts the spindle");
}

/// G74 cuts left-hand threads, G84 right-hand ones; G86 stops a spindle that turns.
bool spindle_turns(Task& task) {
  if (taps(task.code) && is_haas(task)) return can_start_spindle(task);
  const int wanted = taps(task.code) ? tapping_direction(task.code) : 0;
  const int turning = task.modal.spindle_direction;
  if (wanted == 0 && task.code.number != kG86) return true;
  if (wanted == 0 ? turning != 0 : turning == wanted) return true;
  return refuse_at(task, task.word.pos, Code::SC2163,
                   code_name(task.code) + " needs a spindle that turns" +
                       (wanted == 0   ? ""
                        : wanted == 1 ? " clockwise (M03)"
                                      : " counter-clockwise (M04)"));
}

/// A spindle that a tap will start turns where a feed per turn needs it.
void check_feed(Task& task) {
  int& turning = task.modal.spindle_direction;
  const int before = turning;
  if (taps(task.code) && is_haas(task)) turning = tapping_direction(task.code);
  has_feed(task);
  turning = before;
}

/// How often; FANUC: K, and 0 only keeps the words. Beside a pattern of holes L is its own.
std::optional<int> repeats(Task& task) {
  if (has_hole_pattern(task.command)) return 0;
  const bool fanuc = is_fanuc(task);
  const bool of_pecks = pecks(task.code) && is_haas(task);
  if (task.values.has('K') && task.options.dialect != Dialect::fanuc && !of_pecks) {
    refuse(task, 'K', Code::SC2007, "K repeats a cycle in the fanuc dialect; here L does");
    return std::nullopt;
  }
  const char letter = task.values.has('K') && !of_pecks ? 'K' : 'L';
  if (!task.values.has(letter)) return 1;
  const Word& word = task.values.word(letter);
  const auto count = whole_number(task, word);
  if (!count || *count > 0 || fanuc) return count;
  refuse(task, letter, Code::SC2007, "L, the repeat count, must be at least 1");
  return std::nullopt;
}

/// FANUC's and Haas' manuals: G51 does not scale pecks, nor the clearance over them.
void leave_pecks(const Modal& modal, Holes& holes) {
  const double factor = std::abs(modal.transformation.factor(holes.axes.across));
  holes.pecks.first /= factor;
  holes.pecks.less_by /= factor;
  holes.pecks.least /= factor;
  holes.pecks.out_after /= factor;
  holes.clearance /= factor;
}

bool goes_down(Task& task, const PlaneAxes& axes) {
  if (task.modal.transformation.factor(axes.across) > 0) return true;
  return refuse_at(task, task.word.pos, Code::SC2257,
                   code_name(task.code) + " along a mirrored axis " + axis_letter(axes.across));
}

Holes holes_of(const Task& task, const PlaneAxes& axes, const AxisVector& from, int count) {
  const CycleWords& words = task.modal.cycle;
  const Modal& modal = task.modal;
  Holes holes{axes,
              *words.retract,
              *words.bottom,
              0,
              0,
              words.dwell.value_or(0),
              words.pecks.value_or(Pecks{}),
              count,
              from,
              AxisVector::Zero()};
  if (pecks(task.code) && !is_fanuc(task)) holes.dwell = 0;
  if (words.retract_from_start) holes.retract += words.start;
  if (words.bottom_from_retract) holes.bottom += holes.retract;
  const bool to_retract = modal.retract_to_r.value_or(!is_fanuc(task));
  holes.clear = to_retract ? holes.retract : std::max(words.start, holes.retract);
  holes.feed_end = is_fanuc(task) ? holes.retract : holes.clear;
  leave_pecks(modal, holes);
  return holes;
}

/// Where the line puts them.
void place(const Task& task, Holes& holes) {
  for (const int axis : {holes.axes.first, holes.axes.second}) {
    const char letter = axis_letter(axis);
    if (!task.values.has(letter)) continue;
    const double value = task.values[letter] * task.modal.mm_per_unit;
    if (task.modal.incremental)
      holes.step[axis] = value;
    else
      holes.first[axis] = value;
  }
  holes.first += holes.step;
}

/// The tool on its path, in programmed coordinates.
class CyclePath {
 public:
  CyclePath(Task& task, const Holes& holes, const AxisVector& at)
      : task_(task), holes_(holes), at_(at) {}

  int blocks() const { return blocks_; }
  double height() const { return at_[holes_.axes.across]; }
  void over(const AxisVector& hole) {
    at_[holes_.axes.first] = hole[holes_.axes.first];
    at_[holes_.axes.second] = hole[holes_.axes.second];
    go(true);
  }
  void rapid_to(double height) { to(height, true); }
  void feed_to(double height) { to(height, false); }
  void rest() {
    if (holes_.dwell > 0) task_.out.emit(Dwell{holes_.dwell});
  }
  /// 1: clockwise, -1: counter-clockwise, 0: stop.
  void turn(int direction) {
    const int code = direction == 0 ? 5 : direction > 0 ? 3 : 4;
    task_.out.emit(
        Action{Action::Kind::spindle, code, direction * task_.modal.spindle_speed.value_or(0)});
  }

 private:
  void to(double height, bool rapid) {
    at_[holes_.axes.across] = height;
    go(rapid);
  }
  void go(bool rapid) {
    Modal& modal = task_.modal;
    const AxisVector from = modal.beside ? modal.beside->tool : modal.position;
    const AxisVector end = modal.coordinates.to_machine(at_);
    if ((end - from).lpNorm<Eigen::Infinity>() < kShortestMove) return;
    emit_move(task_, softcnc::Line(from, end), rapid);
    ++blocks_;
    modal.position = end;
  }

  Task& task_;
  const Holes& holes_;
  AxisVector at_;
  int blocks_ = 0;
};

/// G73 breaks the chip, G83 clears it out of the hole, as G73 does after some depth if asked to.
void peck(CyclePath& path, const Holes& holes, bool clears) {
  const Pecks& pecks = holes.pecks;
  double peck = pecks.first, since_out = 0;
  for (double depth = holes.retract - peck; depth > holes.bottom; depth -= peck) {
    path.feed_to(depth);
    since_out += peck;
    const bool out = clears || pecks.is_out_after(since_out);
    if (out) path.rapid_to(holes.retract);
    if (out) since_out = 0;
    path.rapid_to(std::min(depth + holes.clearance, holes.retract));
    peck = pecks.after(peck);
  }
  path.feed_to(holes.bottom);
  path.rest();
  path.rapid_to(holes.clear);
}

/// While a tap is in its hole no override counts: it would change the pitch.
class NoOverride {
 public:
  explicit NoOverride(Modal& modal)
      : modal_(modal),
        feed_(std::exchange(modal.feed_override, false)),
        speed_(std::exchange(modal.speed_override, false)) {}
  ~NoOverride() {
    modal_.feed_override = feed_;
    modal_.speed_override = speed_;
  }
  NoOverride(const NoOverride&) = delete;
  NoOverride& operator=(const NoOverride&) = delete;

 private:
  Modal& modal_;
  bool feed_, speed_;
};

/// Haas' controls start the spindle for it; after it the spindle does what it did before.
void tap(CyclePath& path, const Holes& holes, const GCode& code, Modal& modal) {
  const int tapping = tapping_direction(code);
  const int before = std::exchange(modal.spindle_direction, tapping);
  if (before != tapping) path.turn(tapping);
  const NoOverride pitch_stays(modal);
  path.feed_to(holes.bottom);
  path.turn(-tapping);
  path.rest();
  path.feed_to(holes.feed_end);
  path.turn(before);
  modal.spindle_direction = before;
}

void bore(CyclePath& path, const Holes& holes, const GCode& code) {
  path.feed_to(holes.bottom);
  if (dwells(code)) path.rest();
  if (code.number == kG86) path.turn(0);
  if (code.number == kG85) path.feed_to(holes.retract);
  if (code.number == kG89) path.feed_to(holes.feed_end);
}

void drill(CyclePath& path, const Holes& holes, const GCode& code, Modal& modal) {
  if (pecks(code)) return peck(path, holes, code.number == kG83);
  taps(code) ? tap(path, holes, code, modal) : bore(path, holes, code);
  path.rapid_to(holes.clear);
  if (code.number == kG86) path.turn(modal.spindle_direction);
}

AxisVector next_hole(const Task& task, const Holes& holes, const AxisVector& hole) {
  const bool polar = task.modal.polar || task.command.has_polar_words();
  if (!polar || !task.modal.polar_end || !task.modal.incremental) return hole + holes.step;
  return task.modal.polar_end->from(hole);
}

/// `place(i, before)` is where hole i is; before the first one `before` is holes.first.
template <typename Place>
void drill_all(Task& task, const Holes& holes, const AxisVector& from, Place place) {
  CyclePath path(task, holes, from);
  if (path.height() < holes.retract) path.rapid_to(holes.retract);
  AxisVector hole = holes.first;
  for (int i = 0; i < holes.count; ++i) {
    hole = place(i, hole);
    path.over(hole);
    path.rapid_to(holes.retract);
    drill(path, holes, task.code, task.modal);
  }
  task.flow.count_more_blocks(std::max(path.blocks() - 1, 0));
}

/// The motion that stands before a cycle has ended the row before, and comes back after G80.
void lay_below(Task& task) {
  const GCode* below = task.command.below_cycle();
  if (below != nullptr) task.modal.motion = task.modal.motion_below = below;
}

/// How the hole is left.
void compare_retracts(Task& task, const Holes& holes) {
  const Modal& modal = task.modal;
  if (modal.cycle.start <= holes.retract) return;
  if (!modal.retract_to_r)
    task.out.note_difference(DialectDifference::retract, task.word.pos);
  else if (!*modal.retract_to_r && feeds_out(task.code))
    task.out.note_difference(DialectDifference::feed_out, task.word.pos);
}

}  // namespace

void canned_cycle(Task& task) {
  Modal& modal = task.modal;
  lay_below(task);
  const PlaneAxes axes = plane_axes(modal.plane);
  const AxisVector from = modal.coordinates.to_program(modal.position);
  if (!in_row(modal)) modal.cycle.start = from[axes.across];
  const bool fitting = has_fitting_peck_words(task);
  keep_words(task, axes);
  begin_motion(task);
  const auto count = repeats(task);
  check_feed(task);
  if (!fitting || !count || !has_cycle_words(task, axes) || !goes_down(task, axes)) return;
  Holes holes = holes_of(task, axes, from, *count);
  place(task, holes);
  if (!is_possible(task, holes) || !spindle_turns(task)) return;
  compare_retracts(task, holes);
  drill_all(task, holes, from, [&](int i, const AxisVector& before) {
    return i == 0 ? before : next_hole(task, holes, before);
  });
}

void drill_at(Task& task, const std::vector<AxisVector>& places) {
  Task cycle{*task.modal.motion, task.word,  task.command, task.values, task.machine,
             task.options,       task.modal, task.out,     task.flow};
  const PlaneAxes axes = plane_axes(task.modal.plane);
  const AxisVector from = task.modal.coordinates.to_program(task.modal.position);
  check_feed(cycle);
  if (!has_kept_words(cycle, axes) || !goes_down(cycle, axes)) return;
  Holes holes = holes_of(cycle, axes, from, static_cast<int>(places.size()));
  for (const AxisVector& place : places) {
    holes.first = place;
    if (!are_near(cycle, holes)) return;
  }
  if (!is_possible(cycle, holes) || !spindle_turns(cycle)) return;
  drill_all(cycle, holes, from,
            [&](int i, const AxisVector&) { return places[static_cast<std::size_t>(i)]; });
}

void refuse_cycle(Task& task) {
  const std::string why = task.code.number == 880
                              ? " requires the operator to retract the tool by hand"
                              : " needs a spindle that can be oriented";
  task.out.report(Code::SC2161, task.word.pos, code_name(task.code) + why);
  lay_below(task);
  if (is_fanuc(task)) keep_words(task, plane_axes(task.modal.plane));
  task.modal.motion = nullptr;
}

void retract_to_start(Task& task) { task.modal.retract_to_r = false; }
void retract_to_r(Task& task) { task.modal.retract_to_r = true; }

}  // namespace softcnc::ipr
