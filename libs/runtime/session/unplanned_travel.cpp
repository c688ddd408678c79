// SPDX-License-Identifier: MIT
#include "runtime/session/unplanned_travel.hpp"

#include <utility>

#include "ipo/path/travel.hpp"

namespace softcnc::runtime {

void UnplannedTravel::check(const Move& move, SourcePos source) {
  auto outside = ipo::check_travel(move, machine_);
  if (!outside) return;
  outside->pos = source;
  diagnostics_.report(std::move(*outside));
}

}  // namespace softcnc::runtime
