// SPDX-License-Identifier: MIT
// The results of many replays: in one sentence, as JSON, as test cases.
#pragma once

#include <string>
#include <vector>

#include "output/junit.hpp"
#include "replay/replay_run.hpp"

namespace softcnc::app {

/// Returns "12 of 13 recordings agree; 1 differs".
std::string replay_summary(const std::vector<ReplayResult>& results);

/// Returns one JSON document: docs/cli.md.
std::string replay_json(const std::vector<ReplayResult>& results);

/// Returns a test case for each recording.
std::vector<TestCase> replay_cases(const std::vector<ReplayResult>& results);

}  // namespace softcnc::app
