// SPDX-License-Identifier: MIT
// What sources may use from outside: each outside library in the folders that keep it, and nothing
// that prints, reads the environment or shares ownership in a library.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "house/includes.hpp"

using namespace softcnc::house;

namespace {

/// The folders of libs that may know an outside library, by how the names of its headers begin.
using Keepers = std::map<std::string, std::set<std::string>>;

const Keepers kKeepers{
    {"toml++/", {"hal/machine"}},
    {"zstd.h", {"hal/files"}},
    {"xxhash.h", {"hal/files"}},
    {"zip.h", {"hal/files"}},
    {"yaml-cpp/", {"hal/import"}},
    {"linux/", {"hal/ports"}},
    {"thread", {"surface", "runtime/realtime"}},
    {"spdlog/", {}},
    {"CLI/", {}},
    {"nlohmann/", {}},
    {"cairo", {}},
    {"iostream", {}},
    {"chrono", {}},
};

/// What the application leaves to the libraries, or to one folder of its own.
const Keepers kLeftToLibraries{{"toml++/", {}}, {"xxhash.h", {}},
                               {"zip.h", {}},   {"yaml-cpp/", {}},
                               {"linux/", {}},  {"cairo", {"softcnc/pictures"}}};

/// What no library does: print, read the environment, share ownership, or differ by an option.
const std::vector<std::string> kForbidden{"std::cout", "std::cerr",      "std::clog", "std::printf",
                                          "getenv",    "shared_ptr",     "#ifdef",    "#ifndef",
                                          "std::rand", "using namespace"};

/// Lines that include an outside library which the folder of their source does not keep.
Faults out_of_place(const Source& source, const Keepers& keepers) {
  Faults faults;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string header = included(source.lines[i], '<', '>');
    for (const auto& [library, folders] : keepers)
      if (header.starts_with(library) && !folders.contains(source.folder()))
        faults.push_back(source.place(i));
  }
  return faults;
}

Faults out_of_place_in_libraries(const Source& source) { return out_of_place(source, kKeepers); }
Faults out_of_place_in_application(const Source& source) {
  return out_of_place(source, kLeftToLibraries);
}

Faults forbidden(const Source& source) {
  Faults faults;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string code = source.lines[i].substr(0, source.lines[i].find("//"));
    for (const std::string& word : kForbidden)
      if (!(word == "shared_ptr" && source.library() == "api") &&  // users share what they derive
          code.find(word) != std::string::npos)
        faults.push_back(source.place(i));
  }
  return faults;
}

bool folder_includes(const std::string& folder, const std::string& library) {
  for (const Source& source : sources_below("libs/" + folder))
    for (const std::string& line : source.lines)
      if (included(line, '<', '>').starts_with(library)) return true;
  return false;
}

}  // namespace

TEST_CASE("an outside library is known to the folders that keep it", "[house]") {
  CHECK(listed(over(sources_below("libs"), out_of_place_in_libraries)) == "");
  CHECK(listed(over(sources_below("apps"), out_of_place_in_application)) == "");
}

TEST_CASE("a planted outside library is found outside its folder alone", "[house]") {
  const std::string toml = "#include <toml++/toml.h>";
  CHECK(out_of_place_in_libraries(planted("hal/trace/trace.cpp", toml)) ==
        Faults{"hal/trace/trace.cpp:1: " + toml});
  CHECK(out_of_place_in_libraries(planted("hal/machine/toml_reader.cpp", toml)).empty());
  CHECK(out_of_place_in_application(planted("softcnc/main.cpp", toml)).size() == 1);
  CHECK(out_of_place_in_libraries(planted("ipo/path/grid.cpp", "#include <thread>")).size() == 1);
  CHECK(out_of_place_in_libraries(planted("surface/bands.cpp", "#include <thread>")).empty());
}

TEST_CASE("every keeper of an outside library still keeps it", "[house]") {
  for (const auto& [library, folders] : kKeepers)
    for (const std::string& folder : folders) {
      CAPTURE(library, folder);
      CHECK(folder_includes(folder, library));
    }
}

TEST_CASE("no library prints, reads the environment or shares ownership", "[house]") {
  CHECK(listed(over(sources_below("libs"), forbidden)) == "");
  CHECK(forbidden(planted("ipo/path/grid.cpp", "std::shared_ptr<int> p;")).size() == 1);
  CHECK(forbidden(planted("ipo/path/grid.cpp", "// no shared_ptr here")).empty());
}
