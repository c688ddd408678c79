// SPDX-License-Identifier: MIT
// The table of backends.
#include "hal/backends/backend.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "hal/backends/hal_stream.hpp"
#include "hal/backends/home_switches.hpp"
#include "hal/backends/sim.hpp"
#include "hal/backends/stepdir.hpp"
#include "hal/ports/port_edges.hpp"

namespace softcnc::hal {
namespace {

/// Goes nowhere: the axes are taken to be where they are commanded.
class NullBackend final : public Backend {
 public:
  explicit NullBackend(const Machine& machine) : switches_(machine) {}

  Feedback exchange(const Setpoint& setpoint) noexcept override {
    position_ = setpoint.position;
    Feedback feedback{position_, Alarm::none, -1};
    switches_.read(std::span(&position_, 1), feedback);
    return feedback;
  }
  void begin_again() noexcept override { switches_.begin_again(); }
  bool has_home_switches() const noexcept override { return true; }
  AxisVector settle() const noexcept override { return position_; }

 private:
  HomeSwitches switches_;
  AxisVector position_ = AxisVector::Zero();
};

Result<std::unique_ptr<Backend>> open_parport(const Machine& machine, OpenPlayer open_player) {
  std::unique_ptr<EdgeSink> edges;
  if (open_player && !machine.parallel_port.device.empty()) {
    auto player = open_player(machine);
    if (!player) return tl::make_unexpected(std::move(player.error()));
    edges = std::make_unique<PortEdges>(machine, std::move(*player));
  }
  return std::make_unique<StepDir>(machine, port_timing(machine).rules, std::move(edges));
}

struct BackendEntry {
  BackendKind kind;
  Result<std::unique_ptr<Backend>> (*open)(const Machine&, OpenPlayer);
};

constexpr BackendEntry kBackends[] = {
    {BackendKind::none,
     [](const Machine& machine, OpenPlayer) -> Result<std::unique_ptr<Backend>> {
       return std::make_unique<NullBackend>(machine);
     }},
    {BackendKind::sim,
     [](const Machine& machine, OpenPlayer) -> Result<std::unique_ptr<Backend>> {
       return std::make_unique<SimulatedMill>(machine);
     }},
    {BackendKind::stepdir,
     [](const Machine& machine, OpenPlayer) -> Result<std::unique_ptr<Backend>> {
       return StepDir::open(machine);
     }},
    {BackendKind::parport, open_parport},
    {BackendKind::hal_stream,
     [](const Machine& machine, OpenPlayer) -> Result<std::unique_ptr<Backend>> {
       return HalRows::open(machine);
     }},
};

std::array<double, kAxes> unknown_by_axis() noexcept {
  std::array<double, kAxes> none{};
  none.fill(std::numeric_limits<double>::quiet_NaN());
  return none;
}

}  // namespace

std::array<double, kAxes> Backend::following_error_max() const noexcept {
  return unknown_by_axis();
}

std::array<double, kAxes> Backend::lag_misfit() const noexcept { return unknown_by_axis(); }

Machine without_port(Machine machine) {
  machine.step_port.file.clear();
  machine.hal_stream.file.clear();
  machine.parallel_port.device.clear();
  return machine;
}

Result<std::unique_ptr<Backend>> open_backend(const Machine& machine, OpenPlayer open_player) {
  const auto* entry = std::find_if(std::begin(kBackends), std::end(kBackends), [&](const auto& r) {
    return r.kind == machine.control.backend;
  });
  return entry->open(machine, open_player);
}

}  // namespace softcnc::hal
