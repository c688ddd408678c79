// SPDX-License-Identifier: MIT
// Whether a method that ignores the planned speeds fits the backend and the periods.
#include <cmath>
#include <string>

#include "hal/files/number.hpp"
#include "hal/machine/machine_loader.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr double kRoundOff = 1e-9;
/// Periods that an average may have: their positions are kept.
constexpr int kMostPeriods = 100'000;

std::string in_ms(double seconds) { return number_text(ms_from_s(seconds)); }

}  // namespace

void MachineLoader::check_method() {
  const Control& control = loaded_.machine.control;
  if (control.backend != BackendKind::none && control.backend != BackendKind::sim)
    clash(Code::SC7081, {"control.interpolation", "control.backend"},
          std::string(name(control.interpolation)) +
              " keeps no limit of the axes, so it runs with control.backend = none or sim alone, "
              "not with " +
              std::string(name(control.backend)));
  if (control.interpolation == Method::two_step) check_rough_period();
  if (accelerates_after(control.interpolation)) check_averages();
}

void MachineLoader::check_rough_period() {
  const Control& control = loaded_.machine.control;
  const double ratio = control.rough_period / control.period;
  if (ratio > 0.5 && std::abs(ratio - std::round(ratio)) < kRoundOff * ratio) return;
  clash(Code::SC7082, {"control.rough_period_ms", "control.period_ms", "control.interpolation"},
        "control.rough_period_ms = " + in_ms(control.rough_period) +
            " is not a multiple of control.period_ms = " + in_ms(control.period));
}

void MachineLoader::check_averages() {
  const Control& control = loaded_.machine.control;
  const bool rough = control.interpolation == Method::two_step;
  const double period = rough ? control.rough_period : control.period;
  const double time = acc_dec_time(loaded_.machine);
  if (time <= kMostPeriods * period) return;
  clash(Code::SC7083,
        {"control.acc_dec_ms", "axis.x.acceleration_mm_s2", "axis.y.acceleration_mm_s2",
         "axis.z.acceleration_mm_s2", "control.period_ms", "control.rough_period_ms",
         "control.interpolation"},
        "acceleration over " + in_ms(time) + " ms is more than " + std::to_string(kMostPeriods) +
            " periods of " + in_ms(period) + " ms");
}

}  // namespace softcnc::hal
