// SPDX-License-Identifier: MIT
// Properties over random values, with a fixed seed so that every run tests the same. SOFTCNC_SEED
// sets another: a long run draws new values in each of its parts.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "support/sanitized.hpp"

namespace softcnc::test {

/// With sanitizers everything takes some ten times as long: there a twentieth of the values has to
/// do, since the release build tries them all.
inline constexpr int kPart = kSanitized ? 20 : 1;

inline std::uint64_t seed() {
  const char* asked = std::getenv("SOFTCNC_SEED");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 20261121;
}

/// How many random programs are tried: as many as SOFTCNC_PROGRAMS says, or `usual`.
inline int programs_asked(int usual) {
  const char* asked = std::getenv("SOFTCNC_PROGRAMS");
  return asked != nullptr ? std::atoi(asked) : usual;
}

/// Holds for `times` random values. `testable` draws them with real(), integer() or rc::gen, and
/// states what must hold with RC_ASSERT.
template <typename Testable>
void holds(Testable&& testable, int times = 200) {
  rc::detail::TestParams params;
  params.seed = seed();
  params.maxSuccess = std::max(1, times / kPart);
  const auto result = rc::detail::checkTestable(std::forward<Testable>(testable),
                                                rc::detail::TestMetadata{}, params);
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  INFO(text.str());
  REQUIRE(result.template is<rc::detail::SuccessResult>());
}

inline double real(double low, double high) {
  return low + (high - low) * *rc::gen::inRange<int>(0, 1000001) / 1e6;
}

inline int integer(int low, int high) { return *rc::gen::inRange<int>(low, high + 1); }

}  // namespace softcnc::test
