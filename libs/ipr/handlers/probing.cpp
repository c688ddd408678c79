// SPDX-License-Identifier: MIT
// Moves up to the contact of a probe: G38.2 to G38.5, as LinuxCNC's manual has them (G code
// reference, section G38.n), and G31 of FANUC's and Haas' controls.
#include <string>

#include "ipr/handlers/handlers.hpp"
#include "ipr/state/nearness.hpp"
#include "motion/model/contact.hpp"
#include "motion/model/probe_tip.hpp"

namespace softcnc::ipr {
namespace {

/// What a code does: G38.2 and G38.4 must come to a contact or a release.
struct ProbingCode {
  ProbeAim aim;
  bool must;
};

ProbingCode probing_of(const GCode& code) noexcept {
  const bool releases = code.number == kG384 || code.number == kG385;
  return {releases ? ProbeAim::release : ProbeAim::contact,
          code.number == kG382 || code.number == kG384};
}

ProbeTip tip_of(const Task& task) { return probe_tip(task.machine, task.modal.state.loaded_tool); }

/// Whether it is no error to find at once what is looked for, or to move nowhere: as LinuxCNC does,
/// and grbl does not.
bool may_find_nothing(const GCode& code, Dialect dialect) noexcept {
  return dialect == Dialect::linuxcnc && !probing_of(code).must;
}

bool is_no_move(const AxisVector& from, const AxisVector& to) noexcept {
  return (to - from).lpNorm<Eigen::Infinity>() < kShortestMove;
}

/// A move of the plan as it is programmed: it rests at both ends, and no corner of it is rounded.
Move probing_move(const Task& task, const softcnc::Line& line) {
  Move move = cutting_move(task.modal, line, task.modal.feed);
  move.path_mode = PathMode::stop;
  move.corner_tolerance = move.chord_tolerance = 0;
  move.exact = true;
  move.surface.reset();
  return move;
}

/// Ends the move at `end`, and keeps where the contact was.
void end_probing(Task& task, const AxisVector& end, bool contact) {
  if ((end - task.modal.position).norm() >= kShortestMove) {
    task.out.emit(Dwell{0});
    task.out.emit(probing_move(task, softcnc::Line(task.modal.position, end)));
  }
  task.modal.position = end;
  task.modal.probed = ProbedPoint{end, contact};
}

std::string missed(const GCode& code) {
  const bool releases = probing_of(code).aim == ProbeAim::release;
  return code_name(code) +
         (releases ? " comes to its end and still touches" : " comes to its end without a contact");
}

std::string is_so_already(const GCode& code) {
  const bool releases = probing_of(code).aim == ProbeAim::release;
  return code_name(code) +
         (releases ? " begins without a contact" : " begins where the tool touches") + " already";
}

/// The machine will find out.
void wait_for_contact(Task& task, const AxisVector& to) {
  task.out.emit(Action{Action::Kind::probe, 0, 0});
  task.modal.awaited = AwaitedProbe{
      {to, task.modal.feed, probing_of(task.code).aim, tip_of(task), task.out.source()},
      &task.code,
      task.word.pos,
      std::string(task.out.text())};
}

void probe_to(Task& task, const AxisVector& to) {
  const ProbingCode probing = probing_of(task.code);
  if (task.machine.contacts.empty()) {
    task.out.report_once(Code::SC2392, task.word.pos, "probe",
                         code_name(task.code) +
                             " is taken to end where it is programmed to: no [contact] of the "
                             "machine file says what it touches");
    return end_probing(task, to, true);
  }
  const auto bodies = contact_bodies(task.machine);
  const ProbeTip tip = tip_of(task);
  const AxisVector& from = task.modal.position;
  const bool touches_now = touches(bodies, tip, from);
  if (touches_now == (probing.aim == ProbeAim::contact)) {
    if (may_find_nothing(task.code, task.options.dialect)) return end_probing(task, from, true);
    return task.out.report(Code::SC2393, task.word.pos, is_so_already(task.code));
  }
  if (is_no_move(from, to)) return end_probing(task, from, false);
  const softcnc::Line line(from, to);
  if (const auto s = contact_along(line, bodies, tip, probing.aim))
    return end_probing(task, line.position(*s), true);
  if (probing.must) return task.out.report(Code::SC2394, task.word.pos, missed(task.code));
  end_probing(task, to, false);
}

}  // namespace

void warn_of_contact(Task& task, const Path& path) {
  const auto* line = std::get_if<softcnc::Line>(&path);
  if (line == nullptr || task.machine.tools.contains(task.modal.state.loaded_tool.value_or(0)))
    return;
  const ProbeTip tip = tip_of(task);
  for (const auto& [name, body] : task.machine.contacts) {
    const auto s = contact_along(*line, std::span(&body, 1), tip, ProbeAim::contact);
    if (!s) continue;
    return task.out.report_once(Code::SC2395, task.word.pos, "contact",
                                code_name(task.code) + " leads the probe into [contact." + name +
                                    "], " + number_text(*s) + " mm from where it begins");
  }
}

namespace {

/// Why nothing tells a machine that moves by a port of contacts.
std::string why_unread(const Machine& machine) {
  const BackendKind backend = machine.control.backend;
  if (backend == BackendKind::parport && machine.parallel_port.probe_pin != 0)
    return "only softcnc operate and softcnc serve read backend.parport.probe_pin";
  return "the backend " + std::string(name(backend)) + " has no input for a probe";
}

}  // namespace

std::optional<ProbeRefusal> refusal_of(const GCode& code, ProbeFound found, Dialect dialect) {
  if (may_find_nothing(code, dialect)) return std::nullopt;
  if (found == ProbeFound::already) return ProbeRefusal{Code::SC2393, is_so_already(code)};
  if (found == ProbeFound::nothing && probing_of(code).must)
    return ProbeRefusal{Code::SC2394, missed(code)};
  return std::nullopt;
}

void probe(Task& task) {
  if (task.code.group == Group::motion) begin_motion(task);
  if (moves_machine(task.machine.control.backend) && task.options.contacts == Contacts::stated) {
    return task.out.report(Code::SC2114, task.word.pos,
                           code_name(task.code) + " is refused: " + why_unread(task.machine));
  }
  if (!task.values.letters().has_any(kAxisWords)) {
    return task.out.report(Code::SC2005, task.word.pos,
                           code_name(task.code) + " needs X, Y or Z, where it leads at most");
  }
  if (!has_feed(task)) return;
  const AxisVector to = end_point(task);
  if (is_no_move(task.modal.position, to) && !may_find_nothing(task.code, task.options.dialect)) {
    return task.out.report(Code::SC2391, task.word.pos,
                           code_name(task.code) + " ends where it begins: it can find no contact");
  }
  if (task.options.contacts == Contacts::read) return wait_for_contact(task, to);
  probe_to(task, to);
}

}  // namespace softcnc::ipr
