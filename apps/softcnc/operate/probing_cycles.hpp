// SPDX-License-Identifier: MIT
// Probing as a person asks for it: one face, a bore, a boss or a corner, as lines of G-code.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "motion/core/axes.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::app {

/// The machine rests at `place`, mm, with a ball of this radius, mm.
struct ProbingStart {
  AxisVector place = AxisVector::Zero();
  double radius = 0;
};

/// Returns the lines, for modes saved by M70 before them:
///
///   "Z-20", "Z-20=0"  probes over so many mm, and gives the tip at the contact this coordinate;
///                     back to where it began
///   "bore X30 Y30"    from within a bore or pocket about so wide: its centre becomes X0 Y0
///   "boss X60 Y40 Z8" from above a boss or block about so wide, so deep down beside it: likewise
///   "corner X15 Y15"  from before an outer corner, which becomes X0 Y0: so far along its faces
///
/// Errors: what is wrong with the text.
tl::expected<std::string, std::string> probing_lines(std::string_view text,
                                                     const ProbingStart& start,
                                                     const Machine& machine);

}  // namespace softcnc::app
