// SPDX-License-Identifier: MIT
#include "motion/model/limit.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace softcnc {
namespace {

std::string feed_page() {
  std::stringstream text;
  text << std::ifstream(SOFTCNC_SOURCE_DIR "/docs/feed.md").rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("limits have distinct names, in the order of the enumeration", "[motion]") {
  const std::set<std::string_view> distinct(kLimitNames.begin(), kLimitNames.end());
  CHECK(distinct.size() == kLimitNames.size());
  CHECK(distinct.count("") == 0);
  CHECK(name(Limit::feed) == "feed");
  CHECK(name(Limit::roughness) == "roughness");
  CHECK(name(Limit::jerk) == "jerk");
  CHECK(name(Limit::pulse_rate) == "pulse_rate");
  CHECK(name(Limit::override_) == "override");
  CHECK(name(Limit::stop) == "stop");
}

TEST_CASE("docs/feed.md has a row for each limit", "[motion][docs]") {
  const std::string page = feed_page();
  for (const std::string_view limit : kLimitNames) {
    INFO(limit);
    CHECK(page.find("\n| `" + std::string(limit) + "` | ") != std::string::npos);
  }
}

}  // namespace softcnc
