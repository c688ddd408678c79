// SPDX-License-Identifier: MIT
#include "job/run_diagnostics.hpp"

#include <fmt/format.h>

namespace softcnc::app {
Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program) {
  const std::int64_t overruns = punctuality.overruns();
  return {
      .code = punctuality.rights.all() ? Code::SC5040 : Code::SC5041,
      .message = fmt::format("{} of {} periods {} missed; the latest came {:.1f} us late", overruns,
                             punctuality.lateness.wakeups(), overruns == 1 ? "was" : "were",
                             static_cast<double>(punctuality.lateness.largest()) / 1e3),
      .file = program};
}

}  // namespace softcnc::app
