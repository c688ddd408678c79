// SPDX-License-Identifier: MIT
// The table of backends.
#include "hal/backend.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "hal/hal_stream.hpp"
#include "hal/sim.hpp"
#include "hal/stepdir.hpp"

namespace softcnc::hal {
namespace {

/// Goes nowhere: the axes are taken to be where they are commanded.
class None final : public Backend {
 public:
  Feedback exchange(const Setpoint& setpoint) noexcept override {
    position_ = setpoint.position;
    return {position_, Alarm::none, -1};
  }
  AxisVector settle() const noexcept override { return position_; }

 private:
  AxisVector position_ = AxisVector::Zero();
};

struct BackendRow {
  BackendKind kind;
  Result<std::unique_ptr<Backend>> (*open)(const Machine&);
};

constexpr BackendRow kBackends[] = {
    {BackendKind::none,
     [](const Machine&) -> Result<std::unique_ptr<Backend>> { return std::make_unique<None>(); }},
    {BackendKind::sim,
     [](const Machine& machine) -> Result<std::unique_ptr<Backend>> {
       return std::make_unique<SimulatedMill>(machine);
     }},
    {BackendKind::stepdir,
     [](const Machine& machine) -> Result<std::unique_ptr<Backend>> {
       return StepDir::open(machine);
     }},
    {BackendKind::hal_stream,
     [](const Machine& machine) -> Result<std::unique_ptr<Backend>> {
       return HalRows::open(machine);
     }},
};

}  // namespace

std::array<double, kAxes> Backend::following_error_max() const noexcept {
  std::array<double, kAxes> none{};
  none.fill(std::numeric_limits<double>::quiet_NaN());
  return none;
}

Machine without_port(Machine machine) {
  machine.step_port.file.clear();
  machine.hal_stream.file.clear();
  return machine;
}

Result<std::unique_ptr<Backend>> open_backend(const Machine& machine) {
  const auto* row = std::find_if(std::begin(kBackends), std::end(kBackends),
                                 [&](const auto& r) { return r.kind == machine.control.backend; });
  return row->open(machine);
}

}  // namespace softcnc::hal
