// SPDX-License-Identifier: MIT
// Codes that are known, and ask for what softcnc cannot do.
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

void report(Task& task, const std::string& why) {
  task.out.report(Code::SC2114, task.word.pos, code_name(task.code) + " is refused: " + why);
}

}  // namespace

/// G33, G33.1, G76.
void refuse_thread(Task& task) {
  // G76: a thread of LinuxCNC's, fine boring of FANUC's.
  if (task.code.number == kG76 && is_fanuc(task)) return refuse_cycle(task);
  report(task, "threads need a spindle with an encoder, which the axes could follow");
  task.modal.motion = task.modal.motion_below = nullptr;
}

/// M29. Whether the spindle would turn after it is not known.
void refuse_rigid_tapping(Task& task) {
  report(task,
         "rigid tapping needs a spindle in step with the axis; G74 and G84 without M29 take a "
         "floating holder and a spindle that turns");
  task.modal.unknown.add(Part::spindle);
}

/// G31, G38.2 to G38.5. Where the tool would stop is not known.
void refuse_probing(Task& task) {
  report(task, "it moves up to the signal of a probe, and the machine has none");
  if (task.code.group == Group::motion) task.modal.motion = task.modal.motion_below = nullptr;
}

/// G47, G150, M109.
void refuse_of_haas(Task& task) {
  if (task.code.number == kG47)
    return report(task, "it engraves a text or a serial number in the letters of the control");
  if (task.code.number == kG150)
    return report(task,
                  "it clears a pocket whose outline is the program of P, by paths of the control");
  report(task, "it shows a text to the operator and puts the key pressed into the variable of P");
}

/// G103: how far a control looks ahead; G187 P: how smoothly it moves.
void pass_over(Task& task) {
  task.out.report(Code::SC2268, task.word.pos,
                  code_name(task.code) +
                      " has no effect: softcnc looks ahead over the whole program, and keeps the "
                      "tolerance of G64");
}

}  // namespace softcnc::ipr
