// SPDX-License-Identifier: MIT
#include "runtime/session/output_events.hpp"

#include <algorithm>
#include <string>

namespace softcnc::runtime {

void settle_outputs(TimeSheet& sheet, const Machine& machine, Diagnostics& diagnostics) {
  const BackendKind backend = machine.control.backend;
  for (OutputEvent& event : sheet.outputs)
    if (event.source.file != 0) event.file = diagnostics.file(event.source.file);
  const bool moves_a_machine = backend != BackendKind::none && backend != BackendKind::sim;
  if (!moves_a_machine) return;
  const auto is_passed_on = [&](const OutputEvent& event) {
    const bool has_place = backend == BackendKind::parport
                               ? event.port.pin != 0
                               : backend == BackendKind::hal_stream && machine.hal_stream.outputs;
    return has_place && is_switched(event.port);
  };
  const auto passed_on = std::count_if(sheet.outputs.begin(), sheet.outputs.end(), is_passed_on);
  if (passed_on == static_cast<std::ptrdiff_t>(sheet.outputs.size())) return;
  const auto count =
      static_cast<std::int64_t>(sheet.outputs.size()) - passed_on + sheet.outputs_left_out;
  diagnostics.report(Code::SC5050, {},
                     "the program sets outputs " + std::to_string(count) +
                         (count == 1 ? " time" : " times") + ", which backend " +
                         std::string(name(backend)) + " does not pass on");
}

}  // namespace softcnc::runtime
