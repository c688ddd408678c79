// SPDX-License-Identifier: MIT
#include "ipo/planner/make_window.hpp"

#include "ipo/acceleration_limited/exact_window.hpp"
#include "ipo/jerk_limited/jerk_window.hpp"

namespace softcnc::ipo {

std::unique_ptr<Window> make_window(const ConstraintList& constraints, double share,
                                    const Horizon& horizon) {
  if (constraints.limits_jerk()) return std::make_unique<JerkWindow>(constraints, share, horizon);
  return std::make_unique<ExactWindow>(constraints, share);
}

}  // namespace softcnc::ipo
