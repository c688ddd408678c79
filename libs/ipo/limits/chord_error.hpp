// SPDX-License-Identifier: MIT
// The step that keeps a chord within its tolerance.
#pragma once

namespace softcnc::ipo {

/// Returns the longest step, mm, whose chord stays within `tolerance` mm of an arc of curvature
/// `kappa` (1/mm): 2 sqrt(2 rho eps - eps^2), paper 000 eq. (5) in its exact circle form. Where
/// rho <= eps it is 2 eps, since a path of length L is never further than L/2 from its chord.
double chord_step(double kappa, double tolerance) noexcept;

}  // namespace softcnc::ipo
