// SPDX-License-Identifier: MIT
// The limits of a path that leave room for commands ahead of it.
#pragma once

#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Returns the machine as its paths are planned. Where commands are ahead of the path
/// (control.follow), they move at v + a t + j t l: t is the lead, 1/Kv at most, and l the lag of
/// the velocity loop. So that they are never faster than the axis, its path has
/// - a jerk limit, 2 A Kv where the machine has none;
/// - a velocity lower by the most that a t - a^2 / 2J can be, which is J t^2 / 2 up to a = J t,
///   plus J t l: before an axis reaches its velocity, its acceleration a has to fall, and the
///   velocity is still a^2 / 2J below;
/// - where that would be more than a quarter of the velocity, lower acceleration and jerk;
/// - no more acceleration than its motor has torque and voltage for.
/// Returns the machine as it is where control.follow is off.
Machine planned_machine(const Machine& machine);

}  // namespace softcnc::ipo
