// SPDX-License-Identifier: MIT
// G06.2, a NURBS over several lines: one block per control point, then as many blocks of K alone as
// the order. It ends by that count. FANUC writes G06.2 once; LinuxCNC may write it in every block.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "ipr/codes/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kDefaultOrder = 4;
constexpr int kLeastOrder = 2;
constexpr int kFanucOrder = 4;  // the largest of a FANUC control
constexpr std::string_view kSurfaceWords = "DJHL";

/// What cannot be read, or may be what a word stands for that no code takes.
Letters lost(const Command& command) noexcept {
  Letters lost = command.uncertain();
  lost |= command.missing();
  return lost;
}

bool is_first(const PendingCurve& curve) { return curve.spec.control.empty(); }

void note_order(Task& task, const Word& word) {
  if (task.options.dialect != Dialect::fanuc || word.value <= kFanucOrder) return;
  if (task.modal.order_told) return;
  task.modal.order_told = true;
  task.out.report(Code::SC3113, word.pos,
                  "FANUC controls take orders up to " + std::to_string(kFanucOrder) +
                      "; softcnc runs this one of " + number_text(word.value) + " all the same");
}

std::optional<int> read_order(Task& task) {
  if (!task.values.has('P'))
    return lost(task.command).has('P') ? std::nullopt : std::optional(kDefaultOrder);
  const Word& word = task.values.word('P');
  const bool legal = word.value == std::floor(word.value) && word.value >= kLeastOrder &&
                     word.value <= Nurbs::kMaxDegree + 1;
  if (legal) {
    note_order(task, word);
    return static_cast<int>(word.value);
  }
  if (!task.values.has('K')) return std::nullopt;  // what is told is that
  report_word(task, 'P', Code::SC3001,
              "P, the order of the curve, is a whole number from 2 to " +
                  std::to_string(Nurbs::kMaxDegree + 1));
  return std::nullopt;
}

/// FANUC's curves are fed by G94 alone; G93 is refused where the feed is read.
void check_feed_mode(Task& task) {
  if (task.modal.feed_mode != FeedMode::per_turn) return;
  task.out.report(Code::SC2220, task.word.pos,
                  code_name(task.code) + " while G95 is in force: F cannot be its feed");
}

/// One alone, where the knot is missing, may stand for that.
std::ptrdiff_t surface_words(const Values& values) {
  return std::count_if(kSurfaceWords.begin(), kSurfaceWords.end(),
                       [&](char letter) { return values.has(letter); });
}

/// `L3` for P3: with one of them alone no surface is asked for, and the order is not known.
bool stands_for_order(const Task& task) {
  return task.values.has('K') && !task.values.has('P') && surface_words(task.values) == 1;
}

void report_order_meant(Task& task) {
  for (const char letter : kSurfaceWords)
    if (task.values.has(letter))
      report_word(task, letter, Code::SC3125,
                  std::string(1, letter) + " alone asks for no surface: it takes D, J and H");
}

void begin_curve(Task& task) {
  begin_motion(task);
  check_feed_mode(task);
  const bool order_lost = stands_for_order(task);
  if (order_lost)
    report_order_meant(task);
  else if (task.values.has('K') || surface_words(task.values) != 1)
    ask_for_surface_of_curve(task);
  PendingCurve& curve = task.modal.curve.emplace();
  const bool other_code = task.command.contradicted().has(Group::motion);
  curve.order = order_lost || other_code ? 0 : read_order(task).value_or(0);
  curve.headless = std::exchange(task.modal.left_curve_may_go_on, false);
  curve.broken = curve.headless;
  curve.knotless = other_code;  // its blocks may be those of that one
  curve.knots_uncertain = curve.order == 0 || curve.headless;
  curve.spec.degree = curve.order - 1;
  curve.order_word = task.values.value_or('P', 0);
  curve.head = curve_head(task);
}

/// How often the last knot stands at the end of what was read.
int repetitions(const std::vector<double>& knots) {
  const auto other =
      std::find_if(knots.rbegin(), knots.rend(), [&](double knot) { return knot != knots.back(); });
  return static_cast<int>(other - knots.rbegin());
}

std::string ends_message(const char* which, int order) {
  return std::string("the ") + which + " " + std::to_string(order) + " knots must be equal";
}

/// Of a knot that is told because of its place, the next ones are not held against its value.
void refuse_knot(Task& task, PendingCurve& curve, Code code, std::string message) {
  report_word(task, 'K', code, std::move(message));
  curve.knots_uncertain = curve.misshapen = true;
  if (code == Code::SC3005) curve.knot = curve.spec.knots.end()[-2];
}

