// SPDX-License-Identifier: MIT
// The adaptive-feed interpolator of Yeh and Hsu (2002).
#include <algorithm>

#include "ipo/limits/chord_error.hpp"
#include "ipo/methods/step_rule.hpp"

namespace softcnc::ipo {

double yeh_hsu_2002_longest(const WalkPlace& place) noexcept {
  return place.part * chord_step(curvature_at(place), place.chord_tolerance);
}

double yeh_hsu_2002_increment(const WalkPlace& place, double ds) noexcept {
  return taylor2_increment(place, std::min(ds, yeh_hsu_2002_longest(place)));
}

}  // namespace softcnc::ipo
