// SPDX-License-Identifier: MIT
#include "output/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "motion/core/utf8.hpp"

namespace softcnc::app {
namespace {

/// Text as a value of an attribute or between tags.
std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : as_utf8(text)) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      case '\n':
        xml += "&#10;";
        break;
      case '\t':
        xml += "&#9;";
        break;
      default:
        if (static_cast<unsigned char>(c) < ' ')
          xml += kReplacement;
        else
          xml += c;
    }
  }
  for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})  // U+FFFE, U+FFFF
    for (std::size_t at = 0; (at = xml.find(none, at)) != xml.npos;)
      xml.replace(at, none.size(), kReplacement);
  return xml;
}

std::string attribute(const char* name, const std::string& value) {
  return fmt::format(" {}=\"{}\"", name, escaped(value));
}

std::string content(const TestCase& test) {
  const std::string output =
      test.details.empty() ? "" : "<system-out>" + escaped(test.details) + "</system-out>";
  switch (test.result) {
    case TestResult::passed:
      return output;
    case TestResult::skipped:
      return "<skipped" + attribute("message", test.message) + "/>" + output;
    case TestResult::failed:
    case TestResult::error:
      break;
  }
  const char* tag = test.result == TestResult::failed ? "failure" : "error";
  return fmt::format("<{0}{1}{2}>{3}</{0}>", tag, attribute("message", test.message),
                     attribute("type", test.type), escaped(test.details));
}

std::string time_of(const std::optional<double>& seconds) {
  return seconds ? fmt::format(" time=\"{:.3f}\"", *seconds) : std::string();
}

std::string case_xml(const std::string& class_name, const TestCase& test) {
  const std::string inside = content(test);
  const std::string head = "    <testcase" + attribute("classname", class_name) +
                           attribute("name", test.name) + time_of(test.seconds);
  return inside.empty() ? head + "/>\n" : head + ">" + inside + "</testcase>\n";
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::string& class_name,
                      const std::vector<TestCase>& cases) {
  const auto count = [&](TestResult result) {
    return std::count_if(cases.begin(), cases.end(),
                         [&](const TestCase& test) { return test.result == result; });
  };
  double seconds = 0;
  for (const TestCase& test : cases) seconds += test.seconds.value_or(0);
  const std::string counts = fmt::format(
      " tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"", cases.size(),
      count(TestResult::failed), count(TestResult::error), count(TestResult::skipped), seconds);
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite" +
                    attribute("name", suite) + counts + ">\n";
  for (const TestCase& test : cases) xml += case_xml(class_name, test);
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace softcnc::app
