// SPDX-License-Identifier: MIT
// How long a motion takes, planned by itself.
#pragma once

#include "ipo/limits/constraint_list.hpp"
#include "ipo/smoothing/corner_choice.hpp"

namespace softcnc::ipo {

/// Returns a function that plans motions of the machine from rest to rest as the planner does,
/// without an override, and returns their time, s, with what they wait for the drives at rests
/// within. `machine` and the further constraints must outlive it.
PlannedTime planned_time(const Machine& machine, const FurtherConstraints& further = {});

}  // namespace softcnc::ipo
