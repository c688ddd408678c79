// SPDX-License-Identifier: MIT
// The floor plan of docs/floor-plan.md, held against every source: who includes whom, which file
// knows which outside library, and what no library does.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "house/sources.hpp"

using namespace softcnc::house;

namespace {

/// Outside libraries, by the beginning of their headers, and the only files that may know them.
const std::map<std::string, std::set<std::string>> kKeepers{
    {"toml++/", {"hal/toml_reader.cpp"}},
    {"zstd.h", {"hal/packed_file.cpp", "hal/zstd_sink.cpp"}},
    {"xxhash.h", {"hal/hash.cpp"}},
    {"zip.h", {"hal/zip_file.cpp"}},
    {"spdlog/", {}},
    {"CLI/", {}},
    {"nlohmann/", {}},
    {"iostream", {}},
    {"thread", {}},
    {"chrono", {}},
};

/// What no library does: print, read the environment or a clock, share ownership, differ by option.
const std::vector<std::string> kUnheard{"std::cout", "std::cerr",      "std::clog", "std::printf",
                                        "getenv",    "shared_ptr",     "#ifdef",    "#ifndef",
                                        "std::rand", "using namespace"};

/// What stands between these marks behind #include on a line; empty if it is no such line.
std::string included(const std::string& line, char open, char close) {
  const std::string head = std::string("#include ") + open;
  if (line.rfind(head, 0) != 0) return {};
  return line.substr(head.size(), line.find(close, head.size()) - head.size());
}

/// Lines that include a file of a room other than their own and the ground.
Faults doors_broken(const Source& source) {
  Faults faults;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string header = included(source.lines[i], '"', '"');
    const std::string room = header.substr(0, header.find('/'));
    if (!header.empty() && room != source.room() && room != "motion")
      faults.push_back(source.place(i));
  }
  return faults;
}

/// Lines that include an outside library which another file keeps, or none.
Faults libraries_out_of_place(const Source& source) {
  Faults faults;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string header = included(source.lines[i], '<', '>');
    for (const auto& [library, keepers] : kKeepers)
      if (header.rfind(library, 0) == 0 && !keepers.contains(source.name))
        faults.push_back(source.place(i));
  }
  return faults;
}

Faults unheard(const Source& source) {
  Faults faults;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string code = source.lines[i].substr(0, source.lines[i].find("//"));
    for (const std::string& word : kUnheard)
      if (code.find(word) != std::string::npos) faults.push_back(source.place(i));
  }
  return faults;
}

/// Files, and what each of them includes.
using Graph = std::map<std::string, std::set<std::string>>;

Graph include_graph(const std::vector<Source>& sources) {
  Graph graph;
  for (const Source& source : sources)
    for (const std::string& line : source.lines)
      if (const std::string header = included(line, '"', '"'); !header.empty())
        graph[source.name].insert(header);
  return graph;
}

/// The files on a circle of includes, and those that lead to one: what is left when all that
/// includes nothing any more has been taken away, again and again.
Faults circle(Graph graph) {
  const auto leaf = [&graph](const std::string& name) { return !graph.contains(name); };
  for (bool shrunk = true; shrunk;) {
    shrunk = false;
    for (auto& [name, headers] : graph) std::erase_if(headers, leaf);
    shrunk = std::erase_if(graph, [](const auto& node) { return node.second.empty(); }) > 0;
  }
  Faults names;
  for (const auto& [name, headers] : graph) names.push_back(name);
  return names;
}

}  // namespace

TEST_CASE("no room includes a room but its own and the ground", "[house]") {
  CHECK(over(sources_below("libs"), doors_broken) == Faults{});
}

TEST_CASE("a planted include of a neighbour is found, with its place", "[house]") {
  const Source source =
      planted("ipr/lexer.cpp", "#include \"motion/block.hpp\"\n#include \"hal/sim.hpp\"\n");
  CHECK(doors_broken(source) == Faults{"ipr/lexer.cpp:2: #include \"hal/sim.hpp\""});
}

TEST_CASE("an outside library is known to the one file that keeps it", "[house]") {
  CHECK(over(sources_below("libs"), libraries_out_of_place) == Faults{});
  CHECK(libraries_out_of_place(planted("ipo/grid.cpp", "#include <iostream>")).size() == 1);
  CHECK(libraries_out_of_place(planted("hal/sim.cpp", "#include <toml++/toml.h>")).size() == 1);
  CHECK(libraries_out_of_place(planted("hal/toml_reader.cpp", "#include <toml++/toml.h>")).empty());
}

TEST_CASE("every keeper of an outside library still keeps it", "[house]") {
  for (const auto& [library, keepers] : kKeepers)
    for (const std::string& keeper : keepers) {
      std::ifstream in(kRoot / "libs" / keeper);
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      CAPTURE(library, keeper);
      CHECK(text.find("#include <" + library) != std::string::npos);
    }
}

TEST_CASE("no library prints, reads the environment or shares ownership", "[house]") {
  CHECK(over(sources_below("libs"), unheard) == Faults{});
  CHECK(unheard(planted("ipo/grid.cpp", "std::shared_ptr<int> p;")).size() == 1);
  CHECK(unheard(planted("ipo/grid.cpp", "// no shared_ptr here")).empty());
}

TEST_CASE("headers include one another without a circle", "[house]") {
  CHECK(circle(include_graph(sources_below("libs"))) == Faults{});
  CHECK(circle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}, {"d", {"a"}}}).size() == 4);
  CHECK(circle({{"a", {"b", "c"}}, {"b", {"c"}}}).empty());
}
