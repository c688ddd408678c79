// SPDX-License-Identifier: MIT
// The period of most machines in tests.
#pragma once

namespace softcnc::test {

inline constexpr double kPeriod = 1e-3;  // s

}  // namespace softcnc::test