/// True, and told, if the knot is below the one before. Two that fall are two mistakes, whatever
/// else is wrong with the curve: no single value mends both.
bool falls(Task& task, PendingCurve& curve, double knot) {
  const auto before = std::exchange(curve.knot, knot);
  if (curve.disordered || !before || knot >= *before) return false;
  refuse_knot(
      task, curve, Code::SC3004,
      "knot " + number_text(knot) + " after " + number_text(*before) + "; knots must not decrease");
  return true;
}

/// What is wrong with the knot just read can be said at once, and so at its place.
void check_knot(Task& task, PendingCurve& curve) {
  const std::vector<double>& knots = curve.spec.knots;
  const int count = static_cast<int>(knots.size());
  const double knot = knots.back();
  const double before = count > 1 ? knots[static_cast<std::size_t>(count) - 2] : knot;
  const bool end = knot == knots.front() || curve.closing_knots > 0;
  const int most = end ? curve.order : curve.order - 1;
  if (count <= curve.order && knot != knots.front())
    refuse_knot(task, curve, Code::SC3005, ends_message("first", curve.order));
  else if (curve.closing_knots > 1 && knot != before)
    refuse_knot(task, curve, Code::SC3005, ends_message("last", curve.order));
  else if (const int row = repetitions(knots); row > most)
    refuse_knot(task, curve, Code::SC3006,
                "knot " + number_text(knot) + " stands " + std::to_string(row) +
                    " times in a row; at most " + std::to_string(most) + " can be here");
}

/// What else seems wrong with the block may be the word that stands for it. A curve that lacks it
/// from its first block on may be one of another code.
void tell_missing_knot(Task& task, PendingCurve& curve) {
  if (is_first(curve)) curve.knotless = true;
  if (!curve.knotless || is_first(curve))
    task.out.report(Code::SC3102, task.word.pos, "a block of a curve needs its knot, K");
  curve.knot_told = curve.knots_uncertain = curve.misshapen = true;
  task.out.mute();
}

/// `y1`, for K1: of a coordinate alone where the knot is missing nobody knows whether it leads
/// there.
void doubt_lone_coordinate(Task& task, const PendingCurve& curve) {
  if (!curve.knot_told) return;
  for (const char letter : kAxisLetters)
    if (task.values.letters() == Letters({&letter, 1})) task.modal.uncertain.add(letter);
}

void read_knot(Task& task, PendingCurve& curve) {
  if (curve.knot_told) return;
  if (task.command.uncertain().has('K')) {
    curve.knots_uncertain = true;
    return;
  }
  const double knot = task.values['K'];
  if (curve.order > 0) curve.spec.knots.push_back(knot);
  if (!falls(task, curve, knot) && !curve.knots_uncertain) check_knot(task, curve);
}

double read_weight(Task& task, PendingCurve& curve) {
  if (!task.values.has('R')) return 1;
  const Word& word = task.values.word('R');
  if (word.value > 0) return word.value;
  if (curve.knot_told) return 1;
  report_word(task, 'R', Code::SC3007, "R, the weight of a control point, must be above 0");
  curve.misshapen = true;
  return 1;
}

/// The first block names the axes of the curve; if it names none, the second one does.
void check_curve_axes(Task& task, PendingCurve& curve) {
  const bool naming = curve.axes.empty() && curve.spec.control.size() <= 1;
  const bool feed_is_zero = task.command.has(Group::feed) && task.modal.zero_feed;  // `F0`, for Y0
  const bool doubled = task.command.uncertain().has_any("KPR") ||  // one may stand for an axis
                       feed_is_zero;
  for (const char letter : kAxisLetters) {
    if (naming && (doubled || lost(task.command).has(letter))) curve.axes.add(letter);
    if (!task.values.has(letter) || curve.axes.has(letter)) continue;
    curve.axes.add(letter);
    if (naming) continue;
    task.out.report(Code::SC3103, task.values.word(letter).pos,
                    std::string(1, letter) + " is missing in the first block of the curve");
    curve.misshapen = true;
  }
}

/// The curve begins in the position exactly, wherever within the tolerance its first point lies.
AxisVector first_point(Task& task, PendingCurve& curve) {
  const bool known = knows_position(task);
  const AxisVector point = end_point(task);
  const double off = (point - task.modal.position).norm();
  if (off <= start_tolerance(task.machine)) return task.modal.position;
  curve.misshapen = true;
  if (!known || curve.broken) {
    task.out.mute();
    return point;
  }
  report_if_certain(task, kAxisWords, Code::SC3109, span_of(task.values, "XYZ"),
                    "the curve begins " + number_text(off) + " mm off the position");
  return task.modal.position;
}

/// False, and told once, if the curve has as many points as it can have.
bool has_room(Task& task, PendingCurve& curve) {
  if (curve.spec.control.size() < kMostCurvePoints) return true;
  if (!std::exchange(curve.full, true)) report_too_many(task);
  curve.knots_uncertain = curve.misshapen = true;
  return false;
}

