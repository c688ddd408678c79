// SPDX-License-Identifier: MIT
// Who includes whom: libraries beside each other stay apart, and folders form no circle.
#include "house/includes.hpp"

#include <catch2/catch.hpp>

using namespace softcnc::house;

namespace {

/// Whether sources of a library may include another library: all may include motion, runtime joins
/// those that stand on it, and api stands on all.
bool may_include(const std::string& library, const std::string& other) {
  if (other == library || other == "motion" || library == "api") return true;
  return library == "runtime" && other != "api";
}

/// Lines that include a library which theirs may not include.
Faults libraries_crossed(const Source& source) {
  Faults faults;
  for (const Arrow& arrow : file_arrows({source}))
    if (!may_include(source.library(), Source{arrow.to, {}}.library()))
      faults.push_back(arrow.place);
  return faults;
}

const Source kLexer =
    planted("ipr/text/lexer.cpp",
            "#include \"motion/model/block.hpp\"\n#include \"hal/backends/sim.hpp\"\n");

}  // namespace

TEST_CASE("a library includes motion alone, runtime what it joins, and api all", "[house]") {
  CHECK(listed(over(sources_below("libs"), libraries_crossed)) == "");
}

TEST_CASE("a planted include of another library is found, with its place", "[house]") {
  CHECK(libraries_crossed(kLexer) ==
        Faults{"ipr/text/lexer.cpp:2: #include \"hal/backends/sim.hpp\""});
  CHECK(libraries_crossed(planted("motion/core/axes.hpp", "#include \"ipo/path/grid.hpp\"")) ==
        Faults{"motion/core/axes.hpp:1: #include \"ipo/path/grid.hpp\""});
  CHECK(libraries_crossed(planted("hal/trace/trace.cpp", "#include \"runtime/sinks/row_sink.hpp\""))
            .size() == 1);
  CHECK(libraries_crossed(planted("runtime/session/a.hpp", "#include \"ipo/path/grid.hpp\""))
            .empty());
}

TEST_CASE("folders of the libraries form no circle", "[house]") {
  CHECK(listed(arrows_of_circles(folder_arrows(sources_below("libs")))) == "");
}

TEST_CASE("folders of the application form no circle", "[house]") {
  CHECK(listed(arrows_of_circles(folder_arrows(sources_below("apps/softcnc")))) == "");
}

TEST_CASE("a planted circle of folders is found, with its arrows alone", "[house]") {
  const std::vector<Source> sources{
      planted("ipo/path/grid.cpp",
              "#include \"ipo/path/grid.hpp\"\n#include \"ipo/jerk_limited/a.hpp\""),
      planted("ipo/jerk_limited/a.hpp", "#include <cmath>\n#include \"ipo/solver/b.hpp\""),
      planted("ipo/solver/b.hpp", "#include \"ipo/path/grid.hpp\""),
      planted("ipo/planner/c.hpp", "#include \"ipo/path/grid.hpp\"")};
  CHECK(arrows_of_circles(folder_arrows(sources)) ==
        Faults{"ipo/path -> ipo/jerk_limited by ipo/path/grid.cpp:2: #include "
               "\"ipo/jerk_limited/a.hpp\"",
               "ipo/jerk_limited -> ipo/solver by ipo/jerk_limited/a.hpp:2: #include "
               "\"ipo/solver/b.hpp\"",
               "ipo/solver -> ipo/path by ipo/solver/b.hpp:1: #include \"ipo/path/grid.hpp\""});
}

TEST_CASE("files include one another without a circle", "[house]") {
  for (const char* folder : {"libs", "apps/softcnc"}) {
    CAPTURE(folder);
    CHECK(listed(arrows_of_circles(file_arrows(sources_below(folder)))) == "");
  }
  CHECK(arrows_of_circles({{"a", "b", "1"}, {"b", "a", "2"}, {"c", "a", "3"}}) ==
        Faults{"a -> b by 1", "b -> a by 2"});
  CHECK(arrows_of_circles({{"a", "b", "1"}, {"a", "c", "2"}, {"b", "c", "3"}}).empty());
}
