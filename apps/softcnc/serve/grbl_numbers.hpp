// SPDX-License-Identifier: MIT
// The numbers by which grbl 1.1 names errors and alarms.
#pragma once

#include <string>

#include "motion/core/diagnostic.hpp"

namespace softcnc::app {

/// The errors of grbl that the protocol itself gives.
struct GrblError {
  static constexpr int kNoNumber = 2, kStatement = 3, kNoHoming = 5, kNotIdle = 8, kLocked = 9,
                       kTooLong = 11, kTravel = 15, kJogWords = 16, kUnsupported = 20, kNoFeed = 22,
                       kRepeated = 25;
};
struct GrblAlarm {
  static constexpr int kLimit = 1, kReset = 3, kProbeClosed = 4, kNoContact = 5, kHomingReset = 6,
                       kHoming = 9;
};

/// Returns the error of grbl that comes nearest to a diagnostic.
int grbl_error(const Diagnostic& diagnostic) noexcept;

/// "[MSG:SC2102 no feed]": without the words "ok" and "error", by which senders count answers, and
/// without brackets.
std::string grbl_message(const Diagnostic& diagnostic);

}  // namespace softcnc::app
