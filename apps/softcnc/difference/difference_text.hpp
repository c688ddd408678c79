// SPDX-License-Identifier: MIT
// In what two runs differ, for a person and for programs.
#pragma once

#include <string>
#include <vector>

#include "difference/compared_run.hpp"
#include "hal/machine/machine_file.hpp"
#include "output/junit.hpp"
#include "runtime/difference/run_difference.hpp"

namespace softcnc::app {

/// Two runs, and how they differ.
struct ComparedPair {
  const ComparedRun& a;
  const ComparedRun& b;
  const runtime::RunDifference& difference;
};

/// Returns tables of times, of what differs beyond its margin, and the first row that does. Names
/// at most `lines` lines of the program.
std::string difference_text(const ComparedPair& pair, std::size_t lines);

/// Returns one JSON document: docs/cli.md. The same of `lines`.
std::string difference_json(const ComparedPair& pair, std::size_t lines);

/// Returns the values in which the machines differ; none where one of them is not known.
std::vector<hal::DifferingValue> machine_differences(const ComparedPair& pair);

/// Returns a test case for each aspect; those that are not judged are skipped.
std::vector<TestCase> difference_cases(const ComparedPair& pair);

/// The first row that differs, in one sentence: "row 13, at 0.012 s, line 3: X is 0.5 mm in A and
/// 0.6 mm in B". Empty where no row differs.
std::string first_difference(const ComparedPair& pair);

/// A difference with its unit: "12.3 um", "0.5 s", "3 rows".
std::string amount(runtime::Aspect aspect, double value);

}  // namespace softcnc::app
