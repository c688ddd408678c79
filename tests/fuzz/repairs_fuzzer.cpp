// SPDX-License-Identifier: MIT
// libFuzzer on the search for errors that follow from others: something is always told of a wrong
// program, and the same every time.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "ipr/judge.hpp"

namespace {

/// As much of kMostWork for each trial: a fuzzer is to try many programs, not one thoroughly.
constexpr std::int64_t kWork = 100'000;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace softcnc::ipr;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Dialect dialect = size % 2 == 0 ? Dialect::linuxcnc : Dialect::fanuc;
  const Judge judge = [&](const std::string& changed) {
    Verdict verdict = verdict_of(changed, dialect);
    verdict.work += kWork;
    return verdict;
  };
  const auto errors = judge(text).errors;
  if (errors.size() < 2 || errors.size() > 100) return 0;
  const std::vector<bool> follows = follow_from_others(text, errors, judge);
  const bool all = std::all_of(follows.begin(), follows.end(), [](bool follow) { return follow; });
  if (!all && follows == follow_from_others(text, errors, judge)) return 0;
  std::fprintf(stderr, all ? "nothing is told\n" : "not the same twice\n");
  std::abort();
}
