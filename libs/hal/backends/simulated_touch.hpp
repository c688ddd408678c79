// SPDX-License-Identifier: MIT
// The probe of the simulated mill: it touches the bodies of the machine file.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/model/probe_tip.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

class SimulatedTouch {
 public:
  explicit SimulatedTouch(const Machine& machine) : bodies_(contact_bodies(machine)) {}

  bool has_bodies() const noexcept { return !bodies_.empty(); }
  /// From now on this tip may touch.
  void begin(const ProbeTip& tip) noexcept { tip_ = tip; }

  /// The axes have come through these places, mm, in coordinates that lie `offset` before those of
  /// the machine file.
  void read(std::span<const AxisVector> places, const AxisVector& offset,
            Feedback& feedback) noexcept {
    if (!tip_ || places.empty()) return;
    feedback.touched = places.back();
    for (const AxisVector& place : places) {
      if (touches_ == touches(bodies_, *tip_, place + offset)) continue;
      touches_ = !touches_;
      feedback.touched = place;
    }
    feedback.probe = touches_;
  }

 private:
  std::vector<ContactBody> bodies_;
  std::optional<ProbeTip> tip_;
  bool touches_ = false;
};

}  // namespace softcnc::hal
