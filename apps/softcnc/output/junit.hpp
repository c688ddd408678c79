// SPDX-License-Identifier: MIT
// Results as JUnit XML, which the services of continuous integration read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace softcnc::app {

enum class TestResult : std::uint8_t { passed, failed, error, skipped };

struct TestCase {
  std::string name;
  TestResult result = TestResult::passed;
  std::string message;  // of what has not passed: one line
  std::string type;     // likewise: the code of a diagnostic, or an aspect
  std::string details;  // lines for a person, also of what has passed
  std::optional<double> seconds = {};
};

/// Returns a document with one suite. `class_name` tells its cases from those of other documents,
/// which services join. Characters that XML cannot hold become U+FFFD.
std::string junit_xml(const std::string& suite, const std::string& class_name,
                      const std::vector<TestCase>& cases);

}  // namespace softcnc::app