/// Nobody knows which curve it belongs to, and where that ends.
void refuse_late_point(Task& task, PendingCurve& curve) {
  if (!curve.knots_uncertain)
    task.out.report(Code::SC3104, span_of(task.values, "XYZ"),
                    "a control point after " + std::to_string(curve.closing_knots) + " of " +
                        std::to_string(curve.order) + " closing knots");
  curve.knots_uncertain = curve.disordered = true;
  curve.lost_axes |= kAxisWords;
}

/// `Z1` for the closing knot K1: a coordinate alone, where only a knot is due or no axis has its
/// letter.
bool stands_for_knot(const Task& task, const PendingCurve& curve) {
  const Letters given = task.values.letters();
  if (is_first(curve) || given.has('K') || lost(task.command).has('K')) return false;
  for (const char letter : kAxisLetters)
    if (given == Letters({&letter, 1})) return curve.closing_knots > 0 || !curve.axes.has(letter);
  return false;
}

/// It is told, and counts as one.
void read_knot_meant(Task& task, PendingCurve& curve) {
  ++curve.closing_knots;
  tell_missing_knot(task, curve);
}

void read_control_point(Task& task, PendingCurve& curve) {
  if (curve.closing_knots > 0) refuse_late_point(task, curve);
  const bool first = is_first(curve);
  check_curve_axes(task, curve);
  if (!first) task.modal.position = end_point(task);
  if (!has_room(task, curve)) return;
  curve.spec.control.push_back(first ? first_point(task, curve) : task.modal.position);
  curve.spec.weights.push_back(read_weight(task, curve));
  read_knot(task, curve);
}

void read_closing_knot(Task& task, PendingCurve& curve) {
  const int points = static_cast<int>(curve.spec.control.size());
  if (curve.closing_knots++ == 0 && points < curve.order && !curve.headless) {
    task.out.report(Code::SC3002, task.word.pos,
                    "the curve ends after " + std::to_string(points) +
                        " control points; its order asks for " + std::to_string(curve.order));
    curve.knots_uncertain = true;
  } else if (task.values.has('R') && !curve.knot_told) {
    report_word(task, 'R', Code::SC3111, "a closing knot takes K alone");
    curve.lost_axes |= kAxisWords;
  }
  read_knot(task, curve);
}

/// Its ends lie on the curve, whatever becomes of its knots and weights.
void show_broken_curve(const Task& task, PendingCurve& curve) {
  const std::array ends{curve.spec.control.front(), curve.spec.control.back()};
  show_broken(task.modal, task.out, curve, Nurbs::make(std::move(curve.spec)), ends);
}

void finish_curve(Task& task, PendingCurve& curve) {
  Result<Nurbs> made = Nurbs::make(std::move(curve.spec));
  if (!made)
    return task.out.report(made.error().code, curve.head.word, std::move(made.error().message),
                           curve.head.line);
  if (has_surface_speed(task.modal, task.out, curve.head.word, curve.head.line))
    task.out.emit(cutting_move(task.modal, std::move(*made), curve.head.feed), curve.head.source);
}

/// LinuxCNC's Q chooses how the curve is chopped; here it is not.
void read_chopping(Task& task) {
  if (!task.values.has('Q')) return;
  const Word& word = task.values.word('Q');
  if (task.options.dialect == Dialect::fanuc)
    return task.out.report(Code::SC2004, word.pos, "Q is used by no code of this line");
  if (task.modal.chopping_told) return;
  task.modal.chopping_told = true;
  task.out.report(Code::SC3114, word.pos,
                  "Q, the way of chopping the curve, has no effect: no curve is chopped");
}

/// True, and told, if the block has words that count for the whole curve.
bool has_words_of_first(Task& task, const PendingCurve& curve) {
  const Values& values = task.values;
  Letters first = kSurfaceWords;
  const bool again = curve.repeats && values.has('P') && values['P'] == curve.order_word;
  if (!again && curve.order > 0) first.add('P');
  bool told = false;
  for (const char letter : std::string_view("PDJHL")) {
    if (!first.has(letter) || !values.has(letter)) continue;
    report_word(task, letter, Code::SC3110,
                std::string(1, letter) + " belongs to the first block of the curve");
    told = true;
  }
  return told;
}

void read_block(Task& task, PendingCurve& curve) {
  const bool begins = is_first(curve);
  const bool named = task.values.letters().has_any(kAxisWords);
  const bool strays = curve.closing_knots == 0 && task.command.missing().has_any(kAxisWords);
  const bool has_axes = named || strays || task.command.uncertain().has_any(kAxisWords);
  read_chopping(task);
  const bool misplaced = !begins && has_words_of_first(task, curve);
  curve.knot_told = misplaced && !task.values.has('K');
  if (curve.knot_told) curve.knots_uncertain = curve.misshapen = true;
  if (curve.knot_told && !has_axes) return;
  if (!misplaced && stands_for_knot(task, curve)) return read_knot_meant(task, curve);
  if (!curve.knot_told && !task.values.has('K')) tell_missing_knot(task, curve);
  if (begins || has_axes)
    read_control_point(task, curve);
  else
    read_closing_knot(task, curve);
  doubt_lone_coordinate(task, curve);
}

