// SPDX-License-Identifier: MIT
// G06.2, a NURBS over several lines: one block per control point, then as many blocks of K alone as
// the order. It ends by that count. FANUC writes G06.2 once; LinuxCNC may write it in every block.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kDefaultNurbsOrder = 4;
constexpr int kLeastOrder = 2;
constexpr int kFanucOrder = 4;  // the largest of a FANUC control

bool is_first(const PendingCurve& curve) { return curve.spec.control.empty(); }

void note_order(Task& task, const Word& word) {
  if (!is_fanuc_like(task.options.dialect) || word.value <= kFanucOrder) return;
  if (task.modal.order_reported) return;
  task.modal.order_reported = true;
  task.out.report(Code::SC3113, word.pos,
                  "FANUC controls take orders up to " + std::to_string(kFanucOrder) +
                      "; softcnc runs this one of " + number_text(word.value) + " all the same");
}

std::optional<int> read_order(Task& task) {
  if (!task.values.has('P')) return kDefaultNurbsOrder;
  const Word& word = task.values.word('P');
  const bool legal = word.value == std::floor(word.value) && word.value >= kLeastOrder &&
                     word.value <= Nurbs::kMaxDegree + 1;
  if (legal) {
    note_order(task, word);
    return static_cast<int>(word.value);
  }
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

void begin_curve(Task& task) {
  begin_motion(task);
  check_feed_mode(task);
  ask_for_surface_of_curve(task);
  PendingCurve& curve = task.modal.curve.emplace();
  curve.order = read_order(task).value_or(kDefaultNurbsOrder);
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

/// What is wrong with the knot just read can be said at once, and so at its place.
void check_knot(Task& task, const PendingCurve& curve) {
  const std::vector<double>& knots = curve.spec.knots;
  const int count = static_cast<int>(knots.size());
  const double knot = knots.back();
  const double before = count > 1 ? knots[static_cast<std::size_t>(count) - 2] : knot;
  const bool end = knot == knots.front() || curve.closing_knots > 0;
  const int most = end ? curve.order : curve.order - 1;
  if (knot < before)
    report_word(task, 'K', Code::SC3004,
                "knot " + number_text(knot) + " after " + number_text(before) +
                    "; knots must not decrease");
  else if (count <= curve.order && knot != knots.front())
    report_word(task, 'K', Code::SC3005, ends_message("first", curve.order));
  else if (curve.closing_knots > 1 && knot != before)
    report_word(task, 'K', Code::SC3005, ends_message("last", curve.order));
  else if (const int row = repetitions(knots); row > most)
    report_word(task, 'K', Code::SC3006,
                "knot " + number_text(knot) + " stands " + std::to_string(row) +
                    " times in a row; at most " + std::to_string(most) + " can be here");
}

void read_knot(Task& task, PendingCurve& curve) {
  curve.spec.knots.push_back(task.values['K']);
  check_knot(task, curve);
}

double read_weight(Task& task) {
  if (!task.values.has('R')) return 1;
  const Word& word = task.values.word('R');
  if (word.value <= 0)
    report_word(task, 'R', Code::SC3007, "R, the weight of a control point, must be above 0");
  return word.value;
}

/// The first block names the axes of the curve; if it names none, the second one does.
void check_curve_axes(Task& task, PendingCurve& curve) {
  const bool naming = curve.axes.empty() && curve.spec.control.size() <= 1;
  for (const char letter : kAxisLetters) {
    if (!task.values.has(letter) || curve.axes.has(letter)) continue;
    curve.axes.add(letter);
    if (naming) continue;
    task.out.report(Code::SC3103, task.values.word(letter).pos,
                    std::string(1, letter) + " is missing in the first block of the curve");
  }
}

/// The curve begins in the position exactly, wherever within the tolerance its first point lies.
AxisVector first_point(Task& task) {
  const double off = (end_point(task) - task.modal.position).norm();
  if (off > start_tolerance(task.machine))
    task.out.report(
        Code::SC3109, span_of(task.values, "XYZ"),
        "the first control point is " + number_text(off) + " mm from the current position");
  return task.modal.position;
}

void read_control_point(Task& task, PendingCurve& curve) {
  if (curve.closing_knots > 0)
    return task.out.report(Code::SC3104, span_of(task.values, "XYZ"),
                           "a control point after " + std::to_string(curve.closing_knots) + " of " +
                               std::to_string(curve.order) + " closing knots");
  check_curve_axes(task, curve);
  if (curve.spec.control.size() == kMostCurvePoints) return report_too_many(task);
  task.modal.position = is_first(curve) ? first_point(task) : end_point(task);
  curve.spec.control.push_back(task.modal.position);
  curve.spec.weights.push_back(read_weight(task));
  read_knot(task, curve);
}

void read_closing_knot(Task& task, PendingCurve& curve) {
  const int points = static_cast<int>(curve.spec.control.size());
  if (curve.closing_knots++ == 0 && points < curve.order)
    task.out.report(Code::SC3002, task.word.pos,
                    "the curve ends after " + std::to_string(points) +
                        " control points; its order asks for " + std::to_string(curve.order));
  else if (task.values.has('R'))
    report_word(task, 'R', Code::SC3111, "a closing knot takes K alone");
  read_knot(task, curve);
}

void finish_curve(Task& task, PendingCurve& curve) {
  Result<Nurbs> made = Nurbs::make(std::move(curve.spec));
  if (!made)
    return task.out.report(made.error().code, curve.head.word, std::move(made.error().message),
                           curve.head.line);
  Path path = std::move(*made);
  const PlacedWord at{curve.head.word, curve.head.line, code_name(task.code)};
  if (task.modal.placement && !place_path(task.modal, task.out, at, path)) return;
  if (has_surface_speed(task.modal, task.out, curve.head.word, curve.head.line))
    task.out.emit(cutting_move(task.modal, std::move(path), curve.head.feed), curve.head.source);
}

/// LinuxCNC's Q chooses how the curve is chopped; here it is not.
void read_chopping(Task& task) {
  if (!task.values.has('Q')) return;
  const Word& word = task.values.word('Q');
  if (is_fanuc_like(task.options.dialect))
    return task.out.report(Code::SC2004, word.pos, "unused word Q");
  if (task.modal.chopping_reported) return;
  task.modal.chopping_reported = true;
  task.out.report(Code::SC3114, word.pos,
                  "Q, the way of chopping the curve, has no effect: no curve is chopped");
}

/// Reports words that count for the whole curve.
void refuse_words_of_first(Task& task, const PendingCurve& curve) {
  const Values& values = task.values;
  LetterSet first = kSurfaceWordsOfCurve;
  const bool again = curve.repeats && values.has('P') && values['P'] == curve.order_word;
  if (!again) first.add('P');
  for (const char letter : std::string_view("PDJHL"))
    if (first.has(letter) && values.has(letter))
      report_word(task, letter, Code::SC3110,
                  std::string(1, letter) + " belongs to the first block of the curve");
}

void read_block(Task& task, PendingCurve& curve) {
  read_chopping(task);
  if (!is_first(curve)) refuse_words_of_first(task, curve);
  if (!task.values.has('K'))
    return task.out.report(Code::SC3102, task.word.pos, "a block of a curve needs its knot, K");
  if (is_first(curve) || task.values.letters().has_any(kAxisWords))
    read_control_point(task, curve);
  else
    read_closing_knot(task, curve);
}

void forget_curve(Modal& modal) {
  modal.curve.reset();
  modal.motion = nullptr;
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

/// LinuxCNC's form: G06.2 stands in the second block too, or before each closing knot alone, as in
/// its samples. With another P it begins a new curve.
bool goes_on(const PendingCurve& curve, const Command& command) {
  const Values& values = command.values();
  const bool closing = values.has('K') && !values.has('P') && !values.letters().has_any(kAxisWords);
  if (!curve.repeats && !closing && curve.spec.control.size() != 1) return false;
  return !values.has('P') || values['P'] == curve.order_word;
}

}  // namespace

void nurbs(Task& task) {
  if (!task.modal.curve) begin_curve(task);
  PendingCurve& curve = *task.modal.curve;
  read_block(task, curve);
  if (task.out.failed() || curve.closing_knots < curve.order) return;
  finish_curve(task, curve);
  forget_curve(task.modal);
}

/// Any code but G06.2 in LinuxCNC's form.
void check_pending_curve(const Command& command, Dialect dialect, Modal& modal, Output& out) {
  PendingCurve& curve = *modal.curve;
  for (const auto& [code, word] : command.codes()) {
    if (code->group == Group::line_number) continue;
    if (code == modal.motion && goes_on(curve, command)) {
      if (is_fanuc_like(dialect) && !curve.repeats)
        out.report(Code::SC3105, word->pos, "G06.2 within a curve of G06.2");
      curve.repeats = true;
      if (curve.order_word == 0) curve.order_word = command.values().value_or('P', 0);
      continue;
    }
    if (code->group == Group::feed && !ends_curve(command, *modal.motion))
      out.report(Code::SC3110, word->pos, "F belongs to the first block of the curve");
    else
      report_left_early(curve, *code, *word, out);
  }
}

void end_pending_curve(Modal& modal, Output& out) {
  const PendingCurve& curve = *modal.curve;
  out.report(Code::SC3104, curve.head.word, "the program ends, and " + unfinished(curve),
             curve.head.line);
  forget_curve(modal);
}

}  // namespace softcnc::ipr
