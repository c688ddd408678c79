// SPDX-License-Identifier: MIT
// The kind of window for a machine.
#pragma once

#include <memory>

#include "ipo/jerk_limited/horizon.hpp"
#include "ipo/path/window.hpp"

namespace softcnc::ipo {

/// Makes the kind of window that the limits of the machine ask for: with the exact optimum where no
/// axis has a jerk limit, with near-optimal plans where one has.
std::unique_ptr<Window> make_window(const ConstraintList& constraints, double share = 1,
                                    const Horizon& horizon = {});

}  // namespace softcnc::ipo
