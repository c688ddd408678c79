// SPDX-License-Identifier: MIT
// What is done in one place: a run is driven and judged, its requests are kept, and its repeated
// errors are counted, by the folders named in the floor plan, and all others ask them.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>

#include "house/includes.hpp"

using namespace softcnc::house;

namespace {

/// The folders that may include a header, by its name.
const std::map<std::string, std::set<std::string>> kAllowed{
    {"runtime/session/simulate.hpp", {"runtime/session", "runtime/run", "runtime/check"}},
    {"runtime/session/axis_alarm.hpp", {"runtime/session", "runtime/run", "runtime/operator"}},
    {"runtime/session/verification.hpp", {"runtime/session", "runtime/run"}},
    {"runtime/run/foreign_language.hpp", {"runtime/run"}},
    {"runtime/session/requests.hpp", {"runtime/session"}},
    {"ipo/planner/feed_control.hpp", {"ipo/planner", "runtime/session"}},
};

Faults elsewhere(const Source& source) {
  Faults faults;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const auto allowed = kAllowed.find(std::string(included(source.lines[i], '"', '"')));
    if (allowed != kAllowed.end() && !allowed->second.contains(source.folder()))
      faults.push_back(source.place(i));
  }
  return faults;
}

}  // namespace

TEST_CASE("a run is driven and judged in one place", "[house]") {
  CHECK(listed(over(sources_below("libs"), elsewhere)) == "");
  CHECK(listed(over(sources_below("apps"), elsewhere)) == "");
}

TEST_CASE("a second harness of a run is found", "[house]") {
  const std::string drives = "#include \"runtime/session/simulate.hpp\"";
  CHECK(elsewhere(planted("softcnc/job/job.cpp", drives)).size() == 1);
  CHECK(elsewhere(planted("runtime/check/check.cpp", drives)).empty());
}