void forget_curve(Modal& modal) {
  modal.curve.reset();
  modal.motion = nullptr;
}

/// That has been told; that blocks of the curve follow, which nobody can tell apart from others,
/// has not to be.
void leave_curve(Modal& modal) {
  forget_curve(modal);
  modal.uncertain.add('G');
  modal.words_of_left_curve = kWordsOfCurveBlocks;
}

std::string unfinished(const PendingCurve& curve) {
  return "the curve has " + std::to_string(curve.closing_knots) + " of its " +
         std::to_string(curve.order) + " closing knots";
}

void report_left_early(const PendingCurve& curve, const GCode& code, const Word& word,
                       Output& out) {
  const std::string name = code_name(code);
  if (curve.closing_knots > 0)
    out.report(Code::SC3104, word.pos, name + " too early: " + unfinished(curve));
  else
    out.report(Code::SC3105, word.pos, name + " within a curve of G06.2");
}

/// LinuxCNC's form: G06.2 stands in the second block too. With another P it begins a new curve,
/// unless that of the first block could not be read.
bool goes_on(const PendingCurve& curve, const Command& command) {
  if (!curve.repeats && curve.spec.control.size() != 1) return false;
  const Values& values = command.values();
  const bool order_lost = curve.order == 0 && curve.order_word == 0;
  const bool any = !values.has('P') || order_lost || !command.uncertain().empty();
  return any || values['P'] == curve.order_word;
}

/// F within a curve, where no next one may begin with it. Beside a code the line may be the first
/// of the curve once more, with its knot.
void tell_late_feed(const Command& command, Modal& modal, const Word& word, Output& out) {
  PendingCurve& curve = *modal.curve;
  const bool coded = command.has(Group::motion);
  const bool repeated = command.find(Group::motion) == modal.motion && goes_on(curve, command);
  if (coded && (!repeated || curve.knots_uncertain || curve.order == 0)) return;
  out.report(Code::SC3110, word.pos, "F belongs to the first block of the curve");
  if (coded) curve.knots_uncertain = true;
}

/// LinuxCNC's form in the fanuc dialect is told once, and read on as what it is.
void refuse_repetition(PendingCurve& curve, const Word& word, Output& out) {
  if (!curve.knots_uncertain) out.report(Code::SC3105, word.pos, "G06.2 within a curve of G06.2");
  curve.knots_uncertain = true;
}

}  // namespace

void nurbs(Task& task) {
  if (!task.modal.curve) begin_curve(task);
  PendingCurve& curve = *task.modal.curve;
  read_block(task, curve);
  note_faults(task.command, task.modal, task.out, curve);
  if (curve.order == 0 || curve.closing_knots < curve.order) return;
  if (curve.broken) {
    show_broken_curve(task, curve);
    return leave_curve(task.modal);
  }
  finish_curve(task, curve);
  forget_curve(task.modal);
}

void check_pending_curve(const Command& command, Dialect dialect, Modal& modal, Output& out) {
  PendingCurve& curve = *modal.curve;
  if (command.uncertain().has('K')) curve.knots_uncertain = true;
  const bool left = ends_curve(command, *modal.motion);
  for (const auto& [code, word] : command.codes()) {
    if (code->group == Group::line_number || is_told_number(*code, command)) continue;
    if (code == modal.motion && goes_on(curve, command)) {
      if (dialect == Dialect::fanuc && !curve.repeats) refuse_repetition(curve, *word, out);
      curve.repeats = true;
      if (curve.order_word == 0) curve.order_word = command.values().value_or('P', 0);
      continue;
    }
    if (code->group == Group::feed) {
      tell_late_feed(command, modal, *word, out);
      continue;
    }
    if (!curve.knots_uncertain) report_left_early(curve, *code, *word, out);
    if (left || code == modal.motion) return leave_curve(modal);
    note_stranger(*code, curve);
    curve.knots_uncertain = true;
  }
  if (command.find(Group::motion) == modal.motion || !command.uncertain().has('G')) return;
  modal.left_curve_may_go_on = curve.repeats || curve.spec.control.size() == 1;
  leave_curve(modal);
}

void end_pending_curve(Modal& modal, Output& out) {
  const PendingCurve& curve = *modal.curve;
  if (!curve.knots_uncertain)
    out.report(Code::SC3104, curve.head.word, "the program ends, and " + unfinished(curve),
               curve.head.line);
  forget_curve(modal);
}

}  // namespace softcnc::ipr
