// SPDX-License-Identifier: MIT
// Motions planned by themselves, before anything is decided.
#pragma once

#include <memory>

#include "ipo/limits/constraint_list.hpp"
#include "ipo/smoothing/corner_choice.hpp"

namespace softcnc::ipo {

/// It plans motions of the machine from rest to rest as the planner does, without an override; a
/// time contains what a motion waits at rests within, for the drives or in the mean for the next
/// sample. `machine` and the further constraints must outlive it.
std::unique_ptr<const TrialPlan> make_trial_plan(const Machine& machine,
                                                 const FurtherConstraints& further = {});

}  // namespace softcnc::ipo
